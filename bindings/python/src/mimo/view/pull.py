"""A spring by which the user pulls a body."""

from __future__ import annotations

from typing import Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..world import World

LARGEST = 300.0  # N


class Pull:
    """Pulls one body to a target, by applied forces."""

    def __init__(self, world: World) -> None:
        self.stiffness = 200.0  # N/m
        self.body: Optional[str] = None
        self.target: Optional[NDArray[np.float64]] = None
        self.force = np.zeros(3)
        self._world = world

    @property
    def position(self) -> NDArray[np.float64]:
        """The position of the body."""
        place: NDArray[np.float64] = self._selection.read("position", now=True).reshape(3)
        return place

    def choose(self, body: Optional[str]) -> None:
        """Selects a body, or none."""
        self.release()
        self.body = body
        if body is not None:
            self._selection = self._world.bodies(body)
            self._mass = float(self._selection.mass.item())

    def to(self, target: ArrayLike) -> None:
        """Starts pulling to a target."""
        if self.body is not None:
            self.target = np.array(target, np.float64)

    def release(self) -> None:
        """Stops pulling."""
        if self.target is not None and self.body is not None:
            self._selection.force = np.zeros(6)
        self.target, self.force = None, np.zeros(3)

    def apply(self, step_seconds: float) -> None:
        """Sets the force of the next step; smaller for light bodies, which a stiff spring would fling."""
        if self.target is None:
            return
        stiffness = min(self.stiffness, self._mass / step_seconds**2)
        damping = min(np.sqrt(stiffness * self._mass), 0.25 * self._mass / step_seconds)
        velocity = self._selection.read("velocity", now=True).reshape(6)[:3]
        force = stiffness * (self.target - self.position) - damping * velocity
        size = np.linalg.norm(force)
        self.force = force * min(1.0, LARGEST / size) if size > 0 else force
        self._selection.force = np.concatenate([self.force, np.zeros(3)])
