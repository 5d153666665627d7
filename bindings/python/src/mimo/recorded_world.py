"""Writes the configuration of recordings, and makes worlds from it.

A configuration is JSON: the options of `mimo record`, or under "python" the calls that made a scene and the options of
its world.
"""

from __future__ import annotations

import json
import os
from typing import Any, Dict, List, Optional

import numpy as np

from .constants import Kind
from .scene import Scene, scenes
from .world import World

NUMBERS = ("age", "physiological-age", "percentile", "z-length", "z-weight", "z-head")
LARGEST = 4096  # most numbers of an array in a configuration


def recorded_world(path: str, configuration: str, eyes: int, scene: Optional[str]) -> World:
    """The world of a recording, with touch, its ears, and eyes of `eyes` x `eyes` pixels."""
    try:
        given = json.loads(configuration) if configuration else {}
        if not isinstance(given, dict):
            raise ValueError("it is not an object")
        if "python" in given:
            return _of_calls(given["python"], eyes)
        if scene is not None:
            given = {**given, "scene": [scene]}
        if not given and not configuration:
            raise ValueError("it is empty; name the scene, or make a world and pass it to Recording.play")
        return _of_options(given, eyes)
    except RecursionError:
        raise ValueError(f"{path} has a configuration that cannot be made anew: it is nested too deeply") from None
    except (ValueError, TypeError, KeyError, AttributeError) as error:
        raise ValueError(f"{path} has a configuration that cannot be made anew: {error}") from None


def configuration_of(world: World) -> str:
    """How a world was made, as JSON; "" if it cannot be written, as with custom tasks."""
    scene = world._scene
    try:
        return json.dumps(
            {"python": {"scene": scene._start, "calls": scene._steps, "options": world._options}}, default=_plain
        )
    except TypeError:
        return ""


def inner_world(world: Any) -> World:
    """The world itself, or the world of an environment."""
    inner = world if isinstance(world, World) else getattr(getattr(world, "unwrapped", world), "world", None)
    if not isinstance(inner, World):
        raise TypeError(f"world is {world!r}, expected a mimo.World or an environment")
    return inner


# ---- Calls of a Python program ---------------------------------------------------------------------------------------


def _plain(value: Any) -> Any:
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if isinstance(value, (np.ndarray, np.generic)) and value.size <= LARGEST:
        return value.tolist()
    raise TypeError(f"{value!r} cannot be part of a configuration")


def _of_calls(given: Dict[str, Any], eyes: int) -> World:
    scene = Scene(**given["scene"])
    for method, arguments, options in given["calls"]:
        if method in ("add_agent", "add_agents") and options.get("body") != "scene":
            options = {**options, "vision": eyes > 0, "touch": options.get("touch") or True}
            if eyes > 0:
                options.update(vision_width=eyes, vision_height=eyes)
        scene.make_call(method, arguments, options)
    return World(scene, **given["options"])


# ---- Options of `mimo record` ----------------------------------------------------------------------------------------


def _of_options(given: Dict[str, List[str]], eyes: int) -> World:
    """The world that `mimo record` makes of its options, but with the viewer's eyes, which do not affect it."""
    options = {name: values[0] for name, values in given.items()}
    name = options.get("scene", "benchmark")
    scene = Scene(name) if name in scenes() else Scene(file=name)
    agent = {**_senses(options, eyes), **_growth(options)}
    agent.update(_body(scene, name, options))
    if "actuation" in options:
        agent["actuation"] = options["actuation"].replace("-", "_")
    if options.get("reflexes", "none") != "none":
        agent["reflexes"] = options["reflexes"].split(",")
    if "face" in options:
        agent["face"] = options["face"]
    scene.add_agents(**agent)
    return World(scene, **_renderer(options))


def _senses(options: Dict[str, str], eyes: int) -> Dict[str, Any]:
    touch = options.get("touch", "1")
    chosen: Dict[str, Any] = {"vision": eyes > 0, "touch": touch != "off"}
    if eyes > 0:
        chosen.update(vision_width=eyes, vision_height=eyes)
    if touch != "off":
        chosen["touch_scale"] = float(touch)
    if options.get("senses", "usual") != "usual":
        chosen["senses"] = [options["senses"]]
    if "foveation" in options and eyes > 0:
        chosen["vision_foveation"] = float(options["foveation"])
    return chosen


def _growth(options: Dict[str, str]) -> Dict[str, Any]:
    chosen: Dict[str, Any] = {name.replace("-", "_"): float(options[name]) for name in NUMBERS if name in options}
    chosen.update({name: options[name] for name in ("sex", "growth") if name in options})
    if "age" in chosen or "physiological_age" in chosen:
        usual = (("eyes", "perfect"), ("delays", "none"))
        chosen["maturity"] = ["body"] + [part for part, off in usual if options.get(part, "age") != off]
    return chosen


def _body(scene: Scene, name: str, options: Dict[str, str]) -> Dict[str, Any]:
    if "body" in options:
        return {"body": options["body"]}
    if name in scenes():
        return {}
    with World(scene, renderer="none") as bare:
        if any(body.endswith("mimo_location") for body in bare.bodies().names):
            return {"body": "scene"}
        eyes = {} if bare.count(Kind.CAMERA) > 0 else {"vision": False}
    return {"body": "scene", "root": "world", "vestibular": False, **eyes}


def _renderer(options: Dict[str, str]) -> Dict[str, Any]:
    chosen: Dict[str, Any] = {name: options[name] for name in ("renderer",) if name in options}
    for name in ("samples", "render-threads"):
        if name in options:
            chosen[name.replace("-", "_")] = int(options[name])
    if "effects" in options:
        chosen["render"] = [] if options["effects"] == "none" else options["effects"].split(",")
    return chosen
