#!/usr/bin/env python3
"""make_learned.py RUNS: draws learned.png, what policies of examples/python/train.py have learned. Needs 'mimo[train]'.

RUNS has reach-ppo-0, standup-ppo-0 and selfbody-ppo-0, as docs/learning.md tells how to train them.
"""

import sys
from pathlib import Path

import numpy as np
from PIL import Image
from stable_baselines3 import PPO

import mimo

IMAGES = Path(__file__).resolve().parent
SIDE, MOMENTS = 220, 6
VIEWS = {
    "reach": {"look_at": (0.1, 0, 0.45), "distance": 1.1, "azimuth": 130, "elevation": -10},
    "standup": {"look_at": (0.05, 0, 0.35), "distance": 1.4, "azimuth": 120, "elevation": -8},
    "selfbody": {"look_at": (0.05, 0, 0.22), "distance": 0.95, "azimuth": 130, "elevation": -15},
}
ROWS = [("reach", None), ("standup", None), ("selfbody", "head"), ("selfbody", "left_upper_leg")]
OPTIONS = {"selfbody": {"frame_skip": 10, "max_steps": 50}}  # as it was trained


def episode(runs, task, target):
    """Pictures of an episode without exploration, from its first step to its last."""
    policy = PPO.load(runs / f"{task}-ppo-0" / "model.zip", device="cpu")
    envs = mimo.make_vec(task, num_envs=1, autoreset_mode="Disabled", **OPTIONS.get(task, {}))
    seed = 0
    observation, _ = envs.reset(seed=seed)
    while target is not None and wanted(envs) != target:
        seed += 1
        observation, _ = envs.reset(seed=seed)
    pictures, over = [], False
    while not over:
        pictures.append(envs.batch.world(0).render(width=2 * SIDE, height=2 * SIDE, **VIEWS[task]))
        action, _ = policy.predict(observation, deterministic=True)
        observation, _, terminated, truncated, _ = envs.step(action)
        over = bool(terminated[0] or truncated[0]) or len(pictures) == 150
    pictures.append(envs.batch.world(0).render(width=2 * SIDE, height=2 * SIDE, **VIEWS[task]))
    return pictures


def wanted(envs):
    field = envs.batch.layout.fields["task/target"]
    return field.labels[int(envs.batch.observation["task/target"][0].argmax())]


def main():
    runs = Path(sys.argv[1])
    sheet = Image.new("RGB", (MOMENTS * SIDE, len(ROWS) * SIDE))
    for row, (task, target) in enumerate(ROWS):
        pictures = episode(runs, task, target)
        for column, moment in enumerate(np.linspace(0, len(pictures) - 1, MOMENTS).round().astype(int)):
            picture = Image.fromarray(pictures[moment]).resize((SIDE, SIDE), Image.LANCZOS)
            sheet.paste(picture, (column * SIDE, row * SIDE))
    sheet.save(IMAGES / "learned.png", optimize=True)


if __name__ == "__main__":
    main()
