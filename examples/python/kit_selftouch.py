"""Random self-touch, written for the starter kit of BabyBench. It knows nothing of libmimo:

python -m mimo.classic examples/python/kit_selftouch.py --config selftouch.yml --out selftouch.csv

Prints and writes the competition's score after each episode: the share of 68 geoms that both palms have touched so far.
"""

import argparse
import csv
import time

import babybench.utils as bb_utils
import mimoEnv  # noqa: F401
import yaml


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--config", default="selftouch.yml", help="the competition's configuration")
    parser.add_argument("--episodes", type=int, default=20)
    parser.add_argument("--duration", type=int, default=1000, help="steps of an episode")
    parser.add_argument("--out", default="selftouch.csv")
    args = parser.parse_args()
    with open(args.config) as file:
        config = yaml.safe_load(file)
    env = bb_utils.make_env(config)
    right, left, rows = set(), set(), []
    began = time.perf_counter()
    for episode in range(args.episodes):
        env.action_space.seed(episode)
        env.reset(seed=episode)
        for _ in range(args.duration):
            _, _, _, _, info = env.step(env.action_space.sample())
        right |= set(info["right_hand_touches"])
        left |= set(info["left_hand_touches"])
        rows.append({"episode": episode + 1, "score": (len(right) + len(left)) / 68})
    seconds = time.perf_counter() - began
    env.close()
    with open(args.out, "w", newline="") as file:
        table = csv.DictWriter(file, ["episode", "score"])
        table.writeheader()
        table.writerows(rows)
    steps = args.episodes * args.duration
    print(f"score {rows[-1]['score']:.3f} after {args.episodes} episodes, {steps / seconds:.0f} steps a second")


if __name__ == "__main__":
    main()
