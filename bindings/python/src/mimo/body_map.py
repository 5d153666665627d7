"""A map of the skin: the upright body from the front and from the back, side by side."""

from __future__ import annotations

from typing import Any, Tuple

import numpy as np
from numpy.typing import NDArray

from .constants import Kind, Quantity
from .drawing import prefixes, touch_field
from .frames import placed, turned
from .layout import Observation
from .world import World

GAP = 0.08  # between front and back, as a share of the map's height


class BodyMap:
    """Places of an infant's touch sensors on the map: x from 0 to `width`, y from 0 (soles) to 1 (crown).

    In the front view the infant's right is on the left, in the back view its left is.
    """

    def __init__(self, world: World, agent: int = 0) -> None:
        self._world = world
        prefix = list(prefixes(world))[agent]
        field = touch_field(world, prefix)
        if field is None:
            raise ValueError("the infant has no touch; make the world with touch=mimo.Touch.FORCE")
        self.field = field
        places, normals = self._straight(prefix)
        across, up = places[:, 1], places[:, 2]
        self.front: NDArray[np.bool_] = normals[:, 0] >= 0
        height = max(float(np.ptp(up)), 1e-6)
        half = float(np.abs(across).max()) / height
        middle = np.where(self.front, half, 3 * half + GAP)
        x = middle + np.where(self.front, 1, -1) * across / height
        self.places: NDArray[np.float64] = np.column_stack([x, (up - up.min()) / height])
        self.middles = (half, 3 * half + GAP)
        self.width = 4 * half + GAP

    def _straight(self, prefix: str) -> Tuple[Any, Any]:
        """Places and normals in the frame of the trunk (front, left, up), with all hinges and slides at 0."""
        receptors = self._world.layout.receptors(self.field)
        with self._world.clone() as straight:
            joints = straight.joints()
            hinges = [
                int(joint) for joint in joints.ids if joints._width(Quantity.JOINT_POSITION, np.array([joint])) == 1
            ]
            straight.set(Quantity.JOINT_POSITION, 0.0, hinges)
            straight.update()
            poses = straight.poses(Kind.BODY)
            names = straight.bodies().names
        root = names.index(f"{prefix}hip") if f"{prefix}hip" in names else int(receptors.bodies.min())
        back = poses.rotations[root] * np.array([1, -1, -1, -1])
        places = turned(
            back,
            placed(poses.positions[receptors.bodies], poses.rotations[receptors.bodies], receptors.position)
            - poses.positions[root],
        )
        normals = turned(back, turned(poses.rotations[receptors.bodies], receptors.frame[:, 0]))
        return places, normals

    @property
    def force(self) -> NDArray[np.float64]:
        """The force on each sensor now, N."""
        return self.force_in(self._world.observation)

    def force_in(self, observation: Observation) -> NDArray[np.float64]:
        """The force on each sensor in an observation, N."""
        felt = observation[self.field].reshape(len(self.places), -1)
        return np.asarray(np.linalg.norm(felt, axis=1), np.float64)
