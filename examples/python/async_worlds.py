"""Environments in processes of their own, by Gymnasium's AsyncVectorEnv, started by fork and by spawn.

Worlds in one process (mimo.make_vec) are faster; this is for code that wants AsyncVectorEnv. A world belongs to the
process that makes it: environments are made inside of the children, by the functions that are given. Prints the rewards
of both, which are the same for the same seeds.

    python async_worlds.py [--worlds N] [--steps N]
"""

import argparse
from functools import partial

import gymnasium
import numpy as np
from gymnasium.vector import AsyncVectorEnv

import mimo.classic


def make(name):
    return mimo.classic.make(name)


def rewards(start, worlds, steps):
    envs = AsyncVectorEnv([partial(make, "MIMoReach-v0")] * worlds, context=start)
    envs.reset(seed=0)
    envs.action_space.seed(0)
    earned = [envs.step(envs.action_space.sample())[1] for _ in range(steps)]
    envs.close()
    return np.array(earned)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--worlds", type=int, default=2)
    parser.add_argument("--steps", type=int, default=20)
    arguments = parser.parse_args()
    by_fork, by_spawn = (rewards(start, arguments.worlds, arguments.steps) for start in ("fork", "spawn"))
    assert np.array_equal(by_fork, by_spawn)
    print(f"Gymnasium {gymnasium.__version__}: sums of rewards {by_fork.sum(axis=0)}, by fork as by spawn")


if __name__ == "__main__":
    main()
