"""What infants of each age learn: one learner, one reward and one effort for all behaviours, ages and seeds.

    python cohort.py --out runs/cohort                                  # all, one process a core
    python cohort.py --behaviours sit --ages 6 9 12 --seeds 1 --steps 100000
    python cohort.py --strength low middle high                         # infants' strength is known badly
    python cohort.py --ray                                              # on the cluster that this machine belongs to

A run is one behaviour, strength and seed, with infants of all ages side by side in one policy. It writes to
OUT/BEHAVIOUR-STRENGTH-SEED: curve.csv (for each evaluation and age: share of attempts that succeed, the measure and the
longest time held, as mimo info --tasks describes them), checkpoint.pt, and policy.json for `mimo run --policy`. Started
again, every run goes on from its checkpoint as if nothing had been. OUT/cohort.csv has all last evaluations;
docs/images/make_cohort.py draws it. Needs PyTorch, and for --ray the extra [ray].
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
os.environ.setdefault("OMP_NUM_THREADS", "1")  # a process a core: the networks are small

import torch
from cohort_learner import Learner

import mimo

BEHAVIOURS = ["sit", "crawl", "stand-with-support", "walk-with-help", "stand", "walk", "roll-to-back", "roll-to-belly"]
AGES = [0.0, 3.0, 6.0, 9.0, 12.0, 15.0, 18.0, 24.0]
STRENGTHS = {"low": 0.5, "middle": 1.0, "high": 2.0}  # factors of what docs/guide/growth.md estimates
COLUMNS = ["steps", "episodes", "age", "success", "measure", "held_s", "return", "seconds"]
KEY = ["behaviour", "strength", "seed"]
LAST_EPISODES = 8  # attempts of each age in the last evaluation


def possible(behaviour, ages):
    """The ages at which the infant can take the start pose: a newborn's hips do not stretch so far that it stands."""
    found = []
    for age in ages:
        try:
            mimo.World(behaviour, age=age, touch=False, vision=False).close()
            found.append(age)
        except mimo.UnsupportedError:
            pass
    return found


def write(path, rows, columns):
    """All at once, so that nobody finds half a file."""
    new = path.with_suffix(".new")
    with open(new, "w", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows([columns, *rows])
    new.replace(path)


def run(job):
    """One behaviour, strength and seed, from its checkpoint or from the beginning; returns its last rows."""
    behaviour, strength, seed, options = job
    folder = options.out / f"{behaviour}-{strength}-{seed}"
    folder.mkdir(parents=True, exist_ok=True)
    kept, ends = folder / "checkpoint.pt", time.monotonic() + 60 * options.minutes
    learner = Learner(
        behaviour, possible(behaviour, options.ages), STRENGTHS[strength], seed, options.steps, options.worlds
    )
    rows = []
    if kept.exists():
        state = torch.load(kept)
        if state["ages"] != learner.ages:
            raise ValueError(f"{kept} was learned with ages {state['ages']}, not {learner.ages}: choose another --out")
        learner.load(state)
        rows = state["rows"]
        print(f"{folder.name}: goes on from step {learner.steps}", flush=True)

    def note(episodes):
        told = learner.evaluate(episodes)
        rows.extend((learner.steps, episodes, *row, round(learner.seconds, 1)) for row in told)
        write(folder / "curve.csv", rows, COLUMNS)
        torch.save({**learner.state(), "rows": rows, "ages": learner.ages}, folder / "checkpoint.new")
        (folder / "checkpoint.new").replace(kept)
        by_age = " ".join(f"{age:g}:{success:.2f}" for age, success, *_ in told)
        print(f"{folder.name}, step {learner.steps}, {learner.seconds:.0f} s: success by age {by_age}", flush=True)

    while learner.steps < options.steps and time.monotonic() < ends:
        before = learner.steps
        learner.update()
        if (
            before // options.evaluate_every != learner.steps // options.evaluate_every
            and learner.steps < options.steps
        ):
            note(2)
    if not rows or tuple(rows[-1][:2]) != (learner.steps, options.episodes):
        note(options.episodes)
    save_policy(folder, learner, rows, job)
    return [(behaviour, strength, seed, *row) for row in rows[-len(learner.ages) :]]


def save_policy(folder, learner, rows, job):
    behaviour, strength, seed, options = job
    success = {f"{row[2]:g}": row[3] for row in rows[-len(learner.ages) :]}
    how = {"program": "examples/python/cohort.py", "steps": learner.steps, "seed": seed, "strength": strength}
    how[f"success by age in months, {options.episodes} attempts each"] = success
    what = f"A policy for {behaviour}: goals of joints by a network of two layers of 64, and a stretch reflex to them."
    learner.policy(what=what, how=how).save(folder / "policy.json")


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
    parser.add_argument("--steps", type=int, default=1_000_000, help="of 50 ms, of all worlds of a run together")
    parser.add_argument("--minutes", type=float, default=float("inf"), help="after which a run learns no more")
    parser.add_argument("--worlds", type=int, default=64, help="of a run")
    parser.add_argument("--evaluate-every", type=int, default=100_000, help="steps; also keeps a checkpoint")
    parser.add_argument("--episodes", type=int, default=LAST_EPISODES, help="of each age in the last evaluation")
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
    for name in ("seeds", "steps", "worlds", "evaluate_every", "episodes"):
        if getattr(options, name) < 1:
            parser.error(f"--{name.replace('_', '-')} is {getattr(options, name)}, expected 1 or more")
    return options


def main(arguments=None):
    options = parse(arguments)
    options.out = options.out.resolve()
    jobs = [
        (b, s, seed, options)
        for seed in range(options.first_seed, options.first_seed + options.seeds)
        for s in options.strength
        for b in options.behaviours
    ]
    rows, done = [], 0
    for last in pooled(jobs, options):
        rows, done = rows + last, done + 1
        write(options.out / "cohort.csv", sorted(rows), KEY + COLUMNS)
        print(f"{done} of {len(jobs)} runs", flush=True)


if __name__ == "__main__":
    sys.exit(main())
