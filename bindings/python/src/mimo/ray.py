"""Ray: worlds in actors on many machines, and RLlib that trains on them. Needs the extra [ray].

    mimo.ray.connect()                                            # to the cluster, or a new one on this machine
    envs = mimo.ray.make_vec("reach", num_envs=64, actors=8)      # as mimo.make_vec, in eight processes
    config = mimo.ray.configure(PPOConfig(), "reach", num_envs=64, runners=8)   # RLlib

Every machine needs this package, of the same version.
"""

from __future__ import annotations

import difflib
import os
import socket
from typing import Any, Dict, List, Mapping, Optional, Sequence, Tuple, Union

import gymnasium.vector
import numpy as np
import ray
from gymnasium.vector.utils import batch_space
from numpy.typing import NDArray
from ray import cloudpickle
from ray.exceptions import RayActorError, RayTaskError

from .arguments import reset_options, whole_number
from .env import ENVIRONMENTS, Env
from .options import EnvOptions, refuse_unknown
from .scene import Scene, scenes
from .tasks import GoalTask
from .vector import Results
from .vector import VectorEnv as LocalVectorEnv

KEPT_EVERY = 50  # steps: at most so many are made again after the loss of an actor
PATIENCE = 60.0  # seconds until an actor has to have its place in the cluster
LOSSES = 3  # of an actor in one step, after which it is the step's fault
ANSWER_WITHIN = 5.0  # seconds, of a cluster that is there


# ---- The cluster ---------------------------------------------------------------------------------------------------


def connect(address: Optional[str] = None, **options: Any) -> None:
    """Connects to a Ray cluster: to that at `address`, else to the one around (RAY_ADDRESS), else to a new one here.

    `address` is HOST:PORT, ray://HOST:PORT or "auto", which is never a new one; options are those of ray.init.
    """
    if ray.is_initialized():
        return
    given = address or os.environ.get("RAY_ADDRESS")
    if given and given not in ("auto", "local"):
        _check_there(given)
    try:
        ray.init(address=address, **{"log_to_driver": False, **options})
    except ConnectionError:
        raise ConnectionError(f"address is {given!r}: {NOBODY}") from None


NOBODY = "no Ray cluster is there; start one with `ray start --head`, or leave the address out"


def _check_there(address: str) -> None:
    """Ray itself would try for a minute, and then end the process."""
    host, _, port = address.rpartition("://")[2].rpartition(":")
    if not host or not port.isdigit():
        raise ValueError(f"address is {address!r}, expected HOST:PORT, ray://HOST:PORT or auto")
    try:
        socket.create_connection((host, int(port)), ANSWER_WITHIN).close()
    except (OSError, OverflowError):
        raise ConnectionError(f"address is {address!r}: {NOBODY}") from None


# ---- Worlds in actors ----------------------------------------------------------------------------------------------


class VectorEnv(gymnasium.vector.VectorEnv[Any, Any, Any]):
    """mimo.VectorEnv whose worlds are spread over Ray actors, and so over the machines of a cluster.

    World i does exactly what world i of mimo.VectorEnv does, however many `actors` share the worlds. An actor that is
    lost is replaced, and its worlds go on where they were: states are kept every `kept_every` steps, and the steps
    since then are made again. An actor asks for `cpus` of its machine, and its worlds run on as many threads.
    Observations are the caller's own. Options are those of mimo.make_vec, but pictures.
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
        self._parts: List[_Part] = []
        for begin, end in zip(ends[:-1], ends[1:]):
            mine = {**options, "threads": cpus}
            if ages is not None:
                mine["ages"] = [ages[i % len(ages)] for i in range(begin, end)]
            mine["num_envs"] = int(end - begin)
            self._parts.append(_Part(slice(int(begin), int(end)), cpus, kept_every, (scene_of(scene), mine)))
        told = self._answers()[0]
        self.num_envs = num_envs
        self.single_observation_space, self.single_action_space, self.metadata = told
        self.autoreset_mode = self.metadata["autoreset_mode"]
        self.render_mode = None
        self.observation_space = batch_space(self.single_observation_space, num_envs)
        self.action_space = batch_space(self.single_action_space, num_envs)
        if isinstance(options.get("task"), GoalTask):  # only then: learners take it for one with goals
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
                raise ValueError(f"options has {len(values)} of {name!r}, expected one a world, {self.num_envs}")
        super().reset(seed=seed if isinstance(seed, int) else None)
        if seed is None and not self._seeded:
            seed = int(np.random.SeedSequence().generate_state(1)[0])
        self._seeded = True
        for part in self._parts:
            some = seed + part.worlds.start if isinstance(seed, int) else seed and list(seed[part.worlds])
            part.ask("reset", some, {name: values[part.worlds] for name, values in given.items()})
        answers = self._answers()
        return joined([observation for observation, _ in answers]), self._infos([infos for _, infos in answers])

    def step(self, actions: Any) -> Results:
        """Goes one step on in all worlds."""
        self.send(actions)
        return self.receive()

    def send(self, actions: Any) -> None:
        """Starts a step and returns; receive() gives its results."""
        rows = np.asarray(actions, np.float32)
        if rows.shape != self.action_space.shape:
            raise ValueError(f"actions have the shape {rows.shape}, expected {self.action_space.shape}")
        if np.isnan(rows).any():  # refused by all, not only by those whose worlds it is for
            raise ValueError(f"actions: that of world {np.isnan(rows).any(axis=1).argmax()} is not a number")
        for part in self._parts:
            part.ask("step", rows[part.worlds])
        self._sent = True

    def receive(self) -> Results:
        """Waits for the step that was sent."""
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
        """Of all parts, also where one was refused."""
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


class _Part:
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


def scene_of(scene: Union[str, Scene]) -> Union[str, Scene]:
    """The scene of a name, which may be Gymnasium's ("mimo/Reach-v0")."""
    return dict(ENVIRONMENTS).get(scene, scene) if isinstance(scene, str) else scene


def check(scene: Union[str, Scene], options: Mapping[str, Any]) -> None:
    """Refuses a name or an option that there is not, here rather than on another machine."""
    known = [*scenes(), *(name for name, _ in ENVIRONMENTS)]
    if isinstance(scene, str) and scene not in known:
        near = difflib.get_close_matches(scene, known, 1)
        meant = f"; did you mean {near[0]!r}?" if near else ""
        raise ValueError(f"scene is {scene!r}, expected one of {', '.join(known)}{meant}")
    for name, why in REFUSED.items():
        if name in options:
            raise TypeError(f"unexpected keyword argument {name!r}: {why}")
    rest = {name: value for name, value in options.items() if name not in OF_WORLDS}
    refuse_unknown(rest, EnvOptions, LocalVectorEnv.__init__)


OF_WORLDS = ("task", "flatten", "autoreset_mode", "ages")  # what mimo.VectorEnv itself takes
REFUSED = {
    "threads": "an actor has as many as `cpus`",
    **dict.fromkeys(("render_mode", "camera", "width", "height"), "worlds in actors draw no pictures for people"),
}


def joined(parts: Sequence[Any]) -> Any:
    """Observations of all worlds: of arrays, or dicts of them."""
    if isinstance(parts[0], Mapping):
        return {name: joined([part[name] for part in parts]) for name in parts[0]}
    return np.concatenate(parts)


def joined_infos(parts: Sequence[Mapping[str, Any]], sizes: Sequence[int]) -> Dict[str, Any]:
    """Gymnasium's infos of all worlds; what some parts do not tell is zero there, and its mask False."""
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


# ---- RLlib ---------------------------------------------------------------------------------------------------------


def configure(
    config: Any,
    scene: str,
    *,
    num_envs: int,
    runners: int = 0,
    actors: int = 0,
    cpus: int = 1,
    seed: Any = 0,
    **options: Any,
) -> Any:
    """An RLlib AlgorithmConfig (PPOConfig(), SACConfig() ...) with `num_envs` worlds of a scene, in either of two ways.

    `runners`: so many of RLlib's environment runners have their share of worlds, and a copy of the policy each.
    `actors`: one runner has the policy, and so many actors have the worlds (mimo.ray.VectorEnv): the same seed gives
    the same results with any number of them, also if some are lost. Neither: all in one process.

    Observations are one row of numbers, actions -1 to 1; all else as in mimo.make_vec. `seed` may be Tune's to choose.
    """
    check(scene, options)
    if runners and actors:
        raise ValueError(f"runners is {runners} and actors is {actors}, expected one of them to be 0")
    if num_envs < 1 or runners < 0 or num_envs % max(runners, 1):
        raise ValueError(f"num_envs is {num_envs}, expected a multiple of runners, {runners}")
    if not 0 <= actors <= num_envs:
        raise ValueError(f"actors is {actors}, expected 0 to {num_envs}, the number of worlds")
    if options.setdefault("flatten", True) is not True:
        raise ValueError(f"flatten is {options['flatten']!r}, expected True: RLlib's networks take rows of numbers")
    options.setdefault("normalize_actions", True)
    register()
    given = {"scene": scene_of(scene), "actors": actors, "cpus": cpus, "options": options}
    return (
        config.environment(RLLIB_NAME, env_config=given)
        .env_runners(
            num_env_runners=runners,
            num_envs_per_env_runner=num_envs // max(runners, 1),
            num_cpus_per_env_runner=cpus,
            gym_env_vectorize_mode="vector_entry_point",
        )
        .debugging(seed=seed)
    )


def register() -> None:
    """Tells RLlib how to make our worlds, as `configure` does; for programs that only restore a checkpoint."""
    from ray.tune.registry import register_env  # takes seconds, and more than plain Ray

    register_env(RLLIB_NAME, rllib_env)


RLLIB_NAME = "mimo"


def rllib_env(given: Any) -> Any:
    """What RLlib calls where it wants worlds: many with "num_envs", else one."""
    scene, actors, cpus, options = (given[name] for name in ("scene", "actors", "cpus", "options"))
    worlds = given.get("num_envs")
    if worlds is None:
        return Env(scene, **{name: value for name, value in options.items() if name != "ages"})
    if actors:
        envs: Any = VectorEnv(scene, worlds, actors=min(actors, worlds), cpus=cpus, **options)
    else:
        envs = LocalVectorEnv(scene, worlds, threads=cpus, **options)
    return _Seeds(envs, getattr(given, "worker_index", 0) or 0)


class _Seeds(gymnasium.vector.VectorWrapper):
    """Worlds of a seed are the same with any number of runners; RLlib's own overlap, s + 1, s + 2 ... in each."""

    def __init__(self, envs: Any, runner: int) -> None:
        super().__init__(envs)
        self._runner = runner

    def reset(self, *, seed: Any = None, options: Optional[Dict[str, Any]] = None) -> Tuple[Any, Dict[str, Any]]:
        """Starts episodes; RLlib's seed of a runner is that of the whole, and the runner's number, from 1 on."""
        if seed is not None:
            seed = (seed - self._runner) * WORLDS_OF_A_SEED + max(self._runner - 1, 0) * self.num_envs
        return self.env.reset(seed=seed, options=options)


WORLDS_OF_A_SEED = 2**20
