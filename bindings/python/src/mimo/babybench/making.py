"""Environments from configurations."""

from __future__ import annotations

from typing import Any

import gymnasium
from gymnasium.envs.registration import EnvSpec

from ..classic.members import SPEC
from .config import Given, load

NAMES = {"none": "BabyBench", "self_touch": "BabyBench-SelfTouch", "hand_regard": "BabyBench-HandRegard"}


def make(config: Given = "test_installation", training: bool = True, **arguments: Any) -> "gymnasium.Env[Any, Any]":
    """An environment from a YAML file or a dict; without `training` it does not log.

    Other arguments are those of mimo.classic.MIMoEnv, for example `render_mode`.
    """
    whole = load(config)
    spec = EnvSpec(
        NAMES.get(whole["behavior"], "BabyBench-Behavior"),
        entry_point="mimo.babybench:BabyBenchEnv",
        max_episode_steps=whole["max_episode_steps"],
        additional_wrappers=(SPEC,),
    )
    return gymnasium.make(spec, config=whole, training=training, **arguments)


def register() -> None:
    """Registers "BabyBench-SelfTouch" and the others with Gymnasium, with the shipped configurations."""
    shipped = {"none": "test_installation", "self_touch": "selftouch", "hand_regard": "handregard"}
    for behavior, name in NAMES.items():
        if name not in gymnasium.registry:
            gymnasium.registry[name] = EnvSpec(
                name,
                entry_point="mimo.babybench:BabyBenchEnv",
                max_episode_steps=1000,
                additional_wrappers=(SPEC,),
                kwargs={"config": shipped[behavior], "training": False},
            )
