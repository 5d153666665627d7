"""The three scenes, with an infant whose motors are those of a configuration."""

from __future__ import annotations

import xml.etree.ElementTree as ElementTree
from pathlib import Path
from typing import Any, Dict, List, Mapping, NamedTuple, Tuple

from ..scene import Scene
from .config import on
from .groups import group_of, in_order

FOLDER = Path(__file__).parent / "scenes"
ON_ITS_BACK = (0.7071067811865476, 0.0, -0.7071067811865475, 0.0)  # head towards -x

# The posture of cubes: it sits with bent legs. Radians.
SITTING: Dict[str, float] = {
    **{"hip_bend1": 0.532, "hip_bend2": 0.532, "hip_lean1": 0, "hip_lean2": 0, "hip_rot1": 0, "hip_rot2": 0},
    **{"head_tilt": 0.4, "head_tilt_side": 0},
    **{"right_hip1": -1.22, "right_hip2": -0.7, "right_hip3": 0.538, "right_knee": -1.45},
    **{"left_hip1": -1.41, "left_hip2": -0.823, "left_hip3": 0.612, "left_knee": -2.14},
}


class Start(NamedTuple):
    """Where the infant's root is, what is fastened to the world, and what is held where."""

    position: Tuple[float, float, float]
    orientation: Tuple[float, float, float, float]
    welded: str = ""
    locks: Mapping[str, float] = {}


STARTS: Mapping[str, Start] = {
    "base": Start((0, 0, 0.1), ON_ITS_BACK),
    "crib": Start((0, 0, 0.3), ON_ITS_BACK, welded="lower_body"),
    "cubes": Start(
        (0, 0, 0.0467196), (0.885453, -0.000184209, -0.464728, -0.000527509), welded="mimo_location", locks=SITTING
    ),
}


def body_of(config: Mapping[str, Any]) -> str:
    """Hand regard has five fingers, all else mittens."""
    return "fingers" if config["behavior"] == "hand_regard" else "mitten"


def room_of(config: Mapping[str, Any]) -> Scene:
    """The scene with its infant, which no agent senses with yet."""
    start = STARTS[config["scene"]]
    plan = Scene(file=FOLDER / f"{config['scene']}.xml", max_file_bytes=2**20)
    place: Dict[str, Any] = {"position": list(start.position), "orientation": list(start.orientation)}
    plan.add_agent(body=body_of(config), **place)
    scene = Scene(xml=_arranged(plan.xml, on(config, "act")))
    held = {f"robot:{name}": angle for name, angle in start.locks.items()}
    locked = on(config, "lock")
    joints = [joint for joint in _joints(plan.xml) if group_of(joint) in locked]
    for joint, angle in {**dict.fromkeys(joints, 0.0), **held}.items():
        scene.lock(joint, angle)
    if start.welded:
        scene.weld(start.welded)
    return scene


def _joints(document: str) -> List[str]:
    names = (joint.get("name", "") for joint in ElementTree.fromstring(document).iter("joint"))
    return list(dict.fromkeys(name for name in names if name.startswith("robot:")))


def _arranged(document: str, acting: List[str]) -> str:
    """The document with motors of some groups only, in the order of groups, and the infant before all other bodies.

    So numbers of geoms and positions of joints are the same in all scenes, and those of the competition; so is the name
    of the root's joint.
    """
    root = ElementTree.fromstring(document)
    motors: Dict[str, ElementTree.Element] = {}
    for section in root.findall("actuator"):
        motors.update((motor.get("name", ""), motor) for motor in section)
        root.remove(section)
    section = ElementTree.SubElement(root, "actuator")
    section.extend(motors[name] for name in in_order(motors) if group_of(name) in acting)
    for joint in root.iter("freejoint"):
        if joint.get("name") == "mimo_orientation":
            joint.set("name", "mimo_location")
    for world in root.findall("worldbody"):
        if world.find("body[@name='mimo_location']") is None:
            root.remove(world)
            root.append(world)
    return ElementTree.tostring(root, encoding="unicode")
