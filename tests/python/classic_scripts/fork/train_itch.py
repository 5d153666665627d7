"""A fork of the original with an environment, a scene and functions of its own."""

import gymnasium as gym
import mimoEnv
import mimoEnv.utils as env_utils

env = gym.make("MIMoItch-v0")
obs, info = env.reset(seed=4)
print(
    "goal",
    env.model.body(info["desired_goal"]).name,
    "height",
    env.data.qpos[2],
    "elbow",
    env.data.joint("robot:left_elbow").qpos,
)
steps = 0
while True:
    obs, reward, terminated, truncated, info = env.step(env.action_space.sample())
    steps += 1
    if terminated or truncated:
        break
print(
    "steps",
    steps,
    env_utils.get_body_id(env.model, body_name="hip"),
    env_utils.joints_of_motors(env.model)["act:left_elbow"],
)
print(gym.make("MIMoBench-v0", touch_params=None, vision_params=None).unwrapped.__class__.__module__, mimoEnv.__name__)
