"""Experiments of your own: how an episode starts, what is rewarded, when it ends; in Python, on named access."""

from __future__ import annotations

from typing import Any, NamedTuple, Union

import numpy as np
from numpy.typing import NDArray

from .access import Access, Mask


class Judgement(NamedTuple):
    """What a task says of a step: a number and two bools for one world, arrays with one entry a world for a batch."""

    reward: Any
    terminated: Union[bool, NDArray[np.bool_]] = False  # the episode ends here
    success: Union[bool, NDArray[np.bool_]] = False  # goes to info["is_success"]


class Task:
    """Derive from it, and give an instance to make or make_vec.

    The same class serves one world and many, if it computes along the last axes: positions of bodies are (n, 3) in one
    world and (worlds, n, 3) in many, so `position[..., 0, :]` is the first body's in both. Arrays of names that were
    looked up belong to one world or batch, so look them up in setup, on the object given there.

    Episodes are cut off after `max_steps`, an option of make and make_vec.
    """

    def setup(self, world: Access) -> None:
        """Called once, before anything else: look up names here."""

    def reset(self, world: Access, mask: Mask) -> None:
        """Prepares an episode, in worlds that are at their start: move things, draw numbers from world.random.

        In a batch only the worlds where mask is True begin one; give mask to write() and random(). None means all.
        """

    def evaluate(self, world: Access) -> Judgement:
        """Judges a step. Positions of bodies are those of the start of its last physics step."""
        raise NotImplementedError
