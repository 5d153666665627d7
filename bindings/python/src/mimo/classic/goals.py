"""Rewards of goals, which learners look for in environments."""

from __future__ import annotations

import sys
from types import MethodType
from typing import Any, Callable

LEARNER = "stable_baselines3"


class RewardOfGoals:
    """The method compute_reward of an environment.

    Stable-Baselines3 takes every environment that has this method as one with goals in its observations, for HER, and
    its checker then asks for them. The original has the method in all environments, so it is hidden from the learner
    (and from nobody else) where observations have no goals.
    """

    def __init__(self, function: Callable[..., Any]) -> None:
        self._function = function
        self.__doc__ = function.__doc__

    def __get__(self, env: Any, kind: Any = None) -> Any:
        if env is None:
            return self._function
        if not env.goals_in_observation and _caller(2).startswith(LEARNER):
            raise AttributeError("compute_reward")
        return MethodType(self._function, env)


def _caller(depth: int) -> str:
    return str(sys._getframe(depth).f_globals.get("__name__", ""))
