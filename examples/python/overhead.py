"""How much time Python adds to the library's, for one world and for a batch; and what a batch gives.

    python overhead.py [--steps N] [--worlds N] [--scene NAME]

A single world counts the time inside its own step (option timing); the rest of a step's time is Python's. For a batch
the two calls into the library are timed from outside.
The fastest tenth of chunks of 20 steps counts, so that what else the machine does matters
little.
"""

import argparse
import time

import numpy as np

import mimo
import mimo.batch

CHUNK = 20


def chunks(steps):
    return max(1, steps // CHUNK)


def one_world(scene, steps):
    """Microseconds of a step inside the library, and around it."""
    env = mimo.make(scene, timing=True)
    env.action_space.seed(0)
    env.reset(seed=0)
    actions = [env.action_space.sample() for _ in range(CHUNK)]
    inside, around = [], []
    for _ in range(chunks(steps)):
        env.world.reset_timing()
        start = time.perf_counter()
        for action in actions:
            env.step(action)
        wall = time.perf_counter() - start
        spent = env.world.timing["total"]
        inside.append(spent / CHUNK * 1e6)
        around.append((wall - spent) / CHUNK * 1e6)
    return np.quantile(inside, 0.1), np.quantile(around, 0.1)


class Timed:
    """The library, with the time spent in it."""

    def __init__(self, library):
        self._library, self.spent = library, 0.0

    def __getattr__(self, name):
        function = getattr(self._library, name)

        def timed(*arguments):
            start = time.perf_counter()
            result = function(*arguments)
            self.spent += time.perf_counter() - start
            return result

        return timed


def many_worlds(scene, worlds, steps):
    """Microseconds of a step of all worlds inside the library, and around it."""
    envs = mimo.make_vec(scene, num_envs=worlds)
    envs.action_space.seed(0)
    envs.reset(seed=0)
    actions = [envs.action_space.sample() for _ in range(CHUNK)]
    library = mimo.batch.LIB = Timed(mimo.batch.LIB)
    inside, around = [], []
    for _ in range(chunks(steps)):
        library.spent, start = 0.0, time.perf_counter()
        for action in actions:
            envs.step(action)
        wall = time.perf_counter() - start
        inside.append(library.spent / CHUNK * 1e6)
        around.append((wall - library.spent) / CHUNK * 1e6)
    mimo.batch.LIB = library._library
    return np.quantile(inside, 0.1), np.quantile(around, 0.1)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--scene", default="reach", choices=mimo.scenes())
    parser.add_argument("--steps", type=int, default=2000)
    parser.add_argument("--worlds", type=int, default=64)
    options = parser.parse_args()
    inside, around = one_world(options.scene, options.steps)
    print(f"one world: {inside:.1f} us in the library, {around:.1f} us in Python a step")
    inside, around = many_worlds(options.scene, options.worlds, options.steps)
    print(
        f"{options.worlds} worlds: {inside:.0f} us in the library, {around:.0f} us in Python a step "
        f"({100 * around / inside:.1f} %); {options.worlds / (inside + around) * 1e6:.0f} steps/s"
    )
