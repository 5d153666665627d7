"""What infants of each age learn: one learner, one reward and one effort for all behaviours, ages and seeds.

    python cohort.py --out runs/cohort                                  # all, one process a core
    python cohort.py --behaviours sit --ages 6 9 12 --seeds 1 --steps 40000
    python cohort.py --strength low middle high                         # infants' strength is known badly
    python cohort.py --ray                                              # on the cluster that this machine belongs to

A run is one behaviour, strength, age and seed. It writes to OUT/BEHAVIOUR-STRENGTH-AGE-SEED: practice.csv (of each
attempt: value, success, seconds), checkpoint.npz, result.csv (how the last evaluation went: share of attempts that
succeed, progress, the measure and the longest time held, as mimo info --tasks describes them), and policy.json for
`mimo run --policy`. Started again, every run goes on from its checkpoint as if nothing had been. OUT/cohort.csv has all
results; docs/images/make_cohort.py draws it. Needs the package cmaes, and for --ray the extra [ray].
"""

import argparse
import csv
import os
import sys
import time
from concurrent.futures import ProcessPoolExecutor, as_completed
from multiprocessing import get_context
from pathlib import Path

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
os.environ.setdefault("OMP_NUM_THREADS", "1")  # a process a core: its numbers are few

from cohort_learner import Learner

import mimo

BEHAVIOURS = ["sit", "crawl", "stand-with-support", "walk-with-help", "stand", "walk", "roll-to-back", "roll-to-belly"]
AGES = [0.0, 3.0, 6.0, 9.0, 12.0, 15.0, 18.0, 24.0]
STRENGTHS = {"low": 0.5, "middle": 1.0, "high": 2.0}  # factors of what docs/guide/growth.md estimates
KEY = ["behaviour", "strength", "age", "seed"]
TRIED = ["value", "success", "seconds", "steps"]
COLUMNS = [*KEY, "steps", "tried", "episodes", "success", "progress", "measure", "held_s"]
PART = 20_000  # steps between two checkpoints


def write(path, rows, columns):
    """All at once, so that nobody finds half a file."""
    new = path.with_suffix(".new")
    with open(new, "w", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows([columns, *rows])
    new.replace(path)


def run(job):
    """One behaviour, strength, age and seed, from its checkpoint or from the beginning; returns its row of results.

    An age at which the infant cannot take the start pose gives none: a newborn's hips do not stretch to standing.
    """
    behaviour, strength, age, seed, options = job
    try:
        learner = Learner(behaviour, age, STRENGTHS[strength], seed)
    except mimo.UnsupportedError:
        return None
    folder = options.out / f"{behaviour}-{strength}-{age:g}-{seed}"
    folder.mkdir(parents=True, exist_ok=True)
    kept = folder / "checkpoint.npz"
    if kept.exists():
        learner.load(kept)
        print(f"{folder.name}: goes on from step {learner.steps}", flush=True)
    while learner.steps < options.steps:
        if time.time() > options.ends:
            return None
        learner.practise(min(PART, options.steps - learner.steps))
        learner.save(kept.with_suffix(".new"))
        kept.with_suffix(".new").replace(kept)
    numbers = learner.evaluate(options.episodes)
    row = (behaviour, strength, age, seed, learner.steps, len(learner.results), options.episodes)
    row += tuple(round(number, 4) for number in numbers)
    tried = [(f"{value:.4f}", int(success), f"{lasted:.2f}", at) for _, value, success, lasted, at in learner.results]
    write(folder / "practice.csv", tried, TRIED)
    write(folder / "result.csv", [row], COLUMNS)
    learner.policy(what=f"An infant that practised: {about(behaviour)}.", how=how(row)).save(folder / "policy.json")
    return row


def about(behaviour):
    return mimo.Scene(behaviour).behaviour().about


def how(row):
    told = dict(zip(COLUMNS, row))
    return {"program": "examples/python/cohort.py", "nerves": "of its age", **told}


def pooled(jobs, options):
    """Results as they come, of processes of this machine or of a cluster."""
    if options.ray:
        import mimo.ray

        mimo.ray.connect()
        import ray

        waiting = [ray.remote(run).remote(job) for job in jobs]
        while waiting:
            done, waiting = ray.wait(waiting)
            yield from ray.get(done)
        return
    with ProcessPoolExecutor(options.processes or os.cpu_count(), mp_context=get_context("spawn")) as pool:
        for done in as_completed([pool.submit(run, job) for job in jobs]):
            yield done.result()


def parse(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--behaviours", nargs="+", default=BEHAVIOURS, help=f"of {', '.join(BEHAVIOURS)}")
    parser.add_argument("--ages", nargs="+", type=float, default=AGES, help="months")
    parser.add_argument("--strength", nargs="+", default=["middle"], help="low (half), middle, high (double)")
    parser.add_argument("--seeds", type=int, default=5, help="how many")
    parser.add_argument("--first-seed", type=int, default=0)
    parser.add_argument("--steps", type=int, default=130_000, help="of 10 ms, that an infant practises")
    parser.add_argument("--minutes", type=float, default=float("inf"), help="after which no run goes on")
    parser.add_argument("--episodes", type=int, default=8, help="attempts of the evaluation")
    parser.add_argument("--processes", type=int, default=0, help="0: one for each core")
    parser.add_argument("--ray", action="store_true", help="runs on a Ray cluster")
    parser.add_argument("--out", type=Path, default=Path("runs/cohort"))
    options = parser.parse_args(arguments)
    for name, known in (("behaviours", BEHAVIOURS), ("strength", list(STRENGTHS))):
        for one in getattr(options, name):
            if one not in known:
                parser.error(f"--{name} has {one!r}, expected {', '.join(known)}")
    for age in options.ages:
        if not 0 <= age <= 24:
            parser.error(f"--ages has {age:g}, expected months from 0 to 24")
    for name, least in (("seeds", 1), ("steps", 1), ("episodes", 1), ("processes", 0), ("first_seed", 0)):
        if getattr(options, name) < least:
            parser.error(f"--{name.replace('_', '-')} is {getattr(options, name)}, expected {least} or more")
    options.ends = time.time() + 60 * options.minutes
    return options


def main(arguments=None):
    options = parse(arguments)
    options.out = options.out.resolve()
    jobs = [
        (behaviour, strength, age, seed, options)
        for seed in range(options.first_seed, options.first_seed + options.seeds)
        for strength in options.strength
        for behaviour in options.behaviours
        for age in options.ages
    ]
    rows = []
    for done, row in enumerate(pooled(jobs, options), 1):
        if row:
            rows.append(row)
            write(options.out / "cohort.csv", sorted(rows), COLUMNS)
        told = "no result" if row is None else f"{row[0]}, {row[2]:g} months, success {row[7]:.2f}"
        print(f"{done} of {len(jobs)} runs: {told}", flush=True)


if __name__ == "__main__":
    sys.exit(main())
