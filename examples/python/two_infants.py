"""Two infants in one world, each an agent of PettingZoo's. Needs the extra [pettingzoo].

Both act by chance; an infant is rewarded for how near it is to the other's face with either hand.

    python two_infants.py [--steps N]
"""

import argparse

import numpy as np

import mimo


class Touching(mimo.Task):
    """The same for both: minus the distance of the own nearer hand and the other's head, m."""

    def setup(self, world):
        self.names = [agent.name for agent in world.agents]
        self.hands = world.bodies(*(f"{name}/{side}_hand" for name in self.names for side in ("left", "right")))
        self.heads = world.bodies(*(f"{name}/head" for name in self.names))

    def evaluate(self, world):
        hands = self.hands.position.reshape(2, 2, 3)  # infants, sides
        other = self.heads.position[::-1, np.newaxis]
        nearest = np.linalg.norm(hands - other, axis=-1).min(axis=-1)
        return {name: mimo.Judgement(-distance) for name, distance in zip(self.names, nearest)}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--steps", type=int, default=200)
    arguments = parser.parse_args()
    env = mimo.ParallelEnv("playdate", task=Touching(), vision=False, max_steps=arguments.steps, flatten=True)
    observations, _ = env.reset(seed=0)
    for seed, agent in enumerate(env.possible_agents):
        env.action_space(agent).seed(seed)
    earned = dict.fromkeys(env.possible_agents, 0.0)
    while env.agents:
        actions = {agent: env.action_space(agent).sample() for agent in env.agents}
        observations, rewards, *_ = env.step(actions)
        for agent, reward in rewards.items():
            earned[agent] += reward / arguments.steps
    for agent, reward in earned.items():
        print(f"{agent}: {observations[agent].size} numbers observed, {-reward:.3f} m from the other on average")
    env.close()


if __name__ == "__main__":
    main()
