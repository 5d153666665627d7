"""Imports everything from the original's modules, and keeps an environment in several wrappers."""

import gymnasium as gym
from gymnasium.wrappers import ClipAction, RecordEpisodeStatistics
from mimoEnv.envs import *  # noqa: F403
from mimoEnv.envs.mimo_env import *  # noqa: F403
from mimoEnv.utils import *  # noqa: F403


class Watching(gym.Wrapper):
    def reset(self, **kwargs):
        obs, info = self.env.reset(**kwargs)
        self.height = get_body_position(self.data, "head")[2]  # noqa: F405
        return obs, info


env = Watching(
    ClipAction(RecordEpisodeStatistics(gym.make("MIMoSelfBody-v0", render_mode="rgb_array", width=64, height=48)))
)
env.reset(seed=1)
print(issubclass(MIMoSelfBodyEnv, MIMoEnv), sorted(DEFAULT_VESTIBULAR_PARAMS), 0.2 < env.height < 0.5)  # noqa: F405
print(
    env.touch.get_total_sensor_count(),
    env.render().shape,
    env.dt,
    env.model.body(env.target_body).name == env.target_body,
)
