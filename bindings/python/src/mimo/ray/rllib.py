"""RLlib on worlds in its runners or in actors."""

from __future__ import annotations

from typing import Any, Dict, Optional, Tuple

import gymnasium.vector

from ..env import Env
from ..vector import VectorEnv as LocalVectorEnv
from .names import check, scene_of
from .vector import VectorEnv

RLLIB_NAME = "mimo"
WORLDS_OF_A_SEED = 2**20


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

    `runners`: the number of RLlib's environment runners, each with a share of the worlds and a copy of the policy.
    `actors`: the number of actors with worlds (mimo.ray.VectorEnv) beside one runner with the policy; the same seed
    gives the same results with any number of actors, even if some are lost. Without both, one process has everything.

    Observations are one row of numbers, actions -1 to 1; other options are those of mimo.make_vec. Tune may choose
    `seed`.
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
    """Registers the worlds with RLlib, as `configure` does; for programs that only restore a checkpoint."""
    from ray.tune.registry import register_env  # slow, and needs more than plain Ray

    register_env(RLLIB_NAME, rllib_env)


def rllib_env(given: Any) -> Any:
    """Makes worlds for RLlib: many with "num_envs", else one."""
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
    """Gives worlds the same seeds with any number of runners; RLlib's seeds would overlap: s + 1, s + 2 ... in each."""

    def __init__(self, envs: Any, runner: int) -> None:
        super().__init__(envs)
        self._runner = runner

    def reset(self, *, seed: Any = None, options: Optional[Dict[str, Any]] = None) -> Tuple[Any, Dict[str, Any]]:
        """Starts episodes; RLlib adds the runner's number, from 1 on, to the seed."""
        if seed is not None:
            seed = (seed - self._runner) * WORLDS_OF_A_SEED + max(self._runner - 1, 0) * self.num_envs
        return self.env.reset(seed=seed, options=options)
