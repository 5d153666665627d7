"""What a newcomer does with the installed package: an infant that sees and moves. Prints a hash of what it sensed."""

import hashlib

import mimo
import numpy as np

env = mimo.make("reach", vision=mimo.Vision.RGB, vision_width=32, vision_height=32)
observation, _ = env.reset(seed=7)
total = hashlib.sha256()
for step in range(20):
    action = np.full(env.action_space.shape, ((step * 7) % 21 - 10) / 10, np.float32)
    observation, reward, terminated, truncated, info = env.step(action)
    for name in sorted(observation):
        total.update(np.ascontiguousarray(observation[name]).tobytes())
assert env.observation_space.contains(observation)
print(f"libmimo {mimo.version()} on MuJoCo {mimo.mujoco_version()}: senses {total.hexdigest()[:16]}")
