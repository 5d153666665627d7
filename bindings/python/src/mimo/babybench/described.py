"""Behaviours that a scene's document describes (docs/guide/behaviours.md), in BabyBench's form.

Each has a scene of its own. What a configuration does not say is as in that scene: who acts, for how long, how often.
"""

from __future__ import annotations

import os
import xml.etree.ElementTree as ElementTree
from typing import Any, Dict, List, Optional

from ..arguments import meant
from ..behaviour import Behaviour
from ..constants import Act
from ..errors import Error, NotFoundError
from ..scene import FILES, Scene, scenes
from ..world import World
from .groups import flags, group_of

COUNTED = ("none", "self_touch", "hand_regard")  # the competition's own, which the library's tasks count


class Described:
    """A behaviour by the name of its built-in scene or by its MJCF file; ValueError for what describes none."""

    def __init__(self, behavior: Any) -> None:
        self.name = str(behavior)
        self.folder = os.path.dirname(os.path.abspath(self.name)) if self.name.endswith(FILES) else None
        try:
            plan, whole = _scene(behavior), _scene(behavior)
            if not _tells(plan):
                raise ValueError(f"behavior is {self.name!r}, whose scene describes no behaviour")
            self.behaviour: Behaviour = plan.behaviour()
            plan.add_agent(touch=False, vision=False)
            whole.add_agent(acts=Act.ALL)
            with World(plan) as world:
                self.motors = list(world.action_names)
                self.frame_skip, self.timestep = world.frame_skip, world.timestep
        except (Error, OSError) as error:
            raise ValueError(f"behavior is {self.name!r}, which is refused: {error}") from None
        self.root = ElementTree.fromstring(whole.xml)  # of the scene with its infant, all of whose motors act
        self.moved = {group_of(motor) for motor in self.motors}

    @property
    def body(self) -> str:
        """The body for which the scene is made."""
        return "fingers" if self.root.find(".//body[@name='right_fingers']") is None else "mitten"

    def acts(self, motor: str) -> bool:
        """Whether a motor acts where its group does: as in the scene, or all of a group that rests there."""
        return motor in self.motors or group_of(motor) not in self.moved

    def standard(self, frame_skip: Optional[int] = None) -> Dict[str, Any]:
        """Values of a configuration's keys as the scene has them, in steps of so many physics steps, or its own."""
        frames = frame_skip or self.frame_skip
        return {
            "scene": self.name,
            "frame_skip": frames,
            "max_episode_steps": max(1, round(self.behaviour.episode_seconds / (frames * self.timestep))),
            **{name: group in self.moved for name, group in flags("act").items()},
            **dict.fromkeys(flags("lock"), False),
        }


def described_in_scenes() -> List[str]:
    """Built-in scenes that describe a behaviour."""
    return [name for name in scenes() if _tells(Scene(name))]


def motors_in(root: ElementTree.Element) -> List[ElementTree.Element]:
    """The motors of a document."""
    return [motor for section in root.findall("actuator") for motor in section]


def _scene(behavior: Any) -> Scene:
    if isinstance(behavior, str) and behavior in scenes():
        return Scene(behavior)
    if isinstance(behavior, (str, os.PathLike)) and os.fspath(behavior).endswith(FILES):
        return Scene(file=behavior)
    known = [*COUNTED, *described_in_scenes()]
    near = meant(str(behavior), known)
    raise ValueError(f"behavior is {behavior!r}, expected {', '.join(map(repr, known))}, or an MJCF file{near}")


def _tells(scene: Scene) -> bool:
    try:
        scene.behaviour()
    except NotFoundError:
        return False
    return True
