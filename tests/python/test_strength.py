"""`strength` multiplies what an infant's motors and muscles do, in every world, at every age, and in replays."""

import numpy as np
import pytest
from recorded import recorder_or_skip

import mimo

BLIND = {"vision": False, "touch": False, "vestibular": False}


def moved(action, share, gear=1.0, **options):
    """The left elbow's angle after some steps with one action."""
    with mimo.World("free", disable=["gravity", "contact"], **BLIND, **options) as world:
        world.reset(0)
        world.actuators().gear = gear * world.actuators().gear
        actions = np.zeros(len(world.action_names), np.float32)
        actions[world.action_names.index(action)] = share
        for _ in range(20):
            world.step(actions)
        return world.joints("robot:left_elbow").position.item()


def test_a_motor_of_half_the_strength_needs_twice_the_command():
    half = moved("act:left_elbow", -0.5, strength=0.5)
    assert half == pytest.approx(moved("act:left_elbow", -0.25), abs=1e-9)
    assert abs(half - moved("act:left_elbow", -0.5)) > 0.01


@pytest.mark.parametrize(
    ("actuation", "action"),
    [("muscle", "act:left_elbow/negative"), ("mujoco_muscle", "act:left_elbow/negative")],
)
def test_it_does_what_a_world_s_own_gears_do(actuation, action):
    weak = moved(action, 0.5, actuation=actuation, strength=0.6)
    assert weak == pytest.approx(moved(action, 0.5, gear=0.6, actuation=actuation), abs=1e-9)
    assert abs(weak - moved(action, 0.5, actuation=actuation)) > 0.01


def gears(world):
    return world.actuators().gear.copy()


def test_it_is_part_of_every_age_and_of_no_other_world():
    usual = {}
    for age in (18, 3):
        with mimo.World("free", age=age, **BLIND) as world:
            usual[age] = gears(world)
    with mimo.World("free", age=18, strength=0.5, **BLIND) as world:
        assert gears(world) == pytest.approx(0.5 * usual[18])
        world.reset(0)
        assert gears(world) == pytest.approx(0.5 * usual[18])
        world.reset(age=3)
        assert gears(world) == pytest.approx(0.5 * usual[3])
        with world.clone() as twin:
            assert gears(twin) == pytest.approx(0.5 * usual[3])


def test_zero_and_one_are_the_usual_infant():
    with mimo.World("free", **BLIND) as usual, mimo.World("free", strength=1, **BLIND) as one:
        usual.reset(0), one.reset(0)
        action = np.full(len(usual.action_names), 0.3, np.float32)
        for _ in range(20):
            usual.step(action), one.step(action)
        assert usual.save() == one.save()


def test_a_recording_replays_it(tmp_path):
    with mimo.World("reach", strength=0.4, **BLIND) as world:
        world.reset(0)
        with recorder_or_skip(world, tmp_path / "weak.h5"):
            for step in range(40):
                world.step(np.full(len(world.action_names), np.sin(step / 5), np.float32))
        weak = gears(world)
    with mimo.Recording(tmp_path / "weak.h5") as recording, recording.world(eyes=0) as twin:
        assert gears(twin) == pytest.approx(weak)
        assert recording.play(twin).identical


@pytest.mark.parametrize("strength", [-1, 0.001, 101, float("nan")])
def test_other_numbers_are_refused(strength):
    with pytest.raises(ValueError, match=r"strength is .*expected 0\.01 to 100"):
        mimo.World("free", strength=strength, **BLIND)


def test_it_needs_an_infant_with_motors():
    with pytest.raises(ValueError, match="strength is 2, expected 1 with a root or MIMO_ACTUATION_POSITION"):
        mimo.World("free", strength=2, actuation="position", **BLIND)
    scene = mimo.Scene(xml='<mujoco><worldbody><body name="arm"><geom size=".1"/></body></worldbody></mujoco>')
    with pytest.raises(ValueError, match="strength is 2"):
        scene.add_agent(body="scene", root="arm", strength=2, proprioception=0, **BLIND)
