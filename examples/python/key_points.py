"""From a video's key points to joint angles: a kick is seen by a camera and fitted to an infant of six months.

The camera's points come from a simulation here, with noise as pose estimation has it; yours come from a file:
mimo.motion.fit("film", rate=30, camera=CAMERA).
"""

import numpy as np

import mimo
from mimo.constants import Quantity

NAMES = [f"{side}_{joint}" for side in ("left", "right") for joint in ("upper_leg", "lower_leg", "foot", "toes")]
NAMES += ["hip", "head", "left_upper_arm", "right_upper_arm", "left_hand", "right_hand"]  # bodies: their origins
CAMERA = mimo.motion.Camera.pinhole(40, 1280, 720, position=(0.6, -1.6, 0.6), look_at=(0, 0, 0.4))


def infant():
    scene = mimo.Scene("free")
    scene.add_agent(age=6, vision=False, touch=False)
    world = mimo.World(scene)
    world.reset(seed=0)
    return world


def filmed(frames):
    """A kick of the right leg, as pixels."""
    rng = np.random.default_rng(0)
    with infant() as world:
        pixels = []
        for bend in 0.6 * np.sin(np.linspace(0, np.pi, frames)) ** 2:
            world.set(Quantity.JOINT_POSITION, [-2 * bend, -bend], ["robot:right_hip1", "robot:right_knee"])
            points = world.get(Quantity.BODY_POSITION, NAMES, now=True)
            pixels.append(CAMERA.project(points) + rng.normal(0, 1, (len(NAMES), 2)))
    values = np.array(pixels)
    return mimo.motion.KeyPoints(0.04 * np.arange(frames), NAMES, values, np.ones(values.shape[:2]))


points = filmed(frames=15)
found = mimo.motion.fit(points, CAMERA, age=6, cutoff=6)
print(f"points are {np.median(found.errors):.1f} pixels off, at most {found.errors.max():.1f}")
knee = found.positions[:, found.columns.index("robot:right_knee")]
print(f"the right knee bent by {np.degrees(knee.max() - knee.min()):.0f} degrees, of 34")
found.write("motion.csv")
print("what it senses: mimo replay --motion motion.csv --scene free --age 6 --senses all")
