"""What nerves tell of the stimuli with which receptors are measured, beside the values of the literature.

python receptors.py [FOLDER]        # the picture goes there, by default to the current folder

Every panel is a small model of its own: a palm under a probe, a head on a hinge, an arm with a motor, a ball on a
table.
"""

import sys
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import mimo

folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
TICK = 0.005  # s
PALM = """<body name="skin"><geom type="box" size=".05 .05 .01"/></body>
  <body name="probe" pos="0 0 .01999"><joint type="slide" axis="0 0 1" damping="20"/>
  <geom size=".01" mass=".2"/></body>"""
HEAD = '<body name="head"><joint name="turn" axis="{}"/><geom size=".07"/></body>'
ARM = """<body name="arm"><joint name="elbow" axis="0 1 0" range="-1 1" limited="true" damping="1"/>
  <geom type="capsule" fromto="0 0 0 .2 0 0" size=".02"/></body>"""
MOTOR = '<actuator><motor name="act:elbow" joint="elbow" ctrlrange="-1 1" ctrllimited="true"/></actuator>'
TABLE = """<body name="table"><geom type="box" size="1 1 .1" pos="0 0 -.1"/></body>
  <body name="skin" pos="0 0 .0999"><freejoint/><geom size=".1"/></body>"""


def world_of(bodies, root, actuators="", set_up=None, **senses):
    """A world whose agent is a body of a document of one's own, with these senses alone."""
    options = f'<compiler angle="radian"/><option timestep="{TICK}"/>'
    xml = f"<mujoco>{options}<worldbody>{bodies}</worldbody>{actuators}</mujoco>"
    scene = mimo.Scene(xml=xml)
    none = {"vision": False, "touch": False, "vestibular": False, "proprioception": 0}
    scene.add_agent(body="scene", root=root, **{**none, **senses})
    if set_up:
        set_up(scene)
    world = mimo.World(scene, frame_skip=1)
    world.reset(seed=0)
    return world


def press():
    """SA1, RA and PC of a palm that a probe presses 1 mm deep at 10 mm/s, holds and lets go: its weight does it."""
    half = 3.0  # N, press such skin by half of 3 mm: 0.3 N a millimetre of the sensors' spacing
    receptors = mimo.Touch.SA1 | mimo.Touch.RA | mimo.Touch.PC
    world = world_of(
        PALM, "skin", touch=receptors, touch_response=1, set_up=lambda scene: scene.set_touch("skin", 0.01)
    )
    times = np.arange(0, 1.4, TICK)
    rates = []
    for depth in np.interp(times, [0.3, 0.4, 0.9, 1.0], [0.02, 1, 1, 0.02]):
        world.gravity = [0, 0, -half * depth / (3 - depth) / 0.2]
        seen = world.step().observation
        rates.append([seen[f"touch/{name}"].max() for name in ("sa1", "ra", "pc")])
    return times, np.array(rates)


def yaw(seconds):
    """Left and right horizontal canals, regular: 60 degrees a second for 20 s, then nothing."""
    world = world_of(HEAD.format("0 0 1"), "head", vestibular=mimo.Vestibular.CANALS, vestibular_at="head")
    turn = world.joints("turn")
    rates = []
    for time in np.arange(0, seconds, TICK):
        turn.velocity = np.deg2rad(60) if time < 20 else 0
        rates.append(world.step().observation["vestibular/canals"][[1, 4], 0])
    return np.arange(0, seconds, TICK), np.array(rates)


def tilt(degrees):
    """The left utricle's outward and its saccule's upward afferents, 40 s after the head was put to its side."""
    world = world_of(HEAD.format("1 0 0"), "head", vestibular=mimo.Vestibular.OTOLITHS, vestibular_at="head")
    world.joints("turn").position = np.deg2rad(degrees)
    for _ in range(round(40 / TICK)):
        world.step_into(None)
    seen = world.observe()["vestibular/otoliths"]
    return seen[0, 0, 1, 0], seen[0, 1, 0, 0]


def spindles(length):
    """Ia and II of the muscle that pulls to the positive side, held at a length."""
    kinds = mimo.Proprioception.SPINDLE_PRIMARY | mimo.Proprioception.SPINDLE_SECONDARY
    world = world_of(ARM, "arm", MOTOR, proprioception=kinds)
    world.gravity = [0, 0, 0]
    for _ in range(400):
        world.joints("elbow").position = 1 - 2 * (length - 0.8) / 0.3  # shortest where it has pulled all it can
        world.joints("elbow").velocity = 0
        world.step_into(None)
    seen = world.observe()
    return seen["proprioception/spindle_primary"][1], seen["proprioception/spindle_secondary"][1]


def pull(seconds):
    """The tendon organ of a muscle that begins to pull with half its force."""
    world = world_of(ARM, "arm", MOTOR, proprioception=mimo.Proprioception.TENDON_ORGAN)
    field = "proprioception/tendon_organ"
    return np.array([world.step([0.5]).observation[field].max() for _ in range(round(seconds / TICK))])


def touched(material, seconds):
    """Skin of 33 degrees on something of 22."""

    def set_up(scene):
        scene.set_touch("skin", 0.05)
        scene.set_temperature("table", 22)
        scene.set_material("table", material)

    world = world_of(TABLE, "skin", touch=mimo.Touch.TEMPERATURE, set_up=set_up)
    return [world.step().observation["touch/temperature"].min() for _ in range(round(seconds / TICK))]


figure, axes = plt.subplots(2, 3, figsize=(12, 6.4), layout="constrained")
KNOWN = {"marker": "o", "linestyle": "none", "markersize": 5}

panel = axes[0, 0]
times, rates = press()
for index, name in enumerate(("SA1", "RA", "PC")):
    panel.plot(times, rates[:, index], label=name)
panel.plot([0.3, 0.4], [68, 68], "o-", color="tab:blue", markersize=5)  # the mean of the ramp
panel.plot([0.3, 0.4], [32, 32], "o-", color="tab:orange", markersize=5)
panel.plot([0.65], [44], color="tab:blue", **KNOWN)
panel.set(title="skin pressed 1 mm deep at 10 mm/s", xlabel="s", ylabel="Hz", xlim=(0.2, 1.2))

panel = axes[0, 1]
times, rates = yaw(30)
panel.plot(times, rates[:, 0], label="left horizontal canal")
panel.plot(times, rates[:, 1], label="right")
at, above = np.array([[0.005, 1, 5.7, 11.4, 17.1], [26.18, 21.98, 9.64, 3.55, 1.30]])
panel.plot(at, 90 + 0.948 * above, color="tab:blue", **KNOWN)
panel.plot(at, 90 - 0.944 * above, color="tab:orange", **KNOWN)
panel.set(title="60 degrees/s to the left for 20 s", xlabel="s", ylabel="Hz")

panel = axes[0, 2]
degrees = np.arange(0, 91, 10)
told = np.array([tilt(one) for one in degrees])
panel.plot(degrees, told[:, 0], label="left utricle, outward")
panel.plot(degrees, told[:, 1], label="left saccule, upward")
panel.plot([0, 30, 60, 90], 70 + 46.2 * np.sin(np.deg2rad([0, 30, 60, 90])), color="tab:blue", **KNOWN)
panel.plot([0, 30, 60, 90], 70 + 46.2 * np.cos(np.deg2rad([0, 30, 60, 90])), color="tab:orange", **KNOWN)
panel.set(title="on the right ear", xlabel="degrees", ylabel="Hz")

panel = axes[1, 0]
lengths = np.linspace(0.8, 1.1, 13)
told = np.array([spindles(length) for length in lengths])
panel.plot(lengths, told[:, 0], label="spindle, Ia")
panel.plot(lengths, told[:, 1], label="spindle, II")
panel.plot([0.8, 0.9, 1.0, 1.1], [22.4, 52.8, 85.5, 118.2], color="tab:blue", **KNOWN)
panel.plot([0.8, 0.9, 1.0, 1.1], [0, 17.7, 54.7, 91.6], color="tab:orange", **KNOWN)
panel.set(title="muscles that are held", xlabel="length / optimal length", ylabel="Hz")

panel = axes[1, 1]
panel.plot(np.arange(TICK, 10 + TICK / 2, TICK), pull(10), label="tendon organ")
at, share = np.array([[0.005, 0.1, 0.5, 1, 2, 5, 10], [1.7, 1.595, 1.329, 1.186, 1.1, 1.049, 1.018]])
panel.plot(at, 95.9 * share, color="tab:blue", **KNOWN)
panel.set(title="half of the largest force", xlabel="s", ylabel="Hz")

panel = axes[1, 2]
for material, known in {"copper": (30.71, 27.85), "plastic": (31.52, 30.79), "hardwood": (31.69, 31.17)}.items():
    degrees = touched(material, 11)
    (line,) = panel.plot(np.arange(len(degrees)) * TICK, degrees, label=material)
    panel.plot([1, 10], known, color=line.get_color(), **KNOWN)
panel.set(title="skin on things of 22 degrees", xlabel="s", ylabel="degrees Celsius")

for panel in axes.flat:
    panel.legend(fontsize="small")
    panel.grid(alpha=0.3)
figure.suptitle("lines: libmimo, points: the literature's values", fontsize="medium")
figure.savefig(folder / "receptors.png", dpi=90)
print(f"{folder / 'receptors.png'} is drawn")
