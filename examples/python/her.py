"""Hindsight experience replay: a goal that was missed is replaced by what was reached, and learned from.

Environments with goals have compute_reward(achieved, desired, info), for one goal and for rows of them. Trains
Stable-Baselines3's SAC with HER on the original's reach, with goals in the observation. Needs the extra [train].

    python her.py [--steps N]
"""

import argparse

import numpy as np
from gymnasium import spaces

import mimo.classic


class Hands(mimo.classic.MIMoReachEnv):
    """Reach without a prize: minus the distance of hand and ball, so that rewards follow from goals alone."""

    def compute_reward(self, achieved_goal, desired_goal, info):
        return -np.linalg.norm(np.asarray(achieved_goal) - np.asarray(desired_goal), axis=-1)


def check(env):
    """Rows of goals have the rewards of each of them."""
    assert {"observation", "achieved_goal", "desired_goal"} == set(env.observation_space.spaces)
    assert isinstance(env.action_space, spaces.Box)
    goals = np.random.default_rng(0).normal(size=(2, 5, 3))
    rows = env.compute_reward(goals[0], goals[1], [{}] * 5)
    assert np.array_equal(rows, [env.compute_reward(one, other, {}) for one, other in zip(*goals)])
    return rows


def learn(env, steps):
    from gymnasium.wrappers import TimeLimit
    from stable_baselines3 import SAC, HerReplayBuffer

    model = SAC(
        "MultiInputPolicy",
        TimeLimit(env, 100),
        replay_buffer_class=HerReplayBuffer,
        replay_buffer_kwargs={"n_sampled_goal": 4, "goal_selection_strategy": "future"},
        learning_starts=200,
        seed=0,
        device="cpu",
    )
    return model.learn(steps, log_interval=1)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--steps", type=int, default=20000, help="0: only look at the rewards of goals")
    arguments = parser.parse_args()
    env = Hands(goals_in_observation=True)
    print("rewards of five goals:", check(env).round(3))
    if arguments.steps:
        model = learn(env, arguments.steps)
        sample = model.replay_buffer.sample(64).next_observations
        print("share of goals that were reached in hindsight:", reached(sample))


def reached(goals):
    return float(((goals["achieved_goal"] - goals["desired_goal"]).norm(dim=1) < 1e-6).float().mean())


if __name__ == "__main__":
    main()
