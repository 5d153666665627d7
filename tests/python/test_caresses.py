"""C-tactile afferents of skin that a plate strokes: a tuning by speed and temperature, fatigue, and where they are.

Sources: most at 1 to 10 cm/s between 0.3 and 30 (Loken 2009), less at 18 and 42 degrees than at 32 (Ackerley 2014), at
most 100 impulses a second and a long fatigue (Vallbo 2016), none in the palm.
"""

import numpy as np
import pytest

import mimo

ARM, PALM = "left_lower_arm", "left_hand"
STROKE = """<mujoco><option timestep=".0025" cone="elliptic" solver="Newton" iterations="50" tolerance="1e-10"/>
  <worldbody>
    <body name="plate"><joint name="x" type="slide" axis="1 0 0"/>
      <geom type="box" size=".3 .05 .01" mass="5" friction=".5 .005 .0001"/></body>
    <body name="{skin}" pos="0 0 .0199"><joint name="z" type="slide" axis="0 0 1"/>
      <geom type="box" size=".02 .02 .01" mass=".1" friction=".5 .005 .0001"/></body></worldbody></mujoco>"""


def world(skin=ARM, celsius=32, frame_skip=4, **options):
    """Skin that its weight presses on a plate of copper, which soon gives it its own temperature."""
    scene = mimo.Scene(xml=STROKE.format(skin=skin))
    senses = {"touch": mimo.Touch.CT | mimo.Touch.TEMPERATURE, "touch_slip_threshold": 0.002, **options}
    scene.add_agent(body="scene", root=skin, vision=False, vestibular=False, proprioception=0, **senses)
    scene.set_touch(skin, 0.01)
    scene.set_material("plate", "copper")
    scene.set_temperature("plate", celsius)
    made = mimo.World(scene, frame_skip=frame_skip)
    made.reset(0)
    return made


def stroke(made, seconds, speed):
    """The median rate of the sensors that the plate touches, step by step, while it moves at so many cm/s."""
    plate, rates = made.joints("x"), []
    touched = made.layout.receptors("touch/ct").frame[:, 0, 2] < -0.5
    for _ in range(round(seconds / made.layout.step_seconds)):
        plate.position, plate.velocity = 0, 0.01 * speed
        rates.append(float(np.median(made.step().observation["touch/ct"][touched])))
    return np.array(rates)


def test_rates_are_an_inverted_u_over_the_speed():
    rates = {speed: stroke(world(), 0.5, speed)[-1] for speed in (0.3, 1, 3, 10, 30)}
    assert rates[0.3] < min(rates[1], rates[10]) > rates[30]
    assert min(rates.values()) > 0
    assert max(rates.values()) == rates[3] <= 100


# Skin on copper comes within some degrees of it in 30 s; the plate stands until it strokes.
def test_skin_of_32_degrees_feels_most():
    def felt(celsius):
        made = world(celsius=celsius)
        stroke(made, 30, 0)
        return stroke(made, 0.2, 3)[-1], made.observation["touch/temperature"].astype(float)

    (cold, at_cold), (neutral, at_neutral), (warm, at_warm) = felt(18), felt(32), felt(42)
    assert at_cold.min() < 24
    assert abs(at_neutral - 32).min() < 0.7
    assert at_warm.max() > 37
    assert cold < 0.9 * neutral
    assert warm < 0.9 * neutral


# By the guide's numbers: to 0.25 of the fresh rate with a time constant of 5 s; back with 20 s.
def test_they_tire_and_recover_slowly():
    made = world()
    first = stroke(made, 0.1, 3).max()
    tired = stroke(made, 30, 3)[-1]
    assert tired == pytest.approx(0.25 * first, rel=0.05)
    stroke(made, 5, 0)
    soon = stroke(made, 0.1, 3).max()
    stroke(made, 60, 0)
    late = stroke(made, 0.1, 3).max()
    assert tired < soon < 0.6 * first < 0.9 * first < late


def test_a_press_without_sliding_is_no_caress():
    made = world()
    assert stroke(made, 0.5, 0).max() == 0
    assert stroke(made, 0.5, 3).max() > 30
    assert stroke(made, 0.5, 0)[-1] == 0


def test_palms_have_none():
    assert stroke(world(PALM), 0.5, 3).max() == 0


def test_slower_slip_than_the_threshold_is_none():
    assert stroke(world(touch_slip_threshold=0.005), 0.5, 0.3).max() == 0


@pytest.mark.parametrize("frame_skip", [1, 2, 8])
def test_steps_of_any_length_give_the_same(frame_skip):
    """The plate is pushed, as setting its speed acts at steps' starts."""

    def end(frame_skip):
        made = world(frame_skip=frame_skip)
        made.gravity = [0.4, 0, -9.81]  # it runs away, and the skin stays
        for _ in range(200 // frame_skip):
            made.step()
        return made.observe()["touch/ct"].copy()

    told = end(frame_skip)
    assert told.max() > 10
    assert told.tobytes() == end(4).tobytes()


def test_a_state_holds_their_fatigue():
    one, other = world(), world()
    stroke(one, 10, 3)
    assert not other.load(one.save()).fresh
    assert stroke(one, 0.5, 3).tolist() == stroke(other, 0.5, 3).tolist()
    fresh = stroke(world(), 0.1, 3).max()
    assert stroke(one, 0.1, 3).max() < 0.5 * fresh
    one.reset(0)
    assert stroke(one, 0.1, 3).max() == fresh


# An unmyelinated fibre of 1 m/s; the arm of a newborn is 0.2 to 0.4 m away from its head.
def test_their_nerves_are_slow():
    with mimo.World("free", age=0, maturity=["delays"], vision=False, touch=["ct", "ra"]) as made:
        skin = made.layout.receptors("touch/ct").bodies
        arm = np.flatnonzero(skin == made.find(mimo.Kind.BODY, ARM))[0]
        length = made.bodies(ARM).nerve_length.item()
        slow, fast = (made.layout.delays(f"touch/{name}").ravel()[arm] for name in ("ct", "ra"))
        assert slow > fast
        assert slow == pytest.approx(length / 1.0 + 0.026, abs=0.01)


def rubbed(direction):
    """The highest rate in an infant's face, where a ball of 4 mm slides at 3 cm/s as seen from the head's middle."""
    scene = mimo.Scene("free")
    scene.add_agent(vision=False, vestibular=False, proprioception=0, touch=["ct"], touch_response="nearest")
    scene.set_touch(None, 0)
    scene.set_touch("head", 0.003)
    scene.add_object("ball", shape="sphere", size=[0.004], position=[1, 1, 1], mass=0.01)
    with mimo.World(scene, frame_skip=1, disable=["gravity"]) as made:
        made.reset(0)
        head, ball = made.bodies("head"), made.joints("ball")
        skull = made.geoms("head")
        outward = np.array(direction) / np.linalg.norm(direction)
        told = 0.0
        for _ in range(10):
            turn = head.orientation
            w, v = turn[0, 0], turn[0, 1:]
            normal = outward + 2 * np.cross(v, np.cross(v, outward) + w * outward)
            along = np.cross(normal, [0.0, 0.0, 1.0])
            along /= np.linalg.norm(along)
            place = skull.position[0] + (skull.size[0, 0] + 0.004 - 0.0005) * normal
            ball.position = [*place, 1, 0, 0, 0]
            ball.velocity = [*(0.03 * along), 0, 0, 0]
            told = max(told, float(made.step().observation["touch/ct"].max()))
        return told


# The mouth as the built-in faces have it is 0.575 down for 1 ahead, its corners 0.185 to the sides.
def test_lips_have_none_and_cheeks_some():
    assert rubbed([1, 0, -0.575]) == 0
    assert rubbed([1, 0.5, -0.575]) > 10
