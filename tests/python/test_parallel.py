"""PettingZoo, with one infant and with two."""

import numpy as np
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
