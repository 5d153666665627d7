"""The original's classes of touch, for scripts with a touch of their own.

    class Pain(TrimeshTouch):
        VALID_TOUCH_TYPES = {"pain": 1}

        def pain(self, contact_id, body_id):
            return np.maximum(np.abs(self.get_raw_force(contact_id, body_id)[:1]) - 2, 0)

    class Env(MIMoEnv):
        def touch_setup(self, touch_params):
            self.touch = Pain(self, {**touch_params, "touch_function": "pain"})

Contacts and sensors are the library's, forces are spread here, contact by contact. The touch of an environment that
does not override touch_setup is the library's own, which is faster and feels the curved distance along the skin.
"""

from __future__ import annotations

from functools import wraps
from typing import Any, Callable, Dict, List, Mapping, Sequence, Tuple, TypeVar, cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..constants import Kind, Quantity
from . import sensor_points
from .live import PAGE
from .params import DEFAULT_TOUCH_PARAMS
from .rotations import matrices, matrix
from .utils import EPS, get_geoms_for_body

Numbers = NDArray[np.float64]
Found = Tuple[NDArray[np.intp], Numbers]  # numbers of sensors, and their distances
Function = TypeVar("Function", bound=Callable[..., Any])
WEAKEST = 1e-9  # N; contacts with less are left out
# MuJoCo's types of geoms by the names of the original.
GEOM_TYPES = {"PLANE": 0, "HFIELD": 1, "SPHERE": 2, "CAPSULE": 3, "ELLIPSOID": 4, "CYLINDER": 5, "BOX": 6, "MESH": 7}


def scale_linear(force: ArrayLike, distance: float, scale: float) -> Any:
    """A force that falls linearly to 0 at a distance `scale`."""
    return np.asarray(force) * max(0.0, (scale - distance) / scale)


class Touch:
    """Base of touch: an environment's sensors, and the functions that its parameters name.

    `touch_function(contact, owner)` makes numbers of a contact, `response_function(contact, owner, numbers)` adds them
    to `sensor_outputs`. Derived classes list functions of their own in VALID_TOUCH_TYPES, with how many numbers they
    return, and VALID_RESPONSE_FUNCTIONS. Old names of these are `adjustment_function` and VALID_ADJUSTMENTS.
    """

    VALID_TOUCH_TYPES: Mapping[str, int] = {}
    VALID_RESPONSE_FUNCTIONS: Sequence[str] = ()
    VALID_ADJUSTMENTS: Sequence[str] = ()

    def __init__(self, env: Any, touch_params: Mapping[str, Any]) -> None:
        self.env, self.touch_params = env, touch_params
        self.m_model, self.m_data = env.model, env.data
        scales = touch_params.get("scales", {})
        self.sensor_scales = {env.model.body(body).id: float(scale) for body, scale in scales.items()}
        self.touch_type = self._named(touch_params, "touch_function", self.VALID_TOUCH_TYPES)
        self.touch_function: Any = getattr(self, self.touch_type)
        self.touch_size = self.VALID_TOUCH_TYPES[self.touch_type]
        responses = (*self.VALID_RESPONSE_FUNCTIONS, *self.VALID_ADJUSTMENTS)
        old = (
            {"response_function": touch_params["adjustment_function"]} if "adjustment_function" in touch_params else {}
        )
        self.response_type = self.adjustment_type = self._named({**old, **touch_params}, "response_function", responses)
        self.response_function: Any = getattr(self, self.response_type)
        self.adjustment_function = self.response_function
        self.sensor_outputs: Dict[int, Numbers] = {}
        self.sensor_positions: Dict[int, Numbers] = {}

    def get_touch_obs(self) -> Any:
        """What all sensors feel: N x touch_size. It also sets sensor_outputs."""
        raise NotImplementedError(f"{type(self).__name__} has no method get_touch_obs; write one")

    def _named(self, params: Mapping[str, Any], key: str, known: Any) -> str:
        """The function that the parameters name: by default the original's, or the only one."""
        usual = DEFAULT_TOUCH_PARAMS[key]
        name = params.get(key, usual if usual in known else next(iter(known), usual))
        if name not in known:
            raise ValueError(f"touch_params[{key!r}] is {name!r}, expected {', '.join(map(repr, known))}")
        return str(name)


def _by_either_name(function: Function) -> Function:
    """A method that also takes its argument `body_id` by the name `geom_id`, for sensors on geoms."""

    @wraps(function)
    def call(self: Any, *arguments: Any, **named: Any) -> Any:
        if "geom_id" in named:
            named["body_id"] = named.pop("geom_id")
        return function(self, *arguments, **named)

    return cast(Function, call)


class _State:
    """Contacts of one state as arrays, and the frames of all groups."""

    def __init__(self, view: Any, places: Numbers, quaternions: Numbers) -> None:
        self.view, of = view, view.arrays()
        self.geoms, self.forces, self.frames = of.geoms.tolist(), of.force, of.frame.reshape(-1, 3, 3)
        self.positions, self.distances = of.position, of.distance.tolist()
        self.places, self.turns = places, matrices(quaternions).reshape(-1, 3, 3)


class _Sensors(Touch):
    """Sensors in groups, on bodies or on geoms, contacts, and functions of forces.

    A group has its body's or its geom's number, which methods take as `body_id` or `geom_id`.
    """

    VALID_TOUCH_TYPES: Mapping[str, int] = {"force_vector": 3, "force_vector_global": 3, "normal_force": 3, "normal": 1}
    VALID_RESPONSE_FUNCTIONS = ("nearest", "spread_linear")
    _kind: Kind  # of the groups
    _frames: Tuple[Quantity, Quantity]  # where they are, and how they are turned

    def __init__(self, env: Any, touch_params: Mapping[str, Any]) -> None:
        super().__init__(env, touch_params)
        self._state: Any = None
        self._bodies = np.asarray(env.model.geom_bodyid).tolist()
        for body, scale in list(self.sensor_scales.items()):
            self.add_body(body_id=body, scale=scale)
        self.sensor_outputs = self.get_empty_sensor_dict(self.touch_size)

    def add_body(self, body_id: Any = None, body_name: Any = None, scale: float = np.inf) -> int:
        """Puts sensors on a body, which had none; returns their number."""
        raise NotImplementedError

    def owner_of(self, geom: int) -> int:
        """The number of the group that the sensors on a geom belong to."""
        raise NotImplementedError

    def _spacing(self, owner: int) -> float:
        raise NotImplementedError

    def _now(self) -> _State:
        view = self.m_data.contact
        if self._state is None or self._state.view is not view:
            self._state = _State(view, *(self.m_data._it.read(self._kind, it) for it in self._frames))
        state: _State = self._state
        return state

    def __getattr__(self, name: str) -> Any:
        raise AttributeError(f"{type(self).__name__} has no {name!r} here; {PAGE}")

    # ---- Sensors --------------------------------------------------------------------------------------------------

    @_by_either_name
    def has_sensors(self, body_id: int) -> bool:
        """Whether there are sensors in a group."""
        return int(body_id) in self.sensor_positions

    @_by_either_name
    def get_sensor_count(self, body_id: int) -> int:
        """The number of sensors in a group."""
        return len(self.sensor_positions[int(body_id)])

    def get_total_sensor_count(self) -> int:
        """The number of all sensors."""
        return sum(map(len, self.sensor_positions.values()))

    def get_empty_sensor_dict(self, size: int) -> Dict[int, Numbers]:
        """Zeros for each sensor, N x size, by group."""
        return {owner: np.zeros((len(points), size), np.float32) for owner, points in self.sensor_positions.items()}

    def flatten_sensor_dict(self, sensor_dict: Mapping[int, ArrayLike]) -> Any:
        """The numbers of all groups in one array, in the order of their numbers."""
        return np.concatenate([np.asarray(sensor_dict[owner]) for owner in sorted(sensor_dict)])

    def _distances(self, contact_pos: ArrayLike, owner: int) -> Numbers:
        distances: Numbers = np.linalg.norm(self.sensor_positions[int(owner)] - np.asarray(contact_pos), axis=1)
        return distances

    def _k_nearest(self, contact_pos: ArrayLike, owner: int, k: int) -> Found:
        distances = self._distances(contact_pos, owner)
        nearest = np.argsort(distances, kind="stable")[:k]
        return nearest, distances[nearest]

    def _within(self, contact_pos: ArrayLike, owner: int, limit: float) -> Found:
        distances = self._distances(contact_pos, owner)
        near = np.flatnonzero(distances < limit)
        return near, distances[near]

    # ---- Contacts -------------------------------------------------------------------------------------------------

    def get_contacts(self) -> List[Tuple[int, int, Any]]:
        """Contacts of sensors: number of the contact, number of the group, and what the touch function makes of it."""
        found, state = [], self._now()
        for contact, geoms in enumerate(state.geoms):
            if abs(state.forces[contact, 0]) >= WEAKEST:
                owners = dict.fromkeys(self.owner_of(geom) for geom in geoms)
                touched = [owner for owner in owners if owner in self.sensor_positions]
                found += [(contact, owner, self.touch_function(contact, owner)) for owner in touched]
        return found

    def _sign(self, contact: int, owner: int) -> int:
        """-1 if the first geom of a contact belongs to a group, 1 if the second does: forces act on the second."""
        first, second = self._now().geoms[contact]
        if self.owner_of(first) == owner:
            return -1
        if self.owner_of(second) == owner:
            return 1
        raise ValueError(f"contact {contact} is not one of {owner}: its geoms are {first} and {second}")

    @_by_either_name
    def get_raw_force(self, contact_id: int, body_id: int) -> Numbers:
        """The force on the sensors' side of a contact, in the contact's frame, N: normal, two tangents."""
        force: Numbers = self._sign(contact_id, body_id) * self._now().forces[contact_id]
        return force

    @_by_either_name
    def get_contact_normal(self, contact_id: int, body_id: int) -> Numbers:
        """The normal of a contact, towards the sensors' side, world."""
        normal: Numbers = self._sign(contact_id, body_id) * self._now().frames[contact_id, 0]
        return normal

    def get_contact_position_world(self, contact_id: int) -> Numbers:
        """The position of a contact, midway in the overlap, world, m."""
        return np.array(self._now().positions[contact_id])

    @_by_either_name
    def get_contact_position_relative(self, contact_id: int, body_id: int) -> Numbers:
        """The position of a contact on the sensors' own surface, in their frame, m."""
        state = self._now()
        overlap = max(0.0, -state.distances[contact_id])
        on_surface = state.positions[contact_id] - self.get_contact_normal(contact_id, body_id) * overlap / 2
        place: Numbers = (on_surface - state.places[body_id]) @ state.turns[body_id]
        return place

    # ---- Touch functions ------------------------------------------------------------------------------------------

    @_by_either_name
    def force_vector_global(self, contact_id: int, body_id: int) -> Numbers:
        """The force on the sensors' side of a contact, world, N."""
        force: Numbers = self.get_raw_force(contact_id, body_id) @ self._now().frames[contact_id]
        return force

    @_by_either_name
    def force_vector(self, contact_id: int, body_id: int) -> Numbers:
        """The same in the sensors' frame."""
        force: Numbers = self.force_vector_global(contact_id, body_id) @ self._now().turns[body_id]
        return force

    @_by_either_name
    def normal_force(self, contact_id: int, body_id: int) -> Numbers:
        """Its part along the contact's normal, in the sensors' frame."""
        state = self._now()
        along = self.get_raw_force(contact_id, body_id)[0] * state.frames[contact_id, 0]
        force: Numbers = along @ state.turns[body_id]
        return force

    @_by_either_name
    def normal(self, contact_id: int, body_id: int) -> Numbers:
        """The force along the contact's normal, one number."""
        return self.get_raw_force(contact_id, body_id)[:1]

    @_by_either_name
    def get_force(self, contact_id: int, body_id: int) -> Any:
        """What the touch function makes of a contact."""
        return self.touch_function(contact_id, body_id)

    # ---- Response functions ---------------------------------------------------------------------------------------

    @_by_either_name
    def nearest(self, contact_id: int, body_id: int, force: Any) -> None:
        """Adds a force to the nearest sensor."""
        place = self.get_contact_position_relative(contact_id, body_id)
        sensors, _ = self._k_nearest(place, body_id, 1)
        self.sensor_outputs[int(body_id)][sensors] += force

    @_by_either_name
    def spread_linear(self, contact_id: int, body_id: int, force: Any) -> None:
        """Adds a force to the sensors within two spacings, less to those far away; its sum is conserved."""
        reach = 2 * self._spacing(int(body_id))
        place = self.get_contact_position_relative(contact_id, body_id)
        sensors, distances = self._within(place, body_id, reach)
        weights = 1 - distances / reach
        if len(sensors) == 0 or np.sum(weights) < EPS:
            return
        self.sensor_outputs[int(body_id)][sensors] += np.outer(weights / np.sum(weights), force)

    def get_touch_obs(self) -> Any:
        """What all sensors feel: N x touch_size. It also sets sensor_outputs."""
        contacts = self.get_contacts()
        self.sensor_outputs = self.get_empty_sensor_dict(self.touch_size)
        for contact, owner, felt in contacts:
            self.response_function(contact, owner, felt)
        return self.flatten_sensor_dict(self.sensor_outputs)


class Mesh:
    """The sensors of a body, as far as scripts use the original's meshes: `vertices`."""

    def __init__(self, vertices: Numbers) -> None:
        self.vertices = vertices


class TrimeshTouch(_Sensors):
    """Sensors on bodies, without those inside the body; forces in the body's frame. All groups are bodies."""

    _kind, _frames = Kind.BODY, (Quantity.BODY_POSITION, Quantity.BODY_ORIENTATION)

    def __init__(self, env: Any, touch_params: Mapping[str, Any]) -> None:
        self.meshes: Dict[int, Mesh] = {}
        self.active_vertices: Dict[int, NDArray[np.bool_]] = {}
        super().__init__(env, touch_params)

    def add_body(self, body_id: Any = None, body_name: Any = None, scale: float = np.inf) -> int:
        """Puts sensors on a body, which had none; returns their number."""
        body = int(self.m_model.body(body_name if body_id is None else body_id).id)
        skin = self.env.observer.touch
        given = {self.m_model.body(name).id: it for name, it in (self.env.touch_params or {}).get("scales", {}).items()}
        if skin is not None and given.get(body) == scale and body in skin.sensor_positions:
            points = np.array(skin.sensor_positions[body], np.float64)
        else:
            points = self._points(body, scale)
        if len(points) == 0:
            return 0
        self.sensor_scales[body], self.sensor_positions[body] = scale, points
        self.meshes[body], self.active_vertices[body] = Mesh(points), np.ones(len(points), np.bool_)
        return len(points)

    def _points(self, body: int, scale: float) -> Numbers:
        """Points on the body's geoms, without those inside another one."""
        model, geoms = self.m_model, _touchable(self.m_model, body)
        turns = {geom: matrix(model.geom_quat[geom]) for geom in geoms}
        spread = [_points_on(model, geom, scale) @ turns[geom].T + model.geom_pos[geom] for geom in geoms]
        kept = []
        for own, points in zip(geoms, spread):
            hidden = np.zeros(len(points), np.bool_)
            for other in geoms:
                if other != own:
                    local = (points - model.geom_pos[other]) @ turns[other]
                    hidden |= sensor_points.is_inside(int(model.geom_type[other]), model.geom_size[other], local)
            kept.append(points[~hidden])
        return np.concatenate(kept) if kept else np.empty((0, 3))

    def owner_of(self, geom: int) -> int:
        """The body of a geom."""
        return self._bodies[geom]  # type: ignore[no-any-return]

    def _spacing(self, owner: int) -> float:
        return self.sensor_scales[owner]

    def get_nearest_sensor(self, contact_pos: ArrayLike, body_id: int) -> Tuple[int, float]:
        """The nearest sensor of a body to a point in the body's frame, and its distance."""
        sensors, distances = self._k_nearest(contact_pos, body_id, 1)
        return int(sensors[0]), float(distances[0])

    def get_k_nearest_sensors(self, contact_pos: ArrayLike, body_id: int, k: int) -> Found:
        """The k nearest, and their distances."""
        return self._k_nearest(contact_pos, body_id, k)

    def get_sensors_within_distance(self, contact_pos: ArrayLike, body_id: int, distance_limit: float) -> Found:
        """All within a distance, and their distances."""
        return self._within(contact_pos, body_id, distance_limit)

    @property
    def sensing_bodies(self) -> List[int]:
        """Numbers of the bodies with sensors."""
        return list(self.sensor_positions)

    @property
    def sensor_body_names(self) -> List[str]:
        """Names of the bodies with sensors."""
        return [self.m_model.body(body).name for body in self.sensor_positions]


class DiscreteTouch(_Sensors):
    """Sensors on geoms, also inside other geoms; forces in the geom's frame. All groups are geoms."""

    _kind, _frames = Kind.GEOM, (Quantity.GEOM_POSITION, Quantity.GEOM_ORIENTATION)

    def add_body(self, body_id: Any = None, body_name: Any = None, scale: float = np.inf) -> int:
        """Puts sensors on the geoms of a body, which had none; returns their number."""
        body = int(self.m_model.body(body_name if body_id is None else body_id).id)
        self.sensor_scales[body] = scale
        return sum(self.add_geom(geom_id=geom, scale=scale) for geom in _touchable(self.m_model, body))

    def add_geom(self, geom_id: Any = None, geom_name: Any = None, scale: float = np.inf) -> int:
        """Puts sensors on a geom, which had none; returns their number."""
        geom = int(self.m_model.geom(geom_name if geom_id is None else geom_id).id)
        points = _points_on(self.m_model, geom, scale)
        if len(points):
            self.sensor_positions[geom] = points
            self.sensor_scales.setdefault(int(self.m_model.geom_bodyid[geom]), scale)
        return len(points)

    def owner_of(self, geom: int) -> int:
        """The geom itself."""
        return geom

    def _spacing(self, owner: int) -> float:
        return self.sensor_scales[self._bodies[owner]]

    def get_nearest_sensor(self, contact_id: int, geom_id: int) -> Tuple[int, float]:
        """The nearest sensor of a geom to a contact, and its distance."""
        sensors, distances = self._k_nearest(self.get_contact_position_relative(contact_id, geom_id), geom_id, 1)
        return int(sensors[0]), float(distances[0])

    def get_k_nearest_sensors(self, contact_id: int, geom_id: int, k: int) -> Found:
        """The k nearest, and their distances."""
        return self._k_nearest(self.get_contact_position_relative(contact_id, geom_id), geom_id, k)

    def get_sensors_within_distance(self, contact_id: int, geom_id: int, distance: float) -> Found:
        """All within a distance, and their distances."""
        return self._within(self.get_contact_position_relative(contact_id, geom_id), geom_id, distance)

    @property
    def sensing_geoms(self) -> List[int]:
        """Numbers of the geoms with sensors."""
        return list(self.sensor_positions)


def _touchable(model: Any, body: int) -> List[int]:
    """Geoms of a body that can be touched at all."""
    geoms = get_geoms_for_body(model, body)
    return [geom for geom in geoms if model.geom_contype[geom] or model.geom_conaffinity[geom]]


def _points_on(model: Any, geom: int, scale: float) -> Numbers:
    return sensor_points.spread_on(int(model.geom_type[geom]), np.asarray(model.geom_size[geom]), scale)
