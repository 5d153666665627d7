"""Scenes from the original's arguments."""

from __future__ import annotations

import os
import sys
import xml.etree.ElementTree as ET
from contextlib import suppress
from typing import Any, Dict, Mapping, NamedTuple, Optional, Tuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..arguments import vector
from ..errors import ArgumentError
from ..options import AgentOptions, EnvOptions, GrowthOptions, PhysicsOptions, enums, refuse_unknown
from ..scene import Scene, scenes
from .eyes import blur_of
from .params import Senses

Numbers = NDArray[Any]
ROOT = "mimo_location"
JOINTS_OF_ROOT = (ROOT, "mimo_orientation")  # the original's name of the root's joint, and the library's
# The original's files of scenes: built-in scenes, and the body that the original has in them.
FILES: Mapping[str, Tuple[str, str]] = {
    "benchmark_scene.xml": ("benchmark", "mitten"),
    "benchmarkv2_scene.xml": ("benchmark", "fingers"),
    "reach_scene.xml": ("reach", "mitten"),
    "standup_scene.xml": ("standup", "mitten"),
    "selfbody_scene.xml": ("selfbody", "mitten"),
    "catch_scene.xml": ("catch", "fingers"),
    "showroom.xml": ("showroom", "fingers"),
    "roll_over_scene.xml": ("rollover", "mitten"),
    "babybench_base.xml": ("babybench-base", "mitten"),
}
ASSETS = {"mimoEnv": ("mimoEnv", "assets"), "mimo_infant": ("mimo_infant", "simulation", "assets")}
CHEST, UPPER_BODY = "chest", "upper_body"  # the first is a body of its own since version 3, here part of the second
LARGE = 4_000_000  # pixels of a scene that take a noticeable time to read
TAKEN = {"proprioception", "vestibular", "vision", "touch", "actuation", "limit_threshold", "frame_skip"}


def split(options: Mapping[str, Any], name: str) -> Tuple[Dict[str, Any], Dict[str, Any]]:
    """Splits options into those of the infant and those of the simulation."""
    for option in options:
        if option in TAKEN:
            raise TypeError(f"{name} does not take {option!r}: use the original's arguments (touch_params, ...)")
    refuse_unknown(options, EnvOptions)
    infant = {key: value for key, value in options.items() if key in enums(AgentOptions)}
    return infant, {key: value for key, value in options.items() if key in enums(PhysicsOptions)}


def scene_directory(module: str) -> str:
    """The folder of scenes: of a checkout of the original on sys.path, else one whose names stand for ours."""
    below = ASSETS.get(module.partition(".")[0], ASSETS["mimoEnv"])
    for place in sys.path:
        folder = os.path.abspath(os.path.join(place or ".", *below))
        if os.path.isdir(folder):
            return folder
    return os.path.join(os.path.dirname(os.path.abspath(__file__)), "assets")


def sitting_position(name: str) -> Dict[str, Numbers]:
    """The posture in which the original's task of this name starts: angles by joint, rad."""
    scene = Scene(name if name in scenes() else "selfbody")
    scene.add_agents()
    pose = ET.fromstring(scene.xml).find("custom/tuple[@name='mimo:pose']")
    elements = [] if pose is None else pose.findall("element[@objtype='joint']")
    return {str(it.get("objname")): np.array([float(it.get("prm", 0))]) for it in elements}


def age_of(months: Optional[float], measures: Optional[Mapping[str, float]]) -> Dict[str, Any]:
    """Options of an infant's age."""
    if measures:
        raise NotImplementedError(
            f"custom_measurements is {dict(measures)!r}: measures of single parts are not there; use the options of "
            f"growth, {', '.join(enums(GrowthOptions))}"
        )
    return {} if months is None else {"age": months}


class Start(NamedTuple):
    """A scene with its infant, and positions of joints that it cannot hold, which worlds set after each reset."""

    scene: Scene
    late: Dict[str, Numbers]
    file: str  # the document whose pictures the scene lacks; "": it has them


def scene_of(
    model_path: Any,
    infant: Mapping[str, Any],
    senses: Senses,
    pose: Mapping[str, ArrayLike],
    parameters: Mapping[str, float],
) -> Scene:
    """A scene with its infant."""
    return start_of(model_path, infant, senses, pose, parameters).scene


def start_of(
    model_path: Any,
    infant: Mapping[str, Any],
    senses: Senses,
    pose: Mapping[str, ArrayLike],
    parameters: Mapping[str, float],
    drawn: bool = True,
) -> Start:
    """The same, and what its worlds begin with. Unless anything is `drawn`, pictures of files are left out."""
    scene, body = opened(model_path)
    plain = None if drawn or senses.cameras or not scene._start["file"] else without_pictures(scene)
    file, scene = ("", scene) if plain is None else (scene.source, plain)
    late = {joint: np.atleast_1d(np.asarray(value, np.float64)) for joint, value in pose.items()}
    root = _root_in(late) if body != "scene" else {}
    if body == "scene":
        scene.add_agents(**{**infant, "body": body})
    else:
        scene.add_agents(**{**({"body": body} if body else {}), **infant, **root})
    if senses.spacings is not None:
        scene.set_touch(None, 0.0)
        for name, metres in senses.spacings.items():
            if name != CHEST or _has_chest(scene):
                scene.set_touch(name, metres)
    for name, eye in senses.cameras.items():
        scene.add_camera(name, width=eye.width, height=eye.height, fovy=eye.fovy)
        if eye.acuity:
            scene.limit_sense(f"vision/{name}", blur=blur_of(eye.acuity))
    for joint in [joint for joint, value in late.items() if len(value) == 1 and joint not in JOINTS_OF_ROOT]:
        with suppress(ArgumentError):  # beyond the joint's range, where the original lets it start
            scene.set_pose(joint, float(late[joint][0]))
            del late[joint]
    for name, value in parameters.items():
        scene.parameters[name] = value
    return Start(scene, late, file)


def without_pictures(scene: Scene) -> Optional[Scene]:
    """The scene without its textures, None if the pictures in their files are small."""
    root = ET.fromstring(scene.xml)
    files = [path for it in root.iter("texture") for name, path in it.attrib.items() if name.startswith("file")]
    if sum(map(_pixels, files)) < LARGE:
        return None
    for assets in root.findall("asset"):
        for texture in assets.findall("texture"):
            assets.remove(texture)
    for material in root.iter("material"):
        material.attrib.pop("texture", None)
        for layer in material.findall("layer"):
            material.remove(layer)
    return Scene(xml=ET.tostring(root, encoding="unicode"))


def _pixels(file: str) -> int:
    """The size of a picture: of a PNG as its head tells it, of others by their bytes; 0 of the library's own."""
    if not os.path.isfile(file):
        return 0
    with open(file, "rb") as picture:
        head = picture.read(24)
    if head.startswith(b"\x89PNG"):
        return int.from_bytes(head[16:20], "big") * int.from_bytes(head[20:24], "big")
    return os.path.getsize(file)


def _root_in(pose: Dict[str, Numbers]) -> Dict[str, Any]:
    """Takes the root's pose out of a posture, as options of an infant."""
    options: Dict[str, Any] = {}
    for joint in JOINTS_OF_ROOT:
        if joint in pose:
            place = vector(f"initial_qpos[{joint!r}]", pose.pop(joint).tolist(), 7)
            options = {"position": list(place[:3]), "orientation": list(place[3:])}
    return options


def opened(model_path: Any) -> Tuple[Scene, str]:
    """The scene without its infant, and the infant's body: "" for the scene's default, "scene" for its own."""
    if isinstance(model_path, Scene):
        return model_path.copy(), _body_in(model_path)
    path = os.fspath(model_path)
    if path in scenes():
        return Scene(path), ""
    if os.path.exists(path):
        scene = Scene(file=path)
        return scene, _body_in(scene)
    name = os.path.basename(path)
    if name in FILES:
        return Scene(FILES[name][0]), FILES[name][1]
    raise FileNotFoundError(f"model_path is {path!r}, expected an MJCF file or one of {', '.join(scenes())}")


def _has_chest(scene: Scene) -> bool:
    return ET.fromstring(scene.xml).find(f".//body[@name='{CHEST}']") is not None


def _body_in(scene: Scene) -> str:
    return "scene" if f'name="{ROOT}"' in scene.xml else ""
