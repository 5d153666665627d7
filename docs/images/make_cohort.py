#!/usr/bin/env python3
"""make_cohort.py [DATA]: draws cohort.png, what infants of each age learned, beside the ages at which infants show it.

DATA is cohort.csv of examples/python/cohort.py, by default docs/data/cohort/cohort.csv. Ages of infants, with their
sources, are those of the scenes: mimo info --tasks. Needs Matplotlib.
"""

import csv
import sys
from collections import defaultdict
from pathlib import Path

import matplotlib.pyplot as plt

import mimo

IMAGES = Path(__file__).resolve().parent
ORDER = ["roll-to-back", "roll-to-belly", "sit", "stand-with-support", "crawl", "walk-with-help", "stand", "walk"]
OLDEST = 24  # months
STRENGTHS = {  # in colours and words
    "low": ("tab:red", "--", "half the strength, mean"),
    "middle": ("tab:blue", "-", "mean of seeds"),
    "high": ("tab:green", "--", "twice the strength, mean"),
}


def runs(path):
    """By behaviour and strength: of each age the shares of success of all seeds."""
    found = defaultdict(lambda: defaultdict(lambda: defaultdict(list)))
    with open(path, newline="") as file:
        for row in csv.DictReader(file):
            found[row["behaviour"]][row["strength"]][float(row["age"])].append(float(row["success"]))
    return found


def draw(axes, name, of_strengths):
    behaviour = mimo.Scene(name).behaviour()
    norm = behaviour.norm
    if norm.early and norm.late:
        axes.axvspan(norm.early, norm.late, color="tab:orange", alpha=0.18, lw=0, label="WHO: 1st to 99th percentile")
    if norm.age:
        axes.axvline(norm.age, color="tab:orange", lw=1.2, label="the middle infant")
    for strength, (color, style, word) in STRENGTHS.items():
        shares = sorted(of_strengths[strength].items())
        if strength == "middle":
            seeds = [(age, share) for age, all_of in shares for share in all_of]
            axes.plot(*zip(*seeds), "o", color=color, ms=3, alpha=0.35, label="a seed")
        mean = [(age, sum(all_of) / len(all_of)) for age, all_of in shares]
        axes.plot(*zip(*mean), style, color=color, lw=2.2 if strength == "middle" else 1.2, label=word)
    axes.set(title=behaviour.about, xlim=(-0.7, OLDEST + 0.7), ylim=(-0.04, 1.04))
    axes.title.set_fontsize(9)
    axes.set_xticks(range(0, OLDEST + 1, 6))


def main():
    data = Path(sys.argv[1]) if len(sys.argv) > 1 else IMAGES.parent / "data/cohort/cohort.csv"
    found = runs(data)
    figure, grid = plt.subplots(2, 4, figsize=(12, 5), sharex=True, sharey=True, layout="constrained")
    for axes, name in zip(grid.flat, [name for name in ORDER if name in found]):
        draw(axes, name, found[name])
    for axes in grid[-1]:
        axes.set_xlabel("age, months")
    for axes in grid[:, 0]:
        axes.set_ylabel("share that succeeds")
    handles = {label: handle for axes in grid.flat for handle, label in zip(*axes.get_legend_handles_labels())}
    figure.legend(handles.values(), handles.keys(), loc="outside lower center", ncols=4, fontsize=8, frameon=False)
    figure.savefig(IMAGES / "cohort.png", dpi=90)


if __name__ == "__main__":
    main()
