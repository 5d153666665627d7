#!/usr/bin/env python3
"""Writes guide/body.md, the names of the infant's parts, as the library reports them: python docs/make_body.py"""

from __future__ import annotations

import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path
from typing import Dict, List, Tuple

import numpy as np

import mimo

PAGE = Path(__file__).parent / "guide" / "body.md"
STEP = 0.05  # rad, for the sense of rotation
AXES = ("x", "y", "z")

Row = Tuple[str, ...]

INTRODUCTION = """# The body's names

The names of bodies, joints and motors for `mimo_env_find` and Python's `world.joints(...)`. A motor's name often
differs from the name of the joint that it moves. If an infant has a name, that name comes first:
`anna/robot:left_elbow`, `anna/act:left_elbow`.

The library writes this page: `python docs/make_body.py`.

**Ranges** are in degrees here; the library uses radians. The column **+** gives the axis about which the joint's body
turns when the angle grows: an axis of the world, by the right-hand rule, with all joints at 0. The infant then stands
upright, its arms hang down and it looks along x; y is to its left, z is up.

| + | the body's upper end | a hanging limb |
|---|---|---|
| +x, -x | leans to its right; to its left | swings to its left; to its right |
| +y, -y | bends forward; back | swings back; forward |
| +z, -z | turns to its left; to its right | the same |

So negative angles bend elbows and knees, and a negative `robot:right_hip1` lifts the right leg forward.
"""


def world_of(body: str) -> mimo.World:
    """An infant that stands upright and senses only its joints."""
    return mimo.World("free", body=body, vision=False, touch=False)


def motors_of(body: str) -> Dict[str, str]:
    """The motor of each joint that has one, by the scene's document."""
    scene = mimo.Scene("free")
    scene.add_agent(body=body)
    document = ElementTree.fromstring(scene.xml)
    return {str(motor.get("joint")): str(motor.get("name")) for motor in document.iterfind("actuator/*")}


def turned(world: mimo.World, joint: str, body: str) -> str:
    """The axis about which a joint turns its body for growing angles: "+x", "-z", ..."""
    part, hinge = world.bodies(body), world.joints(joint)
    hinge.position = 0
    before = part.orientation[0]
    hinge.position = STEP
    after = part.orientation[0]
    hinge.position = 0
    # The vector part of after * inverse(before).
    axis = after[1:] * before[0] - before[1:] * after[0] - np.cross(after[1:], before[1:])
    main = int(np.argmax(np.abs(axis)))
    return ("+" if axis[main] > 0 else "-") + AXES[main]


def joints_of(body: str) -> List[Row]:
    """Joint, body, range, sense and motor of every joint that proprioception reads."""
    world, motors = world_of(body), motors_of(body)
    world.reset(seed=0)
    names = world.layout.fields["proprioception/position"].labels
    joints, bodies = world.joints(*names), world.bodies().names
    joints.position = 0
    rows = []
    for name, number, limits in zip(names, joints.body_ids, np.degrees(joints.range)):
        part = bodies[number]
        low, high = (f"{limit:.4g}" for limit in limits)
        motor = f"`{motors[name]}`" if name in motors else "none"
        rows.append((f"`{name}`", f"`{part}`", f"{low} to {high}", turned(world, name, part), motor))
    return rows


def bodies_of(body: str) -> List[Row]:
    """Every body, its parent, and its mass."""
    world = world_of(body)
    bodies = world.bodies()
    names, masses = bodies.names, bodies.mass
    return [
        (f"`{name}`", f"`{names[parent]}`", f"{1000 * mass:.0f}")
        for name, parent, mass in list(zip(names, bodies.body_ids, masses))[1:]
    ]


def table(head: Row, rows: List[Row]) -> str:
    """A table of a page."""
    lines = ["| " + " | ".join(row) + " |" for row in (head, *rows)]
    lines.insert(1, "|" + "---|" * len(head))
    return "\n".join(lines) + "\n"


def page() -> str:
    """The whole page."""
    joints, bodies = joints_of("mitten"), bodies_of("mitten")
    more_joints = [row for row in joints_of("fingers") if row not in joints]
    more_bodies = [row for row in bodies_of("fingers") if row[0] not in {name for name, *_ in bodies}]
    joint_head, body_head = ("joint", "moves", "range, degrees", "+", "motor"), ("body", "parent", "mass, g")
    return "\n".join(
        [
            INTRODUCTION,
            "## Joints and motors",
            "",
            table(joint_head, joints),
            "The upper trunk's joints have no motors: tendons make them follow the lower trunk's joints.",
            "",
            "## Bodies",
            "",
            table(body_head, bodies),
            "## Five fingers",
            "",
            '`body = "fingers"` has these parts in place of the mittens, and big toes. The other joints are the same; the',  # noqa: E501
            "other bodies weigh a little more, hands and feet less.",
            "",
            table(joint_head, more_joints),
            table(body_head, more_bodies),
            "## Left and right",
            "",
            "The left side is the mirror image of the right one, except for one thing in each body, as in the",
            "original: the mitten's left hand lies 14 mm off the mirror image, and the first bone of the left little",
            "finger (`robot:left_lf_meta`) turns about another axis. `mitten-mirrored` and `fingers-mirrored` are the",
            "same bodies without these differences ([differences](../differences.md)).",
            "",
        ]
    )


if __name__ == "__main__":
    sys.stdout.write(page()) if "--print" in sys.argv else PAGE.write_text(page())
