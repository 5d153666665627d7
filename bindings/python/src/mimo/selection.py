"""Bodies, joints, ... of a world, looked up once."""

from __future__ import annotations

import ctypes
from functools import lru_cache
from typing import TYPE_CHECKING, Any, List, Optional, Tuple, TypeVar, Union, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._library import LIB, result
from ._strict import Strict, reading
from .arguments import described
from .constants import NOW, Kind, Quantity
from .results import Numbers

if TYPE_CHECKING:
    from .access import Access

Mask = Optional[NDArray[np.bool_]]
SHOWN = 8  # names in a selection's repr


@lru_cache(maxsize=None)
def kind_of(quantity: Quantity) -> Kind:
    """The kind that a quantity's name begins with."""
    return max((kind for kind in Kind if quantity.name.startswith(kind.name)), key=lambda kind: len(kind.name))


class Selection(Strict):
    """A selection of bodies, joints, ...: their numbers in `ids`, their names in `names`."""

    kind: Kind
    ids: NDArray[np.int32]

    def __init__(self, access: Access, ids: NDArray[np.int32], kind: Optional[Kind] = None) -> None:
        self._access = access
        self._shapes: dict[int, Tuple[Tuple[int, ...], int]] = {}
        self._have(ids=reading(ids))
        if kind is not None:
            self._have(kind=kind)

    def __len__(self) -> int:
        return len(self.ids)

    def __getitem__(self, index: Any) -> Any:
        kind = self.kind.name.lower()
        raise TypeError(f"a selection has no [{index!r}]; its arrays have, as in .names[0]; name a {kind} to select it")

    def __repr__(self) -> str:
        shown = [name or f"number {number}" for name, number in zip(self.names[:SHOWN], self.ids)]
        more = ["..."] if len(self) > SHOWN else []
        return f"<{len(self)} {type(self).__name__.lower()}: {', '.join(shown + more)}>"

    @property
    def names(self) -> List[str]:
        """Names, in order; "" for elements without one."""
        return [self._access.name(self.kind, int(number)) for number in self.ids]

    @property
    def body_ids(self) -> NDArray[np.int32]:
        """The body that each element belongs to; of a body its parent."""
        handle = self._access._names_handle
        bodies = [result(ctypes.c_int32, LIB.mimo_env_body_of, handle, self.kind, int(number)) for number in self.ids]
        return np.array(bodies, np.int32)

    def read(self, quantity: str, now: bool = False) -> Numbers:
        """As `selection.quantity`; with `now` poses and velocities of the current positions."""
        attribute = getattr(type(self), quantity, None)
        if not isinstance(attribute, Values):
            raise AttributeError(f"{type(self).__name__.lower()} have no {quantity}")
        return self._get(attribute.quantity, now)

    def write(self, quantity: str, values: ArrayLike, mask: Mask = None) -> None:
        """As `selection.quantity = values`, in a batch only in the worlds where mask is True."""
        attribute = getattr(type(self), quantity, None)
        if not isinstance(attribute, WritableValues):
            raise AttributeError(f"{quantity} of {type(self).__name__.lower()} cannot be written")
        self._set(attribute.quantity, values, mask)

    def _get(self, quantity: Quantity, now: bool = False, dtype: Any = np.float64) -> Numbers:
        shape, _ = self._shape(quantity)
        values = np.empty(shape, dtype)
        if values.dtype not in (np.float64, np.float32):
            raise TypeError(f"dtype is {values.dtype}, expected float64 or float32")
        self._access._read(quantity | NOW if now else quantity, self.ids, values)
        return values

    def _set(self, quantity: Quantity, values: ArrayLike, mask: Mask) -> None:
        shape, _ = self._shape(quantity)
        try:
            given = np.asarray(values, np.float64)
        except (TypeError, ValueError):
            raise TypeError(f"{quantity.name.lower()} is {described(values)}, expected numbers") from None
        if [length for length in given.shape if length != 1] == [length for length in shape if length != 1]:
            given = given.reshape(shape)  # a single element or world needs no axis
        try:
            whole = np.ascontiguousarray(np.broadcast_to(given, shape))
        except ValueError:
            what = f"{quantity.name.lower()} of the shape {given.shape}"
            raise ValueError(f"{what}, expected {shape}, or one number for all") from None
        self._access._write(quantity, self.ids, whole, mask)

    def _shape(self, quantity: Quantity) -> Tuple[Tuple[int, ...], int]:
        """The shape of a quantity's values, cached."""
        if quantity not in self._shapes:
            widths = [self._width(quantity, self.ids[i : i + 1]) for i in range(len(self.ids))]
            total = sum(widths)
            same = len(set(widths)) == 1 and widths[0] > 1
            own = (len(widths), widths[0]) if same else (total,)
            self._shapes[quantity] = (self._access._lead + own, total)
        return self._shapes[quantity]

    def _width(self, quantity: Quantity, ids: NDArray[np.int32]) -> int:
        some = (quantity, ids.ctypes.data, len(ids))
        return int(result(ctypes.c_size_t, LIB.mimo_env_width, self._access._names_handle, *some))


class Values:
    """A quantity that can be read."""

    def __init__(self, quantity: Quantity) -> None:
        self.quantity = quantity
        self.__doc__ = f"See mimo.Quantity.{quantity.name}."

    @overload
    def __get__(self: S2, owner: None, kind: Any) -> S2: ...

    @overload
    def __get__(self, owner: Selection, kind: Any) -> Numbers: ...

    def __get__(self: S2, owner: Optional[Selection], kind: Any) -> Union[S2, Numbers]:
        return self if owner is None else reading(owner._get(self.quantity))

    def __set__(self, owner: Selection, values: Any) -> None:
        raise AttributeError(f"{self.quantity.name.lower()} cannot be written")


S2 = TypeVar("S2", bound=Values)


class WritableValues(Values):
    """A quantity that can be read and written."""

    writable = True

    def __set__(self, owner: Selection, values: Any) -> None:
        owner._set(self.quantity, values, None)
