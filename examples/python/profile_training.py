"""Where the time of training goes: environment, policy, learner. Takes the options of train.py.

    python profile_training.py --task reach --algorithm ppo --library sbx --steps 8192

Environment is all inside SB3VecEnv's steps, and the library what of that is spent in the library: physics, senses and
rewards of all worlds. Learner is all inside the updates; the policy and what lies between is the rest. The first
updates are not counted: in them compilers do their work.
"""

import tempfile
import time
from pathlib import Path

import train  # before torch: it says how many threads products of matrices may have

# isort: split
import torch

import mimo.batch
from mimo.sb3 import SB3VecEnv


class Stopwatch:
    """Adds up the seconds spent inside some methods of an object or class."""

    def __init__(self, owner, *names):
        self.seconds = 0.0
        for name in names:
            setattr(owner, name, self.timed(getattr(owner, name)))

    def timed(self, method):
        def run(*args, **kwargs):
            start = time.perf_counter()
            try:
                return method(*args, **kwargs)
            finally:
                self.seconds += time.perf_counter() - start

        return run


def main():
    options = train.parse()
    torch.set_num_threads(options.torch_threads)
    with tempfile.TemporaryDirectory() as folder:
        envs = train.make_envs(options, Path(folder))
        model = train.make_model(options, envs, Path(folder))
        warm_up = options.rollout if options.algorithm == "ppo" else options.random_steps + 10 * options.worlds
        model.learn(warm_up)
        environment = Stopwatch(SB3VecEnv, "step_async", "step_wait")
        library = Stopwatch(mimo.batch.LIB, "mimo_batch_send", "mimo_batch_receive", "mimo_batch_reset")
        learner = Stopwatch(model, "train")
        start = time.perf_counter()
        model.learn(options.steps, reset_num_timesteps=False)
        wall = time.perf_counter() - start
        envs.close()
    per_step = 1000 * wall / (model.num_timesteps - warm_up)
    shares = {"environment": environment.seconds, "learner": learner.seconds}
    shares["policy and the rest"] = wall - sum(shares.values())
    print(f"{options.task} {options.algorithm}: {per_step:.3f} ms a step")
    shares["the library, of the environment"] = library.seconds
    for name, seconds in shares.items():
        print(f"  {name}: {per_step * seconds / wall:.3f} ms, {100 * seconds / wall:.0f} %")


if __name__ == "__main__":
    main()
