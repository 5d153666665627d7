"""What nerves of the skin tell of things that slide, and of vibration, at several physics steps.

Skin of sensors 10 mm apart is pressed in by d = 3 mm F / (F + 3 N). SA1 tell 48 (d - 0.08 mm) of it, RA and PC
nothing at all as long as it does not change. A thing that slides at w over ridges L apart and A high vibrates at w / L,
of which PC tell all if A is above its threshold there: TouchSim's is 14.1 micrometres at 100 Hz (Saal et al. 2017).
Friction changes none of it.
"""

import numpy as np
import pytest

import mimo

WEIGHT = 0.2 * 9.81  # N
HELD = 48 * (3 * WEIGHT / (WEIGHT + 3) - 0.08)
STEPS = (0.005, 0.0025, 0.001, 0.0005)
OPTIONS = '<option timestep="{}" cone="{}" solver="Newton" iterations="50" tolerance="1e-10"/>'
BELT = """<mujoco>{options}<worldbody>
  <body name="belt"><joint name="x" type="slide" axis="1 0 0"/>
    <geom type="box" size=".3 .05 .01" mass="5" friction="{friction} .005 .0001"/></body>
  <body name="skin" pos="0 0 .0199"><joint name="z" type="slide" axis="0 0 1"/>{tip}
    <geom {shape} mass=".2" friction="{friction} .005 .0001"/></body></worldbody></mujoco>"""
BALL = {"shape": 'size=".01"', "tip": ""}
PLATE = {"shape": 'type="box" size=".02 .02 .01"', "tip": '<joint name="tip" axis="0 1 0"/>'}
TIP = {"shape": 'size=".0005" pos="0 0 -.0095"', "tip": ""}
SENSES = mimo.Touch.SA1 | mimo.Touch.RA | mimo.Touch.PC | mimo.Touch.NORMAL_FORCE


class Belt:
    """Skin that its weight presses on a belt, which runs under it."""

    def __init__(
        self, step, friction, material="plastic", kind=BALL, cone="elliptic", response="NEAREST", senses=SENSES
    ):
        xml = BELT.format(options=OPTIONS.format(step, cone), friction=friction, **kind)
        scene = mimo.Scene(xml=xml)
        scene.add_agent(
            body="scene",
            root="skin",
            vision=False,
            vestibular=False,
            proprioception=0,
            touch=senses,
            touch_response=mimo.TouchResponse[response],
        )
        scene.set_touch("skin", 0.01)
        scene.set_material("belt", material)
        self.world = mimo.World(scene, frame_skip=1)
        self.world.reset(0)

    def run(self, seconds, speed, names=("force", "sa1", "ra", "pc")):
        """Force, SA1, RA and PC in their course, each of the sensor that tells most."""
        told = []
        belt = self.world.joints("x")
        for _ in range(round(seconds / self.world.timestep)):
            belt.position, belt.velocity = 0, speed
            seen = self.world.step().observation
            told.append([seen[f"touch/{name}"].max() for name in names if f"touch/{name}" in seen])
        return np.array(told)


def late(told):
    return told[len(told) // 2 :]


# Its contact opens and closes all the time, at any step: that is MuJoCo's friction, not the world. By TouchSim's table
# ridges of plastic, 2 micrometres high, are felt at no speed below 0.2 m/s.
@pytest.mark.parametrize("step", STEPS)
@pytest.mark.parametrize("friction", [0.3, 1])
@pytest.mark.parametrize("speed", [0.02, 0.1])
def test_smooth_things_slide_silently(step, friction, speed):
    told = late(Belt(step, friction).run(1.5, speed))
    assert (told[:, 0] == 0).any()
    assert told[:, 2].max() == 0
    assert told[:, 3].max() == 0
    assert told[:, 1] == pytest.approx(HELD, rel=0.03)


@pytest.mark.parametrize("kind", [BALL, PLATE], ids=["ball", "plate"])
@pytest.mark.parametrize("cone", ["elliptic", "pyramidal"])
@pytest.mark.parametrize("response", ["NEAREST", "LINEAR", "GAUSSIAN"])
def test_it_also_does_on_several_sensors_and_with_any_friction(kind, cone, response):
    told = late(Belt(0.005, 0.5, kind=kind, cone=cone, response=response).run(2, 0.1))
    assert told[:, 2].mean() < 0.5
    assert told[:, 3].mean() < 0.5


# Cloth has ridges 1 mm apart and 20 micrometres high: at 0.1 m/s one comes every 10 ms.
@pytest.mark.parametrize("friction", [0.3, 1])
def test_a_texture_shows_in_friction(friction):
    told = late(Belt(0.005, friction, "cotton").run(1.5, 0.1))
    assert told[:, 3] == pytest.approx(100, rel=0.04)
    assert told[:, 2].max() == 0  # below half of RA's threshold there, 134 micrometres


# By Hertz 1.962 N on a tip of 0.5 mm make 209 kPa x 1.962^(1/3) = 261.7 kPa, 1.817 times an infant's threshold.
@pytest.mark.parametrize("friction", [0.3, 1])
def test_a_sharp_thing_hurts_as_much_while_it_slides(friction):
    belt = Belt(0.005, friction, kind=TIP, senses=mimo.Touch.NOCICEPTION_FAST | mimo.Touch.NOCICEPTION_SLOW)
    belt.run(4, 0.1)
    told = belt.run(1, 0.1, ("nociception_fast", "nociception_slow"))
    assert told[:, 0] == pytest.approx(20 * 0.817 * 0.4, rel=0.05)
    assert told[:, 1] == pytest.approx(5 * (1.817 - 0.8), rel=0.03)


def test_touching_and_leaving_a_moving_body_is_felt_at_once():
    belt = Belt(0.005, 1)
    skin = belt.world.joints("z")
    skin.position = 0.005
    landing = belt.run(0.06, 0.1)
    touched = np.argmax(landing[:, 0] > 0)
    assert landing[touched : touched + 3, 2].max() > 50
    assert landing[touched : touched + 3, 3].max() > 20
    belt.run(1, 0.1)
    belt.world.gravity = [0, 0, 9.81]
    leaving = belt.run(0.1, 0.1)
    assert leaving[:, 2].max() > 50
    assert leaving[:, 3].max() > 20
    assert belt.run(0.5, 0.1)[-1].tolist() == [0, 0, 0, 0]


def test_a_stopped_slide_is_felt_as_rest():
    belt = Belt(0.005, 1)
    belt.run(1, 0.1)
    belt.run(0.3, 0)
    belt.world.gravity = [0, 0, -2 * 9.81]
    told = belt.run(0.5, 0)
    assert told[:20, 2].max() > 20
    assert told[-1, 1] == pytest.approx(48 * (6 * WEIGHT / (2 * WEIGHT + 3) - 0.08), rel=0.01)


def test_a_state_holds_slides():
    one, other = Belt(0.005, 0.5, "cotton"), Belt(0.005, 0.5, "cotton")
    one.run(0.5, 0.1)
    assert not other.world.load(one.world.save()).fresh
    assert one.run(0.3, 0.1).tolist() == other.run(0.3, 0.1).tolist()


def vibrating(step, frequency):
    """RA and PC of a probe that vibrates on a palm between 0.75 and 1.25 mm, in the mean."""
    xml = f"""<mujoco>{OPTIONS.format(step, "elliptic")}<worldbody>
      <body name="skin"><geom type="box" size=".05 .05 .01"/></body>
      <body name="probe" pos="0 0 .01999"><joint type="slide" axis="0 0 1" damping="2"/><geom size=".01" mass=".2"/>
      </body></worldbody></mujoco>"""
    scene = mimo.Scene(xml=xml)
    scene.add_agent(
        body="scene", root="skin", vision=False, vestibular=False, proprioception=0, touch=SENSES, touch_response=1
    )
    scene.set_touch("skin", 0.01)
    told = []
    with mimo.World(scene, frame_skip=1) as world:
        world.reset(0)
        for time in np.arange(0, 1.5, step):
            depth = 1 + 0.25 * np.sin(2 * np.pi * frequency * time)
            world.gravity = [0, 0, -3 * depth / (3 - depth) / 0.2]
            seen = world.step().observation
            told.append([seen["touch/ra"].max(), seen["touch/pc"].max()])
    return late(np.array(told)).mean(axis=0)


# At a step of 5 ms vibration is within 5 % of what it is at 0.5 ms up to 20 Hz; less than 1 Hz of PC is silence.
@pytest.mark.parametrize("frequency", [5, 10, 20])
def test_vibration_does_not_depend_on_the_step(frequency):
    fine = vibrating(0.0005, frequency)
    for step in STEPS[:-1]:
        assert vibrating(step, frequency) == pytest.approx(fine, rel=0.05, abs=1.1), step
