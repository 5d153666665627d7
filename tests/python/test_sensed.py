"""What was sensed last is in one place, whoever sensed it and wherever to; nobody sees memory that nobody wrote."""

import gc

import numpy as np
import pytest

import mimo

EYES = {"vision_width": 8, "vision_height": 8}
RELATIVE = "proprioception/position"


class Standing(mimo.Task):
    """Notes what the world shows while it is asked."""

    def setup(self, world):
        self.seen = []

    def evaluate(self, world):
        self.seen.append({name: field.copy() for name, field in world.observation.items()})
        return mimo.Judgement(0.0)


def same(shown, observation):
    assert shown.keys() == observation.keys()
    for name, field in observation.items():
        np.testing.assert_array_equal(shown[name], field, name)


def dirty():
    """Leaves memory behind that is full of ones, for whoever takes memory without writing to it."""
    for size in (2**8, 2**12, 2**16, 2**20):
        junk = [np.full(size, 255, np.uint8) for _ in range(50)]
        del junk
    gc.collect()


def test_blocks_begin_as_zeros():
    for _ in range(5):
        dirty()
        world = mimo.World("benchmark", **EYES)
        batch = mimo.Batch("reach", 3)
        blocks = [world.block, batch.blocks, batch.final_blocks, world.layout.new_block(), batch.layout.new_block(3)]
        assert not any(block.any() for block in blocks)
        for observation in (world.observation, batch.observation, batch.world(1).observation):
            assert not any(field.any() for field in observation.values())
        clone = world.clone()
        assert not any(field.any() for field in clone.observation.values())


def test_an_environment_s_world_shows_what_it_returned():
    env = mimo.make("benchmark", **EYES)
    observation, _ = env.reset(seed=1)
    same(env.unwrapped.world.observation, observation)
    for _ in range(3):
        observation, *_ = env.step(env.action_space.sample())
        same(env.unwrapped.world.observation, observation)
    assert observation["vision/eye_left"].any()


def test_a_task_s_observation_is_of_this_step():
    task = Standing()
    env = mimo.make("reach", task=task)
    observation, _ = env.reset(seed=1)
    same(env.world.observation, observation)
    for action in np.linspace(-1, 1, 24, dtype=np.float32).reshape(3, 8):
        observation, *_ = env.step(action)
        same(task.seen[-1], observation)
        same(env.world.observation, observation)


def test_a_page_shows_the_current_step(monkeypatch):
    """The page looks at the world when a step ends: with a task of one's own, too."""

    class Page:
        def __init__(self, env):
            self.env, self.shown = env, []

        def show(self):
            self.shown.append({name: field.copy() for name, field in self.env.world.observation.items()})

    for task in (None, Standing()):
        env = mimo.make("reach", render_mode="human", task=task)
        page = env._viewer = Page(env)
        observation, _ = env.reset(seed=1)
        same(page.shown[-1], observation)
        for action in np.linspace(-1, 1, 24, dtype=np.float32).reshape(3, 8):
            observation, *_ = env.step(action)
            same(page.shown[-1], observation)
        env._viewer = None


def test_blocks_of_the_caller():
    world, twin = mimo.World("reach"), mimo.World("reach")
    block = world.layout.new_block()
    world.reset_into(block, 1)
    same(world.observation, twin.reset(1))
    world.step_into(block, np.ones(8))
    same(world.observation, twin.step(np.ones(8)).observation)
    assert np.shares_memory(world.observation[RELATIVE], block)
    world.step_into(None, np.ones(8))
    same(world.observation, twin.observation)  # nothing was sensed: it is as it was
    world.observe_into(block)
    twin.step(np.ones(8))
    same(world.observation, twin.observe())
    same(world.step(np.ones(8)).observation, twin.step(np.ones(8)).observation)
    assert np.shares_memory(world.observation[RELATIVE], world.block)


def test_batches_and_their_worlds():
    batch = mimo.Batch("reach", 2)
    actions = np.linspace(-1, 1, 16, dtype=np.float32).reshape(2, 8)
    own = batch.layout.new_block(2)
    moves = {
        "reset": lambda: batch.reset(1),
        "step": lambda: batch.step(actions),
        "step_into": lambda: batch.step_into(own, actions),
        "observe_into": lambda: batch.observe_into(own),
        "send": lambda: (batch.send(actions, own), batch.receive()),
        "step again": lambda: batch.step(actions),
    }
    first = batch.world(0)
    for name, move in moves.items():
        move()
        where = own if name in ("step_into", "observe_into", "send") else batch.blocks
        assert np.shares_memory(batch.observation[RELATIVE], where), name
        for index in (0, 1):
            same(batch.world(index).observation, {key: field[index] for key, field in batch.observation.items()})
    first.step(np.ones(8))  # by itself
    assert np.shares_memory(first.observation[RELATIVE], first.block)
    batch.reset(mask=np.array([False, True]))
    assert np.shares_memory(first.observation[RELATIVE], first.block)
    batch.step(actions)
    same(first.observation, {key: field[0] for key, field in batch.observation.items()})


@pytest.mark.parametrize("mode", ["NextStep", "SameStep"])
def test_vectors(mode):
    envs = mimo.make_vec("reach", num_envs=2, autoreset_mode=mode, max_steps=2)
    observation, _ = envs.reset(seed=1)
    same(envs.batch.observation, observation)
    for _ in range(5):
        observation, *_ = envs.step(envs.action_space.sample())
        same(envs.batch.observation, observation)
        same(envs.batch.world(1).observation, {name: field[1] for name, field in observation.items()})


def test_several_infants():
    pytest.importorskip("pettingzoo")
    scene = mimo.Scene("free")
    for name, x in (("anna", 0), ("ben", 1)):
        scene.add_agent(name=name, position=[x, 0, 0.4], vision=False)
    env = mimo.ParallelEnv(scene)
    observations, _ = env.reset(seed=1)
    for _ in range(2):
        for name in env.possible_agents:
            field = observations[name]["touch/force"]
            np.testing.assert_array_equal(env.world.observation[f"{name}/touch/force"], field)
        observations, *_ = env.step({name: env.action_space(name).sample() for name in env.agents})


def test_a_step_does_not_look_fields_up(monkeypatch):
    """Fields of a block are looked up when somebody asks for them."""
    world = mimo.World("reach")
    block, made = world.layout.new_block(), []
    views = mimo.Layout.views
    monkeypatch.setattr(mimo.Layout, "views", lambda layout, block: made.append(block) or views(layout, block))
    for _ in range(3):
        world.step_into(block, np.zeros(8))
    assert not made
    assert world.observation is world.observation
    assert len(made) == 1
