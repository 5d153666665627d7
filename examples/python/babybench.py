"""Baselines of BabyBench: random actions, or PPO on a reward of the infant's own, in many worlds at once.

    python babybench.py selftouch --baseline random --steps 10000
    python babybench.py sit --baseline random --blind                      # a behaviour: mimo info --tasks lists them
    python babybench.py handregard --baseline intrinsic --steps 100000     # needs pip install 'mimo[babybench,train]'

Writes the scores so far to OUT/CONFIG-BASELINE-SEED/curve.csv, which learning_curves.py draws, and the logs beside it.
"""

import argparse
import csv
from pathlib import Path

import numpy as np

import mimo.babybench

REWARDS = {"self_touch": mimo.babybench.touch_count, "hand_regard": mimo.babybench.saliency_of_eyes}
RECENT = 16  # episodes


class Curve:
    """The scores after every so many steps: of all episodes by now, the mean of the last ones; the mean reward."""

    def __init__(self, envs, path, every):
        self.envs, self.every, self.path = envs, every, path
        self.rows = [["steps", "competition", "right", "recent_right", "reward"]]
        self.steps, self.rewards = 0, []

    def take(self, rewards):
        """A step was made in all worlds."""
        before = self.steps // self.every
        self.steps += len(rewards)
        self.rewards.append(np.mean(rewards))
        if self.steps // self.every > before:
            self._add()

    def _add(self):
        log = self.envs.log
        played = [entry for entry in log if entry["steps"] > 0]
        if not played:
            return
        scores, recent = mimo.babybench.scores_of(log), mimo.babybench.scores_of(played[-RECENT:])
        numbers = scores.competition, scores.right, recent.right_mean, np.mean(self.rewards)
        self.rows.append([self.steps, *(round(float(number), 6) for number in numbers)])
        self.rewards = []
        with self.path.open("w", newline="") as file:
            csv.writer(file).writerows(self.rows)


def act_at_random(envs, steps, seed, curve):
    envs.reset(seed=seed)
    envs.action_space.seed(seed)
    while curve.steps < steps:
        curve.take(envs.step(envs.action_space.sample())[1])


def learn(envs, steps, seed, curve):
    from stable_baselines3 import PPO

    from mimo.sb3 import SB3VecEnv

    worlds = SB3VecEnv(envs)
    # Updates come after as many steps as by default, whose 2048 are those of a single environment.
    model = PPO("MultiInputPolicy", worlds, n_steps=max(1, 2048 // envs.num_envs), seed=seed, device="cpu")
    model.learn(steps, callback=lambda known, _: curve.take(known["rewards"]) or True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("config", help="selftouch, handregard, a behaviour as sit, or a YAML file")
    parser.add_argument("--baseline", choices=["random", "intrinsic"], default="random")
    parser.add_argument("--steps", type=int, default=10000, help="of all worlds together")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--worlds", type=int, default=8)
    parser.add_argument("--threads", type=int, default=0, help="that step the worlds; 0: all there are")
    parser.add_argument("--every", type=int, default=8000, help="steps from one row of the curve to the next")
    parser.add_argument("--episode-steps", type=int, help="of an episode; else the configuration's")
    parser.add_argument("--touch-scale", type=float, help="distance of the skin's sensors, times the usual")
    parser.add_argument("--pixels", type=int, help="of each eye; else the configuration's")
    parser.add_argument("--out", type=Path, default=Path("runs"))
    parser.add_argument("--blind", action="store_true", help="without eyes and skin, which random actions do not need")
    arguments = parser.parse_args()
    folder = arguments.out / f"{Path(arguments.config).stem}-{arguments.baseline}-{arguments.seed}"
    folder.mkdir(parents=True, exist_ok=True)
    config = {**mimo.babybench.load(arguments.config), "save_dir": folder}
    given = {"max_episode_steps": "episode_steps", "touch_scale": "touch_scale", "vision_resolution": "pixels"}
    config.update({key: value for key, name in given.items() if (value := getattr(arguments, name)) is not None})
    if arguments.blind:
        config.update(vision_active=False, touch_active=False)
    without_sense = arguments.blind or (config["behavior"] == "self_touch" and config["touch_scale"] == 0)
    reward = None if without_sense else REWARDS.get(config["behavior"])
    if arguments.baseline == "intrinsic" and reward is None:
        parser.error(f"there is no reward for behavior {config['behavior']!r} with these senses")
    envs = mimo.babybench.make_vec(
        config, arguments.worlds, reward=reward, threads=arguments.threads, autoreset_mode="SameStep"
    )
    curve = Curve(envs, folder / "curve.csv", arguments.every)
    run = act_at_random if arguments.baseline == "random" else learn
    run(envs, arguments.steps, arguments.seed, curve)
    envs.close()
    print(mimo.babybench.scores_of(envs.log))


if __name__ == "__main__":
    main()
