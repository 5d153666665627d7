"""Draws learning curves: for each task the mean over seeds of each algorithm, and the spread of one standard deviation.

    python learning_curves.py runs --out curves.png --value mean_return training_success

Reads the folders that train.py and babybench.py write, and prints the last values, and of self-body the success by
target.
"""

import argparse
import csv
import re
from collections import defaultdict
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

OF_EPISODES = ["mean_return", "success", "length", "training_return", "training_success"]
VALUES = {
    **{name: f"{name.replace('_', ' ')} of an episode" for name in OF_EPISODES},
    **{"competition": "the competition's score", "right": "right score", "recent_right": "right score of an episode"},
    "reward": "reward of a step",
}
NAMES = {
    "reach": "reaching",
    "standup": "standing up",
    "selfbody": "self-body",
    "catch": "catching",
    "rollover": "rolling over",
    "selftouch": "self-touch",
    "handregard": "hand regard",
}
ALGORITHMS = {"ppo": "PPO", "sac": "SAC", "random": "random actions", "intrinsic": "PPO, a reward of its own"}


def read(folder, value):
    """{task: {algorithm: [(steps, values) of each seed]}}"""
    curves = defaultdict(lambda: defaultdict(list))
    for file in sorted(folder.glob("*/curve.csv")):
        named = re.fullmatch(r"(\w+)-(\w+)-(\d+)", file.parent.name)
        rows = np.atleast_1d(np.genfromtxt(file, delimiter=",", names=True))
        rows = rows[np.isfinite(rows[value])]  # training has no values before its first episode has ended
        if named and rows.size:
            curves[named[1]][named[2]].append((rows["steps"], rows[value]))
    return curves


def over_seeds(runs):
    """Steps, mean and standard deviation, as far as all seeds have got."""
    last = min(steps[-1] for steps, _ in runs)
    grid = runs[0][0][runs[0][0] <= last]
    values = np.array([np.interp(grid, steps, value) for steps, value in runs])
    return grid, values.mean(axis=0), values.std(axis=0)


def draw_curves(place, task, algorithms, value):
    for algorithm, runs in sorted(algorithms.items()):
        steps, mean, spread = over_seeds(runs)
        seeds = "1 seed" if len(runs) == 1 else f"{len(runs)} seeds"
        (line,) = place.plot(steps, mean, label=f"{ALGORITHMS.get(algorithm, algorithm)} ({seeds})")
        place.fill_between(steps, mean - spread, mean + spread, color=line.get_color(), alpha=0.2, linewidth=0)
        print(f"{task} {algorithm}, {seeds}: {value} {mean[-1]:.3f} +- {spread[-1]:.3f} at {steps[-1]:.0f} steps")


def print_targets(folder):
    """Of the last evaluations: how often each target was touched, by all seeds of an algorithm together."""
    counts = defaultdict(lambda: np.zeros(2, int))
    for file in sorted(folder.glob("*/targets.csv")):
        algorithm = file.parent.name.split("-")[1]
        with file.open(newline="") as rows:
            for row in csv.DictReader(rows):
                counts[algorithm, row["target"]] += int(row["successes"]), int(row["episodes"])
    for (algorithm, target), (successes, episodes) in sorted(counts.items()):
        print(f"{algorithm}, {target}: {successes} of {episodes}")


def draw(folder, values):
    """A row for each value, a column for each task."""
    rows = [sorted(read(folder, value).items()) for value in values]
    if not rows[0]:
        raise SystemExit(f"there are no curves in {folder}")
    size = (4 * len(rows[0]), 0.4 + 2.8 * len(rows))
    counts = len(rows), len(rows[0])
    figure, axes = plt.subplots(*counts, figsize=size, sharex="col", squeeze=False, layout="constrained")
    for places, value, tasks in zip(axes, values, rows):
        for place, (task, algorithms) in zip(places, tasks):
            draw_curves(place, task, algorithms, value)
        places[0].set_ylabel(VALUES[value])
    for place, (task, _) in zip(axes[0], rows[0]):
        place.set_title(NAMES.get(task, task))
        place.legend(fontsize=8)
    for place in axes[-1]:
        place.set_xlabel("steps")
    return figure


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("runs", type=Path)
    parser.add_argument("--out", type=Path, default=Path("curves.png"))
    parser.add_argument("--value", nargs="+", default=["mean_return"], choices=VALUES)
    options = parser.parse_args()
    draw(options.runs, options.value).savefig(options.out, dpi=150)
    print_targets(options.runs)
