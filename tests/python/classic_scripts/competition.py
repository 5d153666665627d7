"""An entry to the competition: a YAML file, the kit's functions, an intrinsic reward, its logs."""

import argparse
import sys

import gymnasium as gym
import mimoEnv  # noqa: F401
import mimoEnv.utils as env_utils
import numpy as np
import yaml

sys.path.append(".")
sys.path.append("..")
import babybench.utils as bb_utils


class Wrapper(gym.Wrapper):
    def __init__(self, env):
        super().__init__(env)
        self.geoms = [
            g
            for b in env_utils.get_child_bodies(self.model, self.model.body("hip").id)
            for g in env_utils.get_geoms_for_body(self.model, b)
        ]
        self.sensors = sum(len(it) for it in env.touch.sensor_positions.values())

    def compute_intrinsic_reward(self, obs):
        return np.sum(obs["touch"] > 1e-6) / len(obs["touch"])

    def step(self, action):
        obs, extrinsic, terminated, truncated, info = self.env.step(action)
        return obs, self.compute_intrinsic_reward(obs) + extrinsic, terminated, truncated, info


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--config", default="config.yml")
    parser.add_argument("--train_for", default=12, type=int)
    args = parser.parse_args()
    with open(args.config) as f:
        config = yaml.safe_load(f)
    env = Wrapper(bb_utils.make_env(config))
    env.reset()
    rewards = []
    for _ in range(args.train_for):
        _, reward, terminated, truncated, info = env.step(env.action_space.sample())
        rewards.append(reward)
        if terminated or truncated:
            env.reset()
    print("geoms", len(env.geoms), "sensors", env.sensors, "reward", bool(0 <= np.mean(rewards) <= 1))
    print("info", sorted(info), "picture", bb_utils.render(env.unwrapped, "top").shape)
    env.close()


if __name__ == "__main__":
    main()
