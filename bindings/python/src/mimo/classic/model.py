"""`env.model` and `env.data`: members that scripts for the original read, by named access.

Arrays are read-only copies; some can be assigned as a whole (`data.qpos = ...`). Missing members raise an error.
"""

from __future__ import annotations

from typing import Any, List, Mapping, NamedTuple, NoReturn, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..constants import Kind
from ..selection import Selection
from ..selections import Joints
from ..world import World

Numbers = NDArray[np.float64]
Name = Union[int, str]
PAGE = "docs/guide/classic.md says what to write instead"


class Contact(NamedTuple):
    """One contact, with MuJoCo's names."""

    geom1: int
    geom2: int
    pos: Numbers  # world, m
    dist: float  # m, negative: overlap
    frame: Numbers  # 9: normal from geom 1 to geom 2, two tangents; world


class Element:
    """A body, joint, ... with the attributes of MuJoCo that scripts use."""

    def __init__(self, selection: Selection, attributes: Mapping[str, str], address: int = -1) -> None:
        self.id = int(selection.ids[0])
        self.name = selection.names[0]
        self.qposadr = np.array([address])
        self._selection, self._attributes = selection, attributes

    def __getattr__(self, name: str) -> Any:
        quantity = self.__dict__.get("_attributes", {}).get(name)
        if quantity is None:
            refuse(f"an element {self.__dict__.get('name')!r}", name)
        return frozen(getattr(self._selection, quantity)[0])


class ModelView:
    """The model's counts and names."""

    def __init__(self, world: World) -> None:
        self._world = world
        self._joints = world.joints()
        self._qpos_at, self._qvel_at = _addresses(self._joints)
        self.opt = OptionView(world)
        kinds = {"nbody": Kind.BODY, "njnt": Kind.JOINT, "ngeom": Kind.GEOM, "nu": Kind.ACTUATOR, "ncam": Kind.CAMERA}
        self._counts = {**{name: world.count(kind) for name, kind in kinds.items()}, "nsite": world.count(Kind.SITE)}
        self._counts.update(nq=int(self._qpos_at[-1]), nv=int(self._qvel_at[-1]), nsensor=world.count(Kind.SENSOR))

    def __getattr__(self, name: str) -> Any:
        counts = self.__dict__.get("_counts", {})
        if name not in counts:
            refuse("model", name)
        return counts[name]

    def body(self, name: Name) -> Element:
        """A body by name or number: id, name, mass, parentid."""
        return _element(self._world, Kind.BODY, name, {"mass": "mass", "parentid": "body_ids"})

    def geom(self, name: Name) -> Element:
        """A geom by name or number: id, name, bodyid, size, friction, rgba."""
        attributes = {"bodyid": "body_ids", "size": "size", "friction": "friction", "rgba": "color"}
        return _element(self._world, Kind.GEOM, name, attributes)

    def actuator(self, name: Name) -> Element:
        """A motor by name or number: id, name."""
        return _element(self._world, Kind.ACTUATOR, name, {})

    def camera(self, name: Name) -> Element:
        """A camera by name or number: id, name."""
        return _element(self._world, Kind.CAMERA, name, {})

    def site(self, name: Name) -> Element:
        """A site by name or number: id, name, bodyid."""
        return _element(self._world, Kind.SITE, name, {"bodyid": "body_ids"})

    def joint(self, name: Name) -> Element:
        """A joint by name or number: id, name, bodyid, range, qposadr."""
        attributes = {"bodyid": "body_ids", "range": "range", "damping": "damping"}
        return _element(self._world, Kind.JOINT, name, attributes, self._qpos_at)

    @property
    def jnt_qposadr(self) -> NDArray[Any]:
        """The index of each joint's position in qpos."""
        return frozen(self._qpos_at[:-1])

    @property
    def jnt_dofadr(self) -> NDArray[Any]:
        """The index of each joint's velocity in qvel."""
        return frozen(self._qvel_at[:-1])

    @property
    def body_parentid(self) -> NDArray[Any]:
        """Each body's parent."""
        return frozen(self._world.bodies().body_ids)

    @property
    def body_mass(self) -> Numbers:
        """Masses, kg."""
        return frozen(self._world.bodies().mass)

    @property
    def geom_bodyid(self) -> NDArray[Any]:
        """The body that each geom belongs to."""
        return frozen(self._world.geoms().body_ids)

    @property
    def actuator_gear(self) -> Numbers:
        """Gears, one number per motor (the original has six and uses the first)."""
        return frozen(self._world.actuators().gear)


class OptionView:
    """`model.opt`: time step (s) and gravity (m/s^2), which can be set."""

    def __init__(self, world: World) -> None:
        self._world = world

    @property
    def timestep(self) -> float:
        """Time step of the physics, s."""
        return self._world.timestep

    @property
    def gravity(self) -> Numbers:
        """Gravity of this world, m/s^2."""
        return frozen(self._world.gravity)

    @gravity.setter
    def gravity(self, xyz: ArrayLike) -> None:
        self._world.gravity = np.asarray(xyz, np.float64)


class DataView:
    """The state of the simulation."""

    def __init__(self, world: World) -> None:
        self._world = world
        self._joints, self._actuators = world.joints(), world.actuators()

    def __getattr__(self, name: str) -> Any:
        refuse("data", name)

    @property
    def qpos(self) -> Numbers:
        """Positions of all joints, one after the other."""
        return frozen(self._joints.position)

    @qpos.setter
    def qpos(self, values: ArrayLike) -> None:
        self._joints.position = np.asarray(values, np.float64)
        self._world.update()

    @property
    def qvel(self) -> Numbers:
        """Velocities of all joints."""
        return frozen(self._joints.velocity)

    @qvel.setter
    def qvel(self, values: ArrayLike) -> None:
        self._joints.velocity = np.asarray(values, np.float64)

    @property
    def ctrl(self) -> Numbers:
        """Control inputs of all motors."""
        return frozen(self._actuators.control)

    @property
    def time(self) -> float:
        """Simulated seconds."""
        return self._world.time

    @property
    def contact(self) -> List[Contact]:
        """The contacts of the last physics step."""
        of = self._world.contacts()
        rows = zip(of.geoms.tolist(), of.position, of.distance.tolist(), of.frame)
        return [Contact(geoms[0], geoms[1], pos, dist, frame.ravel()) for geoms, pos, dist, frame in rows]

    @property
    def ncon(self) -> int:
        """The number of contacts."""
        return len(self._world.contacts().distance)

    @property
    def xpos(self) -> Numbers:
        """Origins of all bodies, world, m."""
        return frozen(self._world.bodies().position)

    @property
    def xquat(self) -> Numbers:
        """Orientations of all bodies, w x y z."""
        return frozen(self._world.bodies().orientation)

    def body(self, name: Name) -> Element:
        """A body by name or number: id, name, xpos, xquat."""
        attributes = {"xpos": "position", "xquat": "orientation", "xipos": "center_of_mass"}
        return _element(self._world, Kind.BODY, name, attributes)

    def geom(self, name: Name) -> Element:
        """A geom by name or number: id, name, xpos."""
        return _element(self._world, Kind.GEOM, name, {"xpos": "position"})

    def site(self, name: Name) -> Element:
        """A site by name or number: id, name, xpos."""
        return _element(self._world, Kind.SITE, name, {"xpos": "position"})

    def joint(self, name: Name) -> Element:
        """A joint by name or number: id, name, qpos, qvel."""
        return _element(self._world, Kind.JOINT, name, {"qpos": "position", "qvel": "velocity"})

    def actuator(self, name: Name) -> Element:
        """A motor by name or number: id, name, ctrl, force."""
        return _element(self._world, Kind.ACTUATOR, name, {"ctrl": "control", "force": "force"})


def refuse(what: str, name: str) -> NoReturn:
    """The error for a missing member."""
    raise AttributeError(f"{what} has no {name!r} here; {PAGE}")


def frozen(array: Any) -> NDArray[Any]:
    """The array, read-only; a single number as an array of one."""
    values = np.atleast_1d(np.array(array))
    values.flags.writeable = False
    return values


_SELECT = {
    Kind.BODY: World.bodies,
    Kind.JOINT: World.joints,
    Kind.GEOM: World.geoms,
    Kind.SITE: World.sites,
    Kind.CAMERA: World.cameras,
    Kind.ACTUATOR: World.actuators,
}


def _element(world: World, kind: Kind, name: Name, attributes: Mapping[str, str], addresses: Any = None) -> Element:
    whole: Selection = _SELECT[kind](world)
    number = world.find(kind, name) if isinstance(name, str) else int(name)
    if not 0 <= number < len(whole):
        raise IndexError(f"{kind.name.lower()} is {name!r}, expected 0 to {len(whole) - 1}")
    selection = type(whole)(world, whole.ids[number : number + 1])
    return Element(selection, attributes, -1 if addresses is None else int(addresses[number]))


def _addresses(joints: Joints) -> List[NDArray[np.intp]]:
    """The index of each joint's position and velocity, and at the end their number."""
    single = [Joints(joints._access, joints.ids[i : i + 1]) for i in range(len(joints))]
    widths = [[one.position.size for one in single], [one.velocity.size for one in single]]
    return [np.concatenate([[0], np.cumsum(width)]).astype(np.intp) for width in widths]
