"""A VectorEnv of Gymnasium with worlds in actors."""

from __future__ import annotations

from typing import Any, Dict, List, Mapping, Optional, Sequence, Tuple, Union

import numpy as np

from ..arguments import reset_options, whole_number
from ..scene import Scene
from ..spaces import of_worlds
from ..tasks import GoalTask
from ..vector import Results, VectorBase, from_chance
from .actors import Part
from .cluster import connect
from .names import check, scene_of

KEPT_EVERY = 50  # most steps that are repeated after the loss of an actor


class VectorEnv(VectorBase):
    """mimo.VectorEnv whose worlds are spread over Ray actors, and so over the machines of a cluster.

    World i behaves exactly like world i of mimo.VectorEnv, with any number of `actors`. A lost actor is replaced, and
    its worlds continue: states are kept every `kept_every` steps, and the steps since then are repeated. An actor
    reserves `cpus` of its machine, and its worlds run on as many threads. Observations are copies. Options are those of
    mimo.make_vec, except pictures.
    """

    def __init__(
        self,
        scene: Union[str, Scene] = "benchmark",
        num_envs: int = 1,
        *,
        actors: int = 1,
        cpus: int = 1,
        kept_every: int = KEPT_EVERY,
        **options: Any,
    ) -> None:
        check(scene, options)
        for name, value, most in (("num_envs", num_envs, None), ("actors", actors, num_envs), ("cpus", cpus, None)):
            if whole_number(name, value) < 1 or (most is not None and value > most):
                raise ValueError(f"{name} is {value!r}, expected {'1 or more' if most is None else f'1 to {most}'}")
        if whole_number("kept_every", kept_every) < 1:
            raise ValueError(f"kept_every is {kept_every!r}, expected 1 or more")
        connect()
        ends = np.linspace(0, num_envs, actors + 1).astype(int)
        ages = options.pop("ages", None)
        self._parts: List[Part] = []
        for begin, end in zip(ends[:-1], ends[1:]):
            mine = {**options, "threads": cpus}
            if ages is not None:
                mine["ages"] = [ages[i % len(ages)] for i in range(begin, end)]
            mine["num_envs"] = int(end - begin)
            self._parts.append(Part(slice(int(begin), int(end)), cpus, kept_every, (scene_of(scene), mine)))
        told = self._answers()[0]
        self.num_envs = num_envs
        self.single_observation_space, self.single_action_space, self.metadata = told
        self.autoreset_mode = self.metadata["autoreset_mode"]
        self.render_mode = None
        self.observation_space = of_worlds(self.single_observation_space, num_envs)
        self.action_space = of_worlds(self.single_action_space, num_envs)
        if isinstance(options.get("task"), GoalTask):  # only with goals: learners test for this attribute
            self.compute_reward = options["task"].compute_reward
        self._seeded = self._sent = False

    def reset(
        self,
        *,
        seed: Optional[Union[int, Sequence[Optional[int]]]] = None,
        options: Optional[Dict[str, Any]] = None,
    ) -> Tuple[Any, Dict[str, Any]]:
        """Starts episodes; one seed s means s, s + 1, ... The same options as in mimo.VectorEnv."""
        given = reset_options(options, "reset_mask", "ages")
        for name, values in given.items():
            if len(values) != self.num_envs:
                raise ValueError(f"options has {len(values)} of {name!r}, expected one per world, {self.num_envs}")
        super().reset(seed=seed if isinstance(seed, int) else None)
        if isinstance(seed, (list, tuple)) and len(seed) != self.num_envs:
            raise ValueError(f"{len(seed)} seeds, expected {self.num_envs}, one for each world")
        seed, self._seeded = seed if self._seeded else from_chance(seed), True
        for part in self._parts:
            some = seed + part.worlds.start if isinstance(seed, int) else seed and list(seed[part.worlds])
            part.ask("reset", some, {name: values[part.worlds] for name, values in given.items()})
        answers = self._answers()
        return joined([observation for observation, _ in answers]), self._infos([infos for _, infos in answers])

    def step(self, actions: Any) -> Results:
        """Steps all worlds."""
        self.send(actions)
        return self.receive()

    def send(self, actions: Any) -> None:
        """Starts a step and returns at once; receive() returns its results."""
        rows = np.asarray(actions, np.float32)
        if rows.shape != self.action_space.shape:
            raise ValueError(f"actions have the shape {rows.shape}, expected {self.action_space.shape}")
        if np.isnan(rows).any():  # all actors refuse it, not only that of the world
            raise ValueError(f"actions: that of world {np.isnan(rows).any(axis=1).argmax()} is not a number")
        for part in self._parts:
            part.ask("step", rows[part.worlds])
        self._sent = True

    def receive(self) -> Results:
        """Waits for the step in flight."""
        if not self._sent:
            raise RuntimeError("receive: no step was sent")
        self._sent = False
        observations, rewards, terminated, truncated, infos = zip(*self._answers())
        whole = (np.concatenate(rows) for rows in (rewards, terminated, truncated))
        return (joined(observations), *whole, self._infos(infos))

    def close_extras(self, **kwargs: Any) -> None:
        """Ends the actors."""
        for part in getattr(self, "_parts", ()):
            part.end()

    def _answers(self) -> List[Any]:
        """Results of all parts, even if one failed."""
        answers, refused = [], []
        for part in self._parts:
            try:
                answers.append(part.take())
            except Exception as error:
                refused.append(error)
        if refused:
            raise refused[0] from None
        return answers

    def _infos(self, infos: Sequence[Mapping[str, Any]]) -> Dict[str, Any]:
        return joined_infos(infos, [part.worlds.stop - part.worlds.start for part in self._parts])


def make_vec(scene: Union[str, Scene] = "benchmark", num_envs: int = 1, **options: Any) -> VectorEnv:
    """Worlds of a scene in Ray actors, as a gymnasium.vector.VectorEnv; see mimo.ray.VectorEnv for the options."""
    return VectorEnv(scene, num_envs, **options)


def joined(parts: Sequence[Any]) -> Any:
    """Observations of all worlds: arrays, or dicts of arrays."""
    if isinstance(parts[0], Mapping):
        return {name: joined([part[name] for part in parts]) for name in parts[0]}
    return np.concatenate(parts)


def joined_infos(parts: Sequence[Mapping[str, Any]], sizes: Sequence[int]) -> Dict[str, Any]:
    """Gymnasium's infos of all worlds; missing values are zero, with a mask of False."""
    whole: Dict[str, Any] = {}
    for name in dict.fromkeys(name for part in parts for name in part):
        first = next(part[name] for part in parts if name in part)
        if isinstance(first, Mapping):
            whole[name] = joined_infos([part.get(name, {}) for part in parts], sizes)
        else:
            blanks = [
                np.full((size, *first.shape[1:]), None if first.dtype == object else 0, first.dtype) for size in sizes
            ]
            whole[name] = np.concatenate([part.get(name, blank) for part, blank in zip(parts, blanks)])
    return whole
