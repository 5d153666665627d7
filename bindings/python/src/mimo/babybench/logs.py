"""Logs of training and evaluation, in the competition's format: pickled lists and dicts.

A pickle can hold programs. This module reads numbers, strings, lists, dicts and arrays, and refuses anything else.
"""

from __future__ import annotations

import pickle
from pathlib import Path
from typing import Any, Dict, List, Mapping, Optional

from .._files import new_file
from .pickled import loads

Entry = Dict[str, Any]
TRAINING = "training.pkl"


def read(path: Path) -> Any:
    """The content of a log."""
    try:
        return loads(path.read_bytes())
    except ValueError as error:
        raise ValueError(f"{path} is not a log: {' '.join(str(error).split())}") from None


def write(path: Path, value: Any) -> None:
    """Writes a complete log or nothing."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with new_file(path) as file:
        file.write_bytes(pickle.dumps(value, protocol=4))


def log_of(config: Mapping[str, Any]) -> "TrainingLog":
    """The log of a run in the configuration's folder, or None without a folder."""
    folder = None if config["save_dir"] is None else Path(config["save_dir"]) / "logs"
    return TrainingLog(folder, config["save_logs_every"])


class TrainingLog:
    """A log with one entry per episode, written every few steps (0: never) and when it is closed.

    A log of an earlier run is kept beside it (training_1.pkl, ...).
    """

    def __init__(self, folder: Optional[Path], every: int) -> None:
        self.entries: List[Entry] = []
        self._path = None if folder is None else folder / TRAINING
        self._every, self._unwritten, self._fresh = every, 0, True

    def add(self, entry: Entry) -> None:
        """Appends an ended episode."""
        self.entries.append(entry)
        self._unwritten += int(entry["steps"])
        if 0 < self._every <= self._unwritten:
            self.flush()

    def flush(self) -> None:
        """Writes the log."""
        if self._path is None or not any(entry["steps"] for entry in self.entries):
            return
        if self._fresh:
            _put_aside(self._path)
        self._fresh, self._unwritten = False, 0
        write(self._path, self.entries)


def _put_aside(path: Path) -> None:
    if path.exists():
        number = 1
        while (other := path.with_name(f"{path.stem}_{number}.pkl")).exists():
            number += 1
        path.rename(other)
