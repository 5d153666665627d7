"""The old package `gym` for scripts that import it: Gymnasium's modules, and steps with four results."""

from __future__ import annotations

import importlib
from types import ModuleType
from typing import Any

import gymnasium

FOUR_RESULTS = True  # running.py sets it by what a script expects


class OldSteps(gymnasium.Wrapper[Any, Any, Any, Any]):
    """As before gym 0.26: reset returns the observation, step observation, reward, done, info; `seed` exists."""

    _seed: Any = None

    def reset(self, **options: Any) -> Any:
        """The observation alone."""
        seed, self._seed = options.pop("seed", self._seed), None
        return self.env.reset(seed=seed, **options)[0]

    def step(self, action: Any) -> Any:
        """Four results: `done` is either end, and info says which."""
        observation, reward, terminated, truncated, info = self.env.step(action)
        info = {**info, "TimeLimit.truncated": truncated and not terminated}
        return observation, reward, terminated or truncated, info

    def seed(self, seed: Any = None) -> Any:
        """Seeds the next reset, and the action space."""
        self._seed = seed
        self.action_space.seed(seed)
        return [seed]

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_") or name == "env":
            raise AttributeError(name)
        return getattr(self.env.unwrapped, name)


def make(name: Any, **arguments: Any) -> Any:
    """An environment of Gymnasium, in the script's manner."""
    made = gymnasium.make(name, **arguments)
    return OldSteps(made) if FOUR_RESULTS else made


class OldGym(ModuleType):
    """The module `gym`, or one in it."""

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        return getattr(self.__dict__["_theirs"], name)


def module_of(name: str) -> OldGym:
    """`gym`, `gym.spaces`, ..."""
    module = OldGym(name, f"Gymnasium's {name}, for scripts for gym.")
    module.__dict__["_theirs"] = importlib.import_module("gymnasium" + name[len("gym") :])
    if name == "gym":
        module.__dict__.update(make=make, __version__="0.21.0")
    return module
