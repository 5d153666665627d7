"""PPO in one file, as CleanRL writes its algorithms: nothing hidden, all to be changed. Needs PyTorch.

Worlds run in one process; observations are one row of numbers each. In the step after an episode's end a world begins
anew (Gymnasium's "NextStep"): that step's action did nothing, so it is left out of what is learned from.

    python single_file_ppo.py [--task reach] [--worlds N] [--rollout N] [--updates N]
"""

import argparse

import numpy as np
import torch
from torch import nn
from torch.distributions import Normal

import mimo

GAMMA, LAMBDA, CLIP, EPOCHS, BATCHES, RATE = 0.99, 0.95, 0.2, 10, 8, 3e-4


class Agent(nn.Module):
    def __init__(self, seen, done):
        super().__init__()
        self.mean, self.value = (layers(seen, out) for out in (done, 1))
        self.log_deviation = nn.Parameter(torch.full((done,), -0.5))

    def policy(self, seen):
        return Normal(self.mean(seen), self.log_deviation.exp())


def layers(seen, out):
    return nn.Sequential(nn.Linear(seen, 64), nn.Tanh(), nn.Linear(64, 64), nn.Tanh(), nn.Linear(64, out))


class Scale:
    """Observations with mean 0 and deviation 1, as seen so far."""

    def __init__(self, size):
        self.count, self.mean, self.square = 1e-4, np.zeros(size), np.ones(size)

    def __call__(self, rows):
        self.count += len(rows)
        self.mean += (rows - self.mean).sum(0) / self.count
        self.square += (rows**2 - self.square).sum(0) / self.count
        deviation = np.sqrt(np.maximum(self.square - self.mean**2, 1e-6))
        return torch.from_numpy(np.clip((rows - self.mean) / deviation, -10, 10)).float()


def rollout(envs, agent, scale, seen, over, steps):
    """Steps of all worlds, with a mask of those that count."""
    kept = {name: [] for name in ("seen", "action", "chance", "reward", "value", "end", "counts")}
    for _ in range(steps):
        with torch.no_grad():
            policy = agent.policy(seen)
            action = policy.sample()
            row = (seen, action, policy.log_prob(action).sum(-1), agent.value(seen)[:, 0])
        observation, reward, terminated, truncated, _ = envs.step(action.numpy())
        ends = terminated | truncated
        told = (torch.from_numpy(reward).float(), torch.from_numpy(ends), torch.from_numpy(~over))
        for name, value in zip(("seen", "action", "chance", "value", "reward", "end", "counts"), (*row, *told)):
            kept[name].append(value)
        seen, over = scale(observation), ends
    return {name: torch.stack(values) for name, values in kept.items()}, seen, over


def advantages(kept, last_value):
    """Generalised advantages; nothing is carried over an end."""
    found, later, value = [], torch.zeros_like(last_value), last_value
    for reward, ends, now in zip(kept["reward"].flip(0), kept["end"].flip(0), kept["value"].flip(0)):
        goes_on = (~ends).float()
        later = reward + GAMMA * value * goes_on - now + GAMMA * LAMBDA * goes_on * later
        value = now
        found.append(later)
    return torch.stack(found[::-1])


def improve(agent, optimizer, kept, gain):
    rows = {name: values[kept["counts"]] for name, values in kept.items()}
    gain = gain[kept["counts"]]
    target, standard = gain + rows["value"], (gain - gain.mean()) / (gain.std() + 1e-8)
    for _ in range(EPOCHS):
        for part in torch.randperm(len(gain)).chunk(BATCHES):
            policy = agent.policy(rows["seen"][part])
            ratio = (policy.log_prob(rows["action"][part]).sum(-1) - rows["chance"][part]).exp()
            better = torch.min(ratio * standard[part], ratio.clamp(1 - CLIP, 1 + CLIP) * standard[part])
            error = (agent.value(rows["seen"][part])[:, 0] - target[part]) ** 2
            optimizer.zero_grad()
            (0.5 * error.mean() - better.mean()).backward()
            nn.utils.clip_grad_norm_(agent.parameters(), 0.5)
            optimizer.step()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--task", default="reach")
    parser.add_argument("--worlds", type=int, default=16)
    parser.add_argument("--rollout", type=int, default=128, help="steps of each world before an update")
    parser.add_argument("--updates", type=int, default=50)
    arguments = parser.parse_args()
    torch.manual_seed(0)
    envs = mimo.make_vec(arguments.task, num_envs=arguments.worlds, flatten=True, normalize_actions=True)
    agent = Agent(envs.single_observation_space.shape[0], envs.single_action_space.shape[0])
    optimizer = torch.optim.Adam(agent.parameters(), lr=RATE)
    scale = Scale(envs.single_observation_space.shape[0])
    seen, over = scale(envs.reset(seed=0)[0]), np.zeros(arguments.worlds, bool)
    for update in range(arguments.updates):
        kept, seen, over = rollout(envs, agent, scale, seen, over, arguments.rollout)
        with torch.no_grad():
            gain = advantages(kept, agent.value(seen)[:, 0])
        improve(agent, optimizer, kept, gain)
        print(f"update {update + 1}: mean reward {kept['reward'][kept['counts']].mean():.4f}")
    envs.close()


if __name__ == "__main__":
    main()
