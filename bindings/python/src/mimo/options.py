"""Options of infants, worlds, objects and pictures, and how they get into the C structs.

An option that is left out has the library's default, or the scene's. docs/python.md lists them.
"""

from __future__ import annotations

import ctypes
import inspect
from enum import IntEnum, IntFlag
from functools import lru_cache
from typing import Any, Dict, Mapping, Optional, Sequence, Union, get_args, get_type_hints

import numpy as np

from . import option_types
from ._library import utf8
from .arguments import real_number, unexpected, vector, whole_number
from .option_types import (
    CameraOptions,
    DocumentOptions,
    FieldOptions,
    GrowthOptions,
    InfantOptions,
    LimitOptions,
    ModelOptions,
    Numbers,
    ObjectOptions,
    PhysicsOptions,
    PictureOptions,
    SensesOptions,
)

__all__ = [
    "AgentOptions",
    "CameraOptions",
    "DocumentOptions",
    "EnvOptions",
    "FieldOptions",
    "GrowthOptions",
    "LimitOptions",
    "ModelOptions",
    "Numbers",
    "ObjectOptions",
    "Options",
    "PhysicsOptions",
    "PictureOptions",
    "SensesOptions",
    "WorldOptions",
    "enums",
    "fill",
    "refuse_unknown",
]

SIZES = 3  # most numbers of a shape


class AgentOptions(GrowthOptions, InfantOptions, total=False):
    """One infant: its position, age, senses and motors.

    `senses` adds all receptors ("all") or senses that are off by default ("hearing") to those that are on.
    """

    senses: Union[str, Sequence[str]]


class EnvOptions(AgentOptions, PhysicsOptions, total=False):
    """Options of make and make_vec, beside their own arguments."""

    parameters: Mapping[str, float]


class WorldOptions(PhysicsOptions, total=False):
    """Settings of a world, and its task."""

    task: str


class Options(EnvOptions, WorldOptions, total=False):
    """Options of World and Batch, beside their own arguments."""


@lru_cache(maxsize=None)
def enums(kind: Any) -> Dict[str, Any]:
    """The options of a class above, each with the enumeration that it takes, or None."""
    # The first releases of Python 3.9 look for names of a class's bases in the module of the class alone.
    hints = get_type_hints(kind, {**vars(option_types), **globals()})
    return {name: next((it for it in (hint, *get_args(hint)) if _is_enum(it)), None) for name, hint in hints.items()}


def _is_enum(kind: Any) -> bool:
    return isinstance(kind, type) and issubclass(kind, (IntEnum, IntFlag))


def refuse_unknown(options: Mapping[str, Any], kind: Any, function: Any = None) -> None:
    """Raises for an option that is neither of a class above nor a keyword argument of `function`."""
    for name in options.keys() - enums(kind).keys():
        own = inspect.signature(function).parameters.values() if function else ()
        known = sorted({*enums(kind), *(it.name for it in own if it.kind == it.KEYWORD_ONLY)})
        raise unexpected(name, known)


def fill(
    config: ctypes.Structure,
    options: Mapping[str, Any],
    kind: Any,
    standard: Optional[Mapping[str, Any]] = None,
) -> None:
    """Writes options of the class `kind` into a config; `standard` has the bits that True stands for."""
    refuse_unknown(options, kind)
    types = {entry[0]: entry[1] for entry in config._fields_}
    for name, value in options.items():
        if standard is not None and value is True:
            value = standard.get(name, value)
        setattr(config, name, _converted(name, value, types[name], enums(kind)[name]))


def _converted(name: str, value: Any, kind: Any, choice: Any) -> Any:
    if kind is ctypes.c_char_p:
        return utf8(value, name)
    if issubclass(kind, ctypes.Array):
        numbers = _size(value) if name == "size" else vector(name, value, kind._length_)
        return kind(*numbers)
    if kind is ctypes.c_double:
        return real_number(name, value)
    number = whole_number(name, value, choice)
    if kind(number).value != number:  # ctypes would silently wrap it
        raise ValueError(f"{name} is {value!r}, out of range")
    return number


def _size(value: Any) -> Any:
    """One to three numbers, padded with zeros."""
    given = np.atleast_1d(vector("size", value, len(value)) if np.ndim(value) else real_number("size", value))
    if not 1 <= len(given) <= SIZES:
        raise ValueError(f"size is {value!r}, expected 1 to {SIZES} numbers")
    return [*given, *[0.0] * (SIZES - len(given))]
