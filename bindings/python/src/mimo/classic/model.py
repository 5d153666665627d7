"""`env.model` and `env.data`: MuJoCo's members, on a world of the library.

Arrays follow the world, also those that a script keeps. Assigning to their elements sets what the library can set, and
is refused where it cannot. Missing members raise an error.
"""

from __future__ import annotations

from typing import Any, Union

import numpy as np
from numpy.typing import ArrayLike

from ..constants import Kind
from ..world import World
from .catalog import Catalog
from .columns import DATA, MODEL, mocap_bodies, user_numbers
from .contacts import ContactView
from .elements import KINDS, Arrays
from .live import PAGE, Live, Stage
from .settings import OptionView, StatisticView, VisualView

COUNTS = {
    "nbody": Kind.BODY,
    "njnt": Kind.JOINT,
    "ngeom": Kind.GEOM,
    "nu": Kind.ACTUATOR,
    "ncam": Kind.CAMERA,
    "nsite": Kind.SITE,
    "nsensor": Kind.SENSOR,
    "nlight": Kind.LIGHT,
}
LISTED = {"neq": "equalities", "nmat": "materials", "ntex": "textures", "ntendon": "tendons", "nkey": "keys"}


def stage_of(world: Union[World, Stage, Catalog]) -> Catalog:
    """What both views of a world share."""
    if isinstance(world, Catalog):
        return world
    return Catalog(world if isinstance(world, Stage) else Stage(world))


class ModelView(Arrays):
    """The model: counts, constants, elements by name or number, options."""

    _owner, _table = "model", MODEL

    def __init__(self, world: Union[World, Stage, Catalog]) -> None:
        super().__init__(stage_of(world))
        self.__dict__["opt"] = OptionView(self._it)
        self.__dict__["stat"], self.__dict__["vis"] = StatisticView(self._it), VisualView(self._it)

    def __getattr__(self, name: str) -> Any:
        if name in COUNTS:
            return self._it.count(COUNTS[name])
        if name in LISTED:
            return len(getattr(self._it.document, LISTED[name]))
        return super().__getattr__(name)

    @property
    def nq(self) -> int:
        """Numbers in qpos."""
        return int(self._it.qpos_at[-1])

    @property
    def nv(self) -> int:
        """Numbers in qvel."""
        return int(self._it.qvel_at[-1])

    @property
    def na(self) -> int:
        """Activations of MuJoCo's own muscles: none."""
        return 0

    @property
    def nmocap(self) -> int:
        """Mocap bodies."""
        return len(mocap_bodies(self._it))

    @property
    def nuser_actuator(self) -> int:
        """User numbers of each motor."""
        return int(user_numbers(self._it).shape[1])

    @property
    def nsensordata(self) -> int:
        """Numbers in sensordata."""
        return int(MODEL["sensor_dim"].read(self._it).sum())

    @property
    def mat_texid(self) -> Live:
        """The texture of each material; of the head's it can be set to that of another face."""
        return self._stage.array(self._textures, self._write_texture)

    @mat_texid.setter
    def mat_texid(self, values: ArrayLike) -> None:
        self.mat_texid[...] = values

    def _textures(self) -> Any:
        names = self.names_of("texture")
        rows = self._it.document.materials
        texid = [names.index(row.at["texture"]) if row.at.get("texture") in names else -1 for row in rows]
        face = self._face_material()
        if face is not None:
            texid[self._head()] = texid[face]
        return np.array(texid, np.int32)

    def _face_material(self) -> Any:
        materials = self.names_of("material")
        name = f"mimo_face_{self._world.face()}"
        return materials.index(name) if name in materials and self._head() is not None else None

    def _head(self) -> Any:
        materials = self.names_of("material")
        return next((materials.index(name) for name in ("head", "mimo_face_neutral") if name in materials), None)

    def _write_texture(self, new: Any, old: Any) -> None:
        changed = np.flatnonzero(new != old)
        materials = self.names_of("material")
        faces = [name[len("mimo_face_") :] for name in materials if name.startswith("mimo_face_")]
        rows = {row.at.get("texture"): row.at.get("name", "") for row in self._it.document.materials}
        for material in changed:
            name = rows.get(self.names_of("texture")[int(new[material])], "")[len("mimo_face_") :]
            if int(material) != self._head() or name not in faces:
                raise ValueError(f"mat_texid: only the face can be changed here, with world.set_face(name); {PAGE}")
            self._world.set_face(name)


class DataView(Arrays):
    """The state of the simulation."""

    _owner, _table = "data", DATA

    def __init__(self, world: Union[World, Stage, Catalog]) -> None:
        super().__init__(stage_of(world))

    @property
    def time(self) -> float:
        """Simulated seconds."""
        return float(self._world.time)

    @property
    def act(self) -> Any:
        """Activations of MuJoCo's own muscles: none."""
        return np.zeros(0)

    @property
    def contact(self) -> ContactView:
        """The contacts of the last physics step: arrays (`contact.geom1`) and a list (`contact[0].geom1`)."""
        stage = self._stage
        if stage.contacts is None or stage.contacts.time != self._world.time:
            stage.contacts = ContactView(self._world)
        return stage.contacts  # type: ignore[no-any-return]

    @property
    def ncon(self) -> int:
        """The number of contacts."""
        return len(self.contact)


__all__ = ["KINDS", "DataView", "ModelView", "OptionView"]
