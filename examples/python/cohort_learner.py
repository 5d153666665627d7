"""The learner of cohort.py: PPO for one behaviour, one strength and one seed, with infants of all ages at once.

A policy says where joints are to go, every 50 ms, and the reflex of reflex.py pulls them there. Networks, advantages
and updates are those of single_file_ppo.py. While it learns, an attempt ends as soon as its progress has fallen by DROP
below its best: what follows a fall teaches little. Evaluations know none of this: they run each attempt to its end.
"""

import time

import numpy as np
import single_file_ppo as ppo
import torch
from reflex import Infants, policy_of

import mimo

WORLDS, ROLLOUT, RATE, GAMMA = 64, 32, 1e-3, 0.98
LOG_DEVIATION = -0.7  # of goals in the beginning, rad
CALMER, SLOWER = 5, 10  # what noise and rate of learning are divided by from the middle of all steps to their end
REWARD_SCALE, DROP = 0.1, 0.3
EVALUATION_SEED = 1_000_000  # episodes that nobody learned from


class Scale(ppo.Scale):
    """As its base; numbers that were learned from stay as they were seen."""

    def deviation(self):
        return np.sqrt(np.maximum(self.square - self.mean**2, 1e-6))

    def scaled(self, rows):
        return torch.from_numpy(np.clip((rows - self.mean) / self.deviation(), -10, 10)).float()


class Learner:
    def __init__(self, behaviour, ages, strength, seed, steps, worlds=WORLDS):
        ppo.GAMMA, ppo.BATCHES = GAMMA, 16
        torch.manual_seed(seed)
        torch.set_num_threads(1)
        self.behaviour, self.ages, self.strength = behaviour, list(ages), strength
        self.infants = Infants(behaviour, ages, worlds, strength)
        seen = self.infants.reset(seed * 10_000)
        self.scale = Scale(seen.shape[1])
        self.agent = ppo.Agent(seen.shape[1], len(self.infants.joints))
        with torch.no_grad():
            self.agent.log_deviation.fill_(LOG_DEVIATION)
            for weights in self.agent.mean[-1].parameters():
                weights.mul_(0.01)
        self.optimizer = torch.optim.Adam(self.agent.parameters(), lr=RATE)
        self.seen = self.scale(seen)
        self.best = np.zeros(worlds)
        self.wanted, self.steps, self.seconds = steps, 0, 0.0

    def update(self):
        """A rollout and what is learned from it; returns the mean reward of a step."""
        began = time.monotonic()
        self._calm()
        kept = {name: [] for name in ("seen", "action", "chance", "value", "reward", "end")}
        for _ in range(ROLLOUT):
            for name, value in zip(kept, self._step()):
                kept[name].append(value)
        kept = {name: torch.stack(values) for name, values in kept.items()}
        kept["counts"] = torch.ones_like(kept["end"])
        with torch.no_grad():
            gain = ppo.advantages(kept, self.agent.value(self.seen)[:, 0])
        ppo.improve(self.agent, self.optimizer, kept, gain)
        self.steps += kept["end"].numel()
        self.seconds += time.monotonic() - began
        return kept["reward"].mean().item() / REWARD_SCALE

    @torch.no_grad()
    def _calm(self):
        """In the second half noise fades, so that the policy without noise is learned, too."""
        late = 2 * self.steps / self.wanted - 1
        if late > 0:
            part = 2 * ROLLOUT * len(self.infants.batch) / self.wanted
            self.agent.log_deviation -= part * np.log(CALMER)
            self.optimizer.param_groups[0]["lr"] = RATE * SLOWER ** -min(late, 1)

    @torch.no_grad()
    def _step(self):
        policy = self.agent.policy(self.seen)
        action = policy.sample()
        row = (self.seen, action, policy.log_prob(action).sum(-1), self.agent.value(self.seen)[:, 0])
        seen, reward, progress, _, over = self.infants.step(action.numpy())
        self.best = np.maximum(self.best, progress)
        fell = ~over & (progress < self.best - DROP)
        self.seen = self.scale(seen)
        reward *= REWARD_SCALE
        if over.any():  # time was over, not the attempt: it would have gone on
            reward += np.where(over, GAMMA * self.agent.value(self.seen)[:, 0].numpy(), 0)
        ends = over | fell
        if ends.any():
            self.best[ends] = 0
            self.seen = self.scale(self.infants.reset(mask=ends))
        return (*row, torch.from_numpy(reward).float(), torch.from_numpy(ends))

    def evaluate(self, episodes):
        """By age: share of attempts that succeed, mean of the measure at their end and of the longest time held."""
        count = len(self.ages) * episodes
        infants = Infants(self.behaviour, self.ages, count, self.strength, ends_on_success=1)
        seen, done = infants.reset(EVALUATION_SEED), np.zeros(count, bool)
        reached, achieved, total = np.zeros(count, bool), np.zeros((count, 0)), np.zeros(count)
        while not done.all():
            with torch.no_grad():
                action = self.agent.mean(self.scale.scaled(seen)).numpy()
            seen, reward, _, now, over = infants.step(action)
            values = np.asarray(infants.batch.get(mimo.Quantity.AGENT_ACHIEVED)).reshape(count, -1)
            achieved = values.copy() if not achieved.size else np.where(done[:, None], achieved, values)
            total += np.where(done, 0, reward)
            reached |= now & ~done
            done |= over
        infants.batch.close()
        rows = []
        for i, age in enumerate(self.ages):
            mine = slice(i, None, len(self.ages))
            numbers = (reached[mine].mean(), achieved[mine, 0].mean(), achieved[mine, -1].mean(), total[mine].mean())
            rows.append((age, *(round(float(number), 4) for number in numbers)))
        return rows

    # ---- Checkpoints: continuing gives what would have come without the break ------------------------------------

    def state(self):
        """Of tensors and plain numbers alone, which any version of PyTorch and NumPy reads."""
        batch, scale = self.infants.batch, self.scale
        return {
            "agent": self.agent.state_dict(),
            "optimizer": self.optimizer.state_dict(),
            "scale": [float(scale.count), torch.from_numpy(scale.mean), torch.from_numpy(scale.square)],
            "worlds": [torch.tensor(list(state), dtype=torch.uint8) for state in batch.save()],
            "blocks": torch.from_numpy(batch.blocks),
            "seen": self.seen,
            "best": torch.from_numpy(self.best),
            "steps": self.steps,
            "seconds": self.seconds,
            "random": torch.get_rng_state(),
        }

    def load(self, state):
        self.agent.load_state_dict(state["agent"])
        self.optimizer.load_state_dict(state["optimizer"])
        self.scale.count, self.scale.mean, self.scale.square = (np.array(one) for one in state["scale"])
        self.infants.batch.load([bytes(one.tolist()) for one in state["worlds"]])
        self.infants.batch.blocks[...] = state["blocks"].numpy()
        self.seen, self.best = state["seen"], state["best"].numpy().copy()
        self.steps, self.seconds = state["steps"], state["seconds"]
        torch.set_rng_state(state["random"])

    def policy(self, **told):
        """For the program and the browser, which act every 10 ms and keep no goal for 50."""
        layers = [
            (one.weight.detach().numpy().astype(float), one.bias.detach().numpy().astype(float))
            for one in self.agent.mean
            if isinstance(one, torch.nn.Linear)
        ]
        return policy_of(self.infants, 0, layers, self.scale.mean, self.scale.deviation(), **told)
