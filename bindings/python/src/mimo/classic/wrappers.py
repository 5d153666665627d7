"""Gymnasium's wrappers pass members of an environment on, as they did when the original was written."""

from __future__ import annotations

from typing import Any

import gymnasium


def pass_members_on() -> None:
    """`env.data` of a wrapped environment is that of the environment within. Gymnasium 1.0 has taken this away."""
    if "__getattr__" not in vars(gymnasium.Wrapper):
        gymnasium.Wrapper.__getattr__ = _passed_on  # type: ignore[attr-defined]


def _passed_on(self: Any, name: str) -> Any:
    if name.startswith("_") or name == "env" or "env" not in self.__dict__:
        raise AttributeError(f"{type(self).__name__} has no attribute {name!r}")
    return getattr(self.env, name)
