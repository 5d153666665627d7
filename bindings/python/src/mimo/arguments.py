"""Checks of arguments that ctypes or numpy would take silently, or refuse without saying what they expect."""

from __future__ import annotations

import difflib
import inspect
from enum import IntEnum, IntFlag
from functools import reduce, wraps
from operator import or_
from typing import Any, Callable, Iterable, List, Mapping, Optional, Tuple, Type, TypeVar, Union, cast

import numpy as np
from numpy.typing import NDArray

Choice = Union[Type[IntEnum], Type[IntFlag]]
Method = TypeVar("Method", bound=Callable[..., Any])
LONGEST = 60  # longest value that a message quotes


def whole_number(name: str, value: Any, choice: Optional[Choice] = None) -> int:
    """An integer; with `choice` also a member's name, in any case, and for flags several of these."""
    if choice is not None and isinstance(value, str):
        member = choice.__members__.get(value.upper())
        if member is None:
            raise ValueError(f"{name} is {value!r}, expected {_members(choice)}")
        return int(member)
    if choice is not None and issubclass(choice, IntFlag) and isinstance(value, (list, tuple, set, frozenset)):
        return reduce(or_, (whole_number(name, one, choice) for one in value), 0)
    try:
        number = int(value)
        if number == value and (choice is None or abs(number) < 2**32):
            return number
    except (TypeError, ValueError, OverflowError):
        pass
    raise TypeError(f"{name} is {value!r}, expected {'a whole number' if choice is None else _members(choice)}")


def _members(choice: Choice) -> str:
    return f"mimo.{choice.__name__} or a name of its members: {', '.join(choice.__members__).lower()}"


def known_keywords(method: Method) -> Method:
    """Makes errors of unexpected keywords list the known ones and suggest the nearest."""
    known = list(inspect.signature(method).parameters)[1:]

    @wraps(method)
    def checked(*arguments: Any, **options: Any) -> Any:
        for name in options:
            if name not in known:
                raise unexpected(name, known)
        return method(*arguments, **options)

    return cast(Method, checked)


def unexpected(name: str, known: Iterable[str]) -> TypeError:
    """The error for an unknown keyword."""
    known = list(known)
    return TypeError(f"unexpected keyword argument {name!r}{meant(name, known) or '.'} There are: {', '.join(known)}")


def meant(name: str, known: Iterable[str]) -> str:
    """A question for the known name that is like an unknown one, or contains it; nothing if there is none."""
    known = list(known)
    near = difflib.get_close_matches(name, known, 1) or [one for one in known if name and name in one.split("_")][:1]
    return f"; did you mean {near[0]!r}?" if near else ""


def real_number(name: str, value: Any) -> float:
    """A number."""
    try:
        return float(value)
    except (TypeError, ValueError):
        raise TypeError(f"{name} is {value!r}, expected a number") from None


def vector(name: str, value: Any, count: int) -> NDArray[np.float64]:
    """An array of `count` numbers."""
    try:
        numbers = np.ascontiguousarray(value, np.float64)
        if np.shape(value) == (count,):
            return numbers
    except (TypeError, ValueError):
        pass
    raise ValueError(f"{name} is {value!r}, expected {count} numbers")


def numbers_in(name: str, value: Any, shape: Tuple[int, ...], kind: Any = np.float32, what: str = "") -> NDArray[Any]:
    """An array of exactly this shape; numpy would broadcast a single number. `what` tells what the numbers are."""
    if isinstance(value, np.ndarray) and value.dtype == kind and value.shape == shape:
        return value
    try:
        given = np.asarray(value)
    except (TypeError, ValueError):
        given = np.asarray(None)
    if given.dtype.kind not in "biuf":
        raise TypeError(f"{name}: expected numbers of the shape {shape}, not {described(value)}")
    if given.shape != shape:
        raise ValueError(f"{name} of the shape {given.shape}, expected {shape}" + (what and f": {what}"))
    return given.astype(kind)


def described(value: Any) -> str:
    """A value as a message quotes it."""
    said = repr(value)
    return said if len(said) <= LONGEST else f"an object of type {type(value).__name__}"


def reset_options(options: Optional[Mapping[str, Any]], *known: str) -> Mapping[str, Any]:
    """The options of a reset; refuses unknown ones."""
    for name in options or {}:
        if name not in known:
            raise ValueError(f"options has {name!r}, expected {' or '.join(map(repr, known)) or 'none'}")
    return options or {}


def several(name: str, value: Any) -> List[str]:
    """A list of names; a single name may be given as it is."""
    names = [value] if isinstance(value, str) else value
    if not isinstance(names, Iterable) or not all(isinstance(one, str) for one in names):
        raise TypeError(f"{name} is {value!r}, expected names")
    return list(names)


def index_in(name: str, value: Any, count: int) -> int:
    """An index below `count`; ctypes would silently take 2^64 for 0."""
    index = whole_number(name, value)
    if not 0 <= index < count:
        raise ValueError(f"{name} is {value!r}, expected {'0' if count == 1 else f'0 to {count - 1}'}")
    return index


def number_of(name: str, value: Any, bits: int = 32) -> int:
    """A number that fits into so many bits, not negative."""
    number = whole_number(name, value)
    if not 0 <= number < 2**bits:
        raise ValueError(f"{name} is {value!r}, expected 0 to 2^{bits} - 1")
    return number
