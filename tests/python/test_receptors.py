"""What nerves tell, asked for as a user does: a probe on the palm, a turn, a tilt, muscles that are held, a cold cup.

Expected numbers: skin by TouchSim (Saal et al. 2017) for a pin held at a depth, canals and otoliths by Schneider et al.
(2015) and Della Santina et al. (2005), spindles by Mileusnic et al. (2006), tendon organs by Lin and Crago (2002). The
articles balance.md, skin.md and proprioception.md of the guide have them in tables.
"""

import json
import subprocess
from functools import lru_cache

import numpy as np
import pytest

import mimo
from mimo import Kind

TICK = 0.005
BLIND = {"senses": "all", "vision": False}
SPACING = (
    0.01  # m, of the hand's sensors: its skin takes 0.3 N a millimetre of it to be pressed in half as far as it goes
)
HALF = 3.0  # N

SKIN = {
    "touch/sa1": ((), "Hz"),
    "touch/ra": ((), "Hz"),
    "touch/pc": ((), "Hz"),
    "touch/sa2": ((2,), "Hz"),
    "touch/temperature": ((), "degC"),
    "touch/cold": ((), "Hz"),
    "touch/warm": ((), "Hz"),
    "touch/nociception_fast": ((), "Hz"),
    "touch/nociception_slow": ((), "Hz"),
    "touch/ct": ((), "Hz"),
    "touch/units": ((4,), ""),
}
MUSCLES = (
    "proprioception/spindle_primary",
    "proprioception/spindle_secondary",
    "proprioception/tendon_organ",
)
BALANCE = {
    "vestibular/canals": ((6, 2), "Hz"),
    "vestibular/otoliths": ((2, 2, 2, 2), "Hz"),
    "vestibular/gravity": ((3,), "m/s^2"),
}


def test_all_senses_are_listed(root):
    command = root / "build/bin/mimo"
    if not command.exists():
        pytest.skip("the program is built by CMake only")
    told = json.loads(subprocess.check_output([command, "info", "--json", "--senses", "all", "--scene", "free"]))
    fields = {field["name"]: field for field in told["observation_fields"]}
    sensors = told["touch_sensors"]
    for name, (rest, unit) in SKIN.items():
        assert (fields[name]["shape"], fields[name]["unit"]) == (
            [sensors, *rest],
            unit,
        ), name
    for name, (shape, unit) in BALANCE.items():
        assert (fields[name]["shape"], fields[name]["unit"]) == (list(shape), unit), name
    for name in MUSCLES:
        assert (fields[name]["shape"], fields[name]["unit"]) == (
            [2 * told["nu"]],
            "Hz",
        ), name
    joints = fields["proprioception/limit"]["shape"][0]
    assert fields["proprioception/joint_receptor"]["shape"] == [joints, 2]
    assert fields["proprioception/joint_receptor"]["unit"] == "Hz"


def test_all_senses_are_observed():
    with mimo.make("free", **BLIND) as env:
        seen, _ = env.reset(seed=1)
        assert {
            *SKIN,
            *MUSCLES,
            *BALANCE,
            "proprioception/joint_receptor",
        } <= seen.keys()
        assert env.observation_space.contains(seen)
    with mimo.make("free", vision=False) as env:
        seen, _ = env.reset(seed=1)
        assert not {*SKIN, *MUSCLES, "vestibular/canals", "proprioception/joint_receptor"} & seen.keys()
    with pytest.raises(ValueError, match="senses is 'most'"):
        mimo.make("free", senses="most")


# ---- Skin: a probe whose weight rests on the left palm ---------------------------------------------------------


def held(*parts, **options):
    """A scene with an infant that hangs in the air, and these of its parts beside its root."""
    scene = mimo.Scene("free")
    scene.add_agents(
        **BLIND,
        position=(0, 0, 1),
        touch_response=mimo.TouchResponse.NEAREST,
        **options,
    )
    scene.set_touch(None, 0)
    scene.set_touch("left_hand", SPACING)
    for part in ("mimo_location", *parts):
        scene.weld(part)
    return scene


def stiff(scene, **options):
    """A world of it whose infant keeps all joints where they are."""
    world = mimo.World(scene, frame_skip=1, **options)
    world.reset(1)
    for joint in world.joints().names:
        if joint.startswith("robot:"):
            world.lock(joint, 0.0)
    return world


def turned(quaternion, vector):
    w, axis = quaternion[0], np.asarray(quaternion[1:])
    return vector + 2 * np.cross(axis, np.cross(axis, vector) + w * vector)


@lru_cache(maxsize=1)
def middle_of_the_palm():
    """Number of a sensor in the middle of the palm, where it is, and where it looks."""
    with mimo.World(held("left_hand"), frame_skip=1) as world:
        world.reset(1)
        hand = world.bodies("left_hand")
        receptors = world.layout.receptors("touch/force")
        palm = receptors.geoms == world.find(Kind.GEOM, "left_hand1")
        flat = np.abs(receptors.frame[:, 0, 1]) > 0.999
        off = np.linalg.norm(receptors.position - receptors.position[palm].mean(axis=0), axis=1)
        sensor = int(np.argmin(np.where(palm & flat, off, np.inf)))
        position, quaternion = hand.position[0], hand.orientation[0]
        at = position + turned(quaternion, receptors.position[sensor])
        return sensor, at, turned(quaternion, receptors.frame[sensor, 0]), quaternion


def probed(newtons, radius=0.01, celsius=33.0, material="plastic", gap=0.0, **options):
    """A world in which a probe of such a weight comes to lie on the palm, and the sensor under it."""
    sensor, at, normal, quaternion = middle_of_the_palm()
    away = turned(quaternion * [1, -1, -1, -1], normal)  # of the palm, in the frame of the hand and of the probe
    xml = f"""<mujoco><worldbody><body name="probe">
      <joint name="down" type="slide" axis="{away[0]} {away[1]} {away[2]}" damping="10"/>
      <geom name="tip" size="{radius}" mass="{newtons / 9.81}"/></body></worldbody></mujoco>"""
    scene = held("left_hand")
    scene.add_model("tool", xml=xml, position=at + (radius + gap) * normal, orientation=quaternion)
    scene.set_temperature("tool/probe", celsius)
    scene.set_material("tool/probe", material)
    world = stiff(scene, **options)
    world.gravity = -9.81 * normal
    return world, sensor


def run(world, seconds):
    for _ in range(round(seconds / world.timestep / world.frame_skip)):
        world.step()
    return world.observation


# TouchSim's SA1 while a pin is held at 0.5, 1 and 1.5 mm: 21, 44 and 68 spikes/s.
@pytest.mark.parametrize(("depth", "rate"), [(0.5, 21), (1.0, 44), (1.5, 68)])
def test_only_sa1_responds_to_a_held_press(depth, rate):
    newtons = HALF * depth / (3 - depth)
    world, sensor = probed(newtons, gap=0.001)
    assert not world.observation["touch/sa1"].any()
    jolt = moving = 0
    for _ in range(40):
        world.step()
        jolt = max(jolt, world.observation["touch/pc"][sensor])
        moving = max(moving, world.observation["touch/ra"][sensor])
    assert jolt > 5
    assert moving > 20
    seen = run(world, 1.5)
    assert np.linalg.norm(seen["touch/force"][sensor]) == pytest.approx(newtons, rel=0.02)
    assert seen["touch/sa1"][sensor] == pytest.approx(rate, rel=0.05)
    assert seen["touch/ra"].max() == 0
    assert seen["touch/pc"].max() == 0
    assert seen["touch/nociception_fast"].max() == 0
    world.gravity = -world.gravity  # it falls off
    gone = [run(world, TICK)["touch/ra"][sensor] for _ in range(20)]
    assert max(gone) > 20
    assert not run(world, 0.5)["touch/sa1"].any()
    world.close()


# Two half-spaces of skin at 33.0 and copper or oak at 10 degrees through 350 W/(m^2 K), after 1 s: 28.21 and 30.26.
def test_a_metal_cup_feels_colder_than_a_wooden_one():
    felt = {}
    for material, skin in (("copper", 28.21), ("hardwood", 30.26)):
        world, sensor = probed(1.5, celsius=10, material=material)
        warm = world.observation["touch/temperature"][sensor]
        assert warm == pytest.approx(33.0, abs=0.02)
        while world.observation["touch/temperature"][sensor] > warm - 1e-3:
            world.step()
        seen = run(world, 1)
        assert warm - seen["touch/temperature"][sensor] == pytest.approx(warm - skin, rel=0.05)
        felt[material] = seen["touch/cold"][sensor]
        assert seen["touch/warm"][sensor] == 0
        world.close()
    assert felt["copper"] > 1.5 * felt["hardwood"]


# 1 N on a tip of 0.5 mm makes 209 kPa by Hertz, of 10 mm 28 kPa; it hurts from 180 kPa x 0.8 for infants on.
def test_a_point_hurts_and_a_ball_does_not():
    world, sensor = probed(1.0, radius=0.0005)
    seen = run(world, 4)
    x = 209 / 144  # kPa
    assert seen["touch/nociception_slow"][sensor] == pytest.approx(5 * (x - 0.8), rel=0.05)
    assert seen["touch/nociception_fast"][sensor] == pytest.approx(20 * (x - 1) * (0.4 + 0.6 * np.exp(-4)), rel=0.05)
    world.close()
    world, sensor = probed(1.0)
    assert run(world, 1)["touch/nociception_slow"].max() == 0
    world.close()


def untouched(*parts, **options):
    """A scene with an infant that these parts hold, and that has no skin."""
    scene = mimo.Scene("free")
    scene.add_agents(**{**BLIND, "touch": False}, position=(0, 0, 1), **options)
    for part in parts:
        scene.weld(part)
    return scene


# A foot of a model is a box, an infant's is not: its 11 kg do not stand on edges.
def test_standing_does_not_hurt():
    with mimo.World("benchmark", **BLIND) as world:
        world.reset(seed=3)
        for _ in range(20):  # it comes down on its feet
            assert not world.step().observation["touch/nociception_fast"].any()
        for _ in range(40):
            seen = world.step().observation
            assert np.linalg.norm(seen["touch/force"], axis=1).max() > 1
            assert not seen["touch/nociception_fast"].any()
            assert not seen["touch/nociception_slow"].any()


# ---- Balance ---------------------------------------------------------------------------------------------------


def canals(world):
    """The three left ones and the three right ones, regular, above what they do at rest."""
    return world.observation["vestibular/canals"][:, 0] - 90


# About a canal's own axis: 26.18 at the start and 21.98, 9.64, 3.55, 1.30 spikes/s after 1, 5.7, 11.4 and 17.1 s, of
# which each canal has its share of the yaw.
def test_a_lasting_yaw_fades():
    share = np.array([-0.180, 0.948, -0.263, 0.173, -0.944, 0.278])
    world = stiff(untouched())
    root = next(name for name in world.joints().names if not name.startswith("robot:"))
    world.gravity = [0, 0, 0]
    assert canals(world) == pytest.approx(0, abs=1e-4)
    speed = [0, 0, 0, 0, 0, np.deg2rad(60)]
    steps = -1  # the first is the jerk of the start
    for seconds, rate in (
        (0.005, 26.18),
        (1, 21.98),
        (5.7, 9.64),
        (11.4, 3.55),
        (17.1, 1.30),
    ):
        while steps < round(seconds / TICK):
            world.joints(root).velocity = speed
            world.step()
            steps += 1
        assert canals(world) == pytest.approx(share * rate, rel=0.05), seconds
    for _ in range(2):
        world.joints(root).velocity = [0] * 6
        world.step()
    assert canals(world)[1] == pytest.approx(0.948 * (1.30 - 26.18), rel=0.05)
    world.close()


# Regular afferents of the static gain 46.2 (spikes/s)/g. Lying on the right ear, up is to the left: the left utricle's
# outward afferents gain that, the right one's lose it, and the saccules' upward ones lose what they have of it upright.
def test_the_otoliths_respond_to_a_tilt_of_90_degrees():
    told = {}
    for name, orientation in (
        ("up", (1, 0, 0, 0)),
        ("right", (0.5**0.5, 0.5**0.5, 0, 0)),
    ):
        with stiff(untouched("mimo_location", "head", orientation=orientation)) as world:
            run(world, 40)  # the slowest part of it goes with 10 s
            told[name] = world.observation["vestibular/otoliths"][..., 0].copy()
            assert canals(world) == pytest.approx(0, abs=0.1)
            gravity = world.observation["vestibular/gravity"]
            assert gravity == pytest.approx([0, 9.81 * (name == "right"), 9.81 * (name == "up")], abs=0.3)
    change = told["right"] - told["up"]
    left, right = change
    assert left[0, 1] == pytest.approx(46.2, rel=0.05)
    assert right[0, 1] == pytest.approx(-46.2, rel=0.05)
    assert left[1, 0] == pytest.approx(-46.2, rel=0.05)
    assert right[1, 0] == pytest.approx(-46.2, rel=0.05)
    assert told["up"][:, 1, 0] == pytest.approx(116.2, rel=0.05)


# ---- Muscles ---------------------------------------------------------------------------------------------------


def elbow(world, field):
    """What is told of the two muscles of the right elbow's motor."""
    labels = world.layout.fields[field].labels
    numbers = [i for i, label in enumerate(labels) if "right_elbow" in label]
    assert len(numbers) == 2
    return world.observation[field][numbers]


# Held, with a drive of 70 spikes a second: Ia 52.8, 85.5 and II 17.7, 54.7 at 0.9 and 1.0 of the optimal length.
def test_held_muscles_tell_their_length():
    with stiff(untouched("mimo_location")) as world:
        low, high = world.get("joint_range", "robot:right_elbow")[0]
        world.lock("robot:right_elbow", low + (high - low) / 3)
        run(world, 3)
        angle = world.joints("robot:right_elbow").position[0]
        assert angle == pytest.approx(low + (high - low) / 3, abs=0.02 * (high - low))
        primary, secondary = (elbow(world, name) for name in MUSCLES[:2])
        assert sorted(primary) == pytest.approx([52.8, 85.5], rel=0.05)
        assert sorted(secondary) == pytest.approx([17.7, 54.7], rel=0.05)


# 40 Hz ln(1 + 20 f) at half of the largest force is 95.9 Hz; a step of it begins at 1.7 of that, is at 1.186 after 1 s
# and at 1.049 after 5.
def test_the_tendon_organ_responds_to_a_pulling_motor():
    with stiff(untouched("mimo_location")) as world:
        assert elbow(world, MUSCLES[2]).tolist() == [0, 0]
        number = next(i for i, name in enumerate(world.action_names) if "right_elbow" in name)
        action = np.zeros(len(world.action_names), np.float32)
        action[number] = 0.5 * world.action_high[number]
        last = 40 * np.log1p(20 * 0.5)
        for steps, part in ((1, 1.7), (200, 1.186), (800, 1.049)):
            for _ in range(steps):
                world.step(action)
            silent, pulling = sorted(elbow(world, MUSCLES[2]))
            assert silent == 0
            assert pulling == pytest.approx(part * last, rel=0.05)
