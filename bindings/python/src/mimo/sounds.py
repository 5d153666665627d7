"""Sounds that a host plays in a world."""

from __future__ import annotations

import ctypes
from typing import Any, Callable, Optional

import numpy as np
from numpy.typing import ArrayLike

from ._library import check, utf8
from .arguments import real_number
from .layout import Layout


def play(
    call: Callable[..., int], handle: Any, layout: Layout, body: str, samples: ArrayLike, rate: Optional[float]
) -> None:
    """Plays samples; the default rate is that of the ears."""
    given = np.asarray(samples)
    if given.size > 0 and given.dtype.kind != "f":
        raise TypeError(
            f"samples are {given.dtype}, expected pascals at 1 m as floating-point numbers; "
            "divide a recording by its full scale, and multiply by the pressure of full scale"
        )
    wave = np.ascontiguousarray(given, dtype=np.float32)
    if wave.ndim != 1:
        raise ValueError(f"samples has shape {wave.shape}, expected one number a sample")
    at = rate_of(layout) if rate is None else real_number("rate", rate)
    check(call(handle, utf8(body), wave.ctypes.data_as(ctypes.c_void_p), wave.size, at))


def rate_of(layout: Layout) -> float:
    """Samples per second of the ears' fields; 16000 without such a field."""
    rates = [field.sample_rate for field in layout.fields.values() if field.sample_rate > 0]
    return rates[0] if rates else 16000.0
