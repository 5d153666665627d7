"""Marks over the world's shapes: touch, contacts, the pull, bones and joints."""

from __future__ import annotations

from typing import Any, List

import numpy as np
from numpy.typing import NDArray

from ..constants import Kind, Quantity
from ..drawing import ages, heat, limited, prefixes, strength, touch_field
from ..frames import placed
from ..layout import Receptors
from ..world import World
from .camera import ROOT
from .pull import Pull

LIFT = 0.002  # m above the skin, so that marks are not inside it
NOWHERE = -1000.0  # m below the floor, for a hidden mark: the page refuses empty lists
CONTACT_SCALE = 0.003  # m per newton
LONGEST = 0.5  # m
CALM, STRAINED = np.array([70, 130, 220]), np.array([230, 40, 40])


class Layer:
    """Marks that can be hidden; hidden ones are not computed."""

    def __init__(self, handle: Any) -> None:
        self._handle = handle

    @property
    def visible(self) -> bool:
        """Whether they are visible."""
        return bool(self._handle.visible)

    @visible.setter
    def visible(self, visible: bool) -> None:
        self._handle.visible = visible

    def update(self) -> None:
        """Draws the current state."""
        if self.visible:
            self._draw()

    def _draw(self) -> None:
        raise NotImplementedError


class Skin(Layer):
    """Touch: each touched sensor, coloured by force."""

    def __init__(self, server: Any, world: World) -> None:
        self._world = world
        self._fields = [field for prefix in prefixes(world) if (field := touch_field(world, prefix))]
        self._receptors: List[Receptors] = [world.layout.receptors(name) for name in self._fields]
        self._ages = ages(world)
        super().__init__(_points(server, f"{ROOT}/touch", 0.008))

    def _draw(self) -> None:
        if not np.array_equal(ages(self._world), self._ages):
            self._ages = ages(self._world)
            self._receptors = [self._world.layout.receptors(name) for name in self._fields]
        poses = self._world.poses(Kind.BODY)
        places, forces = [nowhere(1)], [np.zeros(1)]
        for name, receptors in zip(self._fields, self._receptors):
            felt = self._world.observation[name].reshape(len(receptors.bodies), -1)
            force = np.linalg.norm(felt, axis=1)
            on = np.flatnonzero(force > 0)
            bodies = receptors.bodies[on]
            lifted = receptors.position[on] + LIFT * receptors.frame[on, 0]
            places.append(placed(poses.positions[bodies], poses.rotations[bodies], lifted))
            forces.append(force[on])
        force = np.concatenate(forces)
        self._handle.points = np.concatenate(places).astype(np.float32)
        self._handle.colors = heat(strength(force))


class Contacts(Layer):
    """Contacts: an arrow for the force on the second body of each."""

    def __init__(self, server: Any, world: World) -> None:
        self._world = world
        super().__init__(_arrows(server, f"{ROOT}/contacts", (40, 170, 60)))

    def _draw(self) -> None:
        self._handle.points = contact_arrows(self._world)


class Pulled(Layer):
    """The pull: an arrow from the body to its target."""

    def __init__(self, server: Any, pull: Pull) -> None:
        self._pull = pull
        super().__init__(_arrows(server, f"{ROOT}/pull_force", (200, 60, 200)))

    def _draw(self) -> None:
        target = self._pull.target
        self._handle.points = nowhere(1, 2) if target is None else np.array([[self._pull.position, target]], np.float32)


class Bones(Layer):
    """Bodies with joints, each joined to its parent; blue in the middle of their joints' ranges, red at the limits."""

    def __init__(self, server: Any, world: World) -> None:
        self._world = world
        self._joints = limited(world)
        self._bodies = self._joints.body_ids
        self._own = np.unique(self._bodies)
        parents = world.bodies().body_ids
        self._links = np.array([[body, parents[body]] for body in self._own if parents[body] != 0]).reshape(-1, 2)
        self._lines = server.scene.add_line_segments(
            f"{ROOT}/bones/lines", nowhere(1, 2), (90, 90, 90), thickness=3.0, thickness_units="screen"
        )
        self._points = _points(server, f"{ROOT}/bones/joints", 0.014)
        super().__init__(server.scene.add_frame(f"{ROOT}/bones", show_axes=False, visible=False))

    def _draw(self) -> None:
        positions = self._world.poses(Kind.BODY).positions
        low, high = self._joints._get(Quantity.JOINT_RANGE).reshape(-1, 2).T
        angle = self._joints._get(Quantity.JOINT_POSITION)
        strain = np.abs((angle - low) / np.maximum(high - low, 1e-9) - 0.5) * 2
        share = np.array([strain[self._bodies == body].max() for body in self._own]).reshape(-1, 1).clip(0, 1)
        if len(self._own) > 0:
            self._points.points = positions[self._own]
            self._points.colors = (CALM * (1 - share) + STRAINED * share).astype(np.uint8)
        if len(self._links) > 0:
            self._lines.points = positions[self._links]


def arrows(starts: Any, forces: Any) -> NDArray[np.float32]:
    """Starts and ends (n x 2 x 3) of arrows for forces, N."""
    length = np.linalg.norm(forces, axis=1, keepdims=True)
    shown = length[:, 0] > 1e-3
    drawn = forces * np.minimum(CONTACT_SCALE, LONGEST / np.maximum(length, 1e-9))
    drawn = np.stack([starts, starts + drawn], axis=1)[shown]
    return np.concatenate([nowhere(1, 2), drawn]).astype(np.float32)


def contact_arrows(world: World) -> NDArray[np.float32]:
    """Arrows for the forces on the second bodies of contacts."""
    contacts = world.contacts()
    return arrows(contacts.position, np.einsum("nij,ni->nj", contacts.frame, contacts.force))


def nowhere(*shape: int) -> NDArray[np.float32]:
    """Invisible places."""
    return np.full((*shape, 3), NOWHERE, np.float32)


def _points(server: Any, name: str, size: float) -> Any:
    black = np.zeros((1, 3), np.uint8)
    return server.scene.add_point_cloud(
        name, nowhere(1), black, point_size=size, point_shape="circle", precision="float32"
    )


def _arrows(server: Any, name: str, color: Any) -> Any:
    return server.scene.add_arrows(name, nowhere(1, 2), color, shaft_radius=0.003, head_radius=0.008, head_length=0.015)
