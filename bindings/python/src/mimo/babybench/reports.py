"""Scores of the logs in files and folders."""

from __future__ import annotations

from pathlib import Path
from reprlib import repr as short
from typing import Any, List, Mapping

import numpy as np

from .counts import REGARD_KEYS, TOUCH_KEYS
from .described import COUNTED
from .logs import TRAINING, read
from .scores import Entries, Scores, scores_of

LARGEST = 2**53  # largest integer below which all are floats


def entries_of(path: Path) -> Entries:
    """The episodes in a log."""
    value = read(path)
    if isinstance(value, Mapping) and isinstance(value.get("info"), list):  # all steps of one evaluated episode
        infos = value["info"]
        value = [{**infos[-1], "steps": len(infos)}] if infos and isinstance(infos[-1], Mapping) else infos
    if not isinstance(value, list) or not all(isinstance(entry, Mapping) and "steps" in entry for entry in value):
        raise ValueError(f"{path} is not a log: expected a list of episodes with steps, or an episode with info")
    for number, entry in enumerate(value):
        _check_measured(path, number, entry)
        for key in ("steps", *REGARD_KEYS):
            if not _is_count(entry.get(key, 0)):
                raise ValueError(
                    f"{path} is not a log: {key} of episode {number} is {short(entry[key])}, expected a count"
                )
        for key in TOUCH_KEYS:
            geoms = entry.get(key, ())
            listed = isinstance(geoms, (list, tuple)) or (isinstance(geoms, np.ndarray) and geoms.ndim == 1)
            if not listed or not all(map(_is_count, geoms)):
                raise ValueError(
                    f"{path} is not a log: {key} of episode {number} is {short(geoms)}, expected numbers of geoms"
                )
    return value


def _check_measured(path: Path, number: int, entry: Mapping[str, Any]) -> None:
    """Of a behaviour that a scene describes."""
    if "reached" not in entry:
        return
    for key, right, expected in (
        ("held_seconds", _is_count, "seconds from 0 on"),
        ("hold_seconds", _is_count, "seconds from 0 on"),
        ("reached", lambda value: value in (False, True), "true or false"),
        ("behavior", lambda value: isinstance(value, str), "a name"),
    ):
        value = entry.get(key)
        if not right(value):
            raise ValueError(f"{path} is not a log: {key} of episode {number} is {short(value)}, expected {expected}")


def _is_count(value: Any) -> bool:
    return isinstance(value, (int, float, np.integer, np.floating)) and bool(0 <= value < LARGEST)


def scores_in(place: Path) -> "dict[str, Scores]":
    """Scores of the training, and of all evaluated episodes together."""
    if place.is_file():
        return {place.name: scores_of(entries_of(place))}
    folder = place / "logs" if (place / "logs").is_dir() else place
    training, evaluations = folder / TRAINING, sorted(folder.glob("evaluation_*.pkl"))
    if not training.is_file() and not evaluations:
        raise FileNotFoundError(f"LOGS is {str(place)!r}, expected a log, or a folder with {TRAINING}")
    found = {training.name: scores_of(entries_of(training))} if training.is_file() else {}
    if evaluations:
        episodes: List[Any] = [entry for file in evaluations for entry in entries_of(file)]
        # The competition scores logs of training only, and leaves out their first entry; here all episodes count.
        found["evaluation"] = scores_of([{"steps": 0}, *episodes])
    return found


def report(name: str, scores: Scores) -> str:
    """A report in one line."""
    if scores.competition is None:
        return f"{name}: {scores.behavior}, {scores.episodes} episodes, no score"
    text = f"{name}: {scores.behavior}, {scores.episodes} episodes; "
    if scores.behavior not in COUNTED:
        text += (
            f"reached in {scores.right:.4f} of them, in {scores.competition:.4f} of those that the competition counts"
        )
        return f"{text}; held for {scores.right_mean:.4f} of the time, mean of single episodes"
    text += f"as the competition computes it {scores.competition:.4f}"
    if scores.right is None or scores.right_mean is None:
        return f"{text}; the log does not tell the right score"
    return f"{text}; right {scores.right:.4f}, mean of single episodes {scores.right_mean:.4f}"
