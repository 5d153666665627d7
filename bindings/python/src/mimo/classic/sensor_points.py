"""Where the original spreads touch sensors over a geom (in its frame, m), by the rules of docs/guide/touch.md."""

from __future__ import annotations

from typing import Any, Iterable, List

import numpy as np
from numpy.typing import ArrayLike, NDArray

Points = NDArray[np.float64]
SPHERE, CAPSULE, ELLIPSOID, CYLINDER, BOX, MESH = 2, 3, 4, 5, 6, 7  # MuJoCo's types of geoms
OUTSIDE = 1e-9  # m; points so near to a surface are outside


def spread_on(kind: int, size: ArrayLike, spacing: float) -> Points:
    """Points on a geom, at about this spacing; the middle alone if the geom is too small for more. Planes have none."""
    half = np.asarray(size, np.float64)
    if kind == BOX:
        points = _box(half, spacing)
    elif kind == SPHERE:
        points = _ball(half[[0, 0, 0]], spacing)
    elif kind == ELLIPSOID:
        points = _ball(half, spacing)
    elif kind == CAPSULE:
        points = _capsule(half[0], 2 * half[1], spacing)
    elif kind == CYLINDER:
        points = _cylinder(half[0], 2 * half[1], spacing)
    elif kind == MESH:
        points = _ball(np.full(3, np.linalg.norm(half)), spacing)
    else:
        return np.empty((0, 3))
    return np.unique(np.round(points, 12), axis=0)


def is_inside(kind: int, size: ArrayLike, points: ArrayLike) -> NDArray[np.bool_]:
    """Which points lie inside a geom."""
    half, at = np.asarray(size, np.float64), np.abs(np.asarray(points, np.float64).reshape(-1, 3))
    across = np.hypot(at[:, 0], at[:, 1])
    depth: Any
    if kind == BOX:
        depth = np.max(at - half, axis=1)
    elif kind == SPHERE:
        depth = np.linalg.norm(at, axis=1) - half[0]
    elif kind == ELLIPSOID:
        depth = (np.linalg.norm(at / half, axis=1) - 1) * np.min(half)
    elif kind == CAPSULE:
        depth = np.hypot(across, np.maximum(at[:, 2] - half[1], 0)) - half[0]
    elif kind == CYLINDER:
        depth = np.maximum(across - half[0], at[:, 2] - half[1])
    else:
        return np.zeros(len(at), np.bool_)
    inside: NDArray[np.bool_] = depth < -OUTSIDE
    return inside


def _alone() -> Points:
    return np.zeros((1, 3))


def _box(half: Points, spacing: float) -> Points:
    if 0.75 * spacing > np.max(half):
        return _alone()
    axes = [np.linspace(-one, one, max(2, int(np.ceil(2 * one / spacing)))) for one in half]
    grid = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, 3)
    return grid[np.any(np.abs(np.abs(grid) - half) < 1e-12, axis=1)]


def _ball(radii: Points, spacing: float) -> Points:
    radius = float(np.max(radii))
    if spacing > radius:
        return _alone()
    count = int(np.ceil(np.pi * radius / spacing))
    angles = (np.arange(count) + 0.5) * np.pi / count
    rings = [_ring(np.sin(it), np.cos(it), round(2 * np.pi * radius * np.sin(it) / spacing)) for it in angles]
    return np.concatenate(rings) * radii


def _capsule(radius: float, length: float, spacing: float) -> Points:
    around = int(np.ceil(2 * np.pi * radius / spacing))
    if around < 3:
        return _alone()
    rings = list(_tube(radius, length, around, spacing))
    count = int(np.ceil(np.pi * radius / (2 * spacing)))
    for angle in np.arange(count) * np.pi / (2 * count):  # the last ring is the tube's
        number = int(np.ceil(2 * np.pi * radius * np.sin(angle) / spacing))
        cap = _ring(radius * np.sin(angle), radius * np.cos(angle), number) if number > 1 else _pole(radius)
        above = np.add(cap, [0, 0, length / 2])
        rings += [above, above * [1, 1, -1]]
    return np.concatenate(rings)


def _cylinder(radius: float, length: float, spacing: float) -> Points:
    around, along = int(np.ceil(2 * np.pi * radius / spacing)), int(np.ceil(length / spacing))
    circles = round(radius / spacing) + 1
    if around < 3 or along < 2 or circles == 1:
        return _alone()
    rings = list(_tube(radius, length, around, spacing))
    for inner in np.linspace(0, radius, circles)[:-1]:  # the rim is the tube's
        number = int(np.ceil(2 * np.pi * inner / spacing))
        cap = _ring(inner, length / 2, number) if number > 0 else _pole(length / 2)
        rings += [cap, cap * [1, 1, -1]]
    return np.concatenate(rings)


def _tube(radius: float, length: float, around: int, spacing: float) -> Iterable[Points]:
    heights = np.linspace(-length / 2, length / 2, int(np.ceil(length / spacing)) + 1)
    return (_ring(radius, height, around) for height in heights)


def _ring(radius: float, height: float, count: int) -> Points:
    turns = 2 * np.pi * np.arange(count) / max(count, 1)
    return np.column_stack([radius * np.cos(turns), radius * np.sin(turns), np.full(count, height)])


def _pole(height: float) -> Points:
    pole: List[List[float]] = [[0.0, 0.0, height]]
    return np.array(pole)
