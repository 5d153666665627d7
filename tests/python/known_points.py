"""A known movement of an infant, and where its key points are: forward kinematics is the physics engine's."""

import numpy as np

import mimo
from mimo.constants import Kind, Quantity

JOINTS = ("shoulder", "elbow", "wrist", "hip", "knee", "ankle")
NAMES = [f"{side}_{joint}" for side in ("left", "right") for joint in JOINTS] + ["nose", "left_ear", "right_ear", "hip"]
BODIES = {"shoulder": "upper_arm", "elbow": "lower_arm", "wrist": "hand", "hip": "upper_leg"}
BODIES.update(knee="lower_leg", ankle="foot")
TOLD = ["robot:left_elbow", "robot:right_elbow", "robot:left_knee", "robot:right_knee"]  # by three points each


def infant(age=18):
    scene = mimo.Scene("free")
    scene.add_agent(vision=False, touch=False, age=age)
    world = mimo.World(scene)
    world.reset(seed=0)
    return world


def place(world, name):
    """Worked out here from the poses of bodies: joints at their origins, nose and ears on the sphere of the head."""
    side, _, joint = name.partition("_")
    if name in ("nose", "left_ear", "right_ear"):
        axis = {"nose": (1, 0, -0.15), "left_ear": (0, 1, 0), "right_ear": (0, -1, 0)}[name]
        w, x, y, z = world.get(Quantity.GEOM_ORIENTATION, ["head"], now=False)[0]
        head = np.array(
            [
                [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
            ]
        )
        return (
            world.get(Quantity.GEOM_POSITION, ["head"])[0]
            + head @ np.array(axis) * world.get(Quantity.GEOM_SIZE, ["head"])[0, 0]
        )
    if joint not in BODIES:
        return world.get(Quantity.BODY_POSITION, [name])[0]
    # Where the next part begins when it is straight: its own turns do not move that point of the part before.
    body = f"{side}_{BODIES[joint]}"
    hinges = np.flatnonzero(world.joints().body_ids == world.find(Kind.BODY, body)).tolist()
    before = world.get(Quantity.JOINT_POSITION, hinges).ravel()
    world.set(Quantity.JOINT_POSITION, 0 * before, hinges)
    straight = world.get(Quantity.BODY_POSITION, [body], now=True)[0]
    world.set(Quantity.JOINT_POSITION, before, hinges)
    return straight


def movement(world, rows=12, names=None):
    """Arms, legs and head move, and the whole body rises and turns. Angles of TOLD and the places of all points."""
    amounts = {
        "left_elbow": -1.2,
        "right_elbow": -0.6,
        "left_knee": -1.4,
        "right_knee": -0.5,
        "left_shoulder_ad_ab": 0.5,
    }
    amounts.update({"right_shoulder_horizontal": 0.4, "left_hip1": -0.9, "right_hip1": -0.4, "head_swivel": 0.5})
    hinges = [f"robot:{name}" for name in amounts]
    start = world.get(Quantity.JOINT_POSITION, hinges).ravel()
    limits = world.get(Quantity.JOINT_RANGE, hinges)
    angles, points = [], []
    for share in np.linspace(0.2, 1, rows):
        wanted = np.clip(start + share * np.array(list(amounts.values())), limits[:, 0] + 0.05, limits[:, 1] - 0.05)
        world.set(Quantity.JOINT_POSITION, wanted, hinges)
        turn = 2.5 + 0.3 * share
        root = [0.2, 0.1, 0.5 + 0.05 * share, np.cos(turn / 2), 0, 0, np.sin(turn / 2)]
        world.set(Quantity.JOINT_POSITION, root, ["mimo_orientation"])
        world.update()
        angles.append(world.get(Quantity.JOINT_POSITION, TOLD).ravel())
        points.append([place(world, name) for name in names or NAMES])
    return np.array(angles), np.array(points)
