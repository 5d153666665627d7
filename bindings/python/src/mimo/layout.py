"""What is observed, what acts and what is rewarded; and blocks: one piece of memory that holds all observed fields."""

from __future__ import annotations

import ctypes
import difflib
import weakref
from dataclasses import dataclass, replace
from typing import Any, Callable, Dict, List, NamedTuple, Tuple

import numpy as np
from numpy.typing import NDArray

from . import _abi
from ._handle import Native
from ._library import LIB, check, text, utf8
from ._strict import Strict
from .constants import Receptor
from .errors import ClosedError

ALIGNMENT = 64
SUPPLY_BYTES = 65536
DTYPES: Dict[int, np.dtype[Any]] = {
    1: np.dtype(np.uint8),
    2: np.dtype(np.int32),
    3: np.dtype(np.float32),
    4: np.dtype(np.float64),
}

Observation = Dict[str, NDArray[Any]]
SENSES = ("proprioception", "vestibular", "touch", "vision", "hearing")  # with an option of that name


class Fields(Dict[str, NDArray[Any]]):
    """A dict of fields by name, which says of one that is not there why it is not."""

    def __missing__(self, name: Any) -> NDArray[Any]:
        raise NoFieldError(_no_field(str(name), list(self)))

    def __reduce__(self) -> Tuple[Any, ...]:  # pickled as an ordinary dict
        return dict, (dict(self),)


class NoFieldError(KeyError):
    """A KeyError whose message is a sentence."""

    def __str__(self) -> str:
        return str(self.args[0])


def _no_field(name: str, names: List[str]) -> str:
    sense = name.split("/")[-2] if "/" in name else ""
    if sense in SENSES and not any(f"{sense}/" in other for other in names):
        return f"no field {name!r}: nothing has {sense} here, which is an option, {sense}=True"
    near = difflib.get_close_matches(name, names, 1)
    meant = f"did you mean {near[0]!r}? " if near else ""
    return f"no field {name!r}; {meant}there are: {', '.join(names)}"


@dataclass(frozen=True)
class Field:
    """One field of an observation. It belongs to the time from `start` to `end`, s after the step's end, both <= 0."""

    name: str  # "proprioception/position"
    dtype: np.dtype[Any]
    shape: Tuple[int, ...]
    unit: str  # "rad", "" for none
    frame: str  # frame of reference, "" for none
    low: float  # smallest possible value, -inf where there is none
    high: float
    start: float  # 0 for the step's end, negative for what is older
    end: float  # later than start for what was gathered meanwhile
    period: float  # s from one new value to the next
    offset: int  # bytes from the start of the block
    receptors: int  # on how many it reports, in the order of its first axis; 0: it is not of skin
    sample_rate: float  # of sound, samples a second, the oldest first; 0: it is no sound
    labels: Tuple[str, ...]  # what each element is ("robot:left_elbow"); empty for pictures and touch


@dataclass(frozen=True)
class Action:
    """One action: the control input of one motor or muscle."""

    name: str  # "act:left_elbow"
    unit: str  # "rad", "" for none
    agent: int  # number of the infant whose it is
    low: float
    high: float


@dataclass(frozen=True)
class Term:
    """A part of an infant's reward, which is their sum."""

    name: str  # "distance"
    agent: int  # number of the infant


class Receptors(NamedTuple):
    """Where a field's receptors are, in the order of its first axis."""

    bodies: NDArray[np.int32]  # n
    geoms: NDArray[np.int32]  # n
    position: NDArray[np.float64]  # n x 3, in the frame of the receptor's body, m
    frame: NDArray[np.float64]  # n x 3 x 3, rows: outward normal, two tangents, in the frame of the body


class Layout(Strict):
    """What a world, a batch or attached senses observe, act with and are rewarded for.

    `fields` are by name, in the order of the block; `actions` and `terms` in that of their arrays.
    """

    bytes: int  # of a block
    agents: int
    fields: Dict[str, Field]
    actions: Tuple[Action, ...]
    terms: Tuple[Term, ...]

    def __init__(self, owner: Native, layout_of: Callable[[Native, ctypes.c_void_p], int]) -> None:
        self._owner = weakref.ref(owner)  # which is not to live as long as its description
        self._handle, info = ctypes.c_void_p(), _abi.LayoutInfo()
        check(layout_of(owner, self._handle))
        check(LIB.mimo_layout_describe(self._handle, info))
        self._have(
            bytes=info.block_bytes,
            agents=info.agents,
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
        """Memory for an observation, zeros, aligned; for several worlds with their number in front."""
        count = int(np.prod(lead, dtype=np.int64)) * self.bytes
        room = np.zeros(count + ALIGNMENT, np.uint8)
        start = -room.ctypes.data % ALIGNMENT
        return room[start : start + count].reshape((*lead, self.bytes))

    def views(self, block: NDArray[np.uint8]) -> Observation:
        """The fields of a block. They are views: they share its memory, and keep it alive."""
        record = np.ndarray(block.shape[:-1], self._record, block)
        return Fields((name, record[name]) for name in self._names)

    def _renew(self) -> None:
        """Reads anew when fields are true: infants of other ages are late by other times."""
        for index, field in enumerate(self.fields.values()):
            now = self._raw(index)
            self.fields[field.name] = replace(field, start=now.start, end=now.end)

    def receptors(self, name: str) -> Receptors:
        """Where a field's receptors are; none where it is not of skin."""
        _owner, index = self._find(name)
        return Receptors(
            bodies=self._of_receptors(index, Receptor.BODY).astype(np.int32),
            geoms=self._of_receptors(index, Receptor.GEOM).astype(np.int32),
            position=self._of_receptors(index, Receptor.POSITION).reshape(-1, 3),
            frame=self._of_receptors(index, Receptor.FRAME).reshape(-1, 3, 3),
        )

    def delays(self, name: str) -> NDArray[np.float64]:
        """How late each element of a field comes, s, in the order of the flattened field; 0 for what comes at once.

        In a batch, like the times of its fields: as world 0 was made.
        """
        _owner, index = self._find(name)
        delays = np.empty(int(np.prod(self.fields[name].shape)))
        check(LIB.mimo_layout_delays(self._handle, index, delays.ctypes.data, delays.size))
        return delays

    def directions(self, name: str) -> NDArray[np.float32]:
        """Where the pixels of a picture lie, foveated or not: unit vectors, height x width x 3.

        They lead from the eye or camera to the middle of each pixel, in its frame: x right, y up, z backwards.
        """
        _owner, index = self._find(name)
        directions = np.empty((*self.fields[name].shape[:2], 3), np.float32)
        check(LIB.mimo_layout_directions(self._handle, index, directions.ctypes.data, directions.size))
        return directions

    def _find(self, name: str) -> Tuple[Native, int]:
        """What this describes, which no other thread destroys while the caller holds it, and a field's index."""
        wanted, index = utf8(name), ctypes.c_size_t()
        owner = self._owner()
        if owner is None:
            raise ClosedError("what this layout describes is closed")
        check(LIB.mimo_layout_find(self._handle, wanted, index))
        return owner, index.value

    def _of_receptors(self, field: int, quantity: Receptor) -> NDArray[np.float64]:
        count = ctypes.c_size_t()
        check(LIB.mimo_layout_receptor_width(self._handle, field, quantity, count))
        values = np.empty(count.value)
        check(LIB.mimo_layout_receptors(self._handle, field, quantity, values.ctypes.data, values.size))
        return values

    def _raw(self, index: int) -> _abi.Field:
        field = _abi.Field()
        check(LIB.mimo_layout_field(self._handle, index, field))
        return field

    def _field(self, index: int) -> Field:
        field = self._raw(index)
        shape = tuple(field.shape[: field.ndim])
        return Field(
            name=text(field.name),
            dtype=DTYPES[field.dtype],
            shape=shape,
            unit=text(field.unit),
            frame=text(field.frame),
            low=field.low,
            high=field.high,
            start=field.start,
            end=field.end,
            period=field.period,
            offset=field.offset,
            receptors=field.receptors,
            sample_rate=field.sample_rate,
            labels=self._labels(index, int(np.prod(shape))),
        )

    def _labels(self, field: int, count: int) -> Tuple[str, ...]:
        label = ctypes.c_char_p()
        labels = []
        for element in range(count):
            check(LIB.mimo_layout_label(self._handle, field, element, label))
            if not label.value:
                return ()
            labels.append(text(label.value))
        return tuple(labels)

    def _action(self, index: int) -> Action:
        action = _abi.Action()
        check(LIB.mimo_layout_action(self._handle, index, action))
        return Action(text(action.name), text(action.unit), action.agent, action.low, action.high)

    def _term(self, index: int) -> Term:
        term = _abi.Term()
        check(LIB.mimo_layout_term(self._handle, index, term))
        return Term(text(term.name), term.agent)


class Supply:
    """Fresh blocks, one for each observation that is handed out; cheap, because memory is taken for many at a time."""

    def __init__(self, layout: Layout) -> None:
        self._layout = layout
        self._count = max(1, SUPPLY_BYTES // layout.bytes)
        self._next = self._count

    def take(self) -> Tuple[int, Observation]:
        """The address of a new block, and the views of its fields."""
        if self._next == self._count:
            blocks = self._layout.new_block(self._count)
            self._address = blocks.ctypes.data
            self._fields = list(self._layout.views(blocks).items())
            self._next = 0
        index = self._next
        self._next = index + 1
        return self._address + index * self._layout.bytes, {name: rows[index] for name, rows in self._fields}
