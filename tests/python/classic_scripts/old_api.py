"""From the days of gym: reset returns the observation, step four results."""

import gym
import mimoEnv  # noqa: F401
import numpy as np

env = gym.make("MIMoSelfBody-v0")
env.seed(5)
obs = env.reset()
print("touch", obs["touch"].shape, "target", int(np.flatnonzero(obs["desired_goal"])[0]))
total, done, step = 0.0, False, 0
while not done:
    obs, reward, done, info = env.step(env.action_space.sample())
    total += reward
    step += 1
print("steps", step, "cut", info["TimeLimit.truncated"], isinstance(env.observation_space, gym.spaces.Dict))
