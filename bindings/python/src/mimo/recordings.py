"""Recordings, the HDF5 files of `mimo record`: what is in them, and worlds that play them again. Needs h5py."""

from __future__ import annotations

import json
import os
from typing import Any, Dict, List, Union

import numpy as np
from numpy.typing import NDArray

from .constants import Actuation, GrowthModel, Kind, Render, Sex
from .errors import NotFoundError, UnsupportedError
from .scene import Scene, scenes
from .world import World

FORMAT, VERSION = "mimo recording", 2
NUMBERS = ("age", "physiological-age", "percentile", "z-length", "z-weight", "z-head")
ACTUATIONS = ("torque", "position", "muscle", "mujoco-muscle")  # in the order of their constants
EYES = 128  # pixels to each side


class Recording:
    """A recording that is read; `file` is h5py's."""

    def __init__(self, path: "Union[str, os.PathLike[str]]") -> None:
        self.path = os.fspath(path)
        self.file = _opened(self.path)
        try:
            self._check()
            self.step_seconds = float(self.file.attrs["step_seconds"])
            self.steps = min(len(self.file[name]) for name in ("time", "joints/position", "joints/velocity"))
            if "actions" in self.file:
                self.steps = min(self.steps, len(self.file["actions"]))
            self._states: NDArray[np.int64] = self.file["states/step"][: len(self.file["states/state"])]
            self._given = np.zeros(len(self._states), bool)  # states by which something else than a step changed it
            if "states/given" in self.file:  # since version 2
                given = self.file["states/given"][: len(self._states)] != 0
                self._given[: len(given)] = given
        except (KeyError, OSError) as error:
            self.file.close()
            raise ValueError(f"{self.path} is not a whole recording: {error}") from None
        except BaseException:
            self.file.close()
            raise

    def _check(self) -> None:
        if "format" not in self.file.attrs or self.text("format") != FORMAT:
            raise ValueError(f"{self.path} is an HDF5 file, but not a recording")
        version = int(self.file.attrs["format_version"])
        if version > VERSION:
            raise UnsupportedError(f"{self.path} has format version {version}, and this package reads up to {VERSION}")

    def text(self, name: str) -> str:
        """A text among the attributes."""
        value = self.file.attrs[name]
        return value.decode() if isinstance(value, bytes) else str(value)

    def names(self, table: str) -> List[str]:
        """What the columns of a dataset are."""
        value = self.file[table].attrs.get("names", b"")
        return (value.decode() if isinstance(value, bytes) else str(value)).split("\n")

    def world(self, eyes: int = EYES) -> World:
        """The recorded world, made anew with touch, ears where it had them, and eyes of so many pixels; 0: none."""
        try:
            world = _world_of(json.loads(self.text("configuration")), eyes)
        except (ValueError, TypeError, KeyError) as error:
            raise ValueError(f"{self.path} has a configuration that cannot be made anew: {error}") from None
        if _joints(world) != self.text("joint_names").split("\n")[: world.count(Kind.JOINT)]:
            world.close()
            raise ValueError(f"{self.path} was recorded with other joints than its scene has now")
        return world

    def start(self, world: World, step: int) -> int:
        """Loads the last kept state that is not behind a step; returns the step of that state."""
        before = np.flatnonzero(self._states <= step)
        if len(before) == 0:
            raise ValueError(f"{self.path} has no state to start from: it was cut off before its first flush")
        world.reset(0)  # senses of other sizes begin fresh
        return self._load(world, int(before[-1]))

    def _load(self, world: World, number: int) -> int:
        if "bodies/growth" in self.file and len(self.file["bodies/growth"]) > 1:
            raise UnsupportedError(f"infants grow in {self.path}: mimo.Replay plays it in a world of your own")
        world.load(self.file["states/state"][number].tobytes())
        return int(self._states[number])

    def step(self, world: World, step: int, senses: bool = True) -> None:
        """Makes a recorded step in a world that has come as far."""
        given = np.flatnonzero((self._states == step) & self._given)
        if len(given) > 0 and step > 0:
            self._load(world, int(given[-1]))
        action = self.file["actions"][step] if "actions" in self.file else None
        if action is not None and np.isnan(action).all():  # motors stayed as they were
            action = None
        world.step_into(world.block if senses else None, action)

    def seek(self, world: World, step: int) -> None:
        """Brings a world to where it was after so many steps."""
        if not 0 <= step <= self.steps:
            raise ValueError(f"step is {step}, expected 0 to {self.steps}, where {self.path} ends")
        at = self.start(world, step)
        for passed in range(at, step):
            self.step(world, passed, senses=False)
        world.observe()

    def close(self) -> None:
        """Closes the file."""
        self.file.close()

    def __enter__(self) -> "Recording":
        return self

    def __exit__(self, *error: Any) -> None:
        self.close()


def _opened(path: str) -> Any:
    try:
        import h5py
    except ImportError:
        raise UnsupportedError("recordings need h5py: pip install h5py") from None
    if not os.path.exists(path):
        raise NotFoundError(f"there is no file {path}")
    try:
        return h5py.File(path, "r")
    except OSError:
        pass
    try:
        return h5py.File(path, "r", swmr=True)  # of a run that goes on, or that was killed
    except (OSError, ValueError):
        raise ValueError(f"{path} is not a recording, or was cut off: HDF5 cannot open it") from None


def _joints(world: World) -> List[str]:
    return [world.name(Kind.JOINT, number) for number in range(world.count(Kind.JOINT))]


# ---- The options of `mimo record`, as the package has them -----------------------------------------------------------


def _world_of(given: Dict[str, List[str]], eyes: int) -> World:
    """The world that `mimo record` makes of its options; its eyes, which change nothing, are the viewer's."""
    options = {name: values[0] for name, values in given.items()}
    name = options.get("scene", "benchmark")
    scene = Scene(name) if name in scenes() else Scene(file=name)
    agent = {**_senses(options, eyes), **_growth(options)}
    agent.update(_body(scene, name, options))
    if "actuation" in options:
        agent["actuation"] = Actuation(ACTUATIONS.index(options["actuation"]))
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
    if "sex" in options:
        chosen["sex"] = Sex[options["sex"].upper()]
    if "growth" in options:
        chosen["growth"] = GrowthModel[options["growth"].upper()]
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
        words = [] if options["effects"] == "none" else options["effects"].split(",")
        chosen["render"] = Render(sum(Render[word.upper()] for word in words))
    return chosen
