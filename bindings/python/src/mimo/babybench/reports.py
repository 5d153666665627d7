"""Scores of the logs in files and folders."""

from __future__ import annotations

from pathlib import Path
from typing import Any, List, Mapping

from .logs import TRAINING, read
from .scores import Entries, Scores, scores_of


def entries_of(path: Path) -> Entries:
    """The episodes that a log tells of."""
    value = read(path)
    if isinstance(value, Mapping) and "info" in value:  # of one evaluated episode: info of all its steps
        infos = list(value["info"])
        return [{**infos[-1], "steps": len(infos)}] if infos else []
    if isinstance(value, list) and all(isinstance(entry, Mapping) and "steps" in entry for entry in value):
        return value
    raise ValueError(f"{path} is no log: expected a list of episodes with their steps, or an episode with its info")


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
    """One line."""
    if scores.competition is None:
        return f"{name}: {scores.behavior}, {scores.episodes} episodes, no score"
    text = f"{name}: {scores.behavior}, {scores.episodes} episodes; "
    text += f"as the competition computes it {scores.competition:.4f}"
    if scores.right is None or scores.right_mean is None:
        return f"{text}; the log does not tell the right score"
    return f"{text}; right {scores.right:.4f}, mean of single episodes {scores.right_mean:.4f}"
