"""The maturity of eyes and nerves, in numbers."""

from __future__ import annotations

import ctypes
from dataclasses import asdict, dataclass
from typing import Optional

from . import _abi
from ._library import LIB, check, defaults, from_struct
from .arguments import real_number


@dataclass(frozen=True)
class Maturity:
    """The maturity of an infant's eyes and nerves. The defaults are perfect eyes and nerves without delay.

    The delay of a nerve is its length / conduction_speed plus the delay in the brain.
    dataclasses.replace(mimo.Maturity.at(3), chroma=1) changes one number.
    """

    acuity: float = 0  # finest visible lines, cycles per degree; 0: no limit
    peak_contrast: float = 2  # highest contrast sensitivity
    chroma: float = 1  # visible share of colour, 0 (grey) to 1
    flicker: float = 0  # Hz: faster changes fade; 0: no limit
    contrast_threshold: bool = False  # removes contrasts below the eyes' threshold
    conduction_speed: float = 0  # of large nerve fibres, m/s; 0: no delay
    sensory_delay: float = 0  # from the brain stem to the cortex, s
    motor_delay: float = 0  # from the cortex to the brain stem, s
    vision_delay: float = 0  # from the eye to the cortex, s
    vestibular_delay: float = 0  # from the inner ear to the brain stem, s
    hearing_delay: float = 0  # from the ear to the cortex, s

    @classmethod
    def at(cls, age: float) -> Maturity:
        """The maturity of an age, 0 (a newborn) to 24 months; flicker and contrast_threshold stay off."""
        raw = _abi.Maturity()
        check(LIB.mimo_maturity_at(real_number("age", age), raw, ctypes.sizeof(raw)))
        return from_struct(cls, raw)


def maturity_from(maturity: Optional[Maturity]) -> Optional[_abi.Maturity]:
    """The C struct; None: by the infant's age."""
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
