"""make_vec: no copies, the same numbers as single environments, and autoreset as Gymnasium defines it."""

import copy

import gymnasium
import numpy as np
import pytest
from gymnasium.vector.utils import batch_space
from test_env import NearBall

import mimo


def actions(count, worlds, size=8):
    return np.random.default_rng(0).uniform(-1, 1, (count, worlds, size)).astype(np.float32)


def test_observations_are_views_of_the_library_s_blocks():
    envs = mimo.make_vec("reach", num_envs=4)
    first, _ = envs.reset(seed=1)
    blocks = set()
    for action in actions(4, 4):
        observation = envs.step(action)[0]
        block = envs._blocks[envs._turn]
        blocks.add(block.ctypes.data)
        for name, field in observation.items():
            assert np.shares_memory(field, block)
            assert field.ctypes.data == block.ctypes.data + envs.batch.layout.fields[name].offset
            assert field.strides[0] == envs.batch.layout.bytes
    assert len(blocks) == 2
    assert observation in envs.observation_space
    assert first.keys() == observation.keys()


def test_an_observation_is_valid_until_the_second_step_after_it():
    envs = mimo.make_vec("reach", num_envs=2)
    envs.reset(seed=1)
    one, *_ = envs.step(np.ones((2, 8)))
    kept = one["proprioception/position"].copy()
    envs.step(np.ones((2, 8)))
    np.testing.assert_array_equal(one["proprioception/position"], kept)


def test_worlds_are_single_environments():
    envs = mimo.make_vec("standup", num_envs=2)
    envs.reset(seed=3)
    singles = [mimo.make("standup") for _ in range(2)]
    for i, env in enumerate(singles):
        env.reset(seed=3 + i)
    for action in actions(10, 2, 27):
        observation, reward, *_ = envs.step(action)
        for i, env in enumerate(singles):
            alone, alone_reward, *_ = env.step(action[i])
            assert reward[i] == alone_reward
            for name, field in alone.items():
                np.testing.assert_array_equal(observation[name][i], field)


@pytest.mark.skipif(gymnasium.__version__ < "1", reason="makes processes of single environments before 1.0")
def test_gymnasium_make_vec():
    envs = gymnasium.make_vec("mimo/Reach-v0", num_envs=3)
    assert isinstance(envs.unwrapped, mimo.VectorEnv)
    assert envs.reset(seed=1)[0]["proprioception/position"].shape == (3, 47)
    for mode in (envs.metadata["autoreset_mode"], envs.unwrapped.autoreset_mode):
        assert getattr(mode, "value", mode) == "NextStep"


@pytest.mark.skipif(not hasattr(gymnasium.vector, "AutoresetMode"), reason="this Gymnasium has no AutoresetMode")
@pytest.mark.parametrize("mode", ["NEXT_STEP", "SAME_STEP", "DISABLED"])
def test_gymnasium_s_autoreset_modes(mode):
    wanted = gymnasium.vector.AutoresetMode[mode]
    envs = gymnasium.make_vec("mimo/Reach-v0", num_envs=2, autoreset_mode=wanted)
    assert envs.unwrapped.autoreset_mode is envs.metadata["autoreset_mode"] is wanted
    if mode == "SAME_STEP":  # a wrapper that looks for it takes it
        wrapped = gymnasium.wrappers.vector.RecordEpisodeStatistics(envs)
        wrapped.reset(seed=1)
        wrapped.step(np.zeros((2, 8)))


@pytest.mark.parametrize("task", [None, NearBall(goal=9)])
def test_next_step_mode(task):
    envs = mimo.make_vec("reach", num_envs=2, max_steps=3, task=task)
    envs.reset(seed=1)
    flags = []
    for action in actions(8, 2):
        observation, reward, _, truncated, infos = envs.step(action)
        flags.append(truncated.tolist())
        if len(flags) == 4:  # the step after the end: a reset
            assert not reward.any()
            assert not infos
            assert not np.any(observation["proprioception/velocity"])
    assert flags == [[i % 4 == 2] * 2 for i in range(8)]


def test_same_step_mode():
    envs = mimo.make_vec("reach", num_envs=2, max_steps=3, autoreset_mode="SameStep")
    plain = mimo.make_vec("reach", num_envs=2, max_steps=3, autoreset_mode="Disabled")
    for each in (envs, plain):
        each.reset(seed=1)
    for action in actions(3, 2):
        observation, reward, _, truncated, infos = envs.step(action)
        last, last_reward, *_ = plain.step(action)
    assert truncated.all()
    np.testing.assert_array_equal(reward, last_reward)
    assert infos["_final_obs"].all()
    for i in range(2):
        for name, field in infos["final_obs"][i].items():
            np.testing.assert_array_equal(field, last[name][i])
    assert not np.any(observation["proprioception/velocity"])  # reach starts at rest
    assert infos["final_info"]["is_success"].tolist() == [False, False]
    np.testing.assert_array_equal(infos["final_info"]["reward_terms"]["distance"], reward)


def test_disabled_mode_waits_for_a_mask():
    envs = mimo.make_vec("reach", num_envs=2, max_steps=2, autoreset_mode="Disabled")
    envs.reset(seed=1)
    for action in actions(3, 2):
        observation, *_ = envs.step(action)
    observation, _ = envs.reset(options={"reset_mask": np.array([True, False])})
    moving = np.any(observation["proprioception/velocity"], axis=1)
    assert moving.tolist() == [False, True]


def test_success_is_reported():
    # The ball is put into the hand: reach succeeds in the first step.
    envs = mimo.make_vec("reach", num_envs=2)
    envs.reset(seed=1)
    world = envs.batch.world(1)
    world.bodies("target").position = world.bodies("right_fingers").position
    _, reward, terminated, _, infos = envs.step(np.zeros((2, 8)))
    assert terminated.tolist() == [False, True]
    assert infos["is_success"].tolist() == [False, True]
    assert infos["_is_success"].tolist() == [False, True]
    assert reward[1] == infos["reward_terms"]["success"][1] == 100


def test_a_custom_task_in_many_worlds_is_that_of_one():
    task = NearBall()
    envs = mimo.make_vec("reach", num_envs=3, task=task, max_steps=4)
    envs.reset(seed=5)
    got = [envs.step(action)[1:4] for action in actions(9, 3)]
    for i in range(3):
        env = mimo.make("reach", task=NearBall(), max_steps=4)
        env.reset(seed=5 + i)
        over = False
        for action, (reward, terminated, truncated) in zip(actions(9, 3)[:, i], got):
            if over:
                env.reset()
                alone = (0.0, False, False)
            else:
                alone = env.step(action)[1:4]
            over = alone[1] or alone[2]
            assert (reward[i], terminated[i], truncated[i]) == alone


def test_flat_rows():
    envs = mimo.make_vec("reach", num_envs=2, flatten=True)
    rows, _ = envs.reset(seed=1)
    assert rows.shape == (2, 220)
    np.testing.assert_array_equal(rows[1], mimo.make("reach", flatten=True).reset(seed=2)[0])


@pytest.mark.parametrize("flatten", [False, True])
def test_spaces_of_many_worlds_have_the_bounds_of_one(flatten):
    envs = mimo.make_vec("reach", num_envs=3, flatten=flatten)
    assert envs.observation_space == batch_space(envs.single_observation_space, 3)
    assert envs.action_space == batch_space(envs.single_action_space, 3)
    boxes = [envs.action_space, *([envs.observation_space] if flatten else envs.observation_space.values())]
    for box in boxes:
        for bound in (box.low, box.high, box.bounded_below, box.bounded_above):
            assert bound.shape[0] == 3
            assert bound.strides[0] == 0  # a copy for each of 64 worlds with eyes of 256 pixels would take 100 MB
    assert copy.deepcopy(envs.observation_space) == envs.observation_space
    assert envs.action_space.sample() in envs.action_space
    assert envs.reset(seed=0)[0] in envs.observation_space


def test_worlds_are_made_by_the_first_picture():
    envs = mimo.make_vec("reach", num_envs=3, render_mode="rgb_array")
    envs.reset(seed=0)
    envs.step(envs.action_space.sample())
    assert len(envs.batch._worlds) == 0  # each has a block of its own
    assert len(envs.render()) == 3
    kept = [envs.batch.world(i) for i in range(3)]
    envs.render()
    assert [envs.batch.world(i) for i in range(3)] == kept
    envs.close()


def test_send_and_receive():
    envs = mimo.make_vec("reach", num_envs=2)
    envs.reset(seed=1)
    envs.send(np.zeros((2, 8)))
    assert (envs.receive()[1] < 0).all()


def test_render_and_close():
    envs = mimo.make_vec("reach", num_envs=2, render_mode="rgb_array")
    envs.reset(seed=1)
    assert [picture.shape for picture in envs.render()] == [(180, 240, 3)] * 2
    envs.close()
    with pytest.raises(mimo.ClosedError):
        envs.step(np.zeros((2, 8)))


def test_wrong_options():
    with pytest.raises(ValueError, match="autoreset_mode"):
        mimo.make_vec("reach", num_envs=2, autoreset_mode="sometimes")
    with pytest.raises(TypeError, match="unexpected keyword argument 'frames'"):
        mimo.make_vec("reach", num_envs=2, frames=3)
