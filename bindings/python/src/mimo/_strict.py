"""Refuses assignments without effect: to unknown attributes, and into arrays that are copies."""

from __future__ import annotations

import difflib
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

PACKAGE = __name__.split(".")[0]


class Strict:
    """Refuses unknown attributes; classes that users derive may have their own."""

    def __setattr__(self, name: str, value: Any) -> None:
        kind: Any = type(self)
        if not _assignable(kind, name):
            raise AttributeError(_refusal(kind, name))
        object.__setattr__(self, name, value)

    def _have(self, **attributes: Any) -> None:
        """Sets attributes that users read but do not assign."""
        self.__dict__.update(attributes)


@lru_cache(maxsize=None)
def _assignable(kind: Any, name: str) -> bool:
    own = kind.__module__.split(".")[0] != PACKAGE
    return own or name.startswith("_") or hasattr(_in_class(kind, name), "__set__")


def _in_class(kind: type, name: str) -> Any:
    return next((vars(base)[name] for base in kind.__mro__ if name in vars(base)), None)


def _refusal(kind: type, name: str) -> str:
    members = {member for base in kind.__mro__ for member in vars(base) if not member.startswith("_")}
    writable = sorted(member for member in members if _is_writable(_in_class(kind, member)))
    near = difflib.get_close_matches(name, writable, 1)
    if near:
        return f"a {kind.__name__} has no {name!r} that can be assigned; did you mean {near[0]!r}?"
    expected = f"expected {' or '.join(writable)}" if writable else "it has none"
    return f"a {kind.__name__} has no {name!r} that can be assigned, {expected}"


def _is_writable(member: Any) -> bool:
    return member.fset is not None if isinstance(member, property) else bool(getattr(member, "writable", False))


class Copied(np.ndarray):
    """An array whose copies and pickles are ordinary arrays."""

    def copy(self, order: Any = "C") -> Any:
        """A copy, an ordinary array."""
        return np.array(self, order=order)

    def __copy__(self) -> Any:
        return np.array(self)

    def __deepcopy__(self, memo: Any) -> Any:
        return np.array(self)

    def __reduce_ex__(self, protocol: Any) -> Any:
        return np.array(self).__reduce_ex__(protocol)


class Reading(Copied):
    """A read-only array: an attribute's value is a copy. Arrays computed from it are ordinary.

    `joints.position += 0.1` works: it computes a new array and assigns it.
    """

    def __setitem__(self, key: Any, value: Any) -> None:
        raise ValueError(
            "this array is a copy, so writing to it would change nothing: assign to the attribute, "
            "as in joints.position = values, or write to a copy() of it"
        )

    def __array_wrap__(self, array: Any, context: Any = None, return_scalar: bool = False) -> Any:
        plain = np.asarray(array)
        return plain if plain.ndim else plain[()]


for _name in ("add", "sub", "mul", "truediv", "floordiv", "mod", "pow"):  # x += y is x = x + y
    setattr(Reading, f"__i{_name}__", getattr(np.ndarray, f"__{_name}__"))


def reading(values: NDArray[Any]) -> NDArray[Any]:
    """A read-only view of the array."""
    read = values.view(Reading)
    read.flags.writeable = False
    return read
