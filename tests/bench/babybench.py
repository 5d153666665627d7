#!/usr/bin/env python3
"""What a step of BabyBench costs, over a bare mj_step of the same model (docs/guide/babybench.md).

    tests/bench/babybench.py [TURNS [CONFIGURATION...]]    20 turns of all by default; some minutes

All sides take turns in one process; the numbers are medians over turns, of ours over that turn's bare steps. Needs mimo
(MIMO_LIBRARY=build/lib/libmimo.so PYTHONPATH=bindings/python/src).
"""
import statistics
import sys
import time

import numpy as np

import mimo
import mimo.babybench
from mimo import Disable, Kind, Quantity

CONFIGURATIONS = {
    "self-touch": ("selftouch", {}),
    "self-touch, no skin": ("selftouch", {"touch_active": False}),
    "hand regard, no pictures": ("handregard", {"vision_active": False}),
    "hand regard": ("handregard", {}),
}
STEPS = 100  # of a turn, of all worlds together at least
WORLDS = 64


class Bare:
    """mj_step and nothing else, with random controls, from where the other world is."""

    def __init__(self, env):
        self._joints = np.arange(env.world.count(Kind.JOINT))
        self._other = env.world
        self._world = mimo.World(env.scene, frame_skip=1, disable=Disable.OWN_SOLVER)
        self._bounds = env.action_space.low, env.action_space.high
        self._random = np.random.default_rng(0)

    def __call__(self):
        world, spent = self._world, 0.0
        for quantity in (Quantity.JOINT_POSITION, Quantity.JOINT_VELOCITY):
            world.set(quantity, self._other.get(quantity, self._joints), self._joints)
        for _ in range(STEPS):
            world.set(Quantity.ACTUATOR_CONTROL, self._random.uniform(*self._bounds)[:, None])
            start = time.perf_counter()
            world.physics_step(1)
            spent += time.perf_counter() - start
        return spent / STEPS


def of_env(env):
    """The environment as a script steps it; episodes last 1000 steps."""
    env.reset(seed=0)

    def turn():
        spent = 0.0
        for _ in range(STEPS):
            action = env.action_space.sample()
            start = time.perf_counter()
            truncated = env.step(action)[3]
            spent += time.perf_counter() - start
            if truncated:
                env.reset()
        return spent / STEPS

    return turn


def of_batch(config, threads):
    """Many worlds; a world's share of a step."""
    envs = mimo.babybench.make_vec(config, WORLDS, threads=threads, training=False)
    envs.reset(seed=0)

    def turn():
        count, spent = -(-STEPS // WORLDS), 0.0
        for _ in range(count):
            actions = envs.action_space.sample()
            start = time.perf_counter()
            envs.step(actions)
            spent += time.perf_counter() - start
        return spent / (count * WORLDS)

    return turn


def main(turns, titles):
    print(f"{'':26} {'bare mj_step':>13} {'one world':>10} {f'{WORLDS}, 1 thread':>13} {f'{WORLDS}, 2 threads':>14}")
    for title in titles or CONFIGURATIONS:
        name, switches = CONFIGURATIONS[title]
        config = {**mimo.babybench.load(name), **switches, "save_dir": None}
        env = mimo.babybench.make(config, training=False)
        sides = [of_env(env), of_batch(config, 1), of_batch(config, 2)]
        bare = Bare(env.unwrapped)
        ratios, bares = [[] for _ in sides], []
        for _ in range(turns):
            bares.append(bare())
            for found, side in zip(ratios, sides):
                found.append(side() / bares[-1])
        medians = [statistics.median(found) for found in ratios]
        print(f"{title:26} {statistics.median(bares) * 1e6:10.0f} us " + " ".join(f"{it:12.2f}" for it in medians))


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 20, sys.argv[2:])
