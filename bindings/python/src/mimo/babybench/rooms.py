"""The library's scenes, with the motors and locks of a configuration."""

from __future__ import annotations

import xml.etree.ElementTree as ElementTree
from typing import Any, List, Mapping, Optional, Set

from ..constants import Act
from ..scene import Scene
from .config import is_described, on
from .counts import kind_of
from .described import Described, motors_in
from .groups import group_of, in_order

SWITCHED = ("feet", "eyes")  # groups that the library's scenes lock for a behaviour; other locks are for posture


def body_of(config: Mapping[str, Any]) -> str:
    """Hand regard uses five fingers, self-touch mittens, a behaviour's scene the body for which it is made."""
    if is_described(config):
        return Described(config["behavior"]).body
    return "fingers" if config["behavior"] == "hand_regard" else "mitten"


def room_of(config: Mapping[str, Any]) -> Scene:
    """The scene with its infant, before an agent is added."""
    if is_described(config):
        return _own_room(config)
    plan = Scene(f"babybench-{config['scene']}")
    plan.add_agent(body=body_of(config), acts=Act.ALL)
    root = ElementTree.fromstring(plan.xml)
    _arrange_motors(root, on(config, "act"))
    held = _posture(root)
    for text in root.findall("custom/text[@name='mimo:task']"):
        text.set("data", kind_of(config).task)
    return _locked(root, config, held)


def _own_room(config: Mapping[str, Any]) -> Scene:
    """The scene of a behaviour that its document describes, with BabyBench's cameras."""
    described = Described(config["behavior"])
    root = described.root
    _arrange_motors(root, on(config, "act"), described)
    held = {lock.get("joint1", "") for lock in root.findall("equality/joint") if lock.get("active") == "true"}
    world = ElementTree.SubElement(root, "worldbody")
    there = {camera.get("name") for camera in root.iter("camera")}
    base = Scene("babybench-base")
    base.add_agent()
    cameras = ElementTree.fromstring(base.xml).findall("worldbody/camera")
    world.extend(camera for camera in cameras if camera.get("name") not in there)
    return _locked(root, config, held, described.folder)


def _locked(root: ElementTree.Element, config: Mapping[str, Any], held: Set[str], folder: Any = None) -> Scene:
    """A document's scene, with the locks of a configuration on joints that nothing else holds."""
    scene = Scene(xml=ElementTree.tostring(root, encoding="unicode"), model_dir=folder)
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


def _arrange_motors(root: ElementTree.Element, acting: List[str], described: Optional[Described] = None) -> None:
    """Motors of some groups, in the order of groups, as in the competition's actions."""
    motors = {motor.get("name", ""): motor for motor in motors_in(root)}
    for section in root.findall("actuator"):
        root.remove(section)
    section = ElementTree.SubElement(root, "actuator")
    names = [name for name in in_order(motors) if group_of(name) in acting]
    section.extend(motors[name] for name in names if described is None or described.acts(name))
