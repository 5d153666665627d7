"""Numbers that the guides tell of runs whose data are kept beside them: means and deviations over seeds; and what
senses cost, which ./dev ratios guards."""

import csv
import json

import numpy as np
import pytest
from guide import ROOT, Page


def last(folder, task, steps=None):
    """Of each seed the row of that many steps, or its last one."""
    rows = []
    for path in sorted((ROOT / "docs/data" / folder).glob(f"{task}-*/curve.csv")):
        with open(path) as file:
            curve = list(csv.DictReader(file))
        at = [row for row in curve if steps is None or abs(int(row["steps"]) - steps) <= 0.01 * steps]
        rows += at[-1:]
    return rows


def spread(rows, column):
    values = [float(row[column]) for row in rows if row.get(column) not in (None, "", "nan")]
    return np.mean(values), np.std(values)


FIGURE = [
    ("reach | PPO", "reach-ppo"),
    ("reach | SAC", "reach-sac"),
    ("standing up | PPO", "standup-ppo"),
    ("standing up | SAC", "standup-sac"),
    ("self-body, every 50 ms | PPO", "selfbody-ppo"),
    ("self-body, every 50 ms | SAC", "selfbody-sac"),
]


@pytest.mark.parametrize(("row", "task"), FIGURE)
def test_figure_4(row, task):
    rows = last("figure4", task)
    columns = [spread(rows, column) for column in ("mean_return", "success", "training_success")]
    claim = f"\n| {row} | 10 | {{}} | {{}} +- {{}} | {{}} +- {{}} | {{}} +- {{}} |"
    assert len(rows) == 10
    Page("learning.md").says(claim, max(int(it["steps"]) for it in rows), *np.ravel(columns))


FIRST = [
    ("| reach | PPO |", "reach-ppo", 100000),
    ("| | SAC, `--updates 4` |", "reach-sac", 100000),
    ("| standing up | PPO |", "standup-ppo", 100000),
    ("| | SAC, `--updates -1` |", "standup-sac", 100000),
    ("| self-body | PPO |", "selfbody-ppo", 100000),
    ("| | SAC, `--updates 1` |", "selfbody-sac", 100000),
]


@pytest.mark.parametrize(("row", "task", "steps"), FIRST)
def test_first_runs(row, task, steps):
    rows = last("learning", task, steps)
    columns = [spread(rows, column) for column in ("mean_return", "success", "training_success")]
    claim = f"\n{row} 3 | {steps} | {{}} +- {{}} | {{}} +- {{}} | {{}} +- {{}}"
    assert len(rows) == 3
    Page("learning.md").says(claim, *np.ravel(columns))


def test_the_cohort():
    """The page's tables of shares are means over seeds of the data."""
    with open(ROOT / "docs/data/cohort/cohort.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    lines = (ROOT / "docs/cohort.md").read_text(encoding="utf-8").splitlines()
    told = [[cell.strip() for cell in line.strip("|").split("|")] for line in lines if line.startswith("| ")]
    names = {row["behaviour"] for row in rows}

    def check(behaviour, strength, ages, cells):
        key = (behaviour, strength)
        for age, cell in zip(ages, cells):
            mine = [row for row in rows if (row["behaviour"], row["strength"]) == key and float(row["age"]) == age]
            shares = [float(row["success"]) for row in mine]
            assert (cell == "") == (not shares), (behaviour, strength, age)
            assert not shares or float(cell) == pytest.approx(np.mean(shares), abs=0.0051), (behaviour, strength, age)

    for width in (4, 10):  # the band of strengths; all ages at the middle strength
        table = {cells[0].replace(" ", "-"): cells[1:] for cells in told if len(cells) == width}
        assert names <= set(table)
        for behaviour in names:
            if width == 10:
                check(behaviour, "middle", (0, 3, 6, 9, 12, 15, 18, 24), table[behaviour][:8])
                continue
            for strength, cell in zip(("low", "middle", "high"), table[behaviour]):
                check(behaviour, strength, (3, 6, 12, 24), cell.split(" / "))


def test_costs():
    ratios = json.loads((ROOT / "tests/bench/ratios.json").read_text())["ratios"]
    Page("guide/hearing.md").says(
        "both ears and bands take {} of a step without eyes", ratios["hearing, over the step without eyes"]
    )
    page = Page("guide/skin.md")
    page.says("this page takes {} of a step without eyes", ratios["receptors of skin, over the step without eyes"])
    page.says("receptors of muscles and joints {}.", ratios["all receptors, over the step without eyes"])
    page.says("Caresses alone take {}:", round(ratios["caresses of skin, over the step without eyes"], 2))
    Page("guide/recordings.md").says(
        "the compression: {} of a step without eyes", ratios["recorded, over the step without eyes"]
    )
    Page("guide/maturity.md").says(
        "a newborn's nerves take {} of a step without eyes",
        ratios["a newborn's nerves, over the step without eyes"],
    )
