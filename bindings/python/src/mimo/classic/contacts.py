"""`data.contact`: the contacts of the last physics step, as MuJoCo's arrays and as a list."""

from __future__ import annotations

from typing import Any, Iterator, NamedTuple

import numpy as np
from numpy.typing import NDArray

from .._strict import reading
from ..selections import Contacts
from ..world import World
from .live import PAGE

Numbers = NDArray[np.float64]
ARRAYS = ("geom", "geom1", "geom2", "pos", "dist", "frame")


class Contact(NamedTuple):
    """One contact, with MuJoCo's names."""

    geom1: int
    geom2: int
    pos: Numbers  # world, m
    dist: float  # m, negative: overlap
    frame: Numbers  # 9: normal from geom 1 to geom 2, two tangents; world
    geom: NDArray[np.int32]  # both


class ContactView:
    """All contacts: `contact.geom1`, `contact[0].geom1`, `len(contact)`, `for one in contact`."""

    def __init__(self, world: World) -> None:
        self.time, self._of = world.time, world.contacts()

    def __len__(self) -> int:
        return len(self._of.distance)

    def __iter__(self) -> Iterator[Contact]:
        return (self[index] for index in range(len(self)))

    def __getitem__(self, index: Any) -> Any:
        if isinstance(index, slice):
            return [self[one] for one in range(*index.indices(len(self)))]
        of, number = self._of, int(index)
        if not -len(self) <= number < len(self):
            raise IndexError(f"contact {number}, expected 0 to {len(self) - 1}")
        geoms = of.geoms[number]
        place, frame = of.position[number], of.frame[number].ravel()
        return Contact(int(geoms[0]), int(geoms[1]), place, float(of.distance[number]), frame, geoms)

    def arrays(self) -> Contacts:
        """The library's arrays of all contacts."""
        return self._of

    def force(self, index: int) -> Numbers:
        """Force and torque on geom 2 in the contact's frame, N and Nm."""
        return np.concatenate([self._of.force[index], self._of.torque[index]])

    def __getattr__(self, name: str) -> Any:
        if name == "geom" or name == "geoms":
            return reading(self._of.geoms.copy())
        if name in ("geom1", "geom2"):
            return reading(self._of.geoms[:, int(name[-1]) - 1].copy())
        if name == "pos":
            return reading(self._of.position.copy())
        if name == "dist":
            return reading(self._of.distance.copy())
        if name == "frame":
            return reading(self._of.frame.reshape(-1, 9).copy())
        raise AttributeError(f"data.contact has no {name!r} here; {PAGE}")
