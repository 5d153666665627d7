"""Functions of the original's `mimoEnv.utils`. `model` and `data` are those of an environment."""

from __future__ import annotations

from typing import Any, List, Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..constants import Kind
from ..world import World
from .model import DataView, ModelView

Numbers = NDArray[np.float64]


def get_body_id(model: ModelView, body_id: Optional[int] = None, body_name: Optional[str] = None) -> int:
    """The number of a body, by its name or number."""
    if (body_id is None) == (body_name is None):
        raise ValueError(f"body_id is {body_id!r} and body_name {body_name!r}, expected one of them")
    return int(body_id) if body_name is None else _world(model).find(Kind.BODY, body_name)  # type: ignore[arg-type]


def get_geoms_for_body(model: ModelView, body_id: int) -> List[int]:
    """Numbers of a body's geoms."""
    return [int(geom) for geom in np.flatnonzero(model.geom_bodyid == body_id)]


def get_child_bodies(model: ModelView, body_id: int) -> List[int]:
    """Numbers of a body and its descendants, in order."""
    parents, found = model.body_parentid, [int(body_id)]
    for body in range(int(body_id) + 1, len(parents)):  # parents come before their children
        if parents[body] in found:
            found.append(body)
    return found


def set_joint_qpos(model: ModelView, data: DataView, joint_name: str, qpos: ArrayLike) -> None:
    """Sets a joint's position: a number, or seven for a free joint."""
    world = _world(data)
    world.joints(joint_name).position = np.asarray(qpos, np.float64)
    world.update()


def get_joint_qpos_addr(model: ModelView, joint_id: int) -> int:
    """The index of a joint's position in qpos."""
    return int(model.jnt_qposadr[joint_id])


def get_joint_qvel_addr(model: ModelView, joint_id: int) -> int:
    """The index of a joint's velocity in qvel."""
    return int(model.jnt_dofadr[joint_id])


def lock_joint(model: ModelView, joint_name: str, joint_angle: Optional[float] = None) -> None:
    """Locks a joint softly at an angle (rad); the default is the angle of its lock, usually 0."""
    world = _world(model)
    if joint_angle is None:
        joint_angle = float(world.joints(joint_name).lock.ravel()[1])
    world.lock(joint_name, float(joint_angle))


def unlock_joint(model: ModelView, joint_name: str) -> None:
    """Releases a joint."""
    _world(model).unlock(joint_name)


def get_body_position(data: DataView, body_name: str) -> Numbers:
    """The position of a body's origin, world, m."""
    position: Numbers = _world(data).bodies(body_name).position[0]
    return position


def get_body_rotation(data: DataView, body_name: str) -> Numbers:
    """The rotation of a body: 3 x 3, from its frame to the world's."""
    return matrix(_world(data).bodies(body_name).orientation[0])


def body_pos_to_world(data: DataView, position: ArrayLike, body_id: int) -> Numbers:
    """Converts a point (or n x 3) from a body's frame to the world, m."""
    body = data.body(int(body_id))
    turned: Numbers = np.asarray(position) @ matrix(body.xquat).T + body.xpos
    return turned


def world_pos_to_body(data: DataView, position: ArrayLike, body_id: int) -> Numbers:
    """Converts a point (or n x 3) from the world to a body's frame, m."""
    body = data.body(int(body_id))
    turned: Numbers = (np.asarray(position) - body.xpos) @ matrix(body.xquat)
    return turned


def matrix(quaternion: ArrayLike) -> Numbers:
    """The rotation matrix of a quaternion w x y z."""
    w, x, y, z = np.asarray(quaternion, np.float64) / np.linalg.norm(quaternion)
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def _world(view: Any) -> World:
    if not isinstance(view, (ModelView, DataView)):
        raise TypeError(f"expected env.model or env.data, not an object of type {type(view).__name__}")
    return view._world
