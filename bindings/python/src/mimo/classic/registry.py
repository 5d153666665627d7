"""The original's environments by their names."""

from __future__ import annotations

import difflib
from typing import Any, Dict, List, Mapping, Tuple

import gymnasium
from gymnasium.envs.registration import EnvSpec

from . import envs
from .differences import differences_of
from .live import PAGE
from .members import SPEC

# Class and step limit of each.
ENVIRONMENTS: Mapping[str, Tuple[Any, int]] = {
    "MIMoBench-v0": (envs.MIMoDummyEnv, 6000),
    "MIMoBenchV2-v0": (envs.MIMoV2DummyEnv, 6000),
    "MIMoShowroom-v0": (envs.MIMoShowroomEnv, 500),
    "MIMoReach-v0": (envs.MIMoReachEnv, 1000),
    "MIMoStandup-v0": (envs.MIMoStandupEnv, 500),
    "MIMoRollOver-v0": (envs.MIMoRollOverEnv, 500),
    "MIMoSelfBody-v0": (envs.MIMoSelfBodyEnv, 500),
    "MIMoCatch-v0": (envs.MIMoCatchEnv, 800),
    "MIMoMuscle-v0": (envs.MIMoMuscleDummyEnv, 6000),
}


# The original's set-ups that test muscles, which are not here.
TESTS = (
    "MIMoMuscleStaticTest-v0",
    "MIMoMuscleStaticTestV2-v0",
    "MIMoVelocityMuscleTest-v0",
    "MIMoVelocityMuscleTestV2-v0",
    "MIMoComplianceTest-v0",
    "MIMoComplianceMuscleTest-v0",
)


def not_there(**arguments: Any) -> Any:
    """The set-ups that test muscles: an error that says what to do."""
    raise NotImplementedError(
        f"{', '.join(TESTS)} are not here: build such a set-up with mimo.Scene, its weld and lock, and MIMoEnv; {PAGE}"
    )


def _spec(name: str) -> EnvSpec:
    kind, steps = ENVIRONMENTS[_known(name)]
    entry = f"mimo.classic:{kind.__name__}"
    return EnvSpec(name, entry_point=entry, max_episode_steps=steps, additional_wrappers=(SPEC,))


def make(name: str, **arguments: Any) -> "gymnasium.Env[Any, Any]":
    """An environment of the original by its name, with its step limit, like gymnasium.make.

    Arguments are those of the environment's class; `max_episode_steps` sets another limit.
    """
    return gymnasium.make(_spec(name), **arguments)


def differences(name: str) -> List[str]:
    """Differences of an environment from the original's numbers, one line each."""
    return differences_of(ENVIRONMENTS[_known(name)][0])


def register() -> None:
    """Registers "MIMoReach-v0" and the others with Gymnasium, except names in use; `import mimo.classic` calls it."""
    registry: Dict[str, Any] = gymnasium.registry
    for name in ENVIRONMENTS:
        if name not in registry:
            registry[name] = _spec(name)
    for name in TESTS:
        if name not in registry:
            registry[name] = EnvSpec(name, entry_point="mimo.classic.registry:not_there")


def forget(tests: bool = True) -> None:
    """Takes these names from Gymnasium's registry."""
    for name in (*ENVIRONMENTS, *(TESTS if tests else ())):
        gymnasium.registry.pop(name, None)


def register_again() -> None:
    """Registers them, whatever else has taken the names, except those of tests."""
    forget(tests=False)
    register()


def _known(name: Any) -> str:
    if isinstance(name, str) and name in ENVIRONMENTS:
        return name
    near = difflib.get_close_matches(str(name), ENVIRONMENTS, 1)
    meant = f"; did you mean {near[0]!r}?" if near else ""
    raise ValueError(f"name is {name!r}, expected one of {', '.join(ENVIRONMENTS)}{meant}")
