"""The viewer's actions."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..world import World

REST, RANDOM, SLIDERS = "at rest", "random", "sliders"
CHOICES = (RANDOM, SLIDERS, REST)
HOLD = 0.25  # s between two random actions


class Motors:
    """Actions: none, random ones that are held for a while, or sliders."""

    def __init__(self, world: World, step_seconds: float) -> None:
        self.choice = RANDOM
        self.low, self.high = world.action_low, world.action_high
        self.rest: NDArray[np.float32] = np.clip(np.zeros_like(self.low), self.low, self.high)
        self.given = self.rest.copy()  # by the sliders
        self._hold = max(1, round(HOLD / step_seconds))
        self.restart(None)

    def restart(self, seed: object) -> None:
        """Starts the random actions of an episode, by its seed."""
        self._random = np.random.default_rng(seed if isinstance(seed, int) else None)
        self._left, self._drawn = 0, self.rest

    def next(self) -> NDArray[np.float32]:
        """The action of the next step."""
        if self.choice == SLIDERS:
            return self.given
        if self.choice == REST:
            return self.rest
        if self._left == 0:
            self._left, self._drawn = self._hold, self._random.uniform(self.low, self.high).astype(np.float32)
        self._left -= 1
        return self._drawn
