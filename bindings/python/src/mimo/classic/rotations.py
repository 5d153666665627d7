"""Rotations as MuJoCo's functions and documents write them: quaternions w x y z, matrices, angles."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

Numbers = NDArray[np.float64]


def matrix(quaternion: ArrayLike) -> Numbers:
    """The rotation matrix of a quaternion."""
    w, x, y, z = np.asarray(quaternion, np.float64) / np.linalg.norm(quaternion)
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def matrices(quaternions: ArrayLike) -> Numbers:
    """The matrices of quaternions, each as nine numbers by rows."""
    rows = np.asarray(quaternions, np.float64).reshape(-1, 4)
    return np.array([matrix(row).ravel() for row in rows]).reshape(-1, 9)


def product(first: ArrayLike, second: ArrayLike) -> Numbers:
    """The product of two quaternions: `second` turns first."""
    w1, x1, y1, z1 = np.asarray(first, np.float64)
    w2, x2, y2, z2 = np.asarray(second, np.float64)
    return np.array(
        [
            w1 * w2 - x1 * x2 - y1 * y2 - z1 * z2,
            w1 * x2 + x1 * w2 + y1 * z2 - z1 * y2,
            w1 * y2 - x1 * z2 + y1 * w2 + z1 * x2,
            w1 * z2 + x1 * y2 - y1 * x2 + z1 * w2,
        ]
    )


def about(axis: ArrayLike, angle: float) -> Numbers:
    """The quaternion of a rotation about an axis (of any length), rad."""
    direction = np.asarray(axis, np.float64)
    length = np.linalg.norm(direction)
    if length == 0:
        return np.array([1.0, 0, 0, 0])
    return np.concatenate([[np.cos(angle / 2)], np.sin(angle / 2) * direction / length])


def from_euler(angles: ArrayLike, sequence: str = "xyz") -> Numbers:
    """The quaternion of three rotations (rad) about the axes of `sequence`; lower case: moving axes."""
    turned = np.array([1.0, 0, 0, 0])
    for angle, axis in zip(np.asarray(angles, np.float64), sequence):
        turn = about(np.eye(3)["xyz".index(axis.lower())], float(angle))
        turned = product(turned, turn) if axis.islower() else product(turn, turned)
    return turned


def from_matrix(nine: ArrayLike) -> Numbers:
    """The quaternion of a rotation matrix."""
    m = np.asarray(nine, np.float64).reshape(3, 3)
    # The largest of the four squared components divides safely.
    squares = np.array(
        [
            1 + m[0, 0] + m[1, 1] + m[2, 2],
            1 + m[0, 0] - m[1, 1] - m[2, 2],
            1 - m[0, 0] + m[1, 1] - m[2, 2],
            1 - m[0, 0] - m[1, 1] + m[2, 2],
        ]
    )
    largest = int(np.argmax(squares))
    row = [
        [squares[0], m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1]],
        [m[2, 1] - m[1, 2], squares[1], m[0, 1] + m[1, 0], m[0, 2] + m[2, 0]],
        [m[0, 2] - m[2, 0], m[0, 1] + m[1, 0], squares[2], m[1, 2] + m[2, 1]],
        [m[1, 0] - m[0, 1], m[0, 2] + m[2, 0], m[1, 2] + m[2, 1], squares[3]],
    ][largest]
    quaternion = np.array(row) / np.linalg.norm(row)
    return quaternion if quaternion[0] >= 0 else -quaternion


def quaternion_of(kind: str, values: Any, sequence: str) -> Numbers:
    """The quaternion of an orientation in a document: quat, euler, axisangle (rad), xyaxes or zaxis."""
    if kind == "quat":
        return np.asarray(values) / np.linalg.norm(values)
    if kind == "euler":
        return from_euler(values, sequence)
    if kind == "axisangle":
        return about(values[:3], float(values[3]))
    if kind == "zaxis":
        up, wanted = np.array([0.0, 0, 1]), np.asarray(values) / np.linalg.norm(values)
        return about(np.cross(up, wanted), float(np.arctan2(np.linalg.norm(np.cross(up, wanted)), wanted[2])))
    x = np.asarray(values[:3]) / np.linalg.norm(values[:3])
    y = np.asarray(values[3:]) - np.dot(values[3:], x) * x
    y /= np.linalg.norm(y)
    return from_matrix(np.column_stack([x, y, np.cross(x, y)]))
