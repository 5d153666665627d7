"""The library's scenes, with the motors and locks of a configuration."""

from __future__ import annotations

import xml.etree.ElementTree as ElementTree
from typing import Any, Dict, List, Mapping, Set

from ..constants import Act
from ..scene import Scene
from .config import on
from .counts import COUNTS
from .groups import group_of, in_order

SWITCHED = ("feet", "eyes")  # groups that the library's scenes lock for a behaviour; other locks are for posture


def body_of(config: Mapping[str, Any]) -> str:
    """Hand regard uses five fingers, the others use mittens."""
    return "fingers" if config["behavior"] == "hand_regard" else "mitten"


def room_of(config: Mapping[str, Any]) -> Scene:
    """The scene with its infant, before an agent is added."""
    plan = Scene(f"babybench-{config['scene']}")
    plan.add_agent(body=body_of(config), acts=Act.ALL)
    root = ElementTree.fromstring(plan.xml)
    _arrange_motors(root, on(config, "act"))
    held = _posture(root)
    for text in root.findall("custom/text[@name='mimo:task']"):
        text.set("data", COUNTS[config["behavior"]].task)
    scene = Scene(xml=ElementTree.tostring(root, encoding="unicode"))
    locked = on(config, "lock")
    for joint in _joints(root):
        if group_of(joint) in locked and joint not in held:
            scene.lock(joint, 0.0)
    return scene


def _joints(root: ElementTree.Element) -> List[str]:
    names = (joint.get("name", "") for world in root.findall("worldbody") for joint in world.iter("joint"))
    return [name for name in names if name.startswith("robot:")]


def _posture(root: ElementTree.Element) -> Set[str]:
    """The joints that the scene locks, without those that the configuration decides."""
    active = [lock for lock in root.findall("equality/joint") if lock.get("active") == "true"]
    for lock in active:
        if group_of(lock.get("joint1", "")) in SWITCHED:
            lock.set("active", "false")
    return {lock.get("joint1", "") for lock in active if lock.get("active") == "true"}


def _arrange_motors(root: ElementTree.Element, acting: List[str]) -> None:
    """Motors of some groups, in the order of groups, as in the competition's actions."""
    motors: Dict[str, ElementTree.Element] = {}
    for section in root.findall("actuator"):
        motors.update((motor.get("name", ""), motor) for motor in section)
        root.remove(section)
    section = ElementTree.SubElement(root, "actuator")
    section.extend(motors[name] for name in in_order(motors) if group_of(name) in acting)
