"""Draws growth_curves.png: length, weight and head of the model's infants, and the WHO's tables as points.

Needs the Python package and matplotlib. The tables are those of the tests, tests/golden/growth.
"""

import csv
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import mimo

HERE = Path(__file__).resolve().parent
TABLES = HERE.parents[1] / "src/growth/who_lms.csv"
MONTHS = np.arange(0, 24.01, 1.5)
SEXES = {"female": "f", "male": "m"}
COLORS = {"female": "tab:orange", "male": "tab:blue"}


def standard(measure, sex):
    """Months, and the values at z = -2, 0 and 2: M (1 + L S z)^(1/L)."""
    with open(TABLES) as file:
        rows = [row for row in csv.DictReader(file) if (row["measure"], row["sex"]) == (measure, sex)]
    table = np.array([[float(row[name]) for name in ("age_months", "L", "M", "S")] for row in rows]).T
    months, power, median, spread = table
    return months, [median * (1 + power * spread * z) ** (1 / power) for z in (-2, 0, 2)]


def infant(age, sex, z):
    """Length (cm), weight (kg) and the head's circumference (cm) of the model."""
    growth = {"age": age, "sex": sex, "z_length": z, "z_weight": z, "z_head": z, "absolute": True}
    with mimo.World("free", vision=False, touch=False, renderer="none", **growth) as world:
        head = np.ravel(world.geoms("head").size)[0]
        body = world.agents[0]
    base_head, measured = 0.0735, 46.80675  # m and cm, of the body and of the WHO's mean at 18 months
    return 100 * body.height, body.mass, head / base_head * measured


figure, panels = plt.subplots(1, 3, figsize=(12, 4), layout="constrained")
for sex, letter in SEXES.items():
    lines = np.array([[infant(age, sex, z) for age in MONTHS] for z in (-2, 0, 2)])
    for index, (panel, measure) in enumerate(zip(panels, ("length", "weight", "head_circumference"))):
        months, values = standard(measure, letter)
        for z, points in zip(range(3), values):
            panel.plot(MONTHS, lines[z, :, index], color=COLORS[sex], label=sex if z == 1 else None)
            panel.plot(months, points, ".", color=COLORS[sex], markersize=4)
for panel, title in zip(panels, ("length, cm", "weight, kg", "head's circumference, cm")):
    panel.set(title=title, xlabel="age, months", xticks=range(0, 25, 3))
    panel.grid(alpha=0.3)
panels[0].legend(title="lines: model, points: WHO\nat z = -2, 0, 2")
figure.savefig(HERE / "growth_curves.png", dpi=100)
