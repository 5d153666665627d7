"""Trains MIMo on one of the paper's tasks with PPO or SAC, by default with Stable-Baselines3's settings.

    python train.py --task reach --algorithm ppo --seed 0 --steps 1000000
    python train.py --task reach --algorithm sac --seed 0 --steps 100000 --library sbx --updates 4

Of the two libraries sb3 is Stable-Baselines3 on PyTorch, and sbx the same algorithms compiled by JAX. Writes to
OUT/TASK-ALGORITHM-SEED: curve.csv, of self-body targets.csv, the latest checkpoint, and TensorBoard's files. Started
again, it goes on from the checkpoint, or where that has learned for long enough, only evaluates it. figure4.py trains
all tasks with many seeds, learning_curves.py draws the curves. Needs `pip install 'mimo[train]'`.
"""

import argparse
import csv
import importlib
import os
import time
from pathlib import Path

# Else OpenBLAS and XLA start a thread a core, which makes products as small as these slower.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
os.environ.setdefault("XLA_FLAGS", "--xla_cpu_multi_thread_eigen=false intra_op_parallelism_threads=1")

import numpy as np
import torch
from stable_baselines3.common.callbacks import BaseCallback
from stable_baselines3.common.vec_env import VecMonitor, VecNormalize

import mimo
from mimo.sb3 import SB3VecEnv

# All of an evaluation, without exploration, except the two of training: the last hundred episodes, with exploration.
COLUMNS = ["steps", "mean_return", "return_std", "success", "length", "wall_s", "training_return", "training_success"]
SPREAD_FLOOR = 0.03  # of a normalised number: what hardly moves, as a joint that is held, is not made loud
EVALUATION_SEED = 1_000_000  # the episodes of an evaluation: the same each time, and none of the training's


def algorithm(options):
    """The class, which both libraries make and call in the same way."""
    package = importlib.import_module({"sb3": "stable_baselines3", "sbx": "sbx"}[options.package])
    return getattr(package, options.algorithm.upper())


def make_model(options, envs, folder):
    common = {"seed": options.seed, "device": "cpu", "tensorboard_log": str(folder) if has_tensorboard() else None}
    common |= {"gamma": options.gamma, "learning_rate": options.rate}
    if options.network:
        common["policy_kwargs"] = {"net_arch": options.network}
    if options.algorithm == "ppo":
        # As many steps between two updates as by default, whose 2048 are those of a single environment.
        sizes = {"n_steps": max(1, options.rollout // options.worlds), "batch_size": options.batch or 64}
        exploration = {"use_sde": True, "sde_sample_freq": options.noise_steps} if options.noise_steps else {}
        return algorithm(options)("MlpPolicy", envs, **sizes, **exploration, **common)
    # The default's memory of a million steps, as far as it can be filled.
    sizes = {"gradient_steps": options.updates, "batch_size": options.batch or 256}
    sizes |= {"buffer_size": min(1_000_000, options.steps), "learning_starts": options.random_steps}
    return algorithm(options)("MlpPolicy", envs, ent_coef=f"auto_{options.temperature}", **sizes, **common)


def load_model(options, envs, folder):
    model = algorithm(options).load(folder / "model.zip", envs, device="cpu")
    if options.algorithm == "sac" and (folder / "replay.pkl").exists():
        model.load_replay_buffer(folder / "replay.pkl")
    return model


def make_envs(options, folder):
    """What is learned from; the monitor notes rewards as the task gives them."""
    worlds = SB3VecEnv(options.task, options.worlds, threads=options.threads, flatten=True, **episode_options(options))
    envs = VecMonitor(worlds, info_keywords=("is_success",))
    scales = folder / "scales.pkl"
    if scales.exists():
        envs = VecNormalize.load(scales, envs)
    elif options.normalize_observations or options.normalize_rewards:
        chosen = {"norm_obs": options.normalize_observations, "norm_reward": options.normalize_rewards}
        envs = VecNormalize(envs, gamma=options.gamma, epsilon=SPREAD_FLOOR**2, **chosen)
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
    episode = {"autoreset_mode": "Disabled", "threads": options.threads, "flatten": True, **episode_options(options)}
    return mimo.make_vec(options.task, num_envs=options.evaluation_episodes, **episode)


def evaluate(model, envs):
    """Returns, successes and lengths of one episode in each world, without exploration."""
    scales = model.get_vec_normalize_env()
    observation, _ = envs.reset(seed=EVALUATION_SEED)
    over = np.zeros(envs.num_envs, bool)
    total, length, success = np.zeros(envs.num_envs), np.zeros(envs.num_envs), np.zeros(envs.num_envs, bool)
    while not over.all():
        actions, _ = model.predict(scales.normalize_obs(observation) if scales else observation, deterministic=True)
        observation, reward, terminated, truncated, infos = envs.step(actions)
        total += np.where(over, 0, reward)
        length += ~over
        ended = (terminated | truncated) & ~over
        if ended.any():
            success |= ended & infos["is_success"]
        over |= ended
    return total, success, length


def success_by_target(envs, success):
    """Of the episodes of an evaluation: (target, how many had it, how many of those succeeded)."""
    target = envs.batch.layout.fields.get("task/target")
    if target is None:
        return []
    envs.reset(seed=EVALUATION_SEED)
    asked = envs.batch.observation["task/target"].argmax(axis=1)
    counts = [(name, asked == number) for number, name in enumerate(target.labels)]
    return [(name, mask.sum(), success[mask].sum()) for name, mask in counts if mask.any()]


class Progress(BaseCallback):
    """Now and then notes how training goes, evaluates, writes a row of the curve, and saves a checkpoint."""

    def __init__(self, options, folder):
        super().__init__()
        self.options, self.folder = options, folder
        self.envs = evaluation_envs(options)
        self.start = time.time()
        self.curve = folder / "curve.csv"
        if not self.curve.exists():
            self.curve.write_text(",".join(COLUMNS) + "\n")

    def _on_training_start(self):
        self.noted = self.num_timesteps
        self.note_every = self.options.note_every or self.options.evaluate_every
        self.due, self.evaluation_due = (
            self.num_timesteps + every for every in (self.note_every, self.options.evaluate_every)
        )

    def _on_step(self):
        if self.num_timesteps >= self.due:
            self.due += self.note_every
            self.note(self.num_timesteps >= min(self.evaluation_due, self.options.steps))
        return True

    def note(self, evaluates):
        if evaluates:
            self.evaluation_due += self.options.evaluate_every
        evaluated = self.evaluated() if evaluates else [np.nan] * 4
        self.noted = self.num_timesteps
        row = [*evaluated, time.time() - self.start, *self.training()]
        with self.curve.open("a", newline="") as file:
            csv.writer(file).writerow([self.num_timesteps, *(f"{value:.6g}" for value in row)])
        self.save()

    def evaluated(self):
        total, success, length = evaluate(self.model, self.envs)
        self.logger.record("evaluation/return", total.mean())
        self.logger.record("evaluation/success", success.mean())
        write_targets(self.folder, success_by_target(self.envs, success))
        return [total.mean(), total.std(), success.mean(), length.mean()]

    def training(self):
        """Return and success of the last hundred episodes of training; nan before the first has ended."""
        ended = self.model.ep_info_buffer
        return [np.mean([episode[name] for episode in ended]) if ended else np.nan for name in ("r", "is_success")]

    def _on_training_end(self):
        if self.noted < self.num_timesteps:
            self.note(evaluates=True)
        if self.options.algorithm == "sac" and not self.options.drop_memory:
            self.model.save_replay_buffer(self.folder / "replay.pkl")

    def save(self):
        unfinished = self.folder / "unfinished.zip"
        self.model.save(unfinished)
        unfinished.replace(self.folder / "model.zip")
        if isinstance(self.training_env, VecNormalize):
            self.training_env.save(self.folder / "scales.pkl")


def write_targets(folder, targets):
    if targets:
        rows = [("target", "episodes", "successes"), *targets]
        with (folder / "targets.csv").open("w", newline="") as file:
            csv.writer(file).writerows(rows)


def parse(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--task", required=True, choices=["reach", "standup", "selfbody", "catch", "rollover"])
    parser.add_argument("--algorithm", required=True, choices=["ppo", "sac"])
    parser.add_argument(
        "--library", dest="package", default="sb3", choices=["sb3", "sbx"], help="PyTorch, or compiled by JAX"
    )
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--steps", type=int, default=100_000, help="of all worlds together, also those before a resume")
    parser.add_argument("--worlds", type=int, default=16)
    parser.add_argument("--threads", type=int, default=0, help="0: all cores")
    parser.add_argument("--torch-threads", type=int, default=1, help="the networks are small: one is often fastest")
    parser.add_argument("--out", type=Path, default=Path("runs"))
    parser.add_argument("--evaluate-every", type=int, default=10_000, help="steps")
    parser.add_argument("--note-every", type=int, default=0, help="steps between rows of the curve; 0: as above")
    parser.add_argument("--evaluation-episodes", type=int, default=16)
    parser.add_argument("--max-steps", type=int, default=0, help="of an episode; 0: the task's own")
    parser.add_argument("--frame-skip", type=int, default=0, help="physics steps in a step; 0: the task's own")
    parser.add_argument("--gamma", type=float, default=0.99, help="what a reward is worth one step earlier")
    parser.add_argument("--rate", type=float, default=3e-4, help="of learning")
    parser.add_argument("--network", type=int, nargs="+", help="units of each layer; else the library's default")
    parser.add_argument("--normalize-observations", action="store_true", help="less the mean so far, over the spread")
    parser.add_argument("--normalize-rewards", action="store_true", help="learn from rewards over their running spread")
    parser.add_argument("--rollout", type=int, default=2048, help="PPO: steps between updates")
    parser.add_argument("--batch", type=int, default=0, help="steps in a part of an update; 0: 64 for PPO, 256 for SAC")
    parser.add_argument("--noise-steps", type=int, default=0, help="PPO: how long noise stays (gSDE); 0: new each step")
    parser.add_argument("--updates", type=int, default=1, help="SAC: after a step of all worlds; -1: as many as worlds")
    parser.add_argument("--temperature", type=float, default=1, help="SAC: what randomness is worth at the start")
    parser.add_argument("--random-steps", type=int, default=100, help="SAC: before it begins to learn")
    parser.add_argument("--drop-memory", action="store_true", help="SAC: else saved at the end, up to gigabytes")
    parser.add_argument("--quiet", action="store_true", help="no progress bar")
    options = parser.parse_args(arguments)
    if options.package == "sbx" and options.noise_steps:
        parser.error(f"--noise-steps is {options.noise_steps}, expected 0 with --library sbx: it has no lasting noise")
    return options


def run_folder(options):
    return options.out / f"{options.task}-{options.algorithm}-{options.seed}"


def run(options):
    """Trains until there are as many steps as are wanted, or evaluates what has them."""
    torch.set_num_threads(options.torch_threads)
    folder = run_folder(options)
    folder.mkdir(parents=True, exist_ok=True)
    envs = make_envs(options, folder)
    resumed = (folder / "model.zip").exists()
    model = load_model(options, envs, folder) if resumed else make_model(options, envs, folder)
    envs.seed(options.seed * 1000)  # after the model, which seeds them too: worlds of one seed are none of another's
    left = options.steps - model.num_timesteps
    if left <= 0:
        evaluated = evaluation_envs(options)
        total, success, _ = evaluate(model, evaluated)
        print(f"{folder}: return {total.mean():.4g} +- {total.std():.2g}, success {success.mean():.3f}")
        for name, episodes, successes in success_by_target(evaluated, success):
            print(f"  {name}: {successes} of {episodes}")
        return
    if resumed:
        print(f"{folder} goes on from step {model.num_timesteps}", flush=True)
    model.learn(left, Progress(options, folder), reset_num_timesteps=not resumed, progress_bar=not options.quiet)
    envs.close()
    print(f"{folder}: {model.num_timesteps} steps")
    print((folder / "curve.csv").read_text().splitlines()[-1], flush=True)


if __name__ == "__main__":
    run(parse())
