"""Reflexes of an infant of one month, who floats and commands nothing.

Its head is turned to the left and to the right, a rod is pressed into its palm and then pulled at, its head drops back.

python reflexes.py [FOLDER]        # the picture goes there, by default to the current folder
"""

import sys
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import mimo

folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
REFLEXES = ["palmar_grasp", "moro", "asymmetric_tonic_neck"]
JOINTS = {
    "left elbow": "robot:left_elbow",
    "right elbow": "robot:right_elbow",
    "left middle finger": "robot:left_mf_knuckle",
    "right shoulder, abduction": "robot:right_shoulder_ad_ab",
}
ARM = ("shoulder_horizontal", "shoulder_ad_ab", "shoulder_rotation", "elbow", "hand1", "hand2", "hand3")
LEFT, RIGHT, PRESS, PULL, DROP, END = 1.0, 4.0, 7.5, 8.5, 10.5, 13.0  # seconds
LONG = 2.0  # that the head is turned
TICK = 0.005

scene = mimo.Scene("free")
scene.add_object("rod", shape=mimo.Shape.CAPSULE, size=[0.005, 0.03], mass=0.005, position=[0, 3, 1])
scene.add_agent(
    body="fingers", age=1, vision=False, touch=False, reflexes=REFLEXES, place=mimo.Place.ROOT, position=[0, 0, 1.5]
)
world = mimo.World(scene, frame_skip=1)
world.set(mimo.Quantity.WORLD_GRAVITY, np.zeros((1, 3)))
world.reset(seed=0)
swivel, tilt = world.joints("robot:head_swivel"), world.joints("robot:head_tilt")
hand, rod = world.bodies("left_hand"), world.bodies("rod")
arm, shown = world.joints(*("robot:left_" + name for name in ARM)), world.joints(*JOINTS.values())


def rotation(quaternion):
    w, x, y, z = quaternion
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def turned(time, start):
    """How far the head is turned, slowly there and slowly back, 0 to 1."""
    return float(np.clip(min((time - start) / 0.5, (start + LONG + 0.5 - time) / 0.5), 0, 1))


def lay_rod():
    """The arm is held, and the rod lies across the palm, which looks along the hand's y axis."""
    arm.lock = np.column_stack([np.ones(len(arm)), arm.position])
    w, x, y, z = hand.orientation[0]
    rod.orientation = [np.array([w - y, x - z, w + y, x + z]) * np.sqrt(0.5)]  # a quarter turn about y
    rod.position = hand.position + rotation(hand.orientation[0]) @ [0, 0.013, 0.022]


def direct(time):
    """What is done to the infant in the step that ends then."""
    swivel.lock = [[1.0, np.deg2rad(60 * (turned(time, LEFT) - turned(time, RIGHT)))]]
    if abs(time - PRESS) < TICK / 2:
        lay_rod()
    frame = rotation(hand.orientation[0])
    push = frame @ ([0, -0.3, 0] if time < PULL else [0, 0, 0.5])  # into the palm; along the fingers
    rod.force = [[*(push if PRESS <= time < DROP else np.zeros(3)), 0, 0, 0]]
    if time >= DROP:
        tilt.lock = [[1.0, np.deg2rad(-30 * min(1.0, (time - DROP) / 0.15))]]


# The springs of its joints bend it; half a minute later whatever that set off is forgotten.
tilt.lock = [[1.0, 0.0]]
for _ in range(round(35 / TICK)):
    world.step()
labels = world.layout.fields["reflex/activation"].labels
times, activations, angles, away = np.arange(1, round(END / TICK) + 1) * TICK, [], [], []
for time in times:
    direct(time)
    activations.append(world.step().observation["reflex/activation"].ravel().copy())
    angles.append(np.rad2deg(shown.position))
    away.append(np.linalg.norm(rod.position - hand.position))
activations, angles = np.array(activations), np.array(angles)

for label, course in zip(labels, activations.T):
    acts = np.flatnonzero(course)
    print(f"{label:30s} " + (f"acts from {times[acts[0]]:.3f} s" if len(acts) else "does nothing"))
print(f"pulled by 0.5 N for 2 s, the rod is {100 * away[round(DROP / TICK) - 2]:.1f} cm from the hand's middle")
figure, (above, below) = plt.subplots(2, 1, figsize=(9, 5.5), sharex=True, layout="constrained")
for label, course in zip(labels, activations.T):
    above.plot(times, course, "--" if label.endswith("right") else "-", label=label)
above.set(ylabel="reflex/activation", ylim=(-0.05, 1.35))
above.legend(fontsize=7, ncol=3, loc="upper center")
for name, course in zip(JOINTS, angles.T):
    below.plot(times, course, label=name)
below.set(xlabel="time (s)", ylabel="joints (degrees)", ylim=(-220, 210))
below.legend(fontsize=7, loc="lower left", ncol=2)
EVENTS = {
    "head left": (LEFT, LEFT + LONG + 0.5),
    "head right": (RIGHT, RIGHT + LONG + 0.5),
    "rod pressed": (PRESS, PULL),
    "pulled by 0.5 N": (PULL, DROP),
    "head drops": (DROP, DROP + 0.15),
}
for i, (what, (start, end)) in enumerate(EVENTS.items()):
    for axis in (above, below):
        axis.axvspan(start, end, alpha=0.12)
        axis.axvline(start, color="gray", linewidth=0.5)
    below.text(start + 0.05, 185 - 25 * (i % 2), what, fontsize=8)
figure.savefig(folder / "reflexes.png", dpi=110)
