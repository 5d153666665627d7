"""MuJoCo's functions of numbers, and its plain classes, for scripts where the package is not installed."""

from __future__ import annotations

from typing import Any, Callable, Dict

import numpy as np

from .rotations import about, from_euler, from_matrix, matrix, product


def _into(values: Callable[..., Any]) -> Callable[..., None]:
    def call(result: Any, *arguments: Any) -> None:
        result[:] = np.reshape(values(*arguments), np.shape(result))

    return call


def _rotated(vector: Any, quaternion: Any) -> Any:
    return matrix(quaternion) @ np.asarray(vector, np.float64)


def _velocity(quaternion: Any, seconds: float) -> Any:
    """The rotation vector of a quaternion, by time."""
    w, axis = float(quaternion[0]), np.asarray(quaternion[1:], np.float64)
    length = float(np.linalg.norm(axis))
    angle = 2 * np.arctan2(length, w)
    angle = angle - 2 * np.pi if angle > np.pi else angle
    return axis / length * angle / seconds if length > 0 else np.zeros(3)


def _normalized(vector: Any) -> float:
    """Divides a vector by its length, and returns the length."""
    length = float(np.linalg.norm(vector))
    vector[:] = vector / length if length > 0 else np.eye(1, len(vector)).ravel()
    return length


FUNCTIONS: Dict[str, Callable[..., Any]] = {
    "mju_euler2Quat": _into(from_euler),
    "mju_axisAngle2Quat": _into(about),
    "mju_quat2Mat": _into(matrix),
    "mju_mat2Quat": _into(from_matrix),
    "mju_mulQuat": _into(product),
    "mju_negQuat": _into(lambda it: np.asarray(it) * [1, -1, -1, -1]),
    "mju_rotVecQuat": _into(_rotated),
    "mju_quat2Vel": _into(_velocity),
    "mju_mulMatVec": _into(lambda m, v: np.asarray(m).reshape(-1, len(v)) @ v),
    "mju_mulMatTVec": _into(lambda m, v: np.asarray(m).reshape(len(v), -1).T @ v),
    "mju_cross": _into(np.cross),
    "mju_sub3": _into(np.subtract),
    "mju_add3": _into(np.add),
    "mju_scl3": _into(np.multiply),
    "mju_copy": _into(np.array),
    "mju_normalize3": _normalized,
    "mju_normalize4": _normalized,
    "mju_norm3": lambda it: float(np.linalg.norm(it)),
    "mju_norm": lambda it: float(np.linalg.norm(it)),
    "mju_dot3": lambda a, b: float(np.dot(a, b)),
    "mju_dot": lambda a, b: float(np.dot(a, b)),
}


class MjvCamera:
    """A view: lookat (m), distance (m), azimuth and elevation (degrees), or a camera's number."""

    def __init__(self) -> None:
        self.type = 0
        self.fixedcamid = self.trackbodyid = -1
        self.lookat = np.zeros(3)
        self.distance, self.azimuth, self.elevation = 2.0, 90.0, -45.0


class MjvOption:
    """What pictures show: MuJoCo's flags are kept, and have no effect."""

    def __init__(self) -> None:
        self.flags, self.geomgroup, self.sitegroup = np.zeros(30, np.uint8), np.ones(6, np.uint8), np.ones(6, np.uint8)
        self.frame = self.label = 0


class MjrRect:
    """A part of a picture, in pixels."""

    def __init__(self, left: int, bottom: int, width: int, height: int) -> None:
        self.left, self.bottom, self.width, self.height = left, bottom, width, height


CLASSES: Dict[str, Any] = {"MjvCamera": MjvCamera, "MjvOption": MjvOption, "MjrRect": MjrRect}
