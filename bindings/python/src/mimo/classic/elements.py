"""Bodies, joints, ... by name: `model.body("hip").mass`, `data.joint("robot:left_elbow").qpos`."""

from __future__ import annotations

from typing import Any, Dict, List, Mapping, NamedTuple, NoReturn, Tuple

import numpy as np

from ..constants import Kind
from .catalog import Catalog, Name
from .columns import MODEL, Column
from .live import PAGE, Live

# The kind's name here, and the beginning of the names of MuJoCo's arrays.
KINDS: Mapping[str, Tuple[Kind, str]] = {
    "body": (Kind.BODY, "body_"),
    "joint": (Kind.JOINT, "jnt_"),
    "geom": (Kind.GEOM, "geom_"),
    "site": (Kind.SITE, "site_"),
    "camera": (Kind.CAMERA, "cam_"),
    "actuator": (Kind.ACTUATOR, "actuator_"),
    "sensor": (Kind.SENSOR, "sensor_"),
    "light": (Kind.LIGHT, "light_"),
}
OTHERS: Mapping[str, str] = {
    "tendon": "tendons",
    "equality": "equalities",
    "material": "materials",
    "texture": "textures",
    "key": "keys",
}
SHORT = {"jnt": "joint", "cam": "camera", "eq": "equality", "mat": "material", "tex": "texture"}

_OF_BODY = {"xpos": "xpos", "xquat": "xquat", "xmat": "xmat", "xipos": "xipos", "cvel": "cvel"}
_OF_BODY.update(subtree_com="subtree_com", xfrc_applied="xfrc_applied")
_BY_DOF = ("damping", "armature", "frictionloss")
_JOINT_DATA = ("qpos", "qvel", "qacc", "qfrc_applied", "qfrc_actuator")


class Places(NamedTuple):
    """Where an element's values lie in an array."""

    column: str
    rows: Any


def model_attributes(kind: str) -> Dict[str, str]:
    """The attributes of an element of a model, each with its array."""
    start = KINDS[kind][1] if kind in KINDS else "eq_" if kind == "equality" else "mat_" if kind == "material" else None
    found = {} if start is None else {name[len(start) :]: name for name in MODEL if name.startswith(start)}
    if kind == "joint":
        found.update({name: f"dof_{name}" for name in _BY_DOF}, qpos0="qpos0", qpos_spring="qpos_spring")
    return found


def data_attributes(kind: str) -> Dict[str, str]:
    """The attributes of an element of the data, each with its array."""
    if kind == "body":
        return dict(_OF_BODY)
    if kind == "joint":
        return {name: name for name in _JOINT_DATA}
    if kind in ("geom", "site", "camera"):
        start = {"camera": "cam"}.get(kind, kind)
        return {name: f"{start}_{name}" for name in ("xpos", "xmat")}
    return {"actuator": {"ctrl": "ctrl", "force": "actuator_force"}, "sensor": {"data": "sensordata"}}.get(kind, {})


class Element:
    """One of them: `id`, `name`, and MuJoCo's attributes, which can be written where the library can set them."""

    def __init__(self, owner: str, kind: str, catalog: Catalog, number: int, name: str, columns: Any) -> None:
        attributes = model_attributes(kind) if owner == "model" else data_attributes(kind)
        self.__dict__.update(id=number, name=name, _owner=owner, _kind=kind, _catalog=catalog)
        self.__dict__.update(_attributes=attributes, _columns=columns)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__") or name not in self.__dict__.get("_attributes", {}):
            refuse(f"{self.__dict__.get('_kind')} {self.__dict__.get('name')!r} of {self.__dict__.get('_owner')}", name)
        column = self._attributes[name]
        return self._columns(column)[self._rows(column)]

    def __setattr__(self, name: str, value: Any) -> None:
        getattr(self, name)[...] = value

    def __repr__(self) -> str:
        return f"<{self._kind} {self.id} {self.name!r}: {', '.join(self._attributes)}>"

    def _rows(self, column: str) -> slice:
        it, number = self._catalog, self.id
        if column in ("qpos", "qpos0", "qpos_spring"):
            return slice(int(it.qpos_at[number]), int(it.qpos_at[number + 1]))
        if self._kind == "joint" and column.startswith(("q", "dof_")):
            return slice(int(it.qvel_at[number]), int(it.qvel_at[number + 1]))
        if column == "sensordata":
            start = int(MODEL["sensor_adr"].read(it)[number])
            return slice(start, start + int(MODEL["sensor_dim"].read(it)[number]))
        values = self._columns(column)
        return number if values.ndim > 1 else slice(number, number + 1)  # type: ignore[return-value]


class Arrays:
    """Base of `env.model` and `env.data`: their arrays and elements."""

    _owner: str
    _table: Mapping[str, Column]

    def __init__(self, catalog: Catalog) -> None:
        self.__dict__["_it"] = catalog

    @property
    def _stage(self) -> Any:
        return self._it.stage

    @property
    def _world(self) -> Any:
        return self._it.world

    def _array(self, name: str) -> Live:
        it, column = self._it, self._table[name]
        write = column.write
        refusal = f"{self._owner}.{name} cannot be written: {column.instead}; {PAGE}"
        if write is None:
            return self._stage.array(lambda: column.read(it), None, refusal)
        return self._stage.array(lambda: column.read(it), lambda new, old: write(it, new, old))

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        if name in self._table:
            return self._array(name)
        if name in KINDS or name in OTHERS:
            return lambda *which, **named: self._element(name, *which, **_which(named))
        if name in SHORT:
            return getattr(self, SHORT[name])
        refuse(self._owner, name)

    def __setattr__(self, name: str, value: Any) -> None:
        member = getattr(type(self), name, None)
        if isinstance(member, property) and member.fset is not None:
            member.fset(self, value)
        elif name in self._table:
            self._array(name)[...] = value
        else:
            getattr(self, name)  # refuses unknown names
            raise AttributeError(f"{self._owner}.{name} cannot be assigned; {PAGE}")

    def _element(self, kind: str, which: Name) -> Element:
        number, name = self._numbered(kind, which)
        return Element(self._owner, kind, self._it, number, name, self._array)

    def _numbered(self, kind: str, which: Name) -> Tuple[int, str]:
        if kind in KINDS:
            number = self._it.number(KINDS[kind][0], which)
            return number, self._world.name(KINDS[kind][0], number)
        names = self.names_of(kind)
        if isinstance(which, str):
            if which not in names:
                raise KeyError(f"there is no {kind} {which!r}, expected one of {', '.join(names)}")
            return names.index(which), which
        number = int(np.asarray(which).item())
        return number, names[number]

    def names_of(self, kind: str) -> List[str]:
        """The names of all elements of a kind, "body", "equality", ..."""
        if kind in KINDS:
            return self._it.names(KINDS[kind][0])
        rows = getattr(self._it.document, OTHERS[kind])
        return [row.at.get("name") or (row.at.get("joint1", "") if kind == "equality" else "") for row in rows]


def _which(named: Dict[str, Any]) -> Dict[str, Any]:
    """The argument of an element's function, which MuJoCo calls `name` or `id`."""
    return {"which" if key in ("name", "id") else key: value for key, value in named.items()}


def refuse(what: str, name: str) -> NoReturn:
    """The error for a missing member."""
    raise AttributeError(f"{what} has no {name!r} here; {PAGE}")
