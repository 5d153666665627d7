"""Experiments of your own: how an episode starts, what is rewarded, when it ends; in Python, on named access."""

from __future__ import annotations

from typing import Any, Dict, List, Mapping, NamedTuple, Union

import numpy as np
from numpy.typing import NDArray

from .access import Access, Mask


class Judgement(NamedTuple):
    """What a task says of a step: a number and two bools for one world, arrays with one entry a world for a batch."""

    reward: Any
    terminated: Union[bool, NDArray[np.bool_]] = False  # the episode ends here
    success: Union[bool, NDArray[np.bool_]] = False  # goes to info["is_success"]


class Task:
    """Derive from it, and give an instance to make, make_vec or ParallelEnv.

    The same class serves one world and many, if it computes along the last axes: positions of bodies are (n, 3) in one
    world and (worlds, n, 3) in many, so `position[..., 0, :]` is the first body's in both. Arrays of names that were
    looked up belong to one world or batch, so look them up in setup, on the object given there. What there is no array
    of is reached world by world: `world.contacts(i)` and `world.world(i)` for i in range(world.world_count), which is 1
    in one world.

    Episodes are cut off after `max_steps`, an option of make, make_vec and ParallelEnv.
    """

    def setup(self, world: Access) -> None:
        """Called once, before anything else: look up names here."""

    def reset(self, world: Access, mask: Mask) -> None:
        """Prepares an episode, in worlds that are at their start: move things, draw numbers from world.random.

        In a batch only the worlds where mask is True begin one; give mask to write() and random(). None means all.
        """

    def evaluate(self, world: Access) -> Union[Judgement, Mapping[str, Judgement]]:
        """Judges a step: a Judgement, and for ParallelEnv one for each infant by name, {"anna": Judgement(...), ...}.

        `world.observation` has what was sensed. Positions of bodies are those of the start of its last physics step.
        """
        raise NotImplementedError


def judgement(task: Task, world: Access) -> Judgement:
    """What a task says of a step."""
    given = task.evaluate(world)
    if not isinstance(given, Judgement):
        raise TypeError(f"{type(task).__name__}.evaluate returned {_what(given)}; return a mimo.Judgement")
    return given


def judgements(task: Task, world: Access, agents: List[str]) -> Dict[str, Judgement]:
    """What a task says of each infant."""
    given = task.evaluate(world)
    name = f"{type(task).__name__}.evaluate"
    if not isinstance(given, Mapping) or isinstance(given, Judgement):
        raise TypeError(f'{name} returned {_what(given)}; return one mimo.Judgement an infant, {{"{agents[0]}": ...}}')
    for agent in agents:
        if not isinstance(given.get(agent), Judgement):
            raise TypeError(f"{name} returned {_what(given.get(agent))} for {agent!r}; return a mimo.Judgement")
    return dict(given)


def _what(given: Any) -> str:
    return "None" if given is None else f"an object of type {type(given).__name__}"
