"""PettingZoo, with one infant and with two."""

import numpy as np
import pytest
from pettingzoo.test import parallel_api_test

import mimo


def two():
    scene = mimo.Scene("free")
    for name, side in (("anna", -0.5), ("ben", 0.5)):
        scene.add_agent(name=name, vision=False, touch=False, position=[0, side, 0.4])
    return scene


def test_pettingzoo_s_checker():
    parallel_api_test(mimo.ParallelEnv("reach", max_steps=20), num_cycles=50)
    parallel_api_test(mimo.ParallelEnv(two(), max_steps=20), num_cycles=50)


def test_playdate():
    env = mimo.ParallelEnv("playdate", vision_width=16, vision_height=16, touch_scale=0.3, max_steps=20)
    parallel_api_test(env, num_cycles=30)
    observations, _ = env.reset(seed=1)
    assert sorted(observations) == ["anna", "ben"]
    assert observations["anna"].keys() == observations["ben"].keys()
    assert {"touch/force", "vision/eye_left", "vestibular/acceleration"} <= observations["anna"].keys()
    assert env.action_space("anna").shape == env.action_space("ben").shape == (25,)


def test_each_infant_has_its_own_senses_and_motors():
    env = mimo.ParallelEnv(two())
    observations, _ = env.reset(seed=1)
    assert env.agents == ["anna", "ben"]
    rest = {agent: np.zeros(env.action_space(agent).shape, np.float32) for agent in env.agents}
    for _ in range(10):
        observations, rewards, *_ = env.step({**rest, "anna": env.action_space("anna").high})
    moved = {agent: np.abs(it["proprioception/control"]).max() for agent, it in observations.items()}
    assert moved == {"anna": 1, "ben": 0}
    assert observations["anna"] in env.observation_space("anna")
    assert rewards == {"anna": 0, "ben": 0}


class Higher(mimo.Task):
    """Whose hand is higher? An episode ends for Anna after three steps."""

    def setup(self, world):
        self.names = [agent.name for agent in world.agents]
        self.hands = world.bodies(*(f"{name}/left_hand" for name in self.names))
        self.elbow = world.joints("anna/robot:left_elbow")
        self.steps = 0

    def reset(self, world, mask):
        self.elbow.write("position", -1, mask)
        self.steps = 0

    def evaluate(self, world):
        self.steps += 1
        self.seen = world.observation["anna/proprioception/position"].copy()
        heights = dict(zip(self.names, self.hands.position[:, 2]))
        best = max(heights, key=heights.get)
        return {
            name: mimo.Judgement(height, terminated=name == "anna" and self.steps == 3, success=name == best)
            for name, height in heights.items()
        }


def test_a_custom_task():
    task = Higher()
    env = mimo.ParallelEnv(two(), task=task, max_steps=10)
    parallel_api_test(env, num_cycles=30)
    observations, _ = env.reset(seed=1)
    elbow = env.world.layout.fields["anna/proprioception/position"].labels.index("anna/robot:left_elbow")
    assert observations["anna"]["proprioception/position"][elbow] == -1  # sensed after the task's reset
    for step in range(3):
        actions = {agent: np.zeros(env.action_space(agent).shape, np.float32) for agent in env.agents}
        observations, rewards, terminated, truncated, infos = env.step(actions)
        np.testing.assert_array_equal(task.seen, observations["anna"]["proprioception/position"])
        assert terminated == {"anna": step == 2, "ben": False}
        assert truncated == {"anna": False, "ben": False}
    hands = env.world.bodies("anna/left_hand", "ben/left_hand").position[:, 2]
    assert rewards == {"anna": hands[0], "ben": hands[1]}
    first, second = ({"is_success": won, "is_failure": False} for won in (hands[0] > hands[1], hands[1] > hands[0]))
    assert infos == {"anna": first, "ben": second}
    assert env.agents == ["ben"]


def test_each_infant_needs_a_judgement():
    class Sole(mimo.Task):
        def evaluate(self, world):
            return self.answer

    task = Sole()
    env = mimo.ParallelEnv(two(), task=task)
    for answer, message in (
        (mimo.Judgement(1), "return one mimo.Judgement per infant"),
        ({"anna": mimo.Judgement(1)}, "returned None for 'ben'"),
    ):
        task.answer = answer
        env.reset(seed=1)
        with pytest.raises(TypeError, match=message):
            env.step({})


def test_rows_of_numbers():
    named, flat = mimo.ParallelEnv(two()), mimo.ParallelEnv(two(), flatten=True)
    expected, _ = named.reset(seed=1)
    rows, _ = flat.reset(seed=1)
    for agent in ("anna", "ben"):
        assert rows[agent] in flat.observation_space(agent)
        joined = np.concatenate([field.ravel() for field in expected[agent].values()])
        np.testing.assert_array_equal(rows[agent], joined)
    parallel_api_test(mimo.ParallelEnv(two(), flatten=True, max_steps=10), num_cycles=20)
