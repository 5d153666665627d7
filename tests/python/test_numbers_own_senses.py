"""Numbers of the guide "Write a sense", out of its examples as they are run."""

import importlib
import json
import sys

import numpy as np
import pytest
from guide import ROOT, Page
from sense_libraries import SENSES, sense_library

PAGE = "guide/write-a-sense.md"


def example(name, monkeypatch):
    monkeypatch.setitem(sys.modules, name, None)
    monkeypatch.delitem(sys.modules, name)
    monkeypatch.syspath_prepend(str(SENSES))
    return importlib.import_module(name)


def test_kicks_beside_those_of_infants(monkeypatch):
    kicks = example("kicks", monkeypatch)
    rows = kicks.measured(sense_library("imu"), 120)
    touched = rows[:, 3] > 0
    page = Page(PAGE)
    for column, (name, study) in enumerate(kicks.STUDY.items()):
        values = rows[:, column]
        here = (values.mean(), np.median(values), values[touched].mean(), values[~touched].mean())
        words = name.replace("mean,", "mean acceleration,").replace("peak,", "peak acceleration,")
        page.says(f"| {words} | {{}} to {{}} | {{}} | {{}} | {{}} | {{}} |", *study, *here)
    page.says("which it does in {} % of these movements", 100 * touched.mean())
    page.says("With all {} samples a second", kicks.RATE)
    page.says("out of {} samples a second", kicks.KEPT)
    page.says("an infant of {} months that babbles on its back for {} s", 6, 120)
    # What the page says in words: means within the study's range, and peaks of legs that are free.
    for column in (1, 2):
        low, high = list(kicks.STUDY.values())[column]
        assert low <= (rows[~touched, column] if column == 2 else rows[:, column]).mean() <= high
    assert rows[touched, 2].mean() > rows[~touched, 2].mean() * 1.25


# A cycle of 0.5 s in each second, about gravity. By hand: of 20 samples a second, the third and the fourth are the
# highest, sin(72 degrees) = 0.951 of the size. The peaks 1.90, 2.38, 2.85, 2.38, 1.90 have the mean 2.28 and the
# deviation 0.36: the first and the last one do not reach 1.93. The others last from the first sample above 0 to that
# after the cycle.
def test_a_movement_is_a_cycle_of_the_acceleration(monkeypatch):
    kicks = example("kicks", monkeypatch)
    time = np.arange(100) / kicks.KEPT
    sizes = np.array([2.0, 2.5, 3.0, 2.5, 2.0])[time.astype(int)]
    wave = sizes * np.where(time % 1 < 0.49, np.sin(2 * np.pi * time / 0.5), 0)
    turning = np.ones(len(time))
    assert kicks.movements(wave, turning) == [(21, 30), (41, 50), (61, 70)]
    assert [(end - start) / kicks.KEPT for start, end in kicks.movements(wave, turning)] == [0.45] * 3
    assert kicks.movements(wave, -turning) == []  # the leg does not turn
    assert kicks.movements(0.3 * wave, turning) == []  # no peak reaches 1 m/s^2
    half = np.where(time % 1 < 0.24, wave, 0)
    assert kicks.movements(half, turning) == []  # one direction only


def test_strokes(monkeypatch):
    pytest.importorskip("matplotlib", reason="matplotlib is not installed")
    stroke = example("stroke", monkeypatch)
    library = sense_library("ct")
    by_speed = [stroke.rate(library, speed, 32, 1) for speed in stroke.SPEEDS]
    by_warmth = [stroke.rate(library, 0.01, celsius, 3) for celsius in (18, 32, 42)]
    page = Page(PAGE)
    page.says("| Hz | {} | {} | {} | {} | {} | {} | {} | {} |", *by_speed, *by_warmth)
    row = "| stroke | {} cm/s | {} | {} | {} | {} | {} degrees ({} cm/s) | {} | {} |"
    page.says(row, *(100 * np.array(stroke.SPEEDS)), 18, 1, 32, 42)
    page.tested("their signals travel at {} m/s", "consumer/senses/ct_test.cpp")
    page.tested("Set `touch_slip_threshold` to {},", "consumer/senses/check.hpp")


def test_what_a_sense_costs():
    ratios = json.loads((ROOT / "tests/bench/ratios.json").read_text())["ratios"]
    Page(PAGE).says(
        "takes {} of the bare physics of a pendulum", round(ratios["a user's empty sense, over that physics"], 1)
    )
