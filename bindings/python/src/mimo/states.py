"""What a state did not hold of the world that loaded it."""

from __future__ import annotations

import ctypes
from typing import Any, NamedTuple, Tuple

from . import _abi
from ._library import check, result


class LoadReport(NamedTuple):
    """Names of sections of a state: memories that started fresh, and those that nobody here has."""

    fresh: Tuple[str, ...]
    ignored: Tuple[str, ...]


def reported(load: Any, *arguments: Any) -> LoadReport:
    """Calls a function that loads, and tells what it reports."""
    report = _abi.LoadReport()
    check(load(*arguments, report))
    return LoadReport(_names(report.fresh_names), _names(report.ignored_names))


def saved(handle: Any, size_of: Any, save: Any) -> bytes:
    """What a function that saves writes."""
    state = ctypes.create_string_buffer(result(ctypes.c_size_t, size_of, handle))
    check(save(handle, state, len(state)))
    return state.raw


def _names(joined: bytes) -> Tuple[str, ...]:
    return tuple(joined.decode().split(", ")) if joined else ()
