"""Where the wall time of training goes: PPO on reach with 16 worlds, under Python's profiler.

    python profile_ppo.py [--steps N] [--worlds N] [--task NAME]

Prints the share of the environment (everything inside SB3VecEnv's steps) and the functions that take most.
"""

import argparse
import cProfile
import pstats
import time

from stable_baselines3 import PPO

from mimo.sb3 import SB3VecEnv


def environment_seconds(stats):
    """Time inside step_async and step_wait, with all that they call."""
    return sum(
        cumulative
        for (file, _, name), (_, _, _, cumulative, _) in stats.stats.items()
        if name in ("step_async", "step_wait", "reset") and file.endswith("mimo/sb3.py")
    )


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--task", default="reach")
    parser.add_argument("--worlds", type=int, default=16)
    parser.add_argument("--steps", type=int, default=8192)
    options = parser.parse_args()
    envs = SB3VecEnv(options.task, options.worlds)
    model = PPO("MultiInputPolicy", envs, n_steps=2048 // options.worlds, device="cpu", seed=0)
    profile = cProfile.Profile()
    start = time.perf_counter()
    profile.runcall(model.learn, options.steps)
    wall = time.perf_counter() - start
    stats = pstats.Stats(profile)
    share = environment_seconds(stats) / wall
    print(f"{options.steps / wall:.0f} steps/s; {100 * share:.1f} % of the wall time in the environment")
    stats.sort_stats("tottime").print_stats(12)
