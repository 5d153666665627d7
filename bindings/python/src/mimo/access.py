"""Named access: joints, bodies, ... of one world, or of all worlds of a batch at once.

    hands = world.bodies("left_hand", "right_hand")     # looked up once
    hands.position                                      # (2, 3); of a batch (worlds, 2, 3)
    world.joints("robot:left_elbow").position = -0.5

Quantities of one number (an angle, a mass) have no axis of their own: (n,), or (worlds, n). Joints of different kinds
together give their values one after the other.
docs/guide/time-and-frames.md says when and in which frame values are true.
"""

from __future__ import annotations

import ctypes
from typing import Any, List, Optional, Sequence, Tuple, Type, TypeVar, Union, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._handle import Handle, Native
from ._library import LIB, check, text, utf8
from ._strict import Strict, reading
from .arguments import described, index_in, number_of, whole_number
from .constants import NOW, Kind, Quantity
from .layout import Fields, Layout, Observation
from .results import Last, Numbers, Results, StepResult

Mask = Optional[NDArray[np.bool_]]
Which = Union[None, str, Sequence[Union[str, int]]]  # names or numbers of some; None: all of a kind
SHOWN = 8  # names in a selection's repr
S = TypeVar("S", bound="Selection")


class Access(Handle):
    """What worlds and batches have in common: names, and reading and writing by them."""

    world_count: int = 1
    agents: List[Any]  # what is to be known of each infant of a world: name, actions, mass, height
    action_names: List[str]
    action_low: NDArray[np.float32]
    action_high: NDArray[np.float32]
    layout: Layout
    reward: Numbers  # of the last step, one an infant; of a batch with the worlds in front, as all that follow
    terminated: NDArray[np.bool_]
    truncated: NDArray[np.bool_]
    outcome: NDArray[np.int32]  # of mimo.Outcome
    terms: Numbers  # that the rewards are the sums of, in the order of layout.terms
    _scene: Any
    _last: Last
    _result: StepResult
    _names_handle: Native  # of an environment that knows the names
    _lead: Tuple[int, ...] = ()  # (worlds,) for a batch

    def _take(self, layout: Layout, agents: List[Any]) -> None:
        """What it is: from its layout, in the form in which it is mostly used."""
        self._have(
            layout=layout,
            agents=agents,
            action_names=[action.name for action in layout.actions],
            action_low=reading(np.array([action.low for action in layout.actions], np.float32)),
            action_high=reading(np.array([action.high for action in layout.actions], np.float32)),
        )

    def _show(self, results: Results, views: Observation) -> None:
        """Has what steps give as attributes."""
        self._result, self._last = results.shown(views), Last(views)
        self._have(**results.__dict__)

    @property
    def observation(self) -> Observation:
        """What was sensed last, by a step, reset or observe, into whatever block; zeros before anything was."""
        sensed = self._last.sensed
        if not isinstance(sensed, Fields):
            named = self.layout.views(sensed) if isinstance(sensed, np.ndarray) else Fields(sensed)
            sensed = self._last.sensed = named
        return sensed

    @property
    def action(self) -> Optional[NDArray[np.float32]]:
        """The actions of the last step, within their bounds: (actions,), of a batch (worlds, actions).

        None where the step was given none, and after a reset of all.
        """
        given = self._last.actions
        return None if given is None else reading(np.clip(given, self.action_low, self.action_high))

    def bodies(self, *names: str) -> "Bodies":
        """Rigid bodies by name; without names, all of them."""
        return self._select(Bodies, names)

    def joints(self, *names: str) -> "Joints":
        """Joints by name; without names, all of them."""
        return self._select(Joints, names)

    def geoms(self, *names: str) -> "Geoms":
        """Shapes of bodies by name; without names, all of them."""
        return self._select(Geoms, names)

    def sites(self, *names: str) -> "Sites":
        """Marked places on bodies by name; without names, all of them."""
        return self._select(Sites, names)

    def cameras(self, *names: str) -> "Cameras":
        """Cameras by name; without names, all of them."""
        return self._select(Cameras, names)

    def actuators(self, *names: str) -> "Actuators":
        """Motors by name; without names, all of them."""
        return self._select(Actuators, names)

    def sensors(self, *names: str) -> "Sensors":
        """MuJoCo's sensors by name; without names, all of them."""
        return self._select(Sensors, names)

    def lights(self, *names: str) -> "Lights":
        """Lights by name; without names, all of them."""
        return self._select(Lights, names)

    def get(self, quantity: Quantity, which: Which = None, now: bool = False, dtype: Any = np.float64) -> Numbers:
        """A quantity of some elements, by names or numbers, or of all of its kind; in a batch of all worlds.

        Poses and velocities are as mimo_env_get says; with `now` those of the current positions. `dtype` is float64 or
        float32.
        """
        what = Quantity(whole_number("quantity", quantity, Quantity))
        return self._some(what, which)._get(what, now, dtype)

    def set(self, quantity: Quantity, values: ArrayLike, which: Which = None, mask: Mask = None) -> None:
        """Writes a quantity of some elements, by names or numbers, or of all of its kind.

        In a batch `values` has a row for each world, or is the same for all; `mask` says which worlds are concerned.
        """
        what = Quantity(whole_number("quantity", quantity, Quantity))
        self._some(what, which)._set(what, values, mask)

    def find(self, kind: Kind, name: str) -> int:
        """The number of something by its name."""
        found = ctypes.c_int32()
        check(LIB.mimo_env_find(self._names_handle, whole_number("kind", kind, Kind), utf8(name), found))
        return found.value

    def name(self, kind: Kind, number: int) -> str:
        """The name of something, "" where the model gives none."""
        found = ctypes.c_char_p()
        index = number_of("number", number, 31)
        check(LIB.mimo_env_name(self._names_handle, whole_number("kind", kind, Kind), index, found))
        return text(found.value)

    def count(self, kind: Kind) -> int:
        """How many of a kind there are."""
        count = ctypes.c_size_t()
        check(LIB.mimo_env_count(self._names_handle, whole_number("kind", kind, Kind), count))
        return count.value

    def random(self, count: int, mask: Mask = None) -> Numbers:
        """Numbers from 0 to 1 from the world's own stream: (count,); of a batch (worlds, count), 0 where masked out."""
        raise NotImplementedError

    def __repr__(self) -> str:
        worlds = f"{self.world_count} x " if self._lead else ""
        counts = f"{len(self.agents)} infants, {len(self.action_names)} actions"
        fields = [f"{field.name} {field.shape}" for field in self.layout.fields.values()]
        return f"<mimo.{type(self).__name__} {worlds}{self._scene.source}: {counts}; {', '.join(fields)}>"

    def world(self, index: int) -> Any:
        """One of the worlds, 0 to world_count - 1, as a mimo.World; a world is its own number 0."""
        raise NotImplementedError

    def contacts(self, world: int) -> Any:
        """The contacts in one of the worlds, 0 to world_count - 1."""
        raise NotImplementedError

    def _agent(self, agent: int) -> int:
        return 0 if agent == 0 else index_in("agent", agent, len(self.agents))  # the loop of steps asks for 0

    def _select(self, kind: Type[S], names: Tuple[str, ...]) -> S:
        ids = [self.find(kind.kind, name) for name in names] or range(self.count(kind.kind))
        return kind(self, np.array(ids, np.int32))

    def _some(self, quantity: Quantity, which: Which) -> "Selection":
        """Elements of the kind that a quantity belongs to."""
        kind = kind_of(quantity)
        if which is None:
            ids: Any = range(self.count(kind))
        else:
            some = [which] if isinstance(which, str) else which
            ids = [self.find(kind, one) if isinstance(one, str) else number_of("which", one, 31) for one in some]
        return Selection(self, np.array(ids, np.int32), kind)

    def _read(self, quantity: int, ids: NDArray[np.int32], values: Numbers) -> None:
        raise NotImplementedError

    def _write(self, quantity: int, ids: NDArray[np.int32], values: Numbers, mask: Mask) -> None:
        raise NotImplementedError


def kind_of(quantity: Quantity) -> Kind:
    """What a quantity is one of: its name begins so."""
    return max((kind for kind in Kind if quantity.name.startswith(kind.name)), key=lambda kind: len(kind.name))


class Selection(Strict):
    """Some bodies, joints, ...: their numbers in `ids`, their names in `names`."""

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
        """Names, in order; "" where the model gives none."""
        return [self._access.name(self.kind, int(number)) for number in self.ids]

    @property
    def body_ids(self) -> NDArray[np.int32]:
        """The body that each belongs to, or the parent of a body."""
        found = ctypes.c_int32()
        bodies = []
        for number in self.ids:
            check(LIB.mimo_env_body_of(self._access._names_handle, self.kind, int(number), found))
            bodies.append(found.value)
        return np.array(bodies, np.int32)

    def read(self, quantity: str, now: bool = False) -> Numbers:
        """As `selection.quantity`; with `now` a pose or velocity is that of the current positions."""
        attribute = getattr(type(self), quantity, None)
        if not isinstance(attribute, Values):
            raise AttributeError(f"{type(self).__name__.lower()} have no {quantity}")
        return self._get(attribute.quantity, now)

    def write(self, quantity: str, values: ArrayLike, mask: Mask = None) -> None:
        """As `selection.quantity = values`, but in a batch only in the worlds where mask is True."""
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
            given = given.reshape(shape)  # one element or one world needs no axis of its own
        try:
            whole = np.ascontiguousarray(np.broadcast_to(given, shape))
        except ValueError:
            what = f"{quantity.name.lower()} of the shape {given.shape}"
            raise ValueError(f"{what}, expected {shape}, or one number for all") from None
        self._access._write(quantity, self.ids, whole, mask)

    def _shape(self, quantity: Quantity) -> Tuple[Tuple[int, ...], int]:
        """Shape of a quantity's values, asked for once."""
        if quantity not in self._shapes:
            widths = [self._width(quantity, self.ids[i : i + 1]) for i in range(len(self.ids))]
            total = sum(widths)
            same = len(set(widths)) == 1 and widths[0] > 1
            own = (len(widths), widths[0]) if same else (total,)
            self._shapes[quantity] = (self._access._lead + own, total)
        return self._shapes[quantity]

    def _width(self, quantity: Quantity, ids: NDArray[np.int32]) -> int:
        count = ctypes.c_size_t()
        check(LIB.mimo_env_width(self._access._names_handle, quantity, ids.ctypes.data, len(ids), count))
        return count.value


class Values:
    """A quantity that can be read."""

    def __init__(self, quantity: Quantity, doc: str) -> None:
        self.quantity = quantity
        self.__doc__ = doc

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


class Bodies(Selection):
    """Rigid bodies."""

    kind = Kind.BODY
    position = WritableValues(Quantity.BODY_POSITION, "Of the origin, world, m. Writable with a free joint, or fixed.")
    orientation = WritableValues(Quantity.BODY_ORIENTATION, "Quaternion w x y z. Writable as the position.")
    velocity = Values(Quantity.BODY_VELOCITY, "Linear (m/s) of the origin, angular (rad/s), world frame: 6.")
    pose = WritableValues(Quantity.BODY_POSE, "Position and orientation: 7. Writable as they are.")
    force = WritableValues(Quantity.BODY_FORCE, "Force (N), torque (Nm) that you apply until changed or reset: 6.")
    mass = WritableValues(Quantity.BODY_MASS, "kg; inertia grows along, outlives resets.")
    center_of_mass = Values(Quantity.BODY_CENTER_OF_MASS, "Of the body alone, world, m.")
    nerve_length = Values(Quantity.BODY_NERVE_LENGTH, "Of an infant's nerves from here to its head, m; else 0.")


class Joints(Selection):
    """Joints: hinges (1 number), ball joints (4, velocity 3) and free joints (7, velocity 6)."""

    kind = Kind.JOINT
    position = WritableValues(Quantity.JOINT_POSITION, "rad, m, or quaternion.")
    velocity = WritableValues(Quantity.JOINT_VELOCITY, "rad/s, m/s.")
    force = WritableValues(Quantity.JOINT_FORCE, "Generalised force that you apply until changed or reset.")
    damping = WritableValues(Quantity.JOINT_DAMPING, "Nms/rad, Ns/m; outlives resets.")
    lock = WritableValues(Quantity.JOINT_LOCK, "1 or 0, held or not, and the angle (rad): 2; outlives resets.")
    acceleration = Values(Quantity.JOINT_ACCELERATION, "rad/s^2, m/s^2.")
    range = Values(Quantity.JOINT_RANGE, "Low and high; -inf and inf when not limited.")


class Geoms(Selection):
    """Shapes of bodies."""

    kind = Kind.GEOM
    position = Values(Quantity.GEOM_POSITION, "World, m.")
    orientation = Values(Quantity.GEOM_ORIENTATION, "Quaternion w x y z.")
    pose = Values(Quantity.GEOM_POSE, "Position and orientation: 7.")
    size = WritableValues(Quantity.GEOM_SIZE, "Three numbers by shape, m; outlives resets.")
    friction = WritableValues(Quantity.GEOM_FRICTION, "Sliding, torsional, rolling: 3; outlives resets.")
    color = WritableValues(Quantity.GEOM_COLOR, "Red, green, blue, opacity, 0 to 1: 4; outlives resets.")


class Sites(Selection):
    """Marked places on bodies."""

    kind = Kind.SITE
    position = Values(Quantity.SITE_POSITION, "World, m.")
    orientation = Values(Quantity.SITE_ORIENTATION, "Quaternion w x y z.")
    pose = Values(Quantity.SITE_POSE, "Position and orientation: 7.")
    velocity = Values(Quantity.SITE_VELOCITY, "Linear (m/s) of the position, angular (rad/s), world frame: 6.")


class Cameras(Selection):
    """Cameras; they look along their -z, +y is up in the picture."""

    kind = Kind.CAMERA
    position = Values(Quantity.CAMERA_POSITION, "World, m.")
    orientation = Values(Quantity.CAMERA_ORIENTATION, "Quaternion w x y z.")
    pose = Values(Quantity.CAMERA_POSE, "Position and orientation: 7.")


class Actuators(Selection):
    """Motors."""

    kind = Kind.ACTUATOR
    control = WritableValues(Quantity.ACTUATOR_CONTROL, "Control input.")
    force = Values(Quantity.ACTUATOR_FORCE, "N or Nm.")
    gear = WritableValues(Quantity.ACTUATOR_GEAR, "Torque at control input 1, Nm; outlives resets.")
    fusimotor_drive = WritableValues(
        Quantity.ACTUATOR_FUSIMOTOR_DRIVE,
        "Dynamic and static drive of the spindles of its two muscles, Hz, until changed or reset: 4.",
    )


class Sensors(Selection):
    """MuJoCo's sensors."""

    kind = Kind.SENSOR
    value = Values(Quantity.SENSOR_VALUE, "In the sensor's unit.")


class Lights(Selection):
    """Lights; what is set here outlives resets."""

    kind = Kind.LIGHT
    position = WritableValues(Quantity.LIGHT_POSITION, "In the frame of its body, mostly the world, m.")
    direction = WritableValues(Quantity.LIGHT_DIRECTION, "Unit vector in that frame.")
    color = WritableValues(Quantity.LIGHT_COLOR, "Red, green, blue: 3.")
