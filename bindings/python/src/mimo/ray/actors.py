"""Actors that have worlds, and what it takes to replace one that is lost."""

from __future__ import annotations

from typing import Any, Dict, List, Optional, Tuple, Union

import numpy as np
import ray
from numpy.typing import NDArray
from ray import cloudpickle
from ray.exceptions import RayActorError, RayTaskError

from ..scene import Scene
from ..vector import Results
from ..vector import VectorEnv as LocalVectorEnv

PATIENCE = 60.0  # seconds until an actor has to have its place in the cluster
LOSSES = 3  # of an actor in one step, after which it is the step's fault


class Worlds:
    """What an actor does: it has a batch of worlds. It is made by `make`, so that errors are those of a call."""

    def make(self, scene: Union[str, Scene], options: Dict[str, Any]) -> Tuple[Any, Any, Any]:
        """Makes the worlds; says what they observe and do."""
        self.envs = LocalVectorEnv(scene, **options)
        return self.envs.single_observation_space, self.envs.single_action_space, self.envs.metadata

    def load(self, state: bytes) -> None:
        """Takes the place of an actor that was lost."""
        self.envs = cloudpickle.loads(state)

    def save(self) -> bytes:
        """All that is needed to go on elsewhere."""
        state: bytes = cloudpickle.dumps(self.envs)
        return state

    def reset(self, seed: Any, options: Dict[str, Any]) -> Tuple[Any, Dict[str, Any]]:
        """Starts episodes."""
        return self.envs.reset(seed=seed, options=options)

    def step(self, actions: NDArray[np.float32]) -> Results:
        """Goes one step on."""
        return self.envs.step(actions)


class Part:
    """Some of the worlds: their actor, and all that it takes to replace it."""

    def __init__(self, worlds: slice, cpus: int, kept_every: int, made_of: Tuple[Any, Dict[str, Any]]) -> None:
        self.worlds, self._cpus, self._kept_every = worlds, cpus, kept_every
        self._state: Optional[bytes] = None
        self._calls: List[Tuple[Any, ...]] = []  # since the state was kept
        self._start(cpus)
        self.ask("make", *made_of)

    def ask(self, method: str, *arguments: Any) -> None:
        """Begins a call."""
        self._calls.append((method, *arguments))
        self._call(method, *arguments)

    def take(self) -> Any:
        """The answer to what was asked last, whatever becomes of the actor meanwhile."""
        for _ in range(LOSSES):
            try:
                self._wait_for_place()
                answer = ray.get(self._answer)
                self._keep()
                return answer
            except RayTaskError as error:
                self._calls.pop()  # it was refused, so nothing happened
                raise error.cause from None
            except RayActorError:
                self._replace()
        raise RuntimeError(f"the actor of {self} was lost {LOSSES} times in the same step, {self._calls[-1][0]}")

    def end(self) -> None:
        """Ends the actor."""
        if ray.is_initialized():
            ray.kill(self._actor)

    def __str__(self) -> str:
        return f"worlds {self.worlds.start} to {self.worlds.stop - 1}"

    def _call(self, method: str, *arguments: Any) -> None:
        self._answer = getattr(self._actor, method).remote(*arguments)

    def _keep(self) -> None:
        if len(self._calls) > self._kept_every:
            try:
                self._state = ray.get(self._actor.save.remote())
                self._calls.clear()
            except RayActorError:
                pass  # lost just now: the next call finds out, and goes on from the state before

    def _replace(self) -> None:
        """A new actor, brought to where the lost one was: by the state that was kept, and all calls since then.

        It asks for no CPUs: where a machine is gone there may be none left, and sharing them is slower than ending.
        """
        self._start(cpus=0)
        if self._state is not None:
            self._call("load", self._state)
        for method, *arguments in self._calls:
            self._call(method, *arguments)

    def _start(self, cpus: int) -> None:
        # "SPREAD" also says that within Tune it needs a place of its own, beside what a trial has asked for.
        self._actor = ray.remote(Worlds).options(num_cpus=cpus, scheduling_strategy="SPREAD").remote()
        self._in_place = False

    def _wait_for_place(self) -> None:
        if self._in_place:
            return
        if not ray.wait([self._actor.__ray_ready__.remote()], timeout=PATIENCE)[0]:
            free, there = (found.get("CPU", 0) for found in (ray.available_resources(), ray.cluster_resources()))
            raise RuntimeError(
                f"no room in the cluster for {self} within {PATIENCE:g} s: their actor asks for {self._cpus} CPUs, "
                f"and {free:g} of {there:g} are free"
            )
        self._in_place = True
