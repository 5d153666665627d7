"""What all that show a world elsewhere need: where its shapes are, and what changes their looks."""

from __future__ import annotations

from typing import Any, Iterator, NamedTuple

import numpy as np
from numpy.typing import NDArray

from .constants import Kind, Quantity
from .frames import after, inverse, turned
from .world import World

SEGMENTS = 16  # pieces of a circle, of what moves
FLOOR = 5.0  # half the size of endless planes, m


class OnBodies(NamedTuple):
    """Where geoms are in the frames of their bodies."""

    bodies: NDArray[np.int32]
    positions: NDArray[np.float64]
    rotations: NDArray[np.float64]


def on_bodies(world: World) -> OnBodies:
    """All geoms' places: they stay while bodies move."""
    geoms, bodies, owners = world.poses(Kind.GEOM), world.poses(Kind.BODY), world.geoms().body_ids
    back = inverse(bodies.rotations[owners])
    places = turned(back, geoms.positions - bodies.positions[owners])
    return OnBodies(owners, places, after(back, geoms.rotations))


def ages(world: World) -> Any:
    """Of the infants, months."""
    return world.get(Quantity.AGENT_AGE) if world.agents else np.zeros(0)


def faces(world: World) -> Any:
    """Which ones the infants have, by number."""
    return world.get(Quantity.AGENT_FACE) if world.agents else np.zeros(0)


def prefixes(world: World) -> Iterator[str]:
    """How the names of each infant's fields and parts begin: "anna/", or "" for a sole one."""
    for agent in world.agents:
        yield f"{agent.name}/" if agent.name else ""
