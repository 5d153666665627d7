"""Layouts: fields, actions and reward terms; and blocks, which hold all fields in one piece of memory."""

from __future__ import annotations

import ctypes
import weakref
from dataclasses import dataclass, replace
from typing import Any, Callable, Dict, List, NamedTuple, Tuple

import numpy as np
from numpy.typing import NDArray

from . import _abi
from ._handle import Native
from ._library import LIB, check, from_struct, result, text, utf8
from ._strict import Strict
from .arguments import meant
from .constants import FieldType, Receptor
from .errors import ClosedError
from .option_types import SENSES

ALIGNMENT = 64
SUPPLY_BYTES = 65536
DTYPES: Dict[int, np.dtype[Any]] = {
    FieldType.U8: np.dtype(np.uint8),
    FieldType.I32: np.dtype(np.int32),
    FieldType.F32: np.dtype(np.float32),
    FieldType.F64: np.dtype(np.float64),
}

Observation = Dict[str, NDArray[Any]]


class Fields(Dict[str, NDArray[Any]]):
    """A dict of fields by name; for a missing one the error says why."""

    def __missing__(self, name: Any) -> NDArray[Any]:
        raise NoFieldError(no_field(str(name), list(self)))

    def __reduce__(self) -> Tuple[Any, ...]:  # pickled as an ordinary dict
        return dict, (dict(self),)


class NoFieldError(KeyError):
    """A KeyError whose message is a sentence."""

    def __str__(self) -> str:
        return str(self.args[0])


def no_field(name: str, names: List[str]) -> str:
    """Says why there is no field of a name."""
    sense = name.split("/")[-2] if "/" in name else ""
    if sense in SENSES and not any(f"{sense}/" in other for other in names):
        return f"no field {name!r}: {sense} is off here; make the world with {sense}=True"
    return f"no field {name!r}{meant(name, names) or ';'} there are: {', '.join(names)}"


@dataclass(frozen=True)
class Field:
    """One field of an observation, for the time from `start` to `end`, s after the step's end, both <= 0."""

    name: str  # "proprioception/position"
    dtype: np.dtype[Any]
    shape: Tuple[int, ...]
    unit: str  # "rad", "" for none
    frame: str  # frame of reference, "" for none
    low: float  # smallest possible value, -inf if unbounded
    high: float
    start: float  # 0: the step's end; negative: earlier
    end: float  # later than start if it covers the time between
    period: float  # s from one new value to the next
    offset: int  # bytes from the start of the block
    receptors: int  # number of touch sensors, along the first axis; 0 for other fields
    sample_rate: float  # of sound: samples per second, the oldest first; 0 for other fields
    labels: Tuple[str, ...]  # a name for each element ("robot:left_elbow"); empty for pictures and touch


@dataclass(frozen=True)
class Action:
    """One action: the control input of one motor or muscle."""

    name: str  # "act:left_elbow"
    unit: str  # "rad", "" for none
    agent: int  # number of its infant
    low: float
    high: float


@dataclass(frozen=True)
class Term:
    """A part of an infant's reward; the reward is the sum of its terms."""

    name: str  # "distance"
    agent: int  # number of the infant


class Receptors(NamedTuple):
    """Places of a field's receptors, in the order of its first axis."""

    bodies: NDArray[np.int32]  # n
    geoms: NDArray[np.int32]  # n
    position: NDArray[np.float64]  # n x 3, in the frame of the receptor's body, m
    frame: NDArray[np.float64]  # n x 3 x 3, rows: outward normal, two tangents, in the frame of the body


class Layout(Strict):
    """Fields, actions and reward terms of a world, a batch or attached senses.

    `fields` maps names, in the order of the block; `actions` and `terms` have the order of their arrays.
    """

    bytes: int  # of a block
    agents: int
    step_seconds: float  # simulated time from one step to the next
    fields: Dict[str, Field]
    actions: Tuple[Action, ...]
    terms: Tuple[Term, ...]

    def __init__(self, owner: Native, layout_of: Callable[[Native, ctypes.c_void_p], int]) -> None:
        self._owner = weakref.ref(owner)  # a weak reference: the layout does not keep its owner alive
        self._handle, info = ctypes.c_void_p(), _abi.LayoutInfo()
        check(layout_of(owner, self._handle))
        check(LIB.mimo_layout_describe(self._handle, info))
        self._have(
            bytes=info.block_bytes,
            agents=info.agents,
            step_seconds=info.step_seconds,
            fields={field.name: field for field in map(self._field, range(info.fields))},
            actions=tuple(map(self._action, range(info.actions))),
            terms=tuple(map(self._term, range(info.terms))),
        )
        self._names = list(self.fields)
        listed = self.fields.values()
        self._record = np.dtype(
            {
                "names": self._names,
                "formats": [(field.dtype, field.shape) for field in listed],
                "offsets": [field.offset for field in listed],
                "itemsize": self.bytes,
            }
        )

    def new_block(self, *lead: int) -> NDArray[np.uint8]:
        """Memory for an observation, zeroed and aligned; for several worlds give their number."""
        count = int(np.prod(lead, dtype=np.int64)) * self.bytes
        room = np.zeros(count + ALIGNMENT, np.uint8)
        start = -room.ctypes.data % ALIGNMENT
        return room[start : start + count].reshape((*lead, self.bytes))

    def views(self, block: NDArray[np.uint8]) -> Observation:
        """The fields of a block, as views that share its memory and keep it alive."""
        record = np.ndarray(block.shape[:-1], self._record, block)
        return Fields((name, record[name]) for name in self._names)

    def _renew(self) -> None:
        """Updates the times of fields, which change with the infants' ages."""
        for index, field in enumerate(self.fields.values()):
            now = self._raw(index)
            self.fields[field.name] = replace(field, start=now.start, end=now.end)

    def receptors(self, name: str) -> Receptors:
        """Places of a field's receptors; empty for fields without skin."""
        _owner, index = self._find(name)
        return Receptors(
            bodies=self._of_receptors(index, Receptor.BODY).astype(np.int32),
            geoms=self._of_receptors(index, Receptor.GEOM).astype(np.int32),
            position=self._of_receptors(index, Receptor.POSITION).reshape(-1, 3),
            frame=self._of_receptors(index, Receptor.FRAME).reshape(-1, 3, 3),
        )

    def delays(self, name: str) -> NDArray[np.float64]:
        """Delay of each element of a field, s, in the order of the flattened field; 0: none.

        In a batch the delays, like the times of fields, are those of world 0 when it was made.
        """
        _owner, index = self._find(name)
        delays = np.empty(int(np.prod(self.fields[name].shape)))
        check(LIB.mimo_layout_delays(self._handle, index, delays.ctypes.data, delays.size))
        return delays

    def directions(self, name: str) -> NDArray[np.float32]:
        """Directions of a picture's pixels, foveated or not: unit vectors, height x width x 3.

        Each leads from the eye or camera to the middle of a pixel, in its frame: x right, y up, z backwards.
        """
        _owner, index = self._find(name)
        directions = np.empty((*self.fields[name].shape[:2], 3), np.float32)
        check(LIB.mimo_layout_directions(self._handle, index, directions.ctypes.data, directions.size))
        return directions

    def _find(self, name: str) -> Tuple[Native, int]:
        """The owner, which stays alive while the caller holds it, and a field's index."""
        wanted = utf8(name)
        owner = self._owner()
        if owner is None:
            raise ClosedError("the world, batch or senses of this layout are closed")
        return owner, result(ctypes.c_size_t, LIB.mimo_layout_find, self._handle, wanted)

    def _of_receptors(self, field: int, quantity: Receptor) -> NDArray[np.float64]:
        values = np.empty(result(ctypes.c_size_t, LIB.mimo_layout_receptor_width, self._handle, field, quantity))
        check(LIB.mimo_layout_receptors(self._handle, field, quantity, values.ctypes.data, values.size))
        return values

    def _raw(self, index: int) -> _abi.Field:
        field = _abi.Field()
        check(LIB.mimo_layout_field(self._handle, index, field))
        return field

    def _field(self, index: int) -> Field:
        field = self._raw(index)
        shape = tuple((ctypes.c_size_t * field.ndim).from_address(field.shape))
        labels = self._labels(index, int(np.prod(shape)))
        return from_struct(Field, field, dtype=DTYPES[field.dtype], shape=shape, labels=labels)

    def _labels(self, field: int, count: int) -> Tuple[str, ...]:
        labels: List[str] = []
        for element in range(count):
            label = text(result(ctypes.c_char_p, LIB.mimo_layout_label, self._handle, field, element))
            if not label:
                return ()
            labels.append(label)
        return tuple(labels)

    def _action(self, index: int) -> Action:
        action = _abi.Action()
        check(LIB.mimo_layout_action(self._handle, index, action))
        return from_struct(Action, action)

    def _term(self, index: int) -> Term:
        term = _abi.Term()
        check(LIB.mimo_layout_term(self._handle, index, term))
        return from_struct(Term, term)


class Supply:
    """Fresh blocks, one for each returned observation; memory is allocated for many at a time."""

    def __init__(self, layout: Layout) -> None:
        self._layout = layout
        self._count = max(1, SUPPLY_BYTES // layout.bytes)
        self._next = self._count

    def take(self) -> Tuple[int, Observation]:
        """The address of a new block, and views of its fields."""
        if self._next == self._count:
            blocks = self._layout.new_block(self._count)
            self._address = blocks.ctypes.data
            self._fields = list(self._layout.views(blocks).items())
            self._next = 0
        index = self._next
        self._next = index + 1
        return self._address + index * self._layout.bytes, {name: rows[index] for name, rows in self._fields}
