"""The page's camera: it starts in front of an infant, so near that it fills the scene.

The user moves the camera. To follow the infants, the world moves instead: it lies below a node that keeps them in the
middle of the page.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..constants import Kind
from ..drawing import prefixes
from ..frames import turned
from ..world import World

ROOT = "/world"  # the node below which the world lies
FIELD = np.radians(40.0)  # vertical field of view
FLESH = 0.09  # m around the bodies' origins
SHARE = 0.85  # largest share of the scene that the infants fill
ASIDE, ABOVE = np.radians(-25.0), np.radians(22.0)  # from an infant's front
OVER_LYING = np.radians(50.0)
FOLLOW = 0.15  # share of its way to the infants that the scene moves per frame


class Camera:
    """Aims at the infants of a world, and keeps them in the middle."""

    def __init__(self, server: Any, world: World) -> None:
        self._server, self._world = server, world
        self._bodies = _infants(world)
        self.follows = True
        self._middle = self._places().mean(axis=0)
        self._root = server.scene.add_frame(ROOT, show_axes=False, position=-self._middle)
        self._radius = float(np.linalg.norm(self._places() - self._middle, axis=1).max()) + FLESH
        self._direction = self._begins_at()
        server.initial_camera.fov = FIELD
        server.initial_camera.look_at = (0.0, 0.0, 0.0)
        server.initial_camera.position = self._position(1.0)
        for client in server.get_clients().values():
            self.aim(client)

    def aim(self, client: Any) -> None:
        """Aims one page at the infants; from farther away on a narrow page."""
        camera = client.camera
        camera.position = self._position(camera.aspect)  # first, because it moves look_at, too
        camera.look_at = (0.0, 0.0, 0.0)

    def update(self) -> None:
        """Moves the world until the infants are in the middle."""
        if self.follows:
            self._middle = self._middle + FOLLOW * (self._places().mean(axis=0) - self._middle)
            if np.abs(self._root.position + self._middle).max() > 1e-4:
                self._root.position = -self._middle

    def _places(self) -> NDArray[np.float64]:
        return np.asarray(self._world.poses(Kind.BODY).positions[self._bodies], np.float64)

    def _position(self, aspect: float) -> Any:
        half = min(FIELD / 2, float(np.arctan(np.tan(FIELD / 2) * aspect)))
        return tuple((self._direction * self._radius / (SHARE * np.sin(half))).tolist())

    def _begins_at(self) -> NDArray[np.float64]:
        """The vector from the middle to the camera: ahead of an upright infant, beside and above a lying one."""
        rotation = self._world.poses(Kind.BODY).rotations[self._bodies[0]]
        front, upward = turned(rotation, np.eye(3)[[0, 2]])
        lies = abs(upward[2]) < 0.5
        level, above = (np.cross(upward, (0, 0, 1)), OVER_LYING) if lies else (front, ABOVE)
        around = float(np.arctan2(level[1], level[0])) + (0.0 if lies else ASIDE)
        return np.array([np.cos(above) * np.cos(around), np.cos(above) * np.sin(around), np.sin(above)])


def _infants(world: World) -> NDArray[np.int32]:
    """The bodies of all infants with joints, the first trunk first; all bodies in a scene without infants."""
    joints, starts = world.joints(), tuple(f"{prefix}robot:" for prefix in prefixes(world))
    own = [body for name, body in zip(joints.names, joints.body_ids) if name.startswith(starts)]
    every = np.arange(world.count(Kind.BODY), dtype=np.int32)
    return np.unique(np.array(own, np.int32)) if own else every[-max(1, len(every) - 1) :]
