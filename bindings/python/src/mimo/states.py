"""Saving and loading of states."""

from __future__ import annotations

import ctypes
from typing import Any, NamedTuple, Tuple

from . import _abi
from ._library import check, result


class LoadReport(NamedTuple):
    """Memories by name: those that started fresh, and those of the state that were ignored."""

    fresh: Tuple[str, ...]
    ignored: Tuple[str, ...]


def reported(load: Any, *arguments: Any) -> LoadReport:
    """Calls a function that loads a state, and returns its report."""
    report = _abi.LoadReport()
    check(load(*arguments, report))
    return LoadReport(_names(report.fresh_names), _names(report.ignored_names))


def saved(handle: Any, size_of: Any, save: Any) -> bytes:
    """Calls a function that saves a state, and returns the bytes."""
    state = ctypes.create_string_buffer(result(ctypes.c_size_t, size_of, handle))
    check(save(handle, state, len(state)))
    return state.raw


def _names(joined: bytes) -> Tuple[str, ...]:
    return tuple(joined.decode().split(", ")) if joined else ()
