"""Custom tasks in Python: start, observation, reward and end of episodes."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Dict, Mapping, NamedTuple, Sequence, Union

import numpy as np
from numpy.typing import NDArray

from .access import Access
from .selection import Mask

if TYPE_CHECKING:
    from gymnasium import spaces

Flags = Union[bool, NDArray[np.bool_]]
GOALS = ("achieved_goal", "desired_goal")  # Gymnasium's names


class Judgement(NamedTuple):
    """The result of a step: numbers and bools for one world, arrays with one entry per world for a batch.

    Give either a reward or its terms. `terms` and `info` are dicts by name.
    """

    reward: Any = None
    terminated: Flags = False  # the episode ends here
    success: Flags = False  # goes to info["is_success"]
    truncated: Flags = False  # the episode is cut off here, as by `max_steps`
    failure: Flags = False  # goes to info["is_failure"]
    terms: Mapping[str, Any] = {}  # go to info["reward_terms"]
    info: Mapping[str, Any] = {}  # goes to info

    def total(self) -> Any:
        """The reward."""
        return sum(self.terms.values()) if self.terms else self.reward


class Task:
    """Derive from it, and give an instance to make, make_vec, SB3VecEnv or ParallelEnv.

    A class serves one world and many if it computes along the last axes: `position[..., 0, :]` is the first body's
    position, of (n, 3) or (worlds, n, 3). Look names up in setup, on the object given there, because selections belong
    to one world or batch. `world.contacts(i)` and `world.world(i)` serve single worlds, for i in
    range(world.world_count).

    `fields` declares additional fields, as Gymnasium's Box by name for one world; set it in the class or in setup, and
    override observe. With several infants (ParallelEnv) evaluate and observe return one result per infant:
    {"anna": ..., "ben": ...}. docs/python.md has examples.
    """

    fields: Mapping[str, spaces.Box] = {}

    def setup(self, world: Access) -> None:
        """Called once, before anything else: look up names here."""

    def reset(self, world: Access, mask: Mask) -> None:
        """Prepares an episode: moves things, draws numbers from world.random.

        In a batch only the worlds where mask is True begin one; pass mask to write() and random(). None means all.
        """

    def evaluate(self, world: Access) -> Union[Judgement, Mapping[str, Judgement]]:
        """Judges a step.

        `world.observation` and `world.action` belong to the step, positions of bodies to the start of its last physics
        step.
        """
        raise missing(self, "evaluate(self, world)")

    def observe(self, world: Access) -> Mapping[str, Any]:
        """The values of `fields`, after evaluate and reset: arrays by name; in a batch the first axis is the world."""
        return {}


class GoalTask(Task):
    """A task with a goal that hindsight experience replay (HER) can replace.

    Observations get "achieved_goal" and "desired_goal", both in the space `goal`; with `flatten` the other fields are
    one row "observation", as in Gymnasium's GoalEnv. Override achieved_goal, desired_goal and compute_reward.
    """

    goal: spaces.Box

    def achieved_goal(self, world: Access) -> Any:
        """The achieved goal: an array; in a batch the first axis is the world."""
        raise missing(self, "achieved_goal(self, world)")

    def desired_goal(self, world: Access) -> Any:
        """The desired goal."""
        raise missing(self, "desired_goal(self, world)")

    def compute_reward(self, achieved_goal: Any, desired_goal: Any, info: Any) -> Any:
        """The reward of goals, along the last axis: goals are (n,) or rows of (n,)."""
        raise missing(self, "compute_reward(self, achieved_goal, desired_goal, info)")

    def evaluate(self, world: Access) -> Union[Judgement, Mapping[str, Judgement]]:
        """The reward of the goals; override it to end episodes: super().evaluate(world)._replace(terminated=...)."""
        achieved, desired = self.achieved_goal(world), self.desired_goal(world)
        if isinstance(achieved, Mapping):
            return {name: Judgement(self.compute_reward(achieved[name], desired[name], {})) for name in achieved}
        return Judgement(self.compute_reward(achieved, desired, {}))


SOLE = ("",)  # names of the infants, unless asked per infant
Own = Dict[str, NDArray[Any]]  # fields that a task declares


class Judge:
    """Calls a task for an environment, and checks its results."""

    def __init__(self, task: Task, world: Access, agents: Sequence[str] = SOLE) -> None:
        from gymnasium.spaces import Box

        self.task, self._name, self._agents = task, type(task).__name__, agents
        self._lead = world._lead
        task.setup(world)
        self.fields: Dict[str, spaces.Box] = dict(task.fields)
        if isinstance(task, GoalTask):
            self.fields.update(dict.fromkeys(GOALS, task.goal))
        for name, box in self.fields.items():
            if not isinstance(box, Box):
                raise TypeError(f"{self._name}: the space of {name!r} is {_what(box)}, expected a gymnasium Box")
            if name in world.layout.fields:
                raise ValueError(f"{self._name}: the world has a field {name!r} already; give yours another name")

    def judged(self, world: Access, agents: Sequence[str] = SOLE) -> Dict[str, Judgement]:
        """The judgement of a step, for each of these infants."""
        judged = self._of_each(agents, self.task.evaluate(world), "evaluate", Judgement, "a mimo.Judgement")
        for judgement in judged.values():
            if (judgement.reward is None) != bool(judgement.terms):
                given = "neither" if judgement.reward is None else "both"
                raise ValueError(f"{self._name}.evaluate gave {given} of reward and terms, expected one of them")
            if not np.all(np.isfinite(judgement.total())):
                raise ValueError(f"{self._name}.evaluate gave the reward {judgement.total()}, expected finite numbers")
        return judged

    def observed(self, world: Access, agents: Sequence[str] = SOLE) -> Dict[str, Own]:
        """The declared fields of each of these infants, as new arrays."""
        if not self.fields:
            return {name: {} for name in agents}
        parts = self._of_each(agents, self.task.observe(world), "observe", Mapping, "a dict of arrays")
        if isinstance(self.task, GoalTask):
            for goal in GOALS:
                values = self._of_each(agents, getattr(self.task, goal)(world), goal, object, "an array")
                parts = {name: {**part, goal: values[name]} for name, part in parts.items()}
        return {name: self._arrays(part) for name, part in parts.items()}

    def _of_each(self, agents: Sequence[str], given: Any, method: str, kind: Any, expected: str) -> Dict[str, Any]:
        """The result of a method, by infant; a single infant need not be named."""
        method = f"{self._name}.{method}"
        named = isinstance(given, Mapping) and bool(given) and set(given) <= set(self._agents)
        if len(self._agents) == 1 and not named:
            given = dict.fromkeys(self._agents, given)
        elif not isinstance(given, Mapping):
            one, example = expected.split(" ", 1)[1], f'{{"{agents[0]}": ...}}'
            raise TypeError(f"{method} returned {_what(given)}; return one {one} per infant, {example}")
        for agent in agents:
            if not isinstance(given.get(agent), kind):
                whose = f" for {agent!r}" if agent else ""
                raise TypeError(f"{method} returned {_what(given.get(agent))}{whose}; return {expected}")
        return {agent: given[agent] for agent in agents}

    def _arrays(self, part: Mapping[str, Any]) -> Dict[str, NDArray[Any]]:
        if part.keys() != self.fields.keys():
            raise ValueError(
                f"{self._name}.observe returned {sorted(part)}, expected what `fields` declares, {sorted(self.fields)}"
            )
        arrays = {}
        for name, box in self.fields.items():
            array = np.array(part[name], box.dtype)
            shape = self._lead + box.shape
            if array.shape != shape:
                raise ValueError(f"{self._name}: {name!r} has the shape {array.shape}, expected {shape}")
            arrays[name] = array
        return arrays


def missing(task: Any, method: str) -> NotImplementedError:
    """The error for a missing method."""
    return NotImplementedError(f"{type(task).__name__} has no method {method}; write one")


def _what(given: Any) -> str:
    return "None" if given is None else f"an object of type {type(given).__name__}"
