"""Senses in Python: they fill their fields after each observation, for all worlds of a batch at once.

A sense in a shared library (Scene.load_sense) also sees every physics step, remembers, and is recorded.
"""

from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Any, Dict, List, Mapping
from weakref import WeakValueDictionary

import numpy as np
from numpy.typing import NDArray

from . import _abi
from ._library import LIB, check, defaults, utf8
from .constants import SENSE_INTERFACE, FieldType
from .layout import DTYPES, Observation
from .own_task import status_of
from .tasks import missing

if TYPE_CHECKING:
    from gymnasium import spaces

_TYPES = {dtype: number for number, dtype in DTYPES.items()}


class Sense:
    """Derive from it, and give an instance to Scene.add_sense. Copies of the scene share it.

    Its fields are part of the layout, with zeros until `fill` has run. Limits of senses and recordings see only these
    zeros: they are done when it runs.
    """

    name: str = ""  # of its fields: "edges", or "edges/left" for the field "left"; lower-case letters, digits and _
    fields: Mapping[str, spaces.Box] = {}  # by their names below the sense; "": the field has the sense's name
    units: Mapping[str, str] = {}  # units of fields: {"": "Hz"}

    def fill(self, observation: Observation, out: Dict[str, NDArray[Any]]) -> None:
        """Fills its fields, as arrays with the worlds in front; a single World counts as one world.

        `observation` has all fields by name. `out` has the agent's own fields, by their names in `fields`; write into
        these arrays. Called after each step, reset and observation, once for each agent with the sense.
        """
        raise missing(self, "fill(self, observation, out)")

    def __deepcopy__(self, memo: Dict[int, Any]) -> "Sense":
        return self


class BoundSense:
    """A sense as the library knows it, for one agent."""

    def __init__(self, sense: Sense) -> None:
        from gymnasium.spaces import Box

        if isinstance(sense, type):
            raise TypeError(f"sense is the class {sense.__name__}, expected an object of it: {sense.__name__}(...)")
        if not isinstance(sense, Sense):
            raise TypeError(f"sense is {sense!r}, expected a mimo.Sense")
        self.sense, self.prefix = sense, ""
        for name, box in sense.fields.items():
            if not isinstance(box, Box) or box.dtype not in _TYPES:
                wanted = ", ".join(str(dtype) for dtype in _TYPES)
                raise TypeError(f"{type(sense).__name__}: the space of {name!r} is {box!r}, expected a Box of {wanted}")
            if np.unique(box.low).size != 1 or np.unique(box.high).size != 1:
                raise ValueError(
                    f"{type(sense).__name__}: the bounds of {name!r} differ, expected one low and one high"
                )
        _bounds[id(self)] = self

    def table(self) -> _abi.Sense:
        """For the library."""
        table = defaults(_abi.Sense)
        table.interface_version, table.host_fills = SENSE_INTERFACE, 1
        table.name = utf8(self.sense.name, "name")
        table.user, table.open = id(self), _open
        return table

    def open(self, env: int, told: Any) -> None:
        """Declares its fields."""
        self.prefix = told.prefix.decode()
        for name, box in self.sense.fields.items():
            field = defaults(_abi.SenseField)
            shape = (ctypes.c_size_t * len(box.shape))(*box.shape)
            field.dtype, field.name, field.unit = _TYPES[box.dtype], utf8(name), utf8(self.sense.units.get(name))
            field.shape, field.ndim = ctypes.addressof(shape), len(box.shape)
            if field.dtype in (FieldType.F32, FieldType.F64):
                field.low, field.high = float(box.low.flat[0]), float(box.high.flat[0])
            check(LIB.mimo_sense_add_field(env, field))

    def fill(self, views: Observation, alone: bool) -> None:
        """Lets the sense fill its fields of a block."""
        rows = {name: view[np.newaxis] for name, view in views.items()} if alone else views
        own = {name: rows[self.prefix + "/".join(filter(None, (self.sense.name, name)))] for name in self.sense.fields}
        self.sense.fill(rows, own)


def fill_all(senses: List[BoundSense], views: Observation, alone: bool) -> None:
    """Lets senses fill their fields of a block, whose views are of one world or of many."""
    for bound in senses:
        bound.fill(views, alone)


_bounds: WeakValueDictionary[int, BoundSense] = WeakValueDictionary()


@_abi.SenseOpenFn  # type: ignore[untyped-decorator]
def _open(user: int, env: int, told: Any, _needs: Any) -> int:
    return status_of(lambda: _bounds[user].open(env, told.contents))
