"""Draws self_touch.png: the score of self-touch under random actions, here and in the competition's kit.

    python -m mimo.classic examples/python/kit_selftouch.py --config CONFIG.yml --out selftouch.csv
    python docs/images/make_self_touch.py selftouch.csv

CONFIG.yml is the competition's, or bindings/python/src/mimo/babybench/configs/selftouch.yml. The kit's episodes were
recorded with its pinned packages and the same seeds: tests/golden/babybench.
"""

import csv
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

HERE = Path(__file__).resolve().parent
RECORDED = HERE.parents[1] / "tests/golden/babybench/random_policy.csv"


def kit():
    """The score after each recorded episode: the geoms of both hands in all of them so far, of 68."""
    right, left, scores = set(), set(), []
    with open(RECORDED) as file:
        for row in csv.DictReader(file):
            if row["config"] == "crib self_touch":
                right |= set(row["right_hand_geoms_in_order"].split())
                left |= set(row["left_hand_geoms_in_order"].split())
                scores.append((len(right) + len(left)) / 68)
    return scores


def main():
    with open(sys.argv[1]) as file:
        here = [float(row["score"]) for row in csv.DictReader(file)]
    figure, axes = plt.subplots(figsize=(6, 3), layout="constrained")
    for scores, label, color in ((kit(), "the competition's kit", "tab:gray"), (here, "libmimo", "tab:blue")):
        axes.step(range(1, len(scores) + 1), scores, where="post", label=label, color=color)
    axes.set(
        xlabel="episodes of 1000 steps",
        ylabel="score of self-touch",
        ylim=(0, 0.15),
        xlim=(1, 20),
        xticks=(1, 5, 10, 15, 20),
    )
    axes.legend(frameon=False, loc="lower right")
    figure.savefig(HERE / "self_touch.png", dpi=110)


if __name__ == "__main__":
    main()
