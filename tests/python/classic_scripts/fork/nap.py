"""A fork of the competition's environments: those of the fork run, not this package's."""

import gymnasium as gym
import mimoEnv  # noqa: F401
import numpy as np
from mimoEnv.babybench import BabyBenchNapEnv

gym.register(id="BabyBench-Nap", entry_point=BabyBenchNapEnv, max_episode_steps=20)
env = gym.make("BabyBench-Nap", config={"settle": 100})
env.reset()
for _ in range(5):
    _, _, _, _, info = env.step(np.zeros(env.action_space.shape))
print(BabyBenchNapEnv.__module__, "steps", round(env.data.time / env.dt), "touches", info["touching"] > 0)
