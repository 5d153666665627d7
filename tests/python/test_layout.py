"""What is observed, acted with and rewarded: one description for worlds, batches and attached senses."""

import re

import numpy as np
import pytest

import mimo

STEP, PHYSICS_STEP = 0.01, 0.005  # s, of reach
BOX = """<mujoco><worldbody><body name="box" pos="0 0 1"><freejoint/>
<geom name="shell" type="box" size=".1 .1 .1"/></body></worldbody></mujoco>"""


def with_skin():
    scene = mimo.Scene(xml=BOX)
    scene.add_agent(body="scene", root="box", vision=False, vestibular=False, proprioception=False)
    scene.set_touch("box", 0.05)
    return scene


def test_a_batch_has_the_layout_of_its_worlds(reach):
    with mimo.Batch("reach", 2) as batch:
        of_batch, of_world = batch.layout, reach.layout
        assert batch.world(1).layout is of_batch
        assert (of_batch.bytes, of_batch.agents) == (of_world.bytes, 1)
        for name in ("fields", "actions", "terms"):
            assert getattr(of_batch, name) == getattr(of_world, name)


def test_actions_and_terms_name_their_infant():
    with mimo.World("playdate", vision=False, touch=False) as two:
        for number, infant in enumerate(two.agents):
            assert {action.agent for action in two.layout.actions[infant.actions]} == {number}
            assert two.layout.actions[infant.actions.start].name.startswith(f"{infant.name}/act:")
    with mimo.World("reach", actuation="position", acts="right_arm") as arm:
        (elbow,) = (action for action in arm.layout.actions if action.name == "act:right_elbow")
        # Under position control an action is an angle of the joint that the motor moves.
        assert elbow.unit == "rad"
        assert [elbow.low, elbow.high] == pytest.approx(arm.joints("robot:right_elbow").range[0], abs=1e-6)
        assert arm.action_low.tolist() == [action.low for action in arm.layout.actions]


def test_fields_have_times(reach):
    fields = reach.layout.fields
    assert {field.period for field in fields.values()} == {STEP}
    now, before = fields["proprioception/position"], fields["proprioception/torque"]
    assert (now.start, now.end) == (0, 0)
    assert (before.start, before.end) == (-PHYSICS_STEP, -PHYSICS_STEP)
    scene = mimo.Scene("reach")
    scene.add_agent()
    scene.limit_sense("proprioception", delay=0.03)
    with mimo.World(scene) as late:
        assert late.layout.fields["proprioception/position"].start == pytest.approx(-0.03)
        assert late.layout.fields["proprioception/torque"].end == pytest.approx(-0.03 - PHYSICS_STEP)


def test_elements_have_delays(reach):
    assert not reach.layout.delays("proprioception/position").any()
    with mimo.World("reach", age=0, maturity="delays", vision=False, vestibular=True) as young:
        infant, layout = young.agents[0], young.layout
        assert infant.mass == reach.agents[0].mass  # of 18 months: only the nerves are a newborn's
        for name, field in layout.fields.items():
            late = layout.delays(name)
            assert late.shape == (np.prod(field.shape),)
            start = -PHYSICS_STEP if name.startswith(("proprioception/torque", "vestibular")) else 0
            assert (field.end, field.start) == pytest.approx((start - late.min(), start - late.max()))
        # To the nearest time step: along the nerve of the part that the joint moves, then to the cortex.
        joints, nerves = young.joints(*layout.fields["proprioception/limit"].labels), mimo.Maturity.at(0)
        length = young.get("body_nerve_length", joints.body_ids)
        exact = length / nerves.conduction_speed + nerves.sensory_delay
        assert np.abs(layout.delays("proprioception/limit") - exact).max() <= PHYSICS_STEP / 2 + 1e-9
        assert layout.delays("vestibular/acceleration") == pytest.approx(nerves.vestibular_delay)
        with pytest.raises(mimo.NotFoundError, match="smell"):
            layout.delays("smell")
    with pytest.raises(mimo.ClosedError, match="closed"):
        layout.delays("vestibular/acceleration")


def test_fields_are_as_late_as_the_infant_is_old():
    with mimo.World("free", age=0, maturity=["body", "delays"], vision=False, touch=False) as world:
        position = "proprioception/position"
        young = world.layout.fields[position]
        world.reset(seed=1, age=18)
        assert young.start < world.layout.fields[position].start == -world.layout.delays(position).max() < 0


def test_receptors_lie_on_the_skin():
    with mimo.World(with_skin()) as world:
        field = world.layout.fields["touch/force"]
        skin = world.layout.receptors("touch/force")
        assert field.receptors == field.shape[0] == len(skin.bodies) > 50
        assert set(skin.bodies) == {world.find("body", "box")}
        assert set(skin.geoms) == {world.find("geom", "shell")}
    # From the centre of a cube of half length 0.1 m it is 0.1 m to a face, sqrt 2 times as far to an edge, sqrt 3 times
    # to a corner, each along its normal.
    normal, first, second = skin.frame.transpose(1, 0, 2)
    faces = (np.abs(np.abs(skin.position) - 0.1) < 1e-9).sum(axis=1)
    assert set(faces) == {1, 2, 3}
    np.testing.assert_allclose((skin.position * normal).sum(axis=1), 0.1 * np.sqrt(faces), atol=1e-9)
    np.testing.assert_allclose((normal * first).sum(axis=1), 0, atol=1e-9)
    np.testing.assert_allclose(np.cross(normal, first), second, atol=1e-9)


def test_only_skin_has_receptors(reach):
    assert reach.layout.fields["proprioception/position"].receptors == 0
    assert [len(part) for part in reach.layout.receptors("proprioception/position")] == [0] * 4
    with pytest.raises(mimo.NotFoundError, match="proprioception/position"):
        reach.layout.receptors("proprioception/positions")


def test_a_layout_outlives_its_world():
    with mimo.World(with_skin()) as world:
        layout = world.layout
    assert layout.fields["touch/force"].unit == "N"
    with pytest.raises(mimo.ClosedError, match="closed"):
        layout.receptors("touch/force")


def test_versions_and_supported_names(root):
    header = (root / "include/mimo/status.h").read_text()
    declared = [int(re.search(rf"#define MIMO_{name} (\d+)", header).group(1)) for name in ("API_MAJOR", "API_MINOR")]
    assert list(mimo.api_version()) == declared
    assert mimo.abi_version() == int(re.search(r"#define MIMO_ABI_VERSION (\d+)", header).group(1))
    known = ("mimo_env_step", "MIMO_BODY_MASS", "mimo_field", "mimo_field.period")
    assert [mimo.supports(name) for name in known] == [True] * 4
    assert not mimo.supports("mimo_env_fly")
    assert not mimo.supports("mimo_field.colour")
