#!/usr/bin/env python3
"""learn_pose.py [--scene SCENE] [--ages MONTHS...]: learns the posture in which the infant sits (sit.json).

The policy is one goal for every joint, and the stretch reflex of examples/python/reflex.py that pulls towards it. The
cross-entropy method finds the goals: of many postures around a mean, each tried by infants of all given ages at once,
the best give the next mean and spread. Left and right have the same goals. The file says how well the posture does in
episodes that were not learned from. A generation takes half a minute on one core.
"""

import argparse
import sys
from pathlib import Path

import numpy as np

sys.path.append(str(Path(__file__).resolve().parents[1] / "python"))
from reflex import Infants, policy_of

TRIALS, BEST, SPREAD, LEAST, KEEP = 48, 8, 0.4, 0.03, 0.3  # the last: of the mean and the spread before
MIDLINE = ("hip_twist", "hip_lean", "head_swivel", "head_tilt_side")  # joints that stay straight
NEW_EPISODES = 1_000_000  # seeds that nobody learned from


def sides(motors, apart):
    """The number of each motor's goal, unless they are apart the same for left and right; -1: none."""
    if apart:
        return np.arange(len(motors))
    names = [motor[len("act:") :].replace("left_", "").replace("right_", "") for motor in motors]
    kinds = [name for name in dict.fromkeys(names) if name not in MIDLINE]
    return np.array([kinds.index(name) if name in kinds else -1 for name in names])


def spread_out(goals, places):
    """Goals of all joints, of rows with one for each kind."""
    return np.where(places >= 0, goals[:, places], 0)


def tried(infants, goals, seed, seconds):
    """Mean reward of each world's infant while it keeps its goals."""
    infants.reset([seed] * len(goals))
    return sum(infants.step(goals)[1] for _ in range(round(seconds / infants.seconds))) * infants.seconds / seconds


def learned(infants, ages, generations, seconds, seed, apart=False):
    random, places = np.random.default_rng(seed), sides(infants.batch.action_names, apart)
    mean = np.zeros(places.max() + 1)
    spread = np.full(len(mean), SPREAD)
    for generation in range(generations):
        postures = mean + spread * random.standard_normal((TRIALS, len(mean)))
        rows = spread_out(np.repeat(postures, len(ages), axis=0), places)
        reward = tried(infants, rows, generation, seconds).reshape(TRIALS, len(ages)).mean(axis=1)
        best = postures[np.argsort(-reward)[:BEST]]
        mean = KEEP * mean + (1 - KEEP) * best.mean(axis=0)
        spread = KEEP * spread + (1 - KEEP) * np.maximum(best.std(axis=0), LEAST)
        print(f"generation {generation + 1}: reward of a step {reward.max():.3f} at best", flush=True)
    return spread_out(mean[None], places)[0]


def measured(scene, ages, goals, episodes):
    """The share of episodes that succeed, by age."""
    infants = Infants(scene, ages, len(ages) * episodes, 1, ends_on_success=1)
    infants.reset(NEW_EPISODES)
    done, reached = np.zeros(len(infants.batch), bool), np.zeros(len(infants.batch), bool)
    while not done.all():
        _, _, _, now, over = infants.step(goals)
        reached |= now & ~done
        done |= over
    return {f"{age:g}": float(reached[i :: len(ages)].mean()) for i, age in enumerate(ages)}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split(":")[1].split("(")[0].strip())
    parser.add_argument("--scene", default="sit")
    parser.add_argument("--ages", type=float, nargs="+", default=[5.9], help="months, to learn at")
    parser.add_argument("--generations", type=int, default=5, help="0: keeps the start pose")
    parser.add_argument("--seconds", type=float, default=6, help="of a trial")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--out", type=Path, default=None)
    options = parser.parse_args()
    infants = Infants(options.scene, options.ages, TRIALS * len(options.ages), 1)
    goals = learned(infants, options.ages, options.generations, options.seconds, options.seed)
    success = measured(options.scene, [3, 4, 6, 9, 12, 18], goals, 4)
    how = {"program": "examples/policies/learn_pose.py", "seed": options.seed, "ages": options.ages}
    how |= {"seconds of practice": options.generations * TRIALS * len(options.ages) * options.seconds}
    how["success by age in months, 4 episodes each"] = success
    what = f"A policy for the scene {options.scene}: a posture, and a stretch reflex that pulls towards it."
    policy = policy_of(infants, goals, what=what, how=how)
    policy.save(options.out or Path(__file__).with_name(f"{options.scene}.json"))
    print(success)


if __name__ == "__main__":
    main()
