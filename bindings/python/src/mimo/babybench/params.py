"""A configuration's senses, motors and times, as arguments of the original's environments."""

from __future__ import annotations

from typing import Any, Dict, Mapping, Optional

from ..classic.actuation import MuscleModel, PositionalModel, SpringDamperModel
from ..classic.params import COMPONENTS, DEFAULT_TOUCH_PARAMS, DEFAULT_TOUCH_PARAMS_V2
from .config import Config, on
from .counts import kind_of
from .groups import of_groups
from .rooms import body_of

Parameters = Optional[Mapping[str, float]]
MODELS = {"spring_damper": SpringDamperModel, "muscle": MuscleModel, "positional": PositionalModel}


def arguments_of(config: Config, parameters: Parameters = None) -> Dict[str, Any]:
    """Arguments of mimo.classic.MIMoEnv; `parameters` override those of the behaviour."""
    pixels = {"width": config["vision_resolution"], "height": config["vision_resolution"]}
    return {
        "frame_skip": config["frame_skip"],
        "proprio_params": {"components": [part for part in COMPONENTS if config[f"proprio_{part}"]]},
        "vestibular_params": {} if config["vestibular_active"] else None,
        "vision_params": {"eye_left": pixels, "eye_right": pixels} if config["vision_active"] else None,
        "touch_params": _touch(config),
        "actuation_model": MODELS[config["actuation_model"]],
        "parameters": {**kind_of(config).parameters, **(parameters or {})},
    }


def _touch(config: Config) -> Optional[Dict[str, Any]]:
    """Sensor distances times `touch_scale`, for the bodies of the groups with touch; None without touch."""
    if not config["touch_active"] or config["touch_scale"] == 0:
        return None
    usual = DEFAULT_TOUCH_PARAMS_V2 if body_of(config) == "fingers" else DEFAULT_TOUCH_PARAMS
    bodies = of_groups(usual["scales"], on(config, "touch"))
    if not bodies:
        return None
    return {
        "scales": {body: usual["scales"][body] * config["touch_scale"] for body in bodies},
        "touch_function": config["touch_function"],
        "response_function": config["touch_response"],
    }
