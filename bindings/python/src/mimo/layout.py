"""Observation blocks: one piece of memory that holds all fields, and numpy's views of them."""

from __future__ import annotations

import ctypes
from dataclasses import dataclass
from typing import Any, Dict, Sequence, Tuple

import numpy as np
from numpy.typing import NDArray

from . import _abi
from ._handle import Native
from ._library import LIB, check, text
from .constants import Time

ALIGNMENT = 64
SUPPLY_BYTES = 65536
DTYPES: Dict[int, np.dtype[Any]] = {
    1: np.dtype(np.uint8),
    2: np.dtype(np.int32),
    3: np.dtype(np.float32),
    4: np.dtype(np.float64),
}

Observation = Dict[str, NDArray[Any]]


@dataclass(frozen=True)
class Field:
    """One field of an observation."""

    name: str  # "proprioception/position"
    dtype: np.dtype[Any]
    shape: Tuple[int, ...]
    unit: str  # "rad", "" for none
    frame: str  # frame of reference, "" for none
    time: Time
    low: float  # smallest possible value, -inf where there is none
    high: float
    offset: int  # bytes from the start of the block
    labels: Tuple[str, ...]  # what each element is ("robot:left_elbow"); empty for pictures and touch


class Layout:
    """The fields of an observation block, by name, in the order of the block.

    The handle is that of a world ("env"), or of attached senses ("senses").
    """

    def __init__(self, handle: Native, noun: str = "env") -> None:
        size, count = ctypes.c_size_t(), ctypes.c_size_t()
        self._describe = getattr(LIB, f"mimo_{noun}_observation_field")
        self._label = getattr(LIB, f"mimo_{noun}_observation_label")
        check(getattr(LIB, f"mimo_{noun}_observation_size")(handle, size, count))
        self.bytes: int = size.value
        fields = [self._field(handle, index) for index in range(count.value)]
        self.fields: Dict[str, Field] = {field.name: field for field in fields}
        names = list(self.fields)
        listed = self.fields.values()
        self._record = np.dtype(
            {
                "names": names,
                "formats": [(field.dtype, field.shape) for field in listed],
                "offsets": [field.offset for field in listed],
                "itemsize": self.bytes,
            }
        )
        self._names = names

    def new_block(self, *lead: int) -> NDArray[np.uint8]:
        """Memory for an observation, aligned as the library likes it; for several worlds with their number in front."""
        count = int(np.prod(lead, dtype=np.int64)) * self.bytes
        room = np.empty(count + ALIGNMENT, np.uint8)
        start = -room.ctypes.data % ALIGNMENT
        return room[start : start + count].reshape((*lead, self.bytes))

    def views(self, block: NDArray[np.uint8]) -> Observation:
        """The fields of a block. They are views: they share its memory, and keep it alive."""
        record = np.ndarray(block.shape[:-1], self._record, block)
        return {name: record[name] for name in self._names}

    def _field(self, handle: Native, index: int) -> Field:
        field = _abi.Field()
        check(self._describe(handle, index, field))
        shape = tuple(field.shape[: field.ndim])
        return Field(
            name=text(field.name),
            dtype=DTYPES[field.dtype],
            shape=shape,
            unit=text(field.unit),
            frame=text(field.frame),
            time=Time(field.time),
            low=field.low,
            high=field.high,
            offset=field.offset,
            labels=self._labels(handle, index, shape),
        )

    def _labels(self, handle: Native, index: int, shape: Sequence[int]) -> Tuple[str, ...]:
        label = ctypes.c_char_p()
        labels = []
        for element in range(int(np.prod(shape))):
            if self._label(handle, index, element, label) != 0 or not label.value:
                return ()
            labels.append(text(label.value))
        return tuple(labels)


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
