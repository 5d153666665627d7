"""Quantities by name and number: of one world, of a batch, of now; and what experiments randomise."""

import numpy as np
import pytest

import mimo
from mimo import Kind, Quantity

BALL = """<mujoco><option timestep="0.005"/><worldbody><geom name="floor" type="plane" size="5 5 .1"/>
<light name="sun" pos="0 0 5"/><body name="ball" pos="0 0 1"><freejoint/><geom name="ball" size="0.1" mass="2"/></body>
<body name="table" pos="3 0 0"><geom name="top" type="box" size=".5 .5 .2"/></body></worldbody></mujoco>"""


@pytest.fixture
def world():
    with mimo.World(mimo.Scene(xml=BALL), step_contacts=True, frame_skip=20) as made:
        yield made


def test_names_numbers_and_all(world):
    assert world.get(Quantity.BODY_MASS, "ball") == 2
    assert world.get("body_mass", ["ball", world.find(Kind.BODY, "ball")]).tolist() == [2, 2]
    assert world.get(Quantity.BODY_MASS).shape == (world.count(Kind.BODY),)
    assert world.get(Quantity.BODY_POSITION, ["ball"], dtype=np.float32).dtype == np.float32
    assert world.lights("sun").position.tolist() == [[0, 0, 5]]
    assert world.get(Quantity.WORLD_GRAVITY).tolist() == [[0, 0, -9.81]]
    with pytest.raises(mimo.NotFoundError, match="nobody"):
        world.get(Quantity.BODY_MASS, ["nobody"])
    with pytest.raises(TypeError, match="dtype is int64"):
        world.get(Quantity.BODY_MASS, dtype=np.int64)


def test_now_reads_the_end_of_the_step(world):
    world.step()
    last, now = world.get(Quantity.BODY_POSITION, "ball"), world.get(Quantity.BODY_POSITION, "ball", now=True)
    assert now[0, 2] == pytest.approx(last[0, 2] - 9.81 * 0.005 * 20 * 0.005)
    assert np.array_equal(world.bodies("ball").read("position", now=True), now)
    assert np.array_equal(world.bodies("ball").position, last)
    with pytest.raises(ValueError, match="no MIMO_NOW"):
        world.get(Quantity.CONTACT_FORCE, now=True)


def test_set_values_outlive_resets_and_states(world):
    world.bodies("ball").mass = 0.5
    world.geoms("ball").size = [0.2, 0, 0]
    world.geoms("ball").color = [1, 0, 0, 1]
    world.bodies("table").pose = [0, 0, 0, 1, 0, 0, 0]
    state = world.save()
    world.reset()
    for _ in range(40):
        world.step()
    assert world.geoms("ball").position[0, 2] == pytest.approx(0.2 + 0.2, abs=2e-3)
    assert world.contacts().force[0, 0] == pytest.approx(0.5 * 9.81, abs=1e-3)
    with mimo.World(mimo.Scene(xml=BALL), step_contacts=True, frame_skip=20) as other:
        other.load(state)
        assert other.bodies("ball").mass == 0.5
        assert other.geoms("ball").color.tolist() == [[1, 0, 0, 1]]


def test_contacts_within_a_step_carry_the_change_of_momentum(world):
    ball = world.bodies("ball")
    touched = False
    for _ in range(20):
        before = world.joints().velocity[0, 2]
        world.step()
        contacts = world.step_contacts()
        impulse = contacts.impulse[:, 2].sum() - 2 * 9.81 * 0.1
        assert impulse == pytest.approx(2 * (world.joints().velocity[0, 2] - before), abs=1e-9)
        touched = touched or len(contacts.geoms) > 0
    assert touched
    assert ball.mass == 2
    assert set(world.warnings().values()) == {0}


def test_a_site_moves_with_its_body(world):
    # What turns with w about z goes at w r across the radius r: 3 rad/s, 0.1 m.
    spinning = BALL.replace("<freejoint/>", '<joint name="turn"/><site name="rim" pos="0.1 0 0"/>')
    with mimo.World(mimo.Scene(xml=spinning)) as spun:
        spun.joints("turn").velocity = 3
        assert spun.sites("rim").read("velocity", now=True)[0] == pytest.approx([0, 0.3, 0, 0, 0, 3])
        spun.step()  # of two times 5 ms, of which the last one starts at 3 * 0.005 rad
        turned = [-0.3 * np.sin(0.015), 0.3 * np.cos(0.015), 0, 0, 0, 3]
        assert spun.sites("rim").velocity[0] == pytest.approx(turned)
    with pytest.raises(AttributeError, match="site_velocity cannot be written"):
        world.sites().velocity = 0


def test_rewards_follow_from_goals(reach):
    reach.reset(seed=2)
    reward = reach.step(np.ones(8)).reward[0]
    goal, achieved = reach.get(Quantity.AGENT_GOAL), reach.get("agent_achieved", [0])
    assert np.array_equal(goal, reach.bodies("target").position)
    assert reward == pytest.approx(-np.linalg.norm(goal - achieved))  # reach's distance, docs/tasks.md
    with mimo.Batch("reach", 2) as batch:
        batch.reset(seeds=2)
        batch.step(np.ones((2, 8)))
        assert np.array_equal(batch.get(Quantity.AGENT_GOAL)[0], goal)
    with mimo.World("free", vision=False, touch=False) as aimless:
        assert aimless.get(Quantity.AGENT_GOAL).size == 0


def test_a_batch_of_masses_is_as_many_single_worlds():
    masses = np.array([0.5, 1.0, 2.0, 4.0])
    push = [3, 0, 0, 0, 0, 0]
    with mimo.Batch(mimo.Scene(xml=BALL), 4) as batch:
        batch.set(Quantity.BODY_MASS, masses, "ball")
        batch.set(Quantity.WORLD_GRAVITY, [0, 0, 0])
        batch.bodies("ball").force = push
        assert np.array_equal(batch.get(Quantity.BODY_MASS, "ball")[:, 0], masses)
        for _ in range(10):
            batch.step()
        velocity = batch.joints().velocity[:, 0, 0]
        assert velocity == pytest.approx(3 / masses * 10 * 2 * 0.005)
        for mass, position in zip(masses, batch.joints().position[:, 0]):
            with mimo.World(mimo.Scene(xml=BALL)) as single:
                single.set(Quantity.BODY_MASS, mass, "ball")
                single.gravity = [0, 0, 0]
                single.bodies("ball").force = push
                for _ in range(10):
                    single.step()
                assert np.array_equal(single.joints().position[0], position)
        with pytest.raises(ValueError, match=r"MIMO_CONTACT_[A-Z]*, of which worlds have different numbers"):
            batch.get(Quantity.CONTACT_FORCE)


def test_refused(world):
    with pytest.raises(ValueError, match="expected kilograms above 0"):
        world.set(Quantity.BODY_MASS, 0, "ball")
    with pytest.raises(ValueError, match="can only be read"):
        world.set(Quantity.BODY_VELOCITY, 0, "ball")
    with pytest.raises(mimo.UnsupportedError, match="no equality"):
        world.joints().lock = [1, 0]
    with mimo.World(mimo.Scene(xml=BALL)) as plain, pytest.raises(mimo.UnsupportedError, match="step_contacts"):
        plain.step_contacts()


def test_boxes_are_as_deep_in_boxes_as_they_lie():
    """A cube of 5 cm with its middle at 4.9 cm: 1 mm. MuJoCo 2.2 says half of that where a face touches a box."""
    for under in ('type="plane" size="1 1 0.1"', 'type="box" size="0.5 0.5 0.1" pos="0 0 -0.1"'):
        xml = f"""<mujoco><worldbody><geom {under}/><body pos="0 0 0.049"><freejoint/>
                  <geom type="box" size="0.05 0.05 0.05"/></body></worldbody></mujoco>"""
        with mimo.World(mimo.Scene(xml=xml)) as world:
            contacts = world.contacts()
            assert contacts.distance == pytest.approx([-1e-3] * 4, abs=1e-9)
            assert contacts.position[:, 2] == pytest.approx([-0.5e-3] * 4, abs=1e-9)  # midway
