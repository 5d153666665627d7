"""How many afferents sensors of touch stand for: as many at every age, on any skin.

A person has some 230 000 touch afferents, 15 % of them in the palms of both hands (Corniani and Saal 2020). Their
number does not change: skin grows, and they move apart (Peters and Goldreich 2013). An eyeball as bare skin of the
face, 26 afferents a square centimetre all around, would have 413.
"""

import numpy as np
import pytest

import mimo

PERSON = 230_000
SKINS = ({"age": 0}, {"age": 6}, {"age": 24}, {"age": 3, "keep_spacing": True}, {"touch_scale": 2}, {"sex": "male"})


def units_of(body, **options):
    """By sensor, and the names of their bodies."""
    with mimo.World("free", body=body, vision=False, touch=mimo.Touch.UNITS, **options) as world:
        world.reset(0)
        names = world.bodies().names
        where = [names[number] for number in world.layout.receptors("touch/units").bodies]
        return world.observation["touch/units"].astype(float), np.array(where)


def of(told, *parts):
    units, where = told
    return units[[any(part in name for part in parts) for name in where]].sum()


@pytest.mark.parametrize("body", ["mitten", "fingers"])
def test_the_number_of_units_does_not_depend_on_age_or_sensors(body):
    toddler = units_of(body)
    assert toddler[0].sum() == pytest.approx(PERSON, rel=0.01)
    hands = of(toddler, "hand", "finger", "knuckle", "middle", "distal", "metacarpal", "_th")
    assert hands == pytest.approx(0.15 * PERSON, rel=0.01)
    for options in SKINS:
        told = units_of(body, **options)
        assert told[0].sum() == pytest.approx(toddler[0].sum(), rel=1e-5), options
        for part in ("left_eye", "right_eye"):
            assert 0 < of(told, part) < 413
    for age in (0, 6, 24):
        assert units_of(body, age=age)[0] == pytest.approx(toddler[0]), age


def test_a_part_s_units_do_not_depend_on_skin_elsewhere():
    whole = units_of("mitten")
    scene = mimo.Scene("free")
    scene.add_agents(vision=False, touch=mimo.Touch.UNITS)
    scene.set_touch(None, 0)
    scene.set_touch("left_hand", 0.02)
    with mimo.World(scene) as world:
        world.reset(0)
        assert world.observation["touch/units"].sum() == pytest.approx(of(whole, "left_hand"), rel=1e-5)


# An eyeball has one sensor, and skin no wider than its own: with r = 11.25 mm a spacing of sqrt(4 pi r^2 / 0.87) = 42.8
# mm, which takes 12.8 N to be pressed in by half of 3 mm. 1 N presses it in by 0.217 mm: SA1 tell 48 (0.217 - 0.08) Hz.
EYE = """<mujoco><worldbody><body name="left_eye"><geom size=".01125"/></body>
  <body name="probe" pos="0 0 .02124"><joint type="slide" axis="0 0 1" damping="5"/><geom size=".01" mass="{}"/></body>
  </worldbody></mujoco>"""


def test_an_eyeball_feels_what_presses_it():
    scene = mimo.Scene(xml=EYE.format(1 / 9.81))
    senses = mimo.Touch.SA1 | mimo.Touch.UNITS
    scene.add_agent(body="scene", root="left_eye", vision=False, vestibular=False, proprioception=0, touch=senses)
    scene.set_touch("left_eye", 1.0)
    with mimo.World(scene, frame_skip=1) as world:
        world.reset(0)
        for _ in range(400):
            seen = world.step().observation
        assert seen["touch/sa1"] == pytest.approx([48 * (0.217 - 0.08)], rel=0.02)
        assert seen["touch/units"].sum() == pytest.approx(413, rel=0.01)
