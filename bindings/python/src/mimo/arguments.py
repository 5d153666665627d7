"""Checks of arguments that ctypes or numpy would take silently, or refuse without a word of what was expected."""

from __future__ import annotations

from enum import IntEnum, IntFlag
from typing import Any, Optional, Type, Union

import numpy as np
from numpy.typing import NDArray

Choice = Union[Type[IntEnum], Type[IntFlag]]


def whole_number(name: str, value: Any, choice: Optional[Choice] = None) -> int:
    """An integer; where an enum is taken also the name of a member, in any case."""
    if choice is not None and isinstance(value, str):
        member = choice.__members__.get(value.upper())
        if member is None:
            raise ValueError(f"{name} is {value!r}, expected {_members(choice)}")
        return int(member)
    try:
        number = int(value)
        if number == value:
            return number
    except (TypeError, ValueError, OverflowError):
        pass
    raise TypeError(f"{name} is {value!r}, expected {'a whole number' if choice is None else _members(choice)}")


def ordinal(name: str, value: Any) -> int:
    """The number of a world, an agent, a step...; ctypes would take it modulo 2^64, so that 2^70 were 0."""
    number = whole_number(name, value)
    if not 0 <= number < 2**31:
        raise ValueError(f"{name} is {value!r}, expected a number from 0 to 2^31 - 1")
    return number


def _members(choice: Choice) -> str:
    return f"mimo.{choice.__name__} or a name of its members: {', '.join(choice.__members__).lower()}"


def real_number(name: str, value: Any) -> float:
    """A number."""
    try:
        return float(value)
    except (TypeError, ValueError):
        raise TypeError(f"{name} is {value!r}, expected a number") from None


def vector(name: str, value: Any, count: int) -> NDArray[np.float64]:
    """So many numbers, as an array."""
    try:
        numbers = np.ascontiguousarray(value, np.float64)
        if np.shape(value) == (count,):
            return numbers
    except (TypeError, ValueError):
        pass
    raise ValueError(f"{name} is {value!r}, expected {count} numbers")
