"""The cohort: one learner for infants of all ages, its breaks, its files, and what it refuses."""

import csv
import importlib
import json
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import mimo

torch = pytest.importorskip("torch", reason="PyTorch is not installed")
SCRIPTS = Path(__file__).resolve().parents[2] / "examples/python"
sys.path.append(str(SCRIPTS))
cohort = importlib.import_module("cohort")
cohort_learner = importlib.import_module("cohort_learner")
reflex = importlib.import_module("reflex")

ALL = 256  # steps that a learner of these tests is made for: four updates of two worlds


def learner(behaviour="roll-to-back", seed=0):
    return cohort_learner.Learner(behaviour, [0, 12], 1.0, seed, ALL, worlds=2)


def weights(one):
    return torch.cat([part.detach().reshape(-1) for part in one.agent.parameters()])


def test_every_motor_has_the_joint_that_it_turns():
    world = mimo.World("walk", touch=False, vision=False)
    labels = world.layout.fields["proprioception/position"].labels
    joints = [reflex.joint_of(motor) for motor in world.action_names]
    assert set(joints) <= set(labels)
    assert len(set(joints)) == len(joints) == 38
    world.reset(seed=0)
    for motor, joint in zip(world.action_names, joints):  # full strength turns this joint and no other as far
        world.reset(seed=0)
        command = np.zeros(len(joints), np.float32)
        command[world.action_names.index(motor)] = 1
        before = np.array(world.observation["proprioception/velocity"])
        world.step(command)
        gained = np.array(world.observation["proprioception/velocity"]) - before
        assert gained[labels.index(joint)] > 0, motor


def test_a_break_changes_nothing(tmp_path):
    whole = learner()
    for _ in range(4):
        whole.update()
    broken = learner()  # begins as the other did: PyTorch's random numbers are the process's
    for _ in range(2):
        broken.update()
    torch.save(broken.state(), tmp_path / "checkpoint.pt")
    after = learner(seed=5)  # all of it comes from the checkpoint
    after.load(torch.load(tmp_path / "checkpoint.pt"))
    for _ in range(2):
        after.update()
    assert after.steps == whole.steps == ALL
    assert torch.equal(weights(after), weights(whole))
    assert np.array_equal(after.scale.mean, whole.scale.mean)
    assert not torch.equal(weights(after), weights(broken))


def test_noise_and_rate_fall_in_the_second_half():
    one = learner()
    deviations = []
    for _ in range(4):
        one.update()
        deviations.append(one.agent.log_deviation.mean().exp().item())
    assert deviations[1] > 0.9 * np.exp(cohort_learner.LOG_DEVIATION)
    # Half of the way to a fifth after the third update would need a step beyond the middle: it is at the fourth.
    assert deviations[3] == pytest.approx(deviations[2] / cohort_learner.CALMER**0.5, rel=0.1)
    assert one.optimizer.param_groups[0]["lr"] == pytest.approx(cohort_learner.RATE * 10**-0.5)


def test_the_file_acts_as_the_learner_and_its_reflex():
    one = learner("sit")
    for _ in range(2):
        one.update()
    policy, infants = one.policy(), one.infants
    low, high = infants.batch.action_low, infants.batch.action_high
    seen = infants.observed()
    with torch.no_grad():
        goal = infants.start + one.agent.mean(one.scale.scaled(seen)).numpy()
    angle, velocity = seen[:, infants.joints], seen[:, 47 + np.array(infants.joints)]
    wanted = np.clip(2 * (goal - angle) - 0.1 * velocity, low, high)
    for row in range(2):
        fields = {name: infants.views[name][row] for name, _ in policy.fields}
        assert policy.act(fields, low, high) == pytest.approx(wanted[row], abs=2e-3)
    policy.attach(mimo.World("sit", age=3, touch=False, vision=False))


def test_an_age_without_the_start_pose_is_left_out():
    assert cohort.possible("stand", [0, 12]) == [12]
    assert cohort.possible("sit", [0, 12]) == [0, 12]


def test_a_small_cohort(tmp_path):
    command = [
        sys.executable,
        SCRIPTS / "cohort.py",
        "--behaviours",
        "roll-to-back",
        "--ages",
        "0",
        "12",
        "--seeds",
        "2",
    ]
    command += ["--steps", "128", "--worlds", "2", "--episodes", "1", "--evaluate-every", "64", "--out", tmp_path]
    first = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    assert "2 of 2 runs" in first
    with open(tmp_path / "cohort.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    assert [(row["seed"], row["age"], row["steps"]) for row in rows] == [
        (seed, age, "128") for seed in "01" for age in ("0.0", "12.0")
    ]
    assert all(0 <= float(row["success"]) <= 1 for row in rows)
    curve = (tmp_path / "roll-to-back-middle-0/curve.csv").read_text().splitlines()
    assert [line.split(",")[0:3:2] for line in curve[1:]] == [
        ["64", "0.0"],
        ["64", "12.0"],
        ["128", "0.0"],
        ["128", "12.0"],
    ]
    how = json.loads((tmp_path / "roll-to-back-middle-1/policy.json").read_text())["how"]
    assert (how["steps"], how["seed"], how["strength"]) == (128, 1, "middle")
    again = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    assert "goes on from step 128" in again
    with open(tmp_path / "cohort.csv", newline="") as file:
        assert list(csv.DictReader(file)) == rows
    other = subprocess.run([*command, "--ages", "12"], capture_output=True, text=True)
    assert "was learned with ages [0.0, 12.0], not [12.0]: choose another --out" in other.stderr


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["--behaviours", "fly"], "--behaviours has 'fly', expected sit, crawl"),
        (["--strength", "huge"], "--strength has 'huge', expected low, middle, high"),
        (["--ages", "36"], "--ages has 36, expected months from 0 to 24"),
        (["--seeds", "0"], "--seeds is 0, expected 1 or more"),
        (["--evaluate-every", "0"], "--evaluate-every is 0, expected 1 or more"),
    ],
)
def test_wrong_arguments_are_named(arguments, said, capsys):
    with pytest.raises(SystemExit):
        cohort.parse(arguments)
    assert said in capsys.readouterr().err
