#!/usr/bin/env python3
"""Draws what `mimo-bench --paper --csv FILE` measured as the bars of the paper's Fig. 3.

    tests/bench/plot_paper.py paper.csv benchmark.png

Each bar is the real time that a simulated hour takes, split by what took it; below the line it is faster than real time.
"""
import csv
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

PARTS = ("physics", "touch", "vision", "proprioception", "vestibular", "other")
STEP_MS = 10.0  # of simulated time


def read(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def draw(rows, path):
    labels = [f"V{row['vision_px']}\nT{row['touch_scale']}" for row in rows]
    figure, axes = plt.subplots(figsize=(7, 4), layout="constrained")
    below = [0.0] * len(rows)
    for part in PARTS:
        hours = [float(row[f"{part}_ms"]) / STEP_MS for row in rows]
        axes.bar(labels, hours, bottom=below, label=part)
        below = [low + height for low, height in zip(below, hours)]
    axes.axhline(1, color="black", linestyle="--", linewidth=1)
    axes.annotate("real time", (0, 1), xytext=(0, 3), textcoords="offset points", ha="center")
    axes.set_ylabel("time for a simulated hour (h)")
    axes.set_xlabel("pixels a side of each eye, density of touch")
    axes.legend()
    figure.savefig(path, dpi=150)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    draw(read(sys.argv[1]), sys.argv[2])
