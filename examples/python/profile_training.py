"""Where the time of training goes: environment, policy, learner. Takes the options of train.py.

    python profile_training.py --task reach --algorithm ppo --library sbx --steps 8192

Environment is all inside SB3VecEnv's steps, and the library what of that is spent in the library: physics, senses and
rewards of all worlds. Learner is all inside the updates; the policy and what lies between is the rest. Times are those
of the clock, and of the processor on all threads, which other programs disturb less; threads that wait awake count
there, too. The first updates are not counted: in them compilers do their work.
"""

import tempfile
import time
from pathlib import Path

import train  # before torch: it says how many threads products of matrices may have

# isort: split
import numpy as np
import torch

import mimo.batch
from mimo.sb3 import SB3VecEnv


def now():
    """Seconds of the clock, and of the processor on all threads."""
    return np.array([time.perf_counter(), time.process_time()])


class Stopwatch:
    """Adds up the seconds spent inside some methods of an object or class."""

    def __init__(self, owner, *names):
        self.seconds = np.zeros(2)
        for name in names:
            setattr(owner, name, self.timed(getattr(owner, name)))

    def timed(self, method):
        def run(*args, **kwargs):
            start = now()
            try:
                return method(*args, **kwargs)
            finally:
                self.seconds += now() - start

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
        start = now()
        model.learn(options.steps, reset_num_timesteps=False)
        total = now() - start
        envs.close()
    steps = model.num_timesteps - warm_up
    parts = {"a step": total, "environment": environment.seconds, "learner": learner.seconds}
    parts["policy and the rest"] = total - environment.seconds - learner.seconds
    parts["the library, of the environment"] = library.seconds
    print(f"{options.task} {options.algorithm}, ms a step of the clock and of the processor")
    for name, seconds in parts.items():
        (clock, processor), shares = 1000 * seconds / steps, 100 * seconds / total
        print(f"  {name}: {clock:.3f} ms, {shares[0]:.0f} %; {processor:.3f} ms, {shares[1]:.0f} %")


if __name__ == "__main__":
    main()
