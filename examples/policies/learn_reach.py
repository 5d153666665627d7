#!/usr/bin/env python3
"""learn_reach.py [--updates N] [--out FILE]: learns the policy with which the infant reaches for the ball (reach.json).

PPO as in examples/python/single_file_ppo.py, on worlds whose infants have different ages, so that one network reaches
with all bodies. The file has the mean and deviation of what the infant feels, the layers, and how well it reaches at
each age in episodes that were not learned from. Needs PyTorch; takes about ten minutes on one core.
"""

import argparse
import sys
from pathlib import Path

import numpy as np
import torch

import mimo

sys.path.append(str(Path(__file__).resolve().parents[1] / "python"))
import single_file_ppo as ppo

AGES = [6.0, 9.0, 12.0, 15.0, 18.0, 21.0, 24.0]
WORLDS, ROLLOUT, SEED = 14, 128, 1


def worlds(count):
    return mimo.make_vec("reach", num_envs=count, flatten=True, normalize_actions=True, ages=AGES, threads=1)


def measured(agent, scale, episodes=4):
    """The share of episodes that end in success, by age, without exploration."""
    envs = worlds(len(AGES))
    seen, over = envs.reset(seed=1000)[0], np.zeros(len(AGES), bool)
    ended, reached = np.zeros(len(AGES), int), np.zeros(len(AGES), int)
    while ended.min() < episodes:
        with torch.no_grad():
            action = agent.mean(scale.scaled(seen)).numpy()
        seen, _, terminated, truncated, _ = envs.step(action)
        counts = ~over & (ended < episodes)
        ended += counts & (terminated | truncated)
        reached += counts & terminated
        over = terminated | truncated
    envs.close()
    return {f"{age:g}": int(one) / episodes for age, one in zip(AGES, reached)}


class Scale(ppo.Scale):
    def scaled(self, rows):
        return torch.from_numpy(np.clip((rows - self.mean) / self.deviation(), -10, 10)).float()

    def deviation(self):
        return np.sqrt(np.maximum(self.square - self.mean**2, 1e-6))


def write(path, agent, scale, told):
    layers = [
        (one.weight.detach().numpy(), one.bias.detach().numpy())
        for one in agent.mean
        if isinstance(one, torch.nn.Linear)
    ]
    what = "A policy for the scene reach: the mean action of a network of two layers of 64, tanh between them."
    scales = (scale.mean, scale.deviation())
    policy = mimo.Policy.of(mimo.World("reach"), layers, *scales, scene="reach", what=what, how=told)
    policy.save(path)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split(":")[1].split("\n")[0].strip())
    parser.add_argument("--updates", type=int, default=170)
    parser.add_argument("--out", type=Path, default=Path(__file__).with_name("reach.json"))
    arguments = parser.parse_args()
    torch.manual_seed(SEED)
    torch.set_num_threads(1)
    envs = worlds(WORLDS)
    agent = ppo.Agent(envs.single_observation_space.shape[0], envs.single_action_space.shape[0])
    optimizer = torch.optim.Adam(agent.parameters(), lr=ppo.RATE)
    scale = Scale(envs.single_observation_space.shape[0])
    seen, over = scale(envs.reset(seed=SEED)[0]), np.zeros(WORLDS, bool)
    for update in range(1, arguments.updates + 1):
        kept, seen, over = ppo.rollout(envs, agent, scale, seen, over, ROLLOUT)
        with torch.no_grad():
            gain = ppo.advantages(kept, agent.value(seen)[:, 0])
        ppo.improve(agent, optimizer, kept, gain)
        print(f"update {update}: mean reward {kept['reward'][kept['counts']].mean():.4f}", flush=True)
        if update % 25 == 0 or update == arguments.updates:
            success = measured(agent, scale)
            print(success, flush=True)
            told = {
                "program": "examples/policies/learn_reach.py",
                "steps": update * WORLDS * ROLLOUT,
                "ages": AGES,
                "seed": SEED,
                "success by age, without exploration, 4 episodes each": success,
            }
            write(arguments.out, agent, scale, told)


if __name__ == "__main__":
    main()
