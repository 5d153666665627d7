"""The elements of a world, and reading and writing their quantities by rows."""

from __future__ import annotations

from functools import cached_property
from typing import Any, Dict, List, Sequence, Union

import numpy as np
from numpy.typing import NDArray

from ..constants import NOW, Kind, Quantity
from ..selection import Selection
from ..selections import Joints
from ..world import World
from .document import Document
from .live import Stage
from .scenes import CHEST, JOINTS_OF_ROOT, UPPER_BODY

Numbers = NDArray[Any]
Name = Union[int, str, Sequence[int]]

_SELECT = {
    Kind.BODY: World.bodies,
    Kind.JOINT: World.joints,
    Kind.GEOM: World.geoms,
    Kind.SITE: World.sites,
    Kind.CAMERA: World.cameras,
    Kind.ACTUATOR: World.actuators,
    Kind.SENSOR: World.sensors,
    Kind.LIGHT: World.lights,
}


class Catalog:
    """What `env.model` and `env.data` both know of a world."""

    def __init__(self, stage: Stage) -> None:
        self.stage, self.world = stage, stage.world
        self._selections: Dict[Kind, Selection] = {}
        self._names: Dict[Kind, List[str]] = {}

    def all_of(self, kind: Kind) -> Selection:
        """All elements of a kind."""
        if kind not in self._selections:
            self._selections[kind] = _SELECT[kind](self.world)
        return self._selections[kind]

    def count(self, kind: Kind) -> int:
        """The number of elements of a kind."""
        return len(self.all_of(kind))

    def names(self, kind: Kind) -> List[str]:
        """The names of all elements of a kind."""
        if kind not in self._names:
            self._names[kind] = self.all_of(kind).names
        return self._names[kind]

    def number(self, kind: Kind, name: Name) -> int:
        """The number of an element, by its name or number (or an array with that number)."""
        if isinstance(name, str):
            return self.world.find(kind, self.known_name(kind, name))
        number = int(np.asarray(name).item())
        if not 0 <= number < self.count(kind):
            raise IndexError(f"{kind.name.lower()} is {number!r}, expected 0 to {self.count(kind) - 1}")
        return number

    def known_name(self, kind: Kind, name: str) -> str:
        """The name of an element here, where the original calls it otherwise: the root's joint, the chest."""
        same = {Kind.JOINT: JOINTS_OF_ROOT, Kind.BODY: (CHEST, UPPER_BODY)}.get(kind, ())
        if name in same and name not in self.names(kind):
            return next((other for other in same if other in self.names(kind)), name)
        return name

    def bodies_of(self, kind: Kind) -> Numbers:
        """The body of each element; of a body its parent."""
        return self.all_of(kind).body_ids

    def still_bodies(self) -> NDArray[np.bool_]:
        """Whether each body stands on the world without joints, so that it can be placed."""
        bodies = np.arange(self.count(Kind.BODY))
        moved = np.isin(bodies, self.bodies_of(Kind.JOINT))
        return np.asarray((self.bodies_of(Kind.BODY) == 0) & ~moved & (bodies > 0))

    def read(self, kind: Kind, quantity: Quantity, now: bool = False) -> Numbers:
        """A quantity of all elements."""
        return self.all_of(kind)._get(quantity | NOW if now else quantity)  # type: ignore[arg-type]

    def write(self, kind: Kind, quantity: Quantity, values: Numbers, before: Numbers) -> None:
        """Writes the rows that have changed."""
        if not len(values):
            return
        changed = np.flatnonzero((values != before).reshape(len(values), -1).any(axis=1))
        self.write_to(kind, quantity, changed, values[changed])

    def write_to(self, kind: Kind, quantity: Quantity, numbers: Any, values: Numbers) -> None:
        """Writes a quantity of some elements, one row each."""
        if len(numbers):
            self._some(kind, numbers)._set(quantity, values, None)

    def _some(self, kind: Kind, numbers: Any) -> Selection:
        return type(self.all_of(kind))(self.world, np.array(numbers, np.int32))

    # ---- Joints ---------------------------------------------------------------------------------------------------

    @cached_property
    def qpos_at(self) -> NDArray[np.intp]:
        """The index of each joint's position in qpos, and at the end their number."""
        return _addresses([one.position.size for one in self._single_joints()])

    @cached_property
    def qvel_at(self) -> NDArray[np.intp]:
        """The index of each joint's velocity in qvel, and at the end their number."""
        return _addresses([one.velocity.size for one in self._single_joints()])

    @cached_property
    def joint_of_dof(self) -> NDArray[np.intp]:
        """The joint of each degree of freedom."""
        return np.repeat(np.arange(len(self.qvel_at) - 1), np.diff(self.qvel_at))

    def _single_joints(self) -> List[Joints]:
        joints = self.all_of(Kind.JOINT)
        return [Joints(self.world, joints.ids[i : i + 1]) for i in range(len(joints))]

    def write_joints(self, quantity: Quantity, at: NDArray[np.intp], values: Numbers, before: Numbers) -> None:
        """Writes positions or velocities of the joints whose numbers have changed."""
        changed = np.flatnonzero(values != before)
        numbers = np.unique(np.searchsorted(at, changed, side="right") - 1)
        if len(numbers):
            rows = np.concatenate([values[at[joint] : at[joint + 1]] for joint in numbers])
            joints = Joints(self.world, numbers.astype(np.int32))
            joints._set(quantity, rows.reshape(joints._shape(quantity)[0]), None)

    # ---- Constants ------------------------------------------------------------------------------------------------

    @cached_property
    def document(self) -> Document:
        """The scene's document, which has the constants that the library does not hand out."""
        document = Document(self.world._scene.xml)
        if not document.matches(self.world):
            raise NotImplementedError(
                "this scene has elements that only MuJoCo expands (composite, replicate, ...), so constants such as "
                "jnt_stiffness are not known here; mimo.Scene.save writes the scene for the package mujoco"
            )
        return document


def _addresses(widths: Sequence[int]) -> NDArray[np.intp]:
    return np.concatenate([[0], np.cumsum(widths)]).astype(np.intp)
