"""Worlds of recordings, made anew of the files."""

from __future__ import annotations

import ctypes
from typing import Any, Dict, List, NoReturn, Optional, cast

from . import _abi
from ._handle import Handle, Native
from ._library import LIB, check, defaults
from .constants import AS_RECORDED, Touch, Vision
from .option_types import SENSES
from .scene import Scene, scenes
from .world import World


class RecordedScene:
    """What a world of a recording has in place of its Scene."""

    def __init__(self, path: str) -> None:
        self.source = path
        self._growths: List[Any] = []
        self._task = None
        self._own_senses: List[Any] = []

    def __reduce__(self) -> NoReturn:
        raise TypeError(f"worlds of recordings cannot be pickled: open {self.source} where they are needed")


def recorded_world(recording: Handle, path: str, eyes: int) -> World:
    """The world of a recording, with touch, and eyes of so many pixels; 0: without eyes."""
    senses = defaults(_abi.AgentConfig)
    for sense in SENSES:
        setattr(senses, sense, AS_RECORDED)
    senses.vision = Vision.RGB if eyes > 0 else 0
    if eyes > 0:
        senses.vision_width = senses.vision_height = eyes
    world = _made(recording, path, senses)
    if not world.agents or any("touch/" in name for name in world.layout.fields):
        return world
    world.close()
    senses.touch = Touch.FORCE
    return _made(recording, path, senses)


def world_as_recorded(recording: Handle, path: str) -> World:
    """The world of a recording with exactly the senses that it had."""
    return _made(recording, path, None)


def world_without_senses(recording: Handle, path: str) -> World:
    """The world of a recording, for what moves in it."""
    senses = defaults(_abi.AgentConfig)
    for sense in SENSES:
        setattr(senses, sense, 0)
    return _made(recording, path, senses)


def _made(recording: Handle, path: str, senses: Optional[_abi.AgentConfig]) -> World:
    # No variable here may hold the native handle: an error keeps these frames, and the file would stay open.
    made = ctypes.c_void_p()
    check(LIB.mimo_recording_env(recording._handle, None, senses, made))
    world = World.__new__(World)
    world._begin(Native(made.value, LIB.mimo_env_destroy), cast(Scene, RecordedScene(path)), {})
    return world


def world_of_scene(scene: str, eyes: int) -> World:
    """For recordings that hold no world: a scene with its infants, with touch, and eyes of so many pixels."""
    made = Scene(scene) if scene in scenes() else Scene(file=scene)
    pixels: Dict[str, Any] = {"vision_width": eyes, "vision_height": eyes} if eyes > 0 else {}
    made.add_agents(vision=eyes > 0, touch=True, **pixels)
    return World(made)


def inner_world(world: Any) -> World:
    """The world itself, or the world of an environment."""
    inner = world if isinstance(world, World) else getattr(getattr(world, "unwrapped", world), "world", None)
    if not isinstance(inner, World):
        raise TypeError(f"world is {world!r}, expected a mimo.World or an environment")
    return inner
