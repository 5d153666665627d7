"""Trains MIMo on one of the paper's tasks with Stable-Baselines3's PPO or SAC and their default settings.

    python train.py --task reach --algorithm ppo --seed 0 --steps 1000000

Writes to OUT/TASK-ALGORITHM-SEED: curve.csv (one row an evaluation), the latest checkpoint, and TensorBoard's files.
Started again, it goes on from the checkpoint, or where that has learned for long enough, only evaluates it.
learning_curves.py draws the curves. Needs `pip install 'mimo[train]'`.
"""

import argparse
import csv
import os
import time
from pathlib import Path

# Else OpenBLAS starts a thread a core behind torch's back, which makes products as small as these slower.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import numpy as np
import torch
from stable_baselines3 import PPO, SAC
from stable_baselines3.common.callbacks import BaseCallback
from stable_baselines3.common.vec_env import VecMonitor, VecNormalize

import mimo
from mimo.sb3 import SB3VecEnv

# Of an evaluation, without exploration, but for the two of training: the last hundred episodes, with exploration.
COLUMNS = ["steps", "mean_return", "return_std", "success", "length", "wall_s", "training_return", "training_success"]
EVALUATION_SEED = 1_000_000  # the episodes of an evaluation: the same each time, and none of the training's


def make_model(options, envs, folder):
    common = {"seed": options.seed, "device": "cpu", "tensorboard_log": str(folder) if has_tensorboard() else None}
    if options.algorithm == "ppo":
        # As many steps between two updates as by default, whose 2048 are those of a single environment.
        exploration = {"use_sde": True, "sde_sample_freq": options.noise_steps} if options.noise_steps else {}
        sizes = {"n_steps": max(1, options.rollout // options.worlds), "batch_size": options.batch}
        return PPO("MultiInputPolicy", envs, gamma=options.gamma, **sizes, **exploration, **common)
    # The default's memory of a million steps, as far as it can be filled.
    memory = min(1_000_000, options.steps)
    sizes = {"gradient_steps": options.updates, "buffer_size": memory}
    return SAC("MultiInputPolicy", envs, gamma=options.gamma, **sizes, **common)


def load_model(options, envs, folder):
    kind = PPO if options.algorithm == "ppo" else SAC
    model = kind.load(folder / "model.zip", envs, device="cpu")
    if options.algorithm == "sac" and (folder / "replay.pkl").exists():
        model.load_replay_buffer(folder / "replay.pkl")
    return model


def make_envs(options, folder):
    """What is learned from; the monitor notes rewards as the task gives them."""
    envs = VecMonitor(SB3VecEnv(options.task, options.worlds, threads=options.threads, **episode_options(options)))
    scales = folder / "reward_scale.pkl"
    if scales.exists():
        envs = VecNormalize.load(scales, envs)
    elif options.normalize_rewards:
        envs = VecNormalize(envs, norm_obs=False, gamma=options.gamma)
    envs.seed(options.seed * 1000)  # the worlds of one seed are none of another's
    return envs


def has_tensorboard():
    try:
        import torch.utils.tensorboard  # noqa: F401
    except ImportError:
        return False
    return True


def episode_options(options):
    """What training and evaluation have in common."""
    return {"max_steps": options.max_steps, "frame_skip": options.frame_skip}


def evaluation_envs(options):
    episode = episode_options(options)
    return mimo.make_vec(options.task, num_envs=options.evaluation_episodes, autoreset_mode="Disabled", **episode)


def evaluate(model, envs):
    """Returns, successes and lengths of one episode in each world, without exploration."""
    observation, _ = envs.reset(seed=EVALUATION_SEED)
    over = np.zeros(envs.num_envs, bool)
    total, length, success = np.zeros(envs.num_envs), np.zeros(envs.num_envs), np.zeros(envs.num_envs, bool)
    while not over.all():
        actions, _ = model.predict(observation, deterministic=True)
        observation, reward, terminated, truncated, infos = envs.step(actions)
        total += np.where(over, 0, reward)
        length += ~over
        ended = (terminated | truncated) & ~over
        if ended.any():
            success |= ended & infos["is_success"]
        over |= ended
    return total, success, length


def success_by_target(envs, success):
    """Of the episodes of an evaluation: how many had each target, and how many of those succeeded."""
    target = envs.batch.layout.fields.get("task/target")
    if target is None:
        return
    envs.reset(seed=EVALUATION_SEED)
    asked = envs.batch.observation["task/target"].argmax(axis=1)
    for number, name in enumerate(target.labels):
        if (asked == number).any():
            print(f"  {name}: {success[asked == number].sum()} of {(asked == number).sum()}")


class Evaluation(BaseCallback):
    """Now and then evaluates, writes a row of the curve, and saves a checkpoint."""

    def __init__(self, options, folder):
        super().__init__()
        self.options, self.folder = options, folder
        self.envs = evaluation_envs(options)
        self.start = time.time()
        self.curve = folder / "curve.csv"
        if not self.curve.exists():
            self.curve.write_text(",".join(COLUMNS) + "\n")

    def _on_training_start(self):
        self.due = self.num_timesteps + self.options.evaluate_every

    def _on_step(self):
        if self.num_timesteps >= self.due:
            self.due += self.options.evaluate_every
            self.note()
        return True

    def note(self):
        total, success, length = evaluate(self.model, self.envs)
        row = [total.mean(), total.std(), success.mean(), length.mean(), time.time() - self.start, *self.training()]
        with self.curve.open("a", newline="") as file:
            csv.writer(file).writerow([self.num_timesteps, *(f"{value:.6g}" for value in row)])
        self.logger.record("evaluation/return", row[0])
        self.logger.record("evaluation/success", row[2])
        self.save()

    def training(self):
        """Return and success of the last hundred episodes of training; nan before the first has ended."""
        returns = [episode["r"] for episode in self.model.ep_info_buffer]
        return [np.mean(values) if values else np.nan for values in (returns, list(self.model.ep_success_buffer))]

    def _on_training_end(self):
        self.save()
        if self.options.algorithm == "sac":  # gigabytes: only where training was meant to end
            self.model.save_replay_buffer(self.folder / "replay.pkl")

    def save(self):
        unfinished = self.folder / "unfinished.zip"
        self.model.save(unfinished)
        unfinished.replace(self.folder / "model.zip")
        if isinstance(self.training_env, VecNormalize):
            self.training_env.save(self.folder / "reward_scale.pkl")


def parse():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--task", required=True, choices=["reach", "standup", "selfbody", "catch", "rollover"])
    parser.add_argument("--algorithm", required=True, choices=["ppo", "sac"])
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--steps", type=int, default=100_000, help="of all worlds together, also those before a resume")
    parser.add_argument("--worlds", type=int, default=16)
    parser.add_argument("--threads", type=int, default=0, help="0: all cores")
    parser.add_argument("--torch-threads", type=int, default=1, help="the networks are small: one is often fastest")
    parser.add_argument("--out", type=Path, default=Path("runs"))
    parser.add_argument("--evaluate-every", type=int, default=10_000, help="steps")
    parser.add_argument("--evaluation-episodes", type=int, default=16)
    parser.add_argument("--max-steps", type=int, default=0, help="of an episode; 0: the task's own")
    parser.add_argument("--frame-skip", type=int, default=0, help="physics steps in a step; 0: the task's own")
    parser.add_argument("--gamma", type=float, default=0.99, help="what a reward is worth one step earlier")
    parser.add_argument("--normalize-rewards", action="store_true", help="learn from rewards over their running spread")
    parser.add_argument("--rollout", type=int, default=2048, help="PPO: steps between updates")
    parser.add_argument("--batch", type=int, default=64, help="PPO: steps in a part of an update")
    parser.add_argument("--noise-steps", type=int, default=0, help="PPO: how long noise stays (gSDE); 0: new each step")
    parser.add_argument("--updates", type=int, default=1, help="SAC: after a step of all worlds; -1: as many as worlds")
    parser.add_argument("--quiet", action="store_true", help="no progress bar")
    return parser.parse_args()


def main():
    options = parse()
    torch.set_num_threads(options.torch_threads)
    folder = options.out / f"{options.task}-{options.algorithm}-{options.seed}"
    folder.mkdir(parents=True, exist_ok=True)
    envs = make_envs(options, folder)
    resumed = (folder / "model.zip").exists()
    model = load_model(options, envs, folder) if resumed else make_model(options, envs, folder)
    left = options.steps - model.num_timesteps
    if left <= 0:
        evaluated = evaluation_envs(options)
        total, success, _ = evaluate(model, evaluated)
        print(f"{folder}: return {total.mean():.4g} +- {total.std():.2g}, success {success.mean():.3f}")
        success_by_target(evaluated, success)
        return
    if resumed:
        print(f"{folder} goes on from step {model.num_timesteps}", flush=True)
    model.learn(left, Evaluation(options, folder), reset_num_timesteps=not resumed, progress_bar=not options.quiet)
    print(f"{folder}: {model.num_timesteps} steps")
    print((folder / "curve.csv").read_text().splitlines()[-1])


if __name__ == "__main__":
    main()
