"""Poses of bodies, followed by `mimo replay --motion`: from forward kinematics they lead back to its joints."""

import csv
import json
import subprocess

import numpy as np
from recorded import program

import mimo
from mimo.constants import Kind, Quantity

PARTS = ("x", "y", "z", "qw", "qx", "qy", "qz")


def infant():
    scene = mimo.Scene("free")
    scene.add_agent(vision=False, touch=False)
    world = mimo.World(scene)
    world.reset(seed=0)
    return world


def swing(world, rows, seed):
    """From the start to an end within the limits of each hinge."""
    hinges = [world.name(Kind.JOINT, i) for i in range(1, world.count(Kind.JOINT))]
    limits = world.get(Quantity.JOINT_RANGE, hinges)
    start = world.get(Quantity.JOINT_POSITION, hinges).ravel()
    end = np.random.default_rng(seed).uniform(limits[:, 0], limits[:, 1])
    share = np.linspace(0, 1, rows)[:, None]
    return hinges, (1 - share) * start + share * end


def write_poses(path, world, hinges, angles, columns):
    bodies = [world.name(Kind.BODY, i) for i in range(2, world.count(Kind.BODY))]
    with path.open("w") as file:
        file.write("time," + ",".join(f"{body}:{PARTS[i]}" for body in bodies for i in columns) + "\n")
        for row, positions in enumerate(angles):
            world.set(Quantity.JOINT_POSITION, positions, hinges)
            poses = world.get(Quantity.BODY_POSE, bodies, now=True)[:, columns]
            file.write(f"{0.02 * row}," + ",".join(repr(float(number)) for number in poses.ravel()) + "\n")


def follow(path, folder):
    command = [program(), "replay", "--motion", str(path), "--scene", "free", "--touch", "off", "--json"]
    done = subprocess.run(
        [*command, "--joints", str(folder / "joints.csv")], capture_output=True, text=True, check=True
    )
    with (folder / "joints.csv").open() as file:
        return json.loads(done.stdout), list(csv.DictReader(file))


def check(tmp_path, columns, seed, tolerance):
    with infant() as world:
        hinges, angles = swing(world, 30, seed)
        write_poses(tmp_path / "poses.csv", world, hinges, angles, columns)
    report, rows = follow(tmp_path / "poses.csv", tmp_path)
    found = np.array([[float(row[hinge]) for hinge in hinges] for row in rows])
    assert np.abs(found - angles).max() < tolerance
    worst = max(max(error.values()) for error in report["pose_errors"].values())
    assert worst < tolerance
    assert report["beyond_limits"] == []


def test_joints_come_back_from_orientations(tmp_path):
    for seed in range(3):
        check(tmp_path, [3, 4, 5, 6], seed, 1e-9)


def test_joints_come_back_from_whole_poses(tmp_path):
    check(tmp_path, list(range(7)), 5, 1e-9)
