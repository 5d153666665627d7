"""A tour: an infant in a room moves at random; what it sees, feels and how its joints move become pictures.

python tutorial.py [FOLDER]        # pictures go there, by default to the current folder
"""

import sys
from pathlib import Path

import numpy as np

import mimo
import mimo.plot

folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")

# 1. A world: the scene with two toys in which the paper measures. Eyes and skin are coarse here, to be quick.
world = mimo.World("benchmark", vision_width=128, vision_height=128, touch_scale=0.5)
infant = world.agents[0]
print(f"an infant of {infant.mass:.1f} kg and {infant.height:.2f} m with {len(world.action_names)} motors")

# 2. What it senses: fields with shapes, units and bounds.
for name, field in world.layout.fields.items():
    print(f"  {name:32s} {field.dtype!s:8s} {field.shape!s:16s} {field.unit}")

# 3. A second of random movements. Joints are looked up once, and read after every step.
arm = world.joints("robot:right_shoulder_horizontal", "robot:right_elbow", "robot:left_elbow", "robot:head_tilt")
random = np.random.default_rng(0)
times, angles = [], []
world.reset(seed=0)
for step in range(100):
    if step % 10 == 0:
        action = random.uniform(world.action_low, world.action_high)
    result = world.step(action)
    times.append(world.time)
    angles.append(arm.position)

# 4. Pictures.
mimo.plot.eyes(result.observation).savefig(folder / "eyes.png")
mimo.plot.touch_map(world).savefig(folder / "touch.png")
mimo.plot.joint_angles(times, angles, arm).savefig(folder / "joints.png")

# 5. What presses on the skin, and where.
force = np.linalg.norm(result.observation["touch/force"], axis=-1)
skin = world.layout.receptors("touch/force")
for body in np.unique(skin.bodies[force > 0]):
    strongest = force[skin.bodies == body].max()
    print(f"  {world.name(mimo.Kind.BODY, int(body)):16s} feels up to {strongest:.2f} N")

# 6. Back to the present, as often as one likes: two futures of the same state.
present = world.save()
for sign in (-1, 1):
    world.load(present)
    for _ in range(20):
        world.step(sign * world.action_high)
    print(f"  with all motors at {sign:+d}, the head is at {world.bodies('head').position[0].round(3)}")
