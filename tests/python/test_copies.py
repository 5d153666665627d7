"""Pickle, copy, fork, and other processes."""

import copy
import multiprocessing
import os
import pickle

import cloudpickle
import gymnasium
import numpy as np
import pytest
from test_env import NearBall

import mimo

ACTION = np.linspace(-1, 1, 8, dtype=np.float32)


def same(one, other):
    return all(np.array_equal(one[name], other[name]) for name in one)


@pytest.mark.parametrize("through", [copy.copy, copy.deepcopy, lambda it: pickle.loads(pickle.dumps(it))])
def test_a_copied_world_continues_alike(reach, through):
    reach.reset(seed=1)
    reach.step(ACTION)
    twin = through(reach)
    assert twin is not reach
    one, other = reach.step(ACTION), twin.step(ACTION)
    assert same(one.observation, other.observation)
    assert one.reward == other.reward
    assert reach.random(1) == twin.random(1)


@pytest.mark.parametrize("dump", [pickle, cloudpickle])
@pytest.mark.parametrize("task", [None, NearBall()])
def test_environments(dump, task):
    env = mimo.make("reach", task=task)
    env.reset(seed=1)
    twin = dump.loads(dump.dumps(env))
    assert same(env.step(ACTION)[0], twin.step(ACTION)[0])
    third = copy.deepcopy(env)
    assert env.step(ACTION)[1] == third.step(ACTION)[1]


@pytest.mark.parametrize("task", [None, NearBall()])
def test_vector_environments(task):
    envs = mimo.make_vec("reach", num_envs=2, max_steps=3, task=task)
    envs.reset(seed=1)
    envs.step(np.tile(ACTION, (2, 1)))
    twin = pickle.loads(pickle.dumps(envs))
    for _ in range(4):
        one, other = envs.step(np.tile(ACTION, (2, 1))), twin.step(np.tile(ACTION, (2, 1)))
        assert same(one[0], other[0])
        np.testing.assert_array_equal(one[1], other[1])
    assert np.shares_memory(other[0]["proprioception/position"], twin._blocks[twin._turn])


def test_scenes_are_built_again(tmp_path):
    file = tmp_path / "room.xml"
    file.write_text('<mujoco><worldbody><geom name="floor" type="plane" size="1 1 .1"/></worldbody></mujoco>')
    scene = mimo.Scene(file=file)
    scene.add_object("ball", size=0.1, position=[0, 0, 1])
    scene.add_agent(vision=False, position=[0, 0, 0.4])
    scene.set_touch("left_hand", 0.01)
    scene.parameters["reach/success_reward"] = 3
    twin = pickle.loads(pickle.dumps(scene))
    assert twin.xml == scene.xml
    assert twin.parameters["reach/success_reward"] == 3
    scene.close()
    assert mimo.World(twin).bodies("ball").position[0, 2] == 1


def in_child(connection, world):
    try:
        world.step()
        connection.send("stepped")
    except mimo.ForkedError:
        own = mimo.World("reach")
        own.reset(seed=1)
        connection.send(f"refused, then {len(own.step(ACTION).reward)}")


@pytest.mark.skipif(not hasattr(os, "fork"), reason="this system has no fork()")
def test_after_fork_the_world_raises_forked_error(reach):
    reach.reset(seed=1)
    near, far = multiprocessing.Pipe()
    child = multiprocessing.get_context("fork").Process(target=in_child, args=(far, reach))
    child.start()
    assert near.poll(60)
    assert near.recv() == "refused, then 1"
    child.join(60)
    assert child.exitcode == 0
    reach.step(ACTION)


def in_spawned(connection, world):
    connection.send(world.step(ACTION).reward.tolist())


def test_worlds_are_sent_to_spawned_processes(reach):
    reach.reset(seed=1)
    near, far = multiprocessing.Pipe()
    child = multiprocessing.get_context("spawn").Process(target=in_spawned, args=(far, reach))
    child.start()
    assert near.poll(120)
    assert near.recv() == reach.step(ACTION).reward.tolist()
    child.join(60)


def test_gymnasium_s_async_vector_env():
    envs = gymnasium.vector.AsyncVectorEnv([lambda: gymnasium.make("mimo/Reach-v0")] * 2)
    observation, _ = envs.reset(seed=1)
    alone, _ = mimo.make("reach").reset(seed=2)
    np.testing.assert_array_equal(observation["proprioception/position"][1], alone["proprioception/position"])
    envs.close()
