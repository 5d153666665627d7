"""Muscles: their curves, as the infant's elbow measures them, and a movement under torque, position and muscle control.

python muscles.py [FOLDER]        # pictures go there, by default to the current folder
"""

import sys
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import mimo

folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
JOINT, MOTOR = "robot:right_elbow", "act:right_elbow"
PULLS, PUSHES = MOTOR + "/negative", MOTOR + "/positive"
MODELS = {"MIMo": mimo.Actuation.MUSCLE, "MuJoCo": mimo.Actuation.MUJOCO_MUSCLE}
PEAK, FASTEST = 35.43, 1.566  # of the muscle that bends the elbow, as the model says


def weightless(actuation):
    world = mimo.World(
        "free", vision=False, touch=False, actuation=actuation, disable=mimo.Disable.GRAVITY | mimo.Disable.CONTACT
    )
    world.reset(seed=0)
    return world


def forces(world, angle, velocity=0.0):
    """What both muscles of the elbow would pull with, at an angle and a velocity of the joint."""
    elbow = world.joints(JOINT)
    elbow.position, elbow.velocity = [angle], [velocity]
    felt = world.observe()["proprioception/muscle_force"]
    return np.array([felt[world.action_names.index(name)] for name in (PULLS, PUSHES)])


# 1. Curves: the joint is put to angles (also beyond its range) and velocities, at full activation and at none.
low, high = weightless(mimo.Actuation.TORQUE).joints(JOINT).range[0]
lengths, velocities = np.linspace(0.4, 1.7, 131), np.linspace(-1.2, 0.6, 91)
slope = 0.3 / (high - low)  # lengths go from 0.75 to 1.05 over the range of motion
angles = low + (lengths - 0.75) / slope
best = low + 0.25 / slope
figure, axes = plt.subplots(1, 3, figsize=(11, 3.2), layout="constrained")
for name, model in MODELS.items():
    world = weightless(model)
    passive = np.array([forces(world, angle)[0] for angle in angles]) / PEAK
    rise = [world.step(np.ones(len(world.action_names))).observation["proprioception/activation"][0] for _ in range(15)]
    total = np.array([forces(world, angle)[0] for angle in angles]) / PEAK
    moving = np.array([forces(world, best, FASTEST * v / slope)[0] for v in velocities]) / PEAK
    fall = [
        world.step(np.zeros(len(world.action_names))).observation["proprioception/activation"][0] for _ in range(35)
    ]
    (line,) = axes[0].plot(lengths, total - passive, label=f"{name}, active")
    axes[0].plot(lengths, passive, ":", color=line.get_color(), label=f"{name}, passive")
    axes[1].plot(velocities, moving, label=name)
    axes[2].plot(np.arange(1, 51) * 0.01, rise + fall, label=name)
axes[0].set(xlabel="length", ylabel="force / peak force", ylim=(0, 1.4))
axes[0].axvspan(0.75, 1.05, alpha=0.15, label="range of motion")
axes[1].set(xlabel="velocity / fastest shortening (stretch: positive)", ylabel="force / peak force")
axes[2].set(xlabel="time (s)", ylabel="activation; told 1 until 0.15 s")
for axis, place in zip(axes, ("upper left", "upper left", "upper right")):
    axis.legend(fontsize="x-small", loc=place)
figure.savefig(folder / "muscle_curves.png", dpi=120)

# 2. The elbow bends to -70 degrees; from 4 s to 4.2 s something pushes it back with 1 Nm.
goal = np.deg2rad(-70)
spring = 0.13 * (goal - np.deg2rad(-20))  # what the joint's spring gives against it, Nm


def balanced(world, strength):
    """Activations of both muscles with which the elbow rests at the goal: their forces are then equal."""
    for _ in range(30):
        world.step(np.ones(len(world.action_names)))
    pull, push = forces(world, goal)
    world.reset(seed=0)
    action = np.zeros(len(world.action_names))
    action[world.action_names.index(PULLS)] = strength * push / pull
    action[world.action_names.index(PUSHES)] = strength
    return action


def one_command(world, value):
    action = np.zeros(len(world.action_names))
    action[world.action_names.index(MOTOR)] = value
    return action


ways = {
    "torque": (mimo.Actuation.TORQUE, lambda world: one_command(world, spring / 3.6)),
    "position": (mimo.Actuation.POSITION, lambda world: one_command(world, goal)),
    "muscles, both at 0.1": (mimo.Actuation.MUSCLE, lambda world: balanced(world, 0.1)),
    "muscles, both at 0.8": (mimo.Actuation.MUSCLE, lambda world: balanced(world, 0.8)),
}
times = np.arange(1, 701) * 0.01
figure, axis = plt.subplots(figsize=(7, 3.6), layout="constrained")
for name, (actuation, command) in ways.items():
    world = weightless(actuation)
    action, elbow, angles = command(world), world.joints(JOINT), []
    for time in times:
        elbow.force = [1.0 if 4 < time <= 4.2 else 0.0]
        world.step(action)
        angles.append(np.rad2deg(elbow.position[0]))
    axis.plot(times, angles, label=name)
    print(f"{name:22s} at {angles[399]:6.1f} degrees, pushed to {max(angles[400:]):6.1f}")
axis.axvspan(4, 4.2, alpha=0.15)
axis.set(xlabel="time (s)", ylabel="elbow (degrees)")
axis.legend()
figure.savefig(folder / "muscle_movement.png", dpi=120)
