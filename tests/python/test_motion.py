"""Movements that are known: joints go where they are told."""

import numpy as np
import pytest

import mimo
from mimo.constants import Kind, Quantity


@pytest.fixture
def world():
    scene = mimo.Scene("free")
    scene.add_agent(vision=False, touch=False)
    with mimo.World(scene, frame_skip=1) as world:
        yield world


def test_a_held_infant_is_held_with_its_weight(world):
    """At the third degree of freedom of the free joint, which is the first joint."""
    world.reset(seed=0)
    still = world.get(Quantity.JOINT_POSITION).ravel()
    world.follow(still)
    observation, forces = world.follow(still)
    assert forces.shape == (1, len(still) - 1)  # one quaternion
    assert forces[0, 2] == pytest.approx(9.81 * world.agents[0].mass, abs=1e-6)
    assert np.linalg.norm(observation["vestibular/acceleration"]) == pytest.approx(9.81, abs=1e-4)


def test_joints_reach_the_set_positions(world):
    """To the bit; and bodies where joints of that angle put them, as when the angle is set."""
    world.reset(seed=0)
    elbow, hand = world.find(Kind.JOINT, "robot:left_elbow"), world.find(Kind.BODY, "left_hand")
    told = world.get(Quantity.JOINT_POSITION).ravel()
    told[7 + elbow - 1] = -0.7  # the free joint comes first and has seven; all others have one
    world.follow(told)
    assert np.array_equal(world.get(Quantity.JOINT_POSITION).ravel(), told)
    assert world.get(Quantity.JOINT_POSITION, [elbow]) == -0.7
    world.update()
    followed = world.get(Quantity.BODY_POSITION, [hand]).copy()
    world.reset(seed=0)
    world.set(Quantity.JOINT_POSITION, [-0.7], [elbow])
    world.update()
    assert np.allclose(world.get(Quantity.BODY_POSITION, [hand]), followed, rtol=0, atol=1e-9)


def test_bad_movements_are_refused(world):
    world.reset(seed=0)
    still = world.get(Quantity.JOINT_POSITION).ravel()
    with pytest.raises(mimo.ArgumentError, match="position_count"):
        world.follow(still[1:])
    still[9] = np.nan
    with pytest.raises(mimo.ArgumentError, match=r"positions\[9\] is nan"):
        world.follow(still)
