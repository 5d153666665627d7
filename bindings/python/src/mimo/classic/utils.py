"""Functions of the original's `mimoEnv.utils`. `model` and `data` are those of an environment."""

from __future__ import annotations

from typing import Any, List, Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .elements import Arrays
from .model import DataView, ModelView
from .rotations import matrix

__all__ = [
    "EPS",
    "MUJOCO_DOF_SIZES",
    "MUJOCO_JOINT_SIZES",
    "body_pos_to_body",
    "body_pos_to_geom",
    "body_pos_to_world",
    "body_rot_to_body",
    "body_rot_to_geom",
    "body_rot_to_world",
    "geom_pos_to_body",
    "geom_pos_to_geom",
    "geom_pos_to_world",
    "geom_rot_to_body",
    "geom_rot_to_geom",
    "geom_rot_to_world",
    "get_body_id",
    "get_body_position",
    "get_body_rotation",
    "get_child_bodies",
    "get_data_for_sensor",
    "get_geom_id",
    "get_geom_position",
    "get_geom_rotation",
    "get_geoms_for_body",
    "get_joint_qpos_addr",
    "get_joint_qvel_addr",
    "get_sensor_addr",
    "lock_joint",
    "matrix",
    "normalize_vectors",
    "plot_forces",
    "plot_points",
    "rotate_vector",
    "rotate_vector_transpose",
    "set_joint_locking_angle",
    "set_joint_qpos",
    "unlock_joint",
    "weighted_sum_vectors",
    "world_pos_to_body",
    "world_pos_to_geom",
    "world_rot_to_body",
    "world_rot_to_geom",
]

Numbers = NDArray[np.float64]
EPS = 1e-10
MUJOCO_JOINT_SIZES = {0: 7, 1: 4, 2: 1, 3: 1}  # numbers in qpos of a joint: free, ball, slide, hinge
MUJOCO_DOF_SIZES = {0: 6, 1: 3, 2: 1, 3: 1}  # ... in qvel


# ---- Vectors -----------------------------------------------------------------------------------------------------


def rotate_vector(vector: ArrayLike, rot_matrix: ArrayLike) -> Numbers:
    """The vector (3, or 3 x n), turned by a matrix."""
    return np.asarray(rot_matrix).dot(np.asarray(vector))


def rotate_vector_transpose(vector: ArrayLike, rot_matrix: ArrayLike) -> Numbers:
    """The vector (3, or 3 x n), turned back."""
    return np.asarray(rot_matrix).T.dot(np.asarray(vector))


def weighted_sum_vectors(vector1: ArrayLike, vector2: ArrayLike, weight1: float, weight2: float) -> Numbers:
    """The weighted mean of two vectors."""
    return np.average([vector1, vector2], axis=0, weights=[weight1, weight2])  # type: ignore[no-any-return]


def normalize_vectors(vectors: ArrayLike) -> Numbers:
    """Vectors (their last axis) of length 1."""
    values = np.asarray(vectors, np.float64)
    return np.asarray(values / np.linalg.norm(values, axis=-1, keepdims=True))


# ---- Elements ----------------------------------------------------------------------------------------------------


def get_body_id(model: ModelView, body_id: Optional[int] = None, body_name: Optional[str] = None) -> int:
    """The number of a body, by its name; or the number that is given."""
    return _number(model, "body", body_id, body_name)


def get_geom_id(model: ModelView, geom_id: Optional[int] = None, geom_name: Optional[str] = None) -> int:
    """The number of a geom, by its name; or the number that is given."""
    return _number(model, "geom", geom_id, geom_name)


def _number(model: ModelView, kind: str, number: Optional[int], name: Optional[str]) -> int:
    if number is None and name is None:
        raise ValueError(f"{kind}_id and {kind}_name are None, expected one of them")
    return int(number) if number is not None else int(getattr(_view(model), kind)(name).id)


def get_geoms_for_body(model: ModelView, body_id: int) -> List[int]:
    """Numbers of a body's geoms."""
    return [int(geom) for geom in np.flatnonzero(_view(model).geom_bodyid == body_id)]


def get_child_bodies(model: ModelView, body_id: int) -> List[int]:
    """Numbers of a body and its descendants, in order."""
    parents, found = _view(model).body_parentid, [int(body_id)]
    for body in range(int(body_id) + 1, len(parents)):  # parents come before their children
        if parents[body] in found:
            found.append(body)
    return found


def get_sensor_addr(model: ModelView, sensor_id: int) -> range:
    """The indices of a sensor's numbers in sensordata."""
    start = int(_view(model).sensor_adr[sensor_id])
    return range(start, start + int(model.sensor_dim[sensor_id]))


def get_data_for_sensor(model: ModelView, data: DataView, sensor_name: str) -> Numbers:
    """The numbers of a sensor."""
    return _view(data).sensor(sensor_name).data.copy()  # type: ignore[no-any-return]


# ---- Joints ------------------------------------------------------------------------------------------------------


def set_joint_qpos(model: ModelView, data: DataView, joint_name: str, qpos: ArrayLike) -> None:
    """Sets a joint's position: a number, or seven for a free joint."""
    _view(data).joint(joint_name).qpos = qpos


def get_joint_qpos_addr(model: ModelView, joint_id: int) -> range:
    """The indices of a joint's position in qpos."""
    at = _view(model)._it.qpos_at
    return range(int(at[int(joint_id)]), int(at[int(joint_id) + 1]))


def get_joint_qvel_addr(model: ModelView, joint_id: int) -> range:
    """The indices of a joint's velocity in qvel."""
    at = _view(model)._it.qvel_at
    return range(int(at[int(joint_id)]), int(at[int(joint_id) + 1]))


def set_joint_locking_angle(
    model: ModelView, joint_name: str, angle: ArrayLike, constraint_id: Optional[ArrayLike] = None
) -> None:
    """Sets the angle (rad) at which a joint is held when it is locked."""
    world = _view(model)._world
    names = [joint_name] if constraint_id is None else [model.names_of("equality")[i] for i in np.ravel(constraint_id)]
    for name, value in zip(names, np.broadcast_to(angle, len(names))):
        held = world.locked(name) is not None
        world.lock(name, float(value))
        if not held:
            world.unlock(name)


def lock_joint(model: ModelView, joint_name: str, joint_angle: Optional[float] = None) -> None:
    """Locks a joint softly at an angle (rad); the default is the angle of its lock, usually 0."""
    world = _view(model)._world
    if joint_angle is None:
        joint_angle = float(world.joints(joint_name).lock.ravel()[1])
    world.lock(joint_name, float(joint_angle))


def unlock_joint(model: ModelView, joint_name: str) -> None:
    """Releases a joint."""
    _view(model)._world.unlock(joint_name)


# ---- Places and directions ---------------------------------------------------------------------------------------


def get_body_position(data: DataView, body_id: Any) -> Numbers:
    """The position of a body's origin, world, m."""
    return _view(data).body(body_id).xpos.copy()  # type: ignore[no-any-return]


def get_geom_position(data: DataView, geom_id: Any) -> Numbers:
    """The position of a geom, world, m."""
    return _view(data).geom(geom_id).xpos.copy()  # type: ignore[no-any-return]


def get_body_rotation(data: DataView, body_id: Any) -> Numbers:
    """The rotation of a body: 3 x 3, from its frame to the world's."""
    return _view(data).body(body_id).xmat.copy().reshape(3, 3)  # type: ignore[no-any-return]


def get_geom_rotation(data: DataView, geom_id: Any) -> Numbers:
    """The rotation of a geom: 3 x 3, from its frame to the world's."""
    return _view(data).geom(geom_id).xmat.copy().reshape(3, 3)  # type: ignore[no-any-return]


def body_rot_to_world(data: DataView, vector: ArrayLike, body_id: int) -> Numbers:
    """Turns a direction (or n x 3) from a body's frame to the world."""
    return np.asarray(vector) @ get_body_rotation(data, body_id).T


def world_rot_to_body(data: DataView, vector: ArrayLike, body_id: int) -> Numbers:
    """Turns a direction (or n x 3) from the world to a body's frame."""
    return np.asarray(vector) @ get_body_rotation(data, body_id)


def geom_rot_to_world(data: DataView, vector: ArrayLike, geom_id: int) -> Numbers:
    """Turns a direction (or n x 3) from a geom's frame to the world."""
    return np.asarray(vector) @ get_geom_rotation(data, geom_id).T


def world_rot_to_geom(data: DataView, vector: ArrayLike, geom_id: int) -> Numbers:
    """Turns a direction (or n x 3) from the world to a geom's frame."""
    return np.asarray(vector) @ get_geom_rotation(data, geom_id)


def body_pos_to_world(data: DataView, position: ArrayLike, body_id: int) -> Numbers:
    """Converts a point (or n x 3) from a body's frame to the world, m."""
    return body_rot_to_world(data, position, body_id) + get_body_position(data, body_id)


def world_pos_to_body(data: DataView, position: ArrayLike, body_id: int) -> Numbers:
    """Converts a point (or n x 3) from the world to a body's frame, m."""
    return world_rot_to_body(data, np.asarray(position) - get_body_position(data, body_id), body_id)


def geom_pos_to_world(data: DataView, position: ArrayLike, geom_id: int) -> Numbers:
    """Converts a point (or n x 3) from a geom's frame to the world, m."""
    return geom_rot_to_world(data, position, geom_id) + get_geom_position(data, geom_id)


def world_pos_to_geom(data: DataView, position: ArrayLike, geom_id: int) -> Numbers:
    """Converts a point (or n x 3) from the world to a geom's frame, m."""
    return world_rot_to_geom(data, np.asarray(position) - get_geom_position(data, geom_id), geom_id)


def geom_pos_to_body(data: DataView, position: ArrayLike, geom_id: int, body_id: int) -> Numbers:
    """Converts a point from a geom's frame to a body's, m."""
    return world_pos_to_body(data, geom_pos_to_world(data, position, geom_id), body_id)


def body_pos_to_geom(data: DataView, position: ArrayLike, body_id: int, geom_id: int) -> Numbers:
    """Converts a point from a body's frame to a geom's, m."""
    return world_pos_to_geom(data, body_pos_to_world(data, position, body_id), geom_id)


def geom_pos_to_geom(data: DataView, position: ArrayLike, geom_id_source: int, geom_id_target: int) -> Numbers:
    """Converts a point from a geom's frame to another's, m."""
    return world_pos_to_geom(data, geom_pos_to_world(data, position, geom_id_source), geom_id_target)


def body_pos_to_body(data: DataView, position: ArrayLike, body_id_source: int, body_id_target: int) -> Numbers:
    """Converts a point from a body's frame to another's, m."""
    return world_pos_to_body(data, body_pos_to_world(data, position, body_id_source), body_id_target)


def geom_rot_to_body(data: DataView, vector: ArrayLike, geom_id: int, body_id: int) -> Numbers:
    """Turns a direction from a geom's frame to a body's."""
    return world_rot_to_body(data, geom_rot_to_world(data, vector, geom_id), body_id)


def body_rot_to_geom(data: DataView, vector: ArrayLike, body_id: int, geom_id: int) -> Numbers:
    """Turns a direction from a body's frame to a geom's."""
    return world_rot_to_geom(data, body_rot_to_world(data, vector, body_id), geom_id)


def geom_rot_to_geom(data: DataView, vector: ArrayLike, geom_id_source: int, geom_id_target: int) -> Numbers:
    """Turns a direction from a geom's frame to another's."""
    return world_rot_to_geom(data, geom_rot_to_world(data, vector, geom_id_source), geom_id_target)


def body_rot_to_body(data: DataView, vector: ArrayLike, body_id_source: int, body_id_target: int) -> Numbers:
    """Turns a direction from a body's frame to another's."""
    return world_rot_to_body(data, body_rot_to_world(data, vector, body_id_source), body_id_target)


# ---- Drawings ----------------------------------------------------------------------------------------------------


def plot_points(points: ArrayLike, limit: float = 1.0, title: str = "", show: bool = True) -> Any:
    """Draws points (n x 3); without `show` returns the figure and its axes."""
    return _plot(points, None, limit, title, show)


def plot_forces(points: ArrayLike, vectors: ArrayLike, limit: float = 1.0, title: str = "", show: bool = True) -> Any:
    """Draws points (n x 3) with an arrow at each; without `show` returns the figure and its axes."""
    return _plot(points, vectors, limit, title, show)


def _plot(points: ArrayLike, vectors: Any, limit: float, title: str, show: bool) -> Any:
    from matplotlib import pyplot

    figure = pyplot.figure()
    axes: Any = figure.add_subplot(projection="3d")
    columns = np.asarray(points).reshape(-1, 3).T
    axes.scatter(*columns, color="k", s=10)
    if vectors is not None:
        axes.quiver(*columns, *np.asarray(vectors).reshape(-1, 3).T)
    axes.set(title=title, xlim=(-limit, limit), ylim=(-limit, limit), zlim=(-limit, limit), box_aspect=(1, 1, 1))
    if not show:
        return figure, axes
    pyplot.show()
    return None


def _view(view: Any) -> Any:
    if not isinstance(view, Arrays):
        raise TypeError(f"expected env.model or env.data, not an object of type {type(view).__name__}")
    return view
