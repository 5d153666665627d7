"""A training script with a command line, in the manner of the original's demonstrations."""

import argparse
import os

import gymnasium as gym
import mimoEnv  # noqa: F401
from mimoActuation.actuation import SpringDamperModel
from mimoActuation.muscle import MuscleModel


class RandomAgent:
    def __init__(self, env):
        self.env = env

    def learn(self, total_timesteps):
        self.env.reset(seed=1)
        best = float("-inf")
        for _ in range(total_timesteps):
            _, reward, done, trunc, _ = self.env.step(self.env.action_space.sample())
            best = max(best, reward)
            if done or trunc:
                self.env.reset()
        return best

    def predict(self, obs):
        return self.env.action_space.sample(), None


def test(env, model, test_for, render_video):
    obs, _ = env.reset()
    images = []
    for _ in range(test_for):
        action, _ = model.predict(obs)
        obs, _, done, trunc, _ = env.step(action)
        if render_video:
            images.append(env.mujoco_renderer.render(render_mode="rgb_array"))
        if done or trunc:
            obs, _ = env.reset()
    return images


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--env", required=True, choices=["reach", "standup", "selfbody", "catch"])
    parser.add_argument("--train_for", default=0, type=int)
    parser.add_argument("--test_for", default=4, type=int)
    parser.add_argument("--save_dir", default="models")
    parser.add_argument("--use_muscle", action="store_true")
    parser.add_argument("--render_video", action="store_true")
    args = parser.parse_args()
    names = {
        "reach": "MIMoReach-v0",
        "standup": "MIMoStandup-v0",
        "selfbody": "MIMoSelfBody-v0",
        "catch": "MIMoCatch-v0",
    }
    env = gym.make(names[args.env], actuation_model=MuscleModel if args.use_muscle else SpringDamperModel)
    env.action_space.seed(3)
    agent = RandomAgent(env)
    best = agent.learn(args.train_for)
    images = test(env, agent, args.test_for, args.render_video)
    os.makedirs(args.save_dir, exist_ok=True)
    with open(os.path.join(args.save_dir, "best.txt"), "w") as f:
        f.write(f"{best:.3f}\n")
    print("actions", env.action_space.shape[0], "images", len(images), images[0].shape if images else "")
    env.close()


if __name__ == "__main__":
    main()
