"""The cohort: how an infant of an age practises, its breaks, its files, and what it refuses."""

import csv
import importlib
import json
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import mimo

pytest.importorskip("cmaes", reason="cmaes is not installed")
ROOT = Path(__file__).resolve().parents[2]
SCRIPTS = ROOT / "examples/python"
sys.path.append(str(SCRIPTS))
cohort = importlib.import_module("cohort")
learners = importlib.import_module("cohort_learner")
movements = importlib.import_module("movements")


def learner(behaviour="roll-to-back", seed=0, age=12):
    return learners.Learner(behaviour, age, 1.0, seed, worlds=2)


def test_every_motor_has_the_joint_that_it_turns():
    world = mimo.World("walk", touch=False, vision=False)
    labels = world.layout.fields["proprioception/position"].labels
    joints = [movements.joint_of(motor) for motor in world.action_names]
    assert set(joints) <= set(labels)
    assert len(set(joints)) == len(joints) == 38
    for motor, joint in zip(world.action_names, joints):  # full strength turns this joint and no other as far
        world.reset(seed=0)
        command = np.zeros(len(joints), np.float32)
        command[world.action_names.index(motor)] = 1
        before = np.array(world.observation["proprioception/velocity"])
        world.step(command)
        gained = np.array(world.observation["proprioception/velocity"]) - before
        assert gained[labels.index(joint)] > 0, motor


def test_a_movement_is_as_its_numbers_say():
    motors = mimo.World("sit", touch=False, vision=False).action_names
    still = movements.Movement(np.zeros(movements.COUNT), motors)
    assert (still.stiffness, still.damping, still.period) == (2.0, 0.1, 1.5)
    assert not np.vstack([still.posture, still.clock, still.balance]).any()
    first = len(movements.SPREAD)  # then postures, in their order; then the rhythm
    knee, left, right = first + movements.POSTURE.index("knee"), "act:left_knee", "act:right_knee"
    numbers = np.zeros(movements.COUNT)
    numbers[knee] = 2
    bent = movements.Movement(numbers, motors)
    assert [bent.posture[motors.index(one)] for one in (left, right)] == [0.6, 0.6]  # 2 deviations of 0.3 rad
    assert np.count_nonzero(bent.posture) == 2
    numbers[:] = 0
    numbers[first + len(movements.POSTURE) + movements.RHYTHM.index("knee")] = 1
    numbers[list(movements.SPREAD).index("rhythm")] = np.log(2)  # all of the rhythm is twice as large
    stepping = movements.Movement(numbers, motors)
    assert [stepping.clock[motors.index(one)] for one in (left, right)] == pytest.approx([-0.6, 0.6])
    assert np.count_nonzero(stepping.clock) == 2


def test_the_file_acts_as_the_infant_practised():
    infants = movements.Infants("walk-with-help", 9, 2, 1.0, 0.05)
    numbers = np.random.default_rng(0).standard_normal(movements.COUNT)
    for world in range(2):
        infants.begin(world, numbers)
    infants.reset([3, 4])
    policy = movements.policy_of(infants, numbers, age=9)
    assert (policy.scene, policy.age, policy.delays) == ("walk-with-help", 9, True)
    noise = {"behaviour/pose_noise": 0.05}
    world = mimo.World(
        "walk-with-help", age=9, maturity=["body", "delays"], touch=False, vision=False, parameters=noise
    )
    policy.attach(world)
    world.reset(seed=4)
    for _ in range(50):
        infants.step()
        world.step(policy.act(world.observation, world.action_low, world.action_high, world.time))
        for name in (movements.ANGLES, "vestibular/acceleration"):
            assert infants.views[name][1] == pytest.approx(np.ravel(world.observation[name]), abs=1e-3)


def test_practice_gets_better():
    one = learner("roll-to-belly", age=12)
    one.practise(16_000)
    values = [value for _, value, *_ in one.results]
    assert len(values) > 3 * learners.POPULATION
    first, last = values[: learners.POPULATION], values[-learners.POPULATION :]
    assert np.mean(last) > np.mean(first) + 0.2  # of 6 that the best could be worth


def test_a_break_changes_nothing(tmp_path):
    whole, broken = learner(), learner()
    whole.practise(9000)
    broken.practise(5000)
    broken.save(tmp_path / "checkpoint.npz")
    after = learner()
    after.load(tmp_path / "checkpoint.npz")
    assert after.steps == 5000
    after.practise(4000)
    assert len(after.results) > len(broken.results) > learners.POPULATION  # the search moved before the break
    assert after.results == whole.results
    assert np.array_equal(after.rows, whole.rows)
    assert np.array_equal(after.search.mean, whole.search.mean)


def test_what_a_fall_and_a_success_are_worth():
    one = learner("stand-with-support")  # 15 s
    one.best[:], one.total[:], one.infants.steps[:] = 0.8, 150, 150
    one._finish(0, False)
    one._finish(1, True)
    assert [value for _, value, *_ in one.results] == pytest.approx(
        [150 / 1500 + 3 * 0.8, (150 + 2 * 1350) / 1500 + 3 + 1]
    )


def test_an_age_without_the_start_pose_is_left_out(tmp_path):
    options = cohort.parse(["--out", str(tmp_path)])
    assert cohort.run(("stand", "middle", 0.0, 0, options)) is None  # a newborn's hips do not stretch so far


def test_a_dive_ahead_is_no_crawling():
    """WHO wants three movements in a row. Arms swept back throw the infant 0.4 m ahead before its head lands."""
    infants = movements.Infants("crawl", 12, 4, 1.0, 0.01)
    goals = {"shoulder_abduction": -1.4, "elbow": 0.76, "head_tilt": -0.72, "shoulder_internal": -0.4}
    goals |= {"shoulder_horizontal": -0.15, "hip_flex": -0.16, "hip_abduction": 0.1, "foot_flexion": 0.15}
    numbers = np.zeros(movements.COUNT)
    numbers[:2] = np.log([4.1 / 2, 0.85]) / 0.5  # stiffness, damping
    for name, goal in goals.items():
        numbers[len(movements.SPREAD) + movements.POSTURE.index(name)] = goal / 0.3
    for world in range(4):
        infants.begin(world, numbers)
    infants.reset([1, 2, 3, 4])
    furthest, done = np.zeros(4), np.zeros(4, bool)
    while infants.steps[0] < 100:
        _, _, _, success, _ = infants.step()
        upright = infants.achieved()[:, 2] == 0  # head and trunk have not touched the ground
        furthest = np.where(upright, np.maximum(furthest, infants.achieved()[:, 0]), furthest)
        done |= success
    wanted = np.ravel(infants.batch.get(mimo.Quantity.AGENT_GOAL))[0]  # 0.4 m at 18 months, less for a smaller infant
    assert np.sum(furthest > wanted) >= 3
    assert not done.any()


def test_a_small_cohort(tmp_path):
    command = [sys.executable, SCRIPTS / "cohort.py", "--behaviours", "roll-to-back", "stand", "--ages", "0", "12"]
    command += ["--seeds", "1", "--steps", "800", "--episodes", "1", "--processes", "2", "--out", tmp_path]
    first = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    assert "4 of 4 runs" in first
    with open(tmp_path / "cohort.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    kept = [("roll-to-back", "0.0"), ("roll-to-back", "12.0"), ("stand", "12.0")]
    assert [(row["behaviour"], row["age"]) for row in rows] == kept
    assert all(row["steps"] == "800" and 0 <= float(row["success"]) <= 1 for row in rows)
    folder = tmp_path / "roll-to-back-middle-12-0"
    with open(folder / "practice.csv", newline="") as file:
        tried = list(csv.DictReader(file))
    assert len(tried) == int(rows[1]["tried"])
    policy = mimo.Policy.load(folder / "policy.json")
    assert (policy.how["steps"], policy.how["seed"], policy.how["strength"]) == (800, 0, "middle")
    assert json.loads((folder / "policy.json").read_text())["age"] == 12
    again = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    assert "roll-to-back-middle-12-0: goes on from step 800" in again
    with open(tmp_path / "cohort.csv", newline="") as file:
        assert list(csv.DictReader(file)) == rows


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["--behaviours", "fly"], "--behaviours has 'fly', expected sit, crawl"),
        (["--strength", "huge"], "--strength has 'huge', expected low, middle, high"),
        (["--ages", "36"], "--ages has 36, expected months from 0 to 24"),
        (["--seeds", "0"], "--seeds is 0, expected 1 or more"),
        (["--processes", "-1"], "--processes is -1, expected 0 or more"),
    ],
)
def test_wrong_arguments_are_named(arguments, said, capsys):
    with pytest.raises(SystemExit):
        cohort.parse(arguments)
    assert said in capsys.readouterr().err
