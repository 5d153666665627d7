"""Limited senses, as a lab would set them up."""

import copy

import numpy as np

import mimo


def infant(**limits):
    scene = mimo.Scene("free")
    scene.add_agent(vision=False, touch=False)
    if limits:
        scene.limit_sense("proprioception/position", **limits)
    return mimo.World(scene)


def angles(world, steps=12):
    world.reset(seed=3)
    actions = np.linspace(-1, 1, len(world.action_low), dtype=np.float32)
    return np.array([world.step(actions).observation["proprioception/position"].copy() for _ in range(steps)])


def test_gain_and_delay():
    with infant() as perfect, infant(gain=0.5) as weak, infant(delay=3) as late:
        exact = angles(perfect)
        assert np.array_equal(angles(weak), exact / 2)
        assert np.array_equal(angles(late)[3:], exact[:-3])


def test_noise_is_the_seed_s_and_survives_copies():
    with infant(noise=0.01) as world, infant() as perfect:
        first = angles(world)
        assert np.array_equal(first, angles(world))
        error = first - angles(perfect)
        assert 0.008 < error.std() < 0.012
        assert np.array_equal(angles(copy.deepcopy(world)), first)
