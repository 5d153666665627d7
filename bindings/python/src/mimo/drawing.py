"""Shapes, colours and names that the viewer, USD and Rerun share."""

from __future__ import annotations

from typing import Any, Iterator, NamedTuple, Optional

import numpy as np
from numpy.typing import NDArray

from .constants import Kind, Quantity
from .frames import after, inverse, turned
from .selection import Selection
from .world import World

EYES = 128  # default width and height of an eye's picture, pixels
SEGMENTS = 24  # pieces of a circle, for moving shapes
EARS = ("hearing/ear_left", "hearing/ear_right")  # fields
WEAK, STRONG = 0.1, 10.0  # N of the first and the last colour; logarithmic between them
STOPS = np.array([[255, 235, 130], [250, 140, 40], [215, 25, 30], [110, 0, 60]], np.float64)
FLOOR = 5.0  # half the size of endless planes, m


class OnBodies(NamedTuple):
    """Poses of geoms in the frames of their bodies."""

    bodies: NDArray[np.int32]
    positions: NDArray[np.float64]
    rotations: NDArray[np.float64]


def on_bodies(world: World) -> OnBodies:
    """Poses of all geoms, which stay the same while bodies move."""
    geoms, bodies, owners = world.poses(Kind.GEOM), world.poses(Kind.BODY), world.geoms().body_ids
    back = inverse(bodies.rotations[owners])
    places = turned(back, geoms.positions - bodies.positions[owners])
    return OnBodies(owners, places, after(back, geoms.rotations))


def ages(world: World) -> Any:
    """The infants' ages, months."""
    return world.get(Quantity.AGENT_AGE) if world.agents else np.zeros(0)


def faces(world: World) -> Any:
    """The numbers of the infants' faces."""
    return world.get(Quantity.AGENT_FACE) if world.agents else np.zeros(0)


def prefixes(world: World) -> Iterator[str]:
    """The prefix of each infant's names: "anna/", or "" for a single infant."""
    for agent in world.agents:
        yield f"{agent.name}/" if agent.name else ""


def touch_field(world: World, prefix: str) -> Optional[str]:
    """The field with the forces on an infant's skin, or None."""
    fields = (f"{prefix}touch/{kind}" for kind in ("force", "normal_force"))
    return next((field for field in fields if field in world.layout.fields), None)


def limited(world: World) -> Selection:
    """Hinges and slides with limits."""
    joints = world.joints()
    one = [number for number in joints.ids if joints._width(Quantity.JOINT_POSITION, np.array([number], np.int32)) == 1]
    ranges = world.get(Quantity.JOINT_RANGE, [int(number) for number in one]).reshape(-1, 2)
    bounded = np.isfinite(ranges).all(axis=1) & (ranges[:, 0] < ranges[:, 1])
    return Selection(world, np.array(one, np.int32)[bounded], Kind.JOINT)


def heat(share: Any) -> NDArray[np.uint8]:
    """Colours from pale yellow (0) over red to dark (1)."""
    at = np.clip(np.asarray(share, np.float64), 0, 1) * (len(STOPS) - 1)
    below = np.minimum(at.astype(int), len(STOPS) - 2)
    rest = (at - below)[:, None]
    return np.asarray(STOPS[below] * (1 - rest) + STOPS[below + 1] * rest, np.uint8)


def strength(force: Any) -> NDArray[np.float64]:
    """Forces (N) on the scale from WEAK (0) to STRONG (1)."""
    return np.asarray(np.log(np.maximum(force, 1e-9) / WEAK) / np.log(STRONG / WEAK))
