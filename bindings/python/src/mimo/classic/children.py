"""Processes that a script starts (SubprocVecEnv, multiprocessing) run as the script does."""

from __future__ import annotations

import multiprocessing
import multiprocessing.spawn
from typing import Any, List

_INSTALL = "import mimo.classic.install; "


def children_too() -> None:
    """Lets processes of multiprocessing import the original's modules, too, however they start."""
    multiprocessing.set_forkserver_preload(["mimo.classic.install"])
    theirs = multiprocessing.spawn.get_command_line
    if getattr(theirs, "_installs", False):
        return

    def command_line(**options: Any) -> List[str]:
        command = list(theirs(**options))
        if "-c" in command:
            place = command.index("-c") + 1
            command[place] = _INSTALL + command[place]
        return command

    command_line._installs = True  # type: ignore[attr-defined]
    multiprocessing.spawn.get_command_line = command_line
