"""Trains what the paper's Fig. 4 shows: PPO and SAC on its three tasks, with many seeds, one run after another.

    python figure4.py --seeds 10 --out runs
    python figure4.py --seeds 10 --out runs --algorithm sac    # beside it, with --algorithm ppo, on another core

First all tasks with seed 0, then with seed 1, and so on, so that what is there when it is stopped has the same seeds
everywhere. Started again, it goes on with the run that was not finished, from that run's beginning: a curve does not
depend on interruptions. SETTINGS are what train.py is called with, instead of its defaults; further options are
train.py's and go before these: --steps 1000, for a try.
"""

import argparse
import shutil
from pathlib import Path

import numpy as np
import train

COMMON = "--threads 1 --quiet"
NORMALIZED = "--normalize-observations --normalize-rewards"
PPO = "--library sb3 --note-every 4000 --evaluate-every 50000"
SAC = (
    f"--library sbx {NORMALIZED} --network 64 64 --batch 128 --rate 1e-3 --updates 4 --random-steps 2000 "
    "--drop-memory --note-every 2000 --evaluate-every 20000"
)
ACTS_EACH_50_MS = "--frame-skip 10 --max-steps 50 --gamma 0.98 --worlds 32 --evaluation-episodes 64"
SETTINGS = {
    ("reach", "ppo"): f"{PPO} --steps 200000",
    ("reach", "sac"): f"{SAC} --steps 150000 --temperature 0.01",
    ("standup", "ppo"): f"{PPO} --steps 200000",
    ("standup", "sac"): f"{SAC} --steps 200000 --temperature 0.0005",
    ("selfbody", "ppo"): f"{PPO} --normalize-rewards --steps 400000 --rollout 4096 --batch 256 {ACTS_EACH_50_MS}",
    ("selfbody", "sac"): f"{SAC} --steps 100000 --temperature 0.05 {ACTS_EACH_50_MS}",
}


def steps_done(options):
    """As far as the curve says; a run ends with a row of it."""
    curve = train.run_folder(options) / "curve.csv"
    if not curve.exists():
        return 0
    rows = np.atleast_1d(np.genfromtxt(curve, delimiter=",", names=True))
    return rows["steps"][-1] if rows.size else 0


def parse():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0], allow_abbrev=False)
    parser.add_argument("--seeds", type=int, default=10, help="0 up to this number")
    parser.add_argument("--task", nargs="+", default=["reach", "standup", "selfbody"])
    parser.add_argument("--algorithm", nargs="+", default=["ppo", "sac"])
    parser.add_argument("--out", type=Path, default=Path("runs"))
    return parser.parse_known_args()


def main():
    wanted, further = parse()
    for seed in range(wanted.seeds):
        for (task, algorithm), settings in SETTINGS.items():
            if task not in wanted.task or algorithm not in wanted.algorithm:
                continue
            named = f"--task {task} --algorithm {algorithm} --seed {seed} --out"
            options = train.parse([*named.split(), str(wanted.out), *COMMON.split(), *settings.split(), *further])
            if steps_done(options) < options.steps:
                shutil.rmtree(train.run_folder(options), ignore_errors=True)
                train.run(options)


if __name__ == "__main__":
    main()
