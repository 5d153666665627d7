"""Configurations of BabyBench: a YAML file or a dict, checked key by key."""

from __future__ import annotations

import difflib
import os
import warnings
from pathlib import Path
from reprlib import repr as short
from typing import Any, Dict, List, Mapping, Union

from .described import COUNTED, Described, described_in_scenes
from .groups import flags

Config = Dict[str, Any]
Given = Union[str, "os.PathLike[str]", Mapping[str, Any]]

SHIPPED = Path(__file__).parent / "configs"
CHOICES: Mapping[str, Any] = {
    "behavior": COUNTED,
    "scene": ("base", "crib", "cubes"),
    "actuation_model": ("spring_damper", "muscle", "positional"),
    "touch_function": ("force_vector", "force_vector_global", "normal_force"),
    "touch_response": ("spread_linear", "nearest"),
}
COUNTS = {"max_episode_steps": 1000, "frame_skip": 1, "render_size": 480, "save_logs_every": 1000}
FLAGS: Mapping[str, bool] = {
    **{f"proprio_{part}": True for part in ("velocity", "torque", "limits", "actuation")},
    **{"vestibular_active": True, "vision_active": True, "touch_active": True},
    **{name: group != "eyes" for name, group in flags("touch").items()},
    **dict.fromkeys(flags("act"), True),
    **{name: group == "feet" for name, group in flags("lock").items()},
}
DEFAULTS: Config = {
    "save_dir": None,
    **{name: choices[0] for name, choices in CHOICES.items()},
    **COUNTS,
    **{"vision_resolution": 64, "touch_scale": 1},
    **FLAGS,
}


class Checked(Dict[str, Any]):
    """A configuration that was loaded, whose warnings have been given."""


def load(config: Given) -> Config:
    """A complete configuration: of a file, a shipped one ("selftouch"), a behaviour ("sit"), or a dict.

    Missing keys have their default, for a behaviour that a scene describes as in that scene. Keys that are not switches
    stay in it, with a warning.
    """
    given = config if isinstance(config, Mapping) else _read(config)
    _tell_others(given)
    behavior = given.get("behavior", COUNTED[0])
    counted = isinstance(behavior, str) and behavior in COUNTED
    for name, value in given.items():
        if counted or name not in ("behavior", "scene"):
            _check(name, value)
    own = {} if counted else _own(behavior, given)
    return Checked({**DEFAULTS, **own, **given, **({"behavior": own["scene"]} if own else {})})


def is_described(config: Mapping[str, Any]) -> bool:
    """Whether a scene's document describes the configuration's behaviour."""
    return config["behavior"] not in COUNTED


def _own(behavior: Any, given: Mapping[str, Any]) -> Config:
    """The default values of a behaviour that a scene describes."""
    standard = Described(behavior).standard(given.get("frame_skip"))
    scene = given.get("scene", standard["scene"])
    if str(scene) != standard["scene"]:
        raise ValueError(
            f"scene is {short(scene)}, but behavior {short(standard['scene'])} has a scene of its own: leave scene out"
        )
    return standard


def on(config: Mapping[str, Any], prefix: str) -> List[str]:
    """The groups that switches of a kind, such as "act", switch on."""
    return [group for name, group in flags(prefix).items() if config[name]]


def shipped() -> List[str]:
    """Names of the shipped configurations."""
    return sorted(file.stem for file in SHIPPED.glob("*.yml"))


def _read(path: Any) -> Mapping[str, Any]:
    if isinstance(path, str) and path in described_in_scenes():
        return {"behavior": path}
    file = SHIPPED / f"{path}.yml" if path in shipped() else Path(path)
    if not file.is_file():
        raise FileNotFoundError(
            f"config is {str(path)!r}, expected a YAML file, a dict, or one of {', '.join(shipped())}, "
            f"{', '.join(described_in_scenes())}"
        )
    try:
        import yaml
    except ImportError as error:
        raise ImportError("configurations in files need PyYAML: pip install 'mimo[babybench]'") from error
    try:
        given = yaml.safe_load(file.read_text(encoding="utf-8"))
    except RecursionError:
        raise ValueError(f"{file} is not YAML: it is nested too deeply") from None
    except (yaml.YAMLError, ValueError) as error:
        raise ValueError(f"{file} is not YAML: {' '.join(str(error).split())}") from None
    if not isinstance(given, Mapping):
        raise ValueError(f"{file} holds {type(given).__name__}, expected keys with values")
    return given


def _tell_others(given: Mapping[str, Any]) -> None:
    others = [str(name) for name in given if name not in DEFAULTS]
    if not others or isinstance(given, Checked):
        return
    if len(others) == len(given):
        raise ValueError(f"config has {short(others[0])}, but no switch. There are: {', '.join(DEFAULTS)}")
    for name in others:
        near = difflib.get_close_matches(name, DEFAULTS, 1)
        meant = f"; did you mean {near[0]!r}?" if near else ""
        warnings.warn(f"config has {short(name)}, which is not a switch and has no effect{meant}", stacklevel=4)


def _check(name: Any, value: Any) -> None:
    if name in CHOICES and value not in CHOICES[name]:
        raise ValueError(f"{name} is {short(value)}, expected {', '.join(map(repr, CHOICES[name]))}")
    if name in FLAGS and not isinstance(value, bool):
        raise ValueError(f"{name} is {short(value)}, expected true or false")
    if (name in COUNTS or name == "vision_resolution") and not _is_number(value, int):
        raise ValueError(f"{name} is {short(value)}, expected a whole number")
    least = 0 if name == "save_logs_every" else 1
    if (name in COUNTS or name == "vision_resolution") and value < least:
        raise ValueError(f"{name} is {short(value)}, expected a whole number from {least} on")
    if name == "touch_scale" and not (_is_number(value, (int, float)) and value >= 0):
        raise ValueError(f"touch_scale is {short(value)}, expected a number from 0 on; 0: no touch")
    if name == "save_dir" and not (value is None or isinstance(value, (str, os.PathLike))):
        raise ValueError(f"save_dir is {short(value)}, expected a folder")


def _is_number(value: Any, kind: Any) -> bool:
    return isinstance(value, kind) and not isinstance(value, bool)
