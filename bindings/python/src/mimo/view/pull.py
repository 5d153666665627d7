"""A spring between a place and a body: how a viewer's user pulls at it."""

from __future__ import annotations

from typing import Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..world import World

LARGEST = 300.0  # N


class Pull:
    """Pulls one body to a target, by the forces that callers may apply."""

    def __init__(self, world: World) -> None:
        self.stiffness = 200.0  # N/m
        self.body: Optional[str] = None
        self.target: Optional[NDArray[np.float64]] = None
        self.force = np.zeros(3)
        self._world = world

    @property
    def position(self) -> NDArray[np.float64]:
        """Where the body is."""
        place: NDArray[np.float64] = self._selection.read("position", now=True).reshape(3)
        return place

    def choose(self, body: Optional[str]) -> None:
        """Another body, or none."""
        self.release()
        self.body = body
        if body is not None:
            self._selection = self._world.bodies(body)
            self._mass = float(self._selection.mass.item())

    def to(self, target: ArrayLike) -> None:
        """Pulls there from now on."""
        if self.body is not None:
            self.target = np.array(target, np.float64)

    def release(self) -> None:
        """Pulls no more."""
        if self.target is not None and self.body is not None:
            self._selection.force = np.zeros(6)
        self.target, self.force = None, np.zeros(3)

    def apply(self, step_seconds: float) -> None:
        """The force of the next step. Light bodies are pulled less: a stiff spring would throw them about."""
        if self.target is None:
            return
        stiffness = min(self.stiffness, self._mass / step_seconds**2)
        damping = min(np.sqrt(stiffness * self._mass), 0.25 * self._mass / step_seconds)
        velocity = self._selection.read("velocity", now=True).reshape(6)[:3]
        force = stiffness * (self.target - self.position) - damping * velocity
        size = np.linalg.norm(force)
        self.force = force * min(1.0, LARGEST / size) if size > 0 else force
        self._selection.force = np.concatenate([self.force, np.zeros(3)])
