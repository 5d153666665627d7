"""Rotations as quaternions w x y z, and points that move with bodies."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[Any]


def turned(rotations: ArrayLike, points: ArrayLike) -> Array:
    """Points (n x 3) turned by rotations (n x 4, or one for all): v + 2 w (u x v) + 2 u x (u x v)."""
    quaternions, vectors = np.atleast_2d(rotations), np.atleast_2d(points)
    w, u = quaternions[:, :1], quaternions[:, 1:]
    cross = np.cross(u, vectors)
    moved: Array = vectors + 2 * (w * cross + np.cross(u, cross))
    return moved


def inverse(rotations: ArrayLike) -> Array:
    """Inverse rotations (n x 4)."""
    undone: Array = np.atleast_2d(rotations) * np.array([1, -1, -1, -1])
    return undone


def after(first: ArrayLike, second: ArrayLike) -> Array:
    """Products of rotations (n x 4): first `second`, then `first`."""
    a, b = np.atleast_2d(first), np.atleast_2d(second)
    w = a[:, :1] * b[:, :1] - np.sum(a[:, 1:] * b[:, 1:], axis=1, keepdims=True)
    xyz = a[:, :1] * b[:, 1:] + b[:, :1] * a[:, 1:] + np.cross(a[:, 1:], b[:, 1:])
    return np.hstack([w, xyz])


def placed(positions: ArrayLike, rotations: ArrayLike, points: ArrayLike) -> Array:
    """Points (n x 3) in frames with a position and a rotation each, converted to the outer frame."""
    moved: Array = turned(rotations, points) + np.atleast_2d(positions)
    return moved
