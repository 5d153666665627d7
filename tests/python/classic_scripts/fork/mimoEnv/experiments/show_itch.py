"""Lies within the fork's package, which its users have installed with pip -e: packages beside it can be imported."""

import gymnasium as gym
import mimoEnv  # noqa: F401
from itchTools import scratch
from mimoEnv.envs.itch import ITCH_XML

env = gym.make("MIMoItch-v0")
env.reset(seed=1)
print("scratched", scratch.count(env), ITCH_XML.endswith("fork/mimoEnv/assets/itch_scene.xml"))
