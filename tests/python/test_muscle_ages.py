"""Muscles of infants who cannot stretch their joints yet: levers, strength and spindles.

A muscle's lever is 0.3 of its best length over the range of its joint (the original MIMo's rule). Hips lack 50 of 153
degrees at birth, knees 25 of 149, elbows 24 of 151; none of that makes muscles pull with a longer lever: whatever the
age, a muscle turns its joint with the same share of what the joint's motor can (within 5 %), and a radian stretches it
by as much.
"""

import numpy as np
import pytest

import mimo

AGES = (0, 1, 3, 6, 9, 24)
MUSCLES = {
    "left_elbow": "left_elbow",
    "right_knee": "right_knee",
    "left_hip1": "left_hip_flex",
    "right_foot1": "right_foot_flexion",
}


def world_of(age, **options):
    world = mimo.World("free", vision=False, touch=False, vestibular=False, frame_skip=1, age=age, **options)
    world.gravity = [0, 0, 0]
    world.reset(0)
    return world


def middle(world, joint):
    return np.mean(world.get("joint_range", f"robot:{joint}")[0])


def hold(world, joint, angle, action=None):
    joints = world.joints(f"robot:{joint}")
    joints.position = angle
    joints.velocity = 0
    world.step_into(None, action)


def strengths(age, kind):
    """What each muscle turns its joint with in the middle of its range, over what the motor can: its gear."""
    shares = {}
    with world_of(age, actuation=kind) as world:
        for joint, motor in MUSCLES.items():
            for side in ("negative", "positive"):
                action = np.zeros(len(world.action_names), np.float32)
                action[world.action_names.index(f"act:{motor}/{side}")] = 1
                world.reset(0)
                for _ in range(20):
                    hold(world, joint, middle(world, joint), action)
                shares[joint, side] = abs(world.actuators(f"act:{motor}").control[0])
    return shares


# At 18 months: lengths of 0.9 there, where the original's muscles pull with 0.92 + 0.15 x 0.0988 of their peak force,
# so that a hip's flexor pulls with 71.25 x 0.3 / (153 degrees) x 0.9348 / 8 Nm = 0.935 of what the motor can.
@pytest.mark.parametrize("kind", ["MUSCLE", "MUJOCO_MUSCLE"])
def test_muscles_are_as_strong_as_motors_at_every_age(kind):
    toddler = strengths(18, mimo.Actuation[kind])
    if kind == "MUSCLE":
        force = 0.92 + 0.15 * 0.5 * (0.05 / 0.1125) ** 2
        assert toddler["left_hip1", "negative"] == pytest.approx(71.25 * 0.3 / np.deg2rad(153) * force / 8, rel=1e-3)
    for age in AGES:
        shares = strengths(age, mimo.Actuation[kind])
        assert shares == pytest.approx(toddler, rel=0.01), age


def spindles(age):
    """Ia and II of both muscles of the left hip, 0.4 rad beyond the middle of its range, after two seconds."""
    kinds = mimo.Proprioception.SPINDLE_PRIMARY | mimo.Proprioception.SPINDLE_SECONDARY
    with world_of(age, proprioception=kinds) as world:
        for _ in range(400):
            hold(world, "left_hip1", middle(world, "left_hip1") + 0.4)
        seen = world.observe()
        labels = world.layout.fields["proprioception/spindle_primary"].labels
        numbers = [i for i, label in enumerate(labels) if "left_hip_flex" in label]
        return np.array([seen[f"proprioception/spindle_{kind}"][numbers] for kind in ("primary", "secondary")])


# Muscles of 0.80 to 1.10 L0 over 153 degrees are 0.995 and 0.905 L0 long there; a range of 103 degrees would make that
# 1.017 and 0.883, which moves Ia by 7 and II by 8 Hz (331 and 369 Hz for each L0, by the table in proprioception.md).
def test_a_radian_stretches_a_spindle_by_as_much_at_every_age():
    toddler = spindles(18)
    # They creep on for seconds.
    assert toddler[0] == pytest.approx([85.5 - 0.005 * 327, 52.8 + 0.005 * 327], rel=0.08)
    for age in AGES:
        assert spindles(age) == pytest.approx(toddler, abs=0.5), age


OWN_RANGES = (
    "<mujoco><include file='mimo/mitten.xml'/><custom><numeric name='mimo:born_ranges' data='{}'/></custom></mujoco>"
)


@pytest.mark.parametrize(
    ("numbers", "complaint"),
    [
        ("0 1", "has 2 numbers, expected two for each of the infant's 47 hinges"),
        (" ".join(["1 0"] * 47), "goes from 1 to 0"),
    ],
)
def test_unsuitable_ranges_are_refused(numbers, complaint):
    scene = mimo.Scene(xml=OWN_RANGES.format(numbers))
    scene.add_agent(body="scene", actuation=mimo.Actuation.MUSCLE, vision=False)
    with pytest.raises(mimo.ModelError, match=complaint):
        mimo.World(scene)
