"""An experiment of one's own: MIMo is to bring its right hand to its mouth.

The reward, the start and the end of an episode are Python; positions are looked up by name once and read after every
step. The same class serves one world and many: it computes along the last axes. Prints how fast both are.

    python own_experiment.py [--worlds N] [--steps N]
"""

import argparse
import time

import numpy as np

import mimo

MOUTH = np.array([0.075, 0.0, 0.045])  # from the head's origin, m; the head looks ahead here


class HandToMouth(mimo.Task):
    def setup(self, world):
        self.hand_and_head = world.bodies("right_fingers", "head")
        self.elbow = world.joints("robot:right_elbow")

    def reset(self, world, mask):
        low, high = self.elbow.range[..., 0, 0], self.elbow.range[..., 0, 1]
        start = low + (high - low) * world.random(1, mask)[..., 0]
        self.elbow.write("position", start[..., None], mask)

    def evaluate(self, world):
        place = self.hand_and_head.position
        distance = np.linalg.norm(place[..., 0, :] - place[..., 1, :] - MOUTH, axis=-1)
        near = distance < 0.06
        return mimo.Judgement(reward=-distance + near, terminated=near, success=near)


SETTINGS = {
    "task": HandToMouth(),
    "acts": mimo.Act.RIGHT_ARM,
    "actuation": mimo.Actuation.POSITION,
    "normalize_actions": True,
    "max_steps": 100,
}


def run_one(steps):
    env = mimo.make("reach", **SETTINGS)
    env.action_space.seed(0)
    env.reset(seed=0)
    rewards, start = [], time.perf_counter()
    for _ in range(steps):
        _, reward, terminated, truncated, _ = env.step(env.action_space.sample())
        rewards.append(reward)
        if terminated or truncated:
            env.reset()
    print(f"one world:  {steps / (time.perf_counter() - start):7.0f} steps/s, mean reward {np.mean(rewards):.3f}")


def run_many(worlds, steps):
    envs = mimo.make_vec("reach", num_envs=worlds, **SETTINGS)
    envs.action_space.seed(0)
    envs.reset(seed=0)
    rewards, reached, start = [], 0, time.perf_counter()
    for _ in range(steps):
        _, reward, terminated, _, _ = envs.step(envs.action_space.sample())
        rewards.append(reward.mean())
        reached += terminated.sum()
    rate = worlds * steps / (time.perf_counter() - start)
    print(f"{worlds:3d} worlds: {rate:7.0f} steps/s, mean reward {np.mean(rewards):.3f}, {reached} times at the mouth")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--worlds", type=int, default=16)
    parser.add_argument("--steps", type=int, default=200)
    options = parser.parse_args()
    run_one(options.steps)
    run_many(options.worlds, options.steps)
