"""How what nerves tell depends on the physics step: a table in Markdown, and a picture.

python receptor_steps.py [FOLDER]        # the picture goes there, by default to the current folder

The same stimuli as receptors.py has, and some more, at steps of 5, 2.5, 1 and 0.5 ms.
"""

import sys
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import mimo

STEPS = (0.005, 0.0025, 0.001, 0.0005)  # s
HALF = 3.0  # N, press skin of sensors 10 mm apart by half of 3 mm
SKIN = mimo.Touch.SA1 | mimo.Touch.RA | mimo.Touch.PC | mimo.Touch.SA2
PROBE = """<body name="skin"><geom type="box" size=".05 .05 .01"/></body>
  <body name="probe" pos="0 0 {}"><joint type="slide" axis="0 0 1" damping="{}"/><geom size="{}" mass=".2"/></body>"""
BELT = """<body name="belt"><joint name="x" type="slide" axis="1 0 0"/>
    <geom type="box" size=".3 .05 .01" mass="5" friction="{0} .005 .0001" condim="{1}"/></body>
  <body name="skin" pos="0 0 .0199"><joint type="slide" axis="0 0 1"/>
    <geom size="{2}" pos="0 0 {3}" mass=".2" friction="{0} .005 .0001" condim="{1}"/></body>"""
HEAD = '<body name="head"><joint name="turn" axis="0 0 1"/><geom size=".07"/></body>'
ARM = """<body name="arm"><joint name="elbow" axis="0 1 0" range="-1 1" limited="true" damping="1"/>
  <geom type="capsule" fromto="0 0 0 .2 0 0" size=".02"/></body>"""
MOTOR = '<actuator><motor name="act:elbow" joint="elbow" ctrlrange="-1 1" ctrllimited="true"/></actuator>'


def world_of(step, bodies, root, actuators="", set_up=None, **senses):
    """A world in such steps whose agent is a body of a document of one's own, with these senses alone."""
    options = f"""<compiler angle="radian"/>
      <option timestep="{step}" cone="elliptic" solver="Newton" iterations="50" tolerance="1e-10"/>"""
    scene = mimo.Scene(xml=f"<mujoco>{options}<worldbody>{bodies}</worldbody>{actuators}</mujoco>")
    none = {"vision": False, "touch": False, "vestibular": False, "proprioception": 0}
    scene.add_agent(body="scene", root=root, **{**none, **senses})
    if set_up:
        set_up(scene)
    world = mimo.World(scene, frame_skip=1)
    world.reset(seed=0)
    return world


def skin_world(step, bodies, senses=SKIN, celsius=33, material="plastic"):
    def set_up(scene):
        scene.set_touch("skin", 0.01)
        thing = "belt" if "belt" in bodies else "probe"
        scene.set_temperature(thing, celsius)
        scene.set_material(thing, material)

    return world_of(step, bodies, "skin", touch=senses, touch_response=1, set_up=set_up)


def seen(world, *names):
    return [world.observation[f"touch/{name}"].max() for name in names]


def pressed(step, depth_at, seconds, damping=20):
    """SA1, RA and PC over time of a palm that a probe presses so deep, mm: its weight does it."""
    world = skin_world(step, PROBE.format(0.01999, damping, 0.01))
    rates = []
    for time in np.arange(0, seconds, step):
        depth = depth_at(time)
        world.gravity = [0, 0, -HALF * depth / (3 - depth) / 0.2]
        world.step()
        rates.append(seen(world, "sa1", "ra", "pc"))
    return np.array(rates)


def ramp(step):
    told = pressed(step, lambda time: np.interp(time, [0.3, 0.4, 0.9, 1.0], [0.02, 1, 1, 0.02]), 1.4)
    times = np.arange(len(told)) * step
    on, held = (times >= 0.3) & (times < 0.4), (times > 0.75) & (times < 0.85)
    return {
        "SA1, 1 mm held": told[held, 0].mean(),
        "SA1, pressed at 10 mm/s": told[on, 0].mean(),
        "RA, pressed at 10 mm/s": told[on, 1].mean(),
        "RA, 1 mm held": told[held, 1].max(),
        "PC, 1 mm held": told[held, 2].max(),
        "PC, spikes of press and release": told[:, 2].sum() * step,
    }


def vibration(step, frequency):
    told = pressed(step, lambda time: 1 + 0.25 * np.sin(2 * np.pi * frequency * time), 2, damping=2)
    late = told[len(told) // 2 :].mean(axis=0)
    return {f"RA, 0.25 mm at {frequency} Hz": late[1], f"PC, 0.25 mm at {frequency} Hz": late[2]}


def drop(step):
    """A ball that falls 2 cm on a palm."""
    world = skin_world(step, PROBE.format(0.04, 0, 0.01))
    told = []
    for _ in range(round(0.5 / step)):
        world.step()
        told.append(seen(world, "ra", "pc"))
    told = np.array(told)
    return {
        "RA, spikes of a ball that drops": told[:, 0].sum() * step,
        "PC, spikes of a ball that drops": told[:, 1].sum() * step,
    }


def belt(step, friction, material, speed=0.1):
    """A means of the last of two seconds, and all of the normal force's course."""
    bodies = BELT.format(max(friction, 1e-3), 3 if friction > 0 else 1, 0.01, 0)
    world = skin_world(step, bodies, SKIN | mimo.Touch.NORMAL_FORCE, material=material)
    slide = world.joints("x")
    told = []
    for _ in range(round(2 / step)):
        slide.position, slide.velocity = -0.1, speed
        world.step()
        told.append([*seen(world, "sa1", "ra", "pc", "sa2", "force")])
    return np.array(told)


def sliding(step):
    found = {}
    for name, friction, material in (
        ("smooth, no friction", 0, "plastic"),
        ("smooth, friction 0.3", 0.3, "plastic"),
        ("smooth, friction 1", 1, "plastic"),
        ("cloth, friction 1", 1, "cotton"),
    ):
        told = belt(step, friction, material)
        late = told[len(told) // 2 :]
        for column, kind in enumerate(("SA1", "RA", "PC")):
            found[f"{kind}, 0.1 m/s, {name}"] = late[:, column].mean()
        if friction == 1 and material == "plastic":
            found["SA2, 0.1 m/s, smooth, friction 1"] = late[:, 3].mean()
            found["share of steps in contact there, %"] = 100 * (late[:, 4] > 0).mean()
    return found


def warmth(step):
    kinds = mimo.Touch.TEMPERATURE | mimo.Touch.COLD
    world = skin_world(step, PROBE.format(0.0199, 20, 0.01), kinds, celsius=10, material="copper")
    for _ in range(round(1 / step)):
        world.step()
    return {
        "skin on copper of 10 degrees after 1 s, degrees": world.observation["touch/temperature"].min(),
        "cold receptors on copper of 10 degrees": world.observation["touch/cold"].max(),
    }


def pain(step):
    kinds = mimo.Touch.NOCICEPTION_FAST | mimo.Touch.NOCICEPTION_SLOW
    world = skin_world(step, PROBE.format(0.0104, 20, 0.0005), kinds)
    for _ in range(round(2 / step)):
        world.step()
    fast, slow = seen(world, "nociception_fast", "nociception_slow")
    world = skin_world(step, BELT.format(1, 3, 0.0005, -0.0095), kinds)
    slides = []
    for _ in range(round(2 / step)):
        world.joints("x").position, world.joints("x").velocity = -0.1, 0.1
        world.step()
        slides.append(seen(world, "nociception_fast", "nociception_slow"))
    late = np.mean(slides[len(slides) // 2 :], axis=0)
    return {
        "nociceptors, 2 N on a tip of 0.5 mm for 2 s, fast": fast,
        "nociceptors there, slow": slow,
        "nociceptors, the same tip slides at 0.1 m/s with friction 1, fast": late[0],
        "nociceptors, slow, while it slides": late[1],
    }


def balance(step):
    found = {}
    for frequency in (1, 5, 10):
        kinds = mimo.Vestibular.CANALS | mimo.Vestibular.OTOLITHS
        world = world_of(step, HEAD, "head", vestibular=kinds, vestibular_at="head")
        omega = 2 * np.pi * frequency
        canals, otoliths = [], []
        for time in np.arange(0, 2, step):
            world.joints("turn").velocity = np.deg2rad(20) * np.sin(omega * time)
            world.gravity = [0, 0.981 * np.sin(omega * time), 0]  # a head that is shaken feels the same
            told = world.step().observation
            canals.append(told["vestibular/canals"][1, 0])
            otoliths.append(told["vestibular/otoliths"][0, 0, 1, 0])
        late = slice(len(canals) // 2, None)
        found[f"canal, regular, 20 degrees/s at {frequency} Hz: amplitude"] = np.ptp(canals[late]) / 2
        found[f"otolith, regular, 0.1 g at {frequency} Hz: amplitude"] = np.ptp(otoliths[late]) / 2
    return found


def muscles(step):
    kinds = mimo.Proprioception.SPINDLE_PRIMARY | mimo.Proprioception.SPINDLE_SECONDARY
    kinds |= mimo.Proprioception.TENDON_ORGAN
    world = world_of(step, ARM, "arm", MOTOR, proprioception=kinds)
    world.gravity = [0, 0, 0]

    def stretch(length, speed):  # L0 and L0/s of the muscle that pulls to the negative side
        world.joints("elbow").position = -1 + 2 * (length - 0.8) / 0.3
        world.joints("elbow").velocity = 2 * speed / 0.3
        return world.step([0]).observation

    for _ in range(round(3 / step)):
        stretch(0.95, 0)
    for time in np.arange(0, 0.13 / 0.66, step):
        told = stretch(0.95 + 0.66 * time, 0.66)
    found = {
        "Ia, end of a ramp of 0.66 L0/s": told["proprioception/spindle_primary"][0],
        "II, end of a ramp of 0.66 L0/s": told["proprioception/spindle_secondary"][0],
    }
    world.reset(seed=0)
    for time in (0.1, 1.0):
        while world.time < time - step / 2:
            world.step([0.5])
        organs = world.observation["proprioception/tendon_organ"]
        found[f"tendon organ, {time:g} s after half of the force"] = organs.max()
    return found


def rates(step):
    """All that is told at a physics step, by name."""
    found = {
        **ramp(step),
        **vibration(step, 20),
        **vibration(step, 40),
        **vibration(step, 80),
        **drop(step),
        **sliding(step),
    }
    return {**found, **warmth(step), **pain(step), **balance(step), **muscles(step)}


def table(by_step):
    lines = ["| " + " | ".join(["Hz", *(f"{1e3 * step:g} ms" for step in STEPS)]) + " |", "|---" * 5 + "|"]
    for name in by_step[0]:
        lines.append("| " + " | ".join([name, *(f"{found[name]:.1f}" for found in by_step)]) + " |")
    return "\n".join(lines)


def draw(by_step, file):
    """Every rate over that at the finest step."""
    figure, axes = plt.subplots(figsize=(9, 5), layout="constrained")
    apart = []
    for name, last in by_step[-1].items():
        if last < 1 or "%" in name or "degrees after" in name:
            continue
        shares = [found[name] / last for found in by_step]
        off = max(abs(share - 1) for share in shares) > 0.05
        axes.plot([1e3 * step for step in STEPS], shares, "o-", color="tab:red" if off else "0.6", lw=1, ms=4)
        if off:
            apart.append((shares[0], name))
    at = -np.inf
    for share, name in sorted(apart):
        at = max(share, at + 0.02)
        axes.annotate(name, (5, share), (5.5, at), fontsize="small", va="center")
    axes.axhspan(0.95, 1.05, color="tab:green", alpha=0.15)
    axes.set(xscale="log", xlabel="physics step, ms", ylabel="rate over that at 0.5 ms", xlim=(0.45, 22))
    axes.set_xticks([0.5, 1, 2.5, 5], ["0.5", "1", "2.5", "5"], minor=False)
    axes.set_xticks([], minor=True)
    figure.savefig(file, dpi=90)


if __name__ == "__main__":
    folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
    found = [rates(step) for step in STEPS]
    print(table(found))
    draw(found, folder / "receptor_steps.png")
