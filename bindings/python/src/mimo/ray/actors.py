"""Actors with worlds, and their replacement after a loss."""

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

PATIENCE = 60.0  # longest wait for an actor's place in the cluster, s
LOSSES = 3  # losses of an actor in one step after which the step is to blame


class Worlds:
    """An actor with a batch of worlds. `make` creates them, so that errors are raised by a call."""

    def make(self, scene: Union[str, Scene], options: Dict[str, Any]) -> Tuple[Any, Any, Any]:
        """Makes the worlds; returns their spaces."""
        self.envs = LocalVectorEnv(scene, **options)
        return self.envs.single_observation_space, self.envs.single_action_space, self.envs.metadata

    def load(self, state: bytes) -> None:
        """Restores the worlds of a lost actor."""
        self.envs = cloudpickle.loads(state)

    def save(self) -> bytes:
        """The complete state of the worlds."""
        state: bytes = cloudpickle.dumps(self.envs)
        return state

    def reset(self, seed: Any, options: Dict[str, Any]) -> Tuple[Any, Dict[str, Any]]:
        """Starts episodes."""
        return self.envs.reset(seed=seed, options=options)

    def step(self, actions: NDArray[np.float32]) -> Results:
        """Makes one step."""
        return self.envs.step(actions)


class Part:
    """Some of the worlds: their actor, and the data to replace it."""

    def __init__(self, worlds: slice, cpus: int, kept_every: int, made_of: Tuple[Any, Dict[str, Any]]) -> None:
        self.worlds, self._cpus, self._kept_every = worlds, cpus, kept_every
        self._state: Optional[bytes] = None
        self._calls: List[Tuple[Any, ...]] = []  # calls since the state was kept
        self._start(cpus)
        self.ask("make", *made_of)

    def ask(self, method: str, *arguments: Any) -> None:
        """Begins a call."""
        self._calls.append((method, *arguments))
        self._call(method, *arguments)

    def take(self) -> Any:
        """The result of the last call, even if the actor is lost meanwhile."""
        for _ in range(LOSSES):
            try:
                self._wait_for_place()
                answer = ray.get(self._answer)
                self._keep()
                return answer
            except RayTaskError as error:
                self._calls.pop()  # it was refused, so nothing changed
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
                pass  # the actor was lost: the next call notices, and continues from the previous state

    def _replace(self) -> None:
        """A new actor in the state of the lost one: from the kept state and all calls since then.

        It asks for no CPUs: after the loss of a machine none may be left, and sharing them is better than failing.
        """
        self._start(cpus=0)
        if self._state is not None:
            self._call("load", self._state)
        for method, *arguments in self._calls:
            self._call(method, *arguments)

    def _start(self, cpus: int) -> None:
        # "SPREAD" also lets it have resources beyond those of a trial of Tune.
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
