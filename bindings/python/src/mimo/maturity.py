"""How mature eyes and nerves are, in numbers."""

from __future__ import annotations

import ctypes
from dataclasses import asdict, dataclass
from typing import Optional

from . import _abi
from ._library import LIB, check, defaults, from_struct
from .arguments import real_number


@dataclass(frozen=True)
class Maturity:
    """How mature an infant's eyes and nerves are; by itself perfect eyes, and nerves that take no time.

    A nerve of some length is late by length / conduction_speed, and by what its way through the brain adds.
    dataclasses.replace(mimo.Maturity.at(3), chroma=1) changes one number.
    """

    acuity: float = 0  # the finest lines that are seen, cycles per degree; 0: pictures as drawn
    peak_contrast: float = 2  # the greatest contrast sensitivity
    chroma: float = 1  # share of colour that is seen, 0 (grey) to 1
    flicker: float = 0  # Hz: faster changes are seen less and less; 0: all
    contrast_threshold: bool = False  # contrasts too faint for such eyes are gone
    conduction_speed: float = 0  # of large nerve fibres, m/s; 0: they take no time
    sensory_delay: float = 0  # from the brain stem to the cortex, s
    motor_delay: float = 0  # from the cortex to the brain stem, s
    vision_delay: float = 0  # from the eye to the cortex, s
    vestibular_delay: float = 0  # from the inner ear to the brain stem, s
    hearing_delay: float = 0  # from the ear to the cortex, s

    @classmethod
    def at(cls, age: float) -> Maturity:
        """That of an age, 0 (a newborn) to 24 months; flicker and contrast_threshold, which are options, stay off."""
        raw = _abi.Maturity()
        check(LIB.mimo_maturity_at(real_number("age", age), raw, ctypes.sizeof(raw)))
        return from_struct(cls, raw)


def maturity_from(maturity: Optional[Maturity]) -> Optional[_abi.Maturity]:
    """What the library is told of it; None: as old as the infant."""
    if maturity is None:
        return None
    if not isinstance(maturity, Maturity):
        raise TypeError(f"maturity is {maturity!r}, expected a mimo.Maturity or None")
    raw = defaults(_abi.Maturity)
    numbers = asdict(maturity)
    raw.contrast_threshold = bool(numbers.pop("contrast_threshold"))
    for name, value in numbers.items():
        setattr(raw, name, real_number(name, value))
    return raw
