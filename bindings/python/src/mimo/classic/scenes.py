"""Scenes from the original's arguments."""

from __future__ import annotations

import os
from typing import Any, Dict, Mapping, Tuple

import numpy as np
from numpy.typing import ArrayLike

from ..arguments import real_number, vector
from ..options import AgentOptions, EnvOptions, PhysicsOptions, enums, refuse_unknown
from ..scene import Scene, scenes
from .params import Senses

ROOT = "mimo_location"
TAKEN = {"proprioception", "vestibular", "vision", "touch", "actuation", "limit_threshold", "frame_skip"}


def split(options: Mapping[str, Any], name: str) -> Tuple[Dict[str, Any], Dict[str, Any]]:
    """Splits options into those of the infant and those of the simulation."""
    for option in options:
        if option in TAKEN:
            raise TypeError(f"{name} does not take {option!r}: use the original's arguments (touch_params, ...)")
    refuse_unknown(options, EnvOptions)
    infant = {key: value for key, value in options.items() if key in enums(AgentOptions)}
    return infant, {key: value for key, value in options.items() if key in enums(PhysicsOptions)}


def scene_of(
    model_path: Any,
    infant: Mapping[str, Any],
    senses: Senses,
    pose: Mapping[str, ArrayLike],
    parameters: Mapping[str, float],
) -> Scene:
    """A scene with its infant."""
    scene, brings_infant = _start(model_path)
    angles, root = _posed(pose)
    if brings_infant and root:
        raise ValueError(f"initial_qpos has {ROOT!r}, but {model_path} places its infant itself")
    body = {"body": "scene"} if brings_infant else {}
    scene.add_agents(**{**infant, **body, **root})
    if senses.spacings is not None:
        scene.set_touch(None, 0.0)
        for name, metres in senses.spacings.items():
            scene.set_touch(name, metres)
    for name, (width, height) in senses.cameras.items():
        scene.add_camera(name, width=width, height=height)
    for joint, angle in angles.items():
        scene.set_pose(joint, angle)
    for name, value in parameters.items():
        scene.parameters[name] = value
    return scene


def _start(model_path: Any) -> Tuple[Scene, bool]:
    if isinstance(model_path, Scene):
        return model_path.copy(), _brings_infant(model_path)
    path = os.fspath(model_path)
    if path in scenes():
        return Scene(path), False
    if not os.path.exists(path):
        raise FileNotFoundError(f"model_path is {path!r}, expected an MJCF file or one of {', '.join(scenes())}")
    scene = Scene(file=path)
    return scene, _brings_infant(scene)


def _brings_infant(scene: Scene) -> bool:
    return f'name="{ROOT}"' in scene.xml


def _posed(pose: Mapping[str, ArrayLike]) -> Tuple[Dict[str, float], Dict[str, Any]]:
    """Angles by joint, and the pose of the root if given."""
    angles: Dict[str, float] = {}
    root: Dict[str, Any] = {}
    for joint, value in pose.items():
        if joint == ROOT:
            place = vector(f"initial_qpos[{joint!r}]", value, 7)
            root = {"position": list(place[:3]), "orientation": list(place[3:])}
        else:
            angles[joint] = real_number(f"initial_qpos[{joint!r}]", np.asarray(value).item())
    return angles, root
