"""Every example runs; so does every program in the documentation, in test_guides.py."""

import os
import re
import subprocess
import sys

import pytest
from recorded import recorder_or_skip

import mimo

EXAMPLES = {
    "async_worlds.py": ["--steps", "5"],
    "babble.py": [],
    "babybench.py": ["selftouch", "--blind", "--steps", "20", "--out", "results"],
    "her.py": ["--steps", "0"],
    "hearing.py": [],
    "key_points.py": [],
    "muscles.py": [],
    "own_experiment.py": ["--worlds", "2", "--steps", "20"],
    "own_scene.py": [],
    "overhead.py": ["--steps", "20", "--worlds", "4"],
    "reflexes.py": [],
    "receptors.py": [],
    "tutorial.py": [],
    "two_infants.py": ["--steps", "20"],
    "zero_copy.py": [],
}


def run(arguments, folder):
    environment = {**os.environ, "MPLBACKEND": "Agg"}
    done = subprocess.run(arguments, cwd=folder, env=environment, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.mark.parametrize("name", EXAMPLES)
def test_example(name, root, tmp_path):
    assert run([sys.executable, root / "examples/python" / name, *EXAMPLES[name]], tmp_path)


def test_babybench_accepts_a_scale_of_0(root, tmp_path):
    """That is no skin: for the reward of touching there is nothing to go by."""
    example = [sys.executable, root / "examples/python/babybench.py", "selftouch", "--touch-scale", "0"]
    run([*example, "--steps", "8"], tmp_path)
    done = subprocess.run([*example, "--baseline", "intrinsic"], cwd=tmp_path, capture_output=True, text=True)
    assert "there is no reward for behavior 'self_touch' with these senses" in done.stderr


def test_babybench_plays_a_behaviour(root, tmp_path):
    example = [sys.executable, root / "examples/python/babybench.py", "sit", "--blind"]
    said = run([*example, "--steps", "32", "--every", "8", "--episode-steps", "2"], tmp_path)
    assert "Scores(behavior='sit'" in said
    refused = subprocess.run([*example, "--baseline", "intrinsic"], cwd=tmp_path, capture_output=True, text=True)
    assert "there is no reward for behavior 'sit' with these senses" in refused.stderr


def test_films_of_a_policy(root, tmp_path):
    with mimo.World("reach", vision=False) as world, recorder_or_skip(world, tmp_path / "try.h5"):
        pass
    film = [sys.executable, root / "examples/python/film.py", root / "examples/policies/sit.json"]
    assert "sit-6.h5: success" in run([*film, "--ages", "6", "--out", "films"], tmp_path)
    with mimo.Recording(tmp_path / "films/sit-6.h5") as recording:
        assert recording.steps == 1500  # 15 s


def test_no_example_is_forgotten(root):
    in_test_sb3 = {"train.py", "learning_curves.py", "profile_training.py", "figure4.py", "single_file_ppo.py"}
    elsewhere = in_test_sb3 | {
        "kit_selftouch.py",
        "cluster.py",
        "cohort.py",
        "cohort_learner.py",
        "film.py",
        "movements.py",
        "torchrl_ppo.py",
        "receptor_steps.py",
        "without_binding.py",
    }  # in test_classic_scripts, test_ray, test_cohort, test_torchrl, below, and in examples/CMakeLists.txt
    assert {file.name for file in (root / "examples/python").glob("*.py")} == set(EXAMPLES) | elsewhere


def rows(text):
    """Rows of a table with five columns by their first one, as numbers."""
    cells = [[cell.strip() for cell in line.split("|")[1:-1]] for line in text.splitlines() if line.startswith("|")]
    numbers = re.compile(r"\d+\.\d")
    return {row[0]: [float(cell) for cell in row[1:]] for row in cells if len(row) == 5 and numbers.match(row[1])}


def test_the_page_on_steps_has_the_table_that_the_example_prints(root, tmp_path):
    printed = rows(run([sys.executable, root / "examples/python/receptor_steps.py"], tmp_path))
    assert len(printed) > 30
    page = rows((root / "docs/guide/receptor-steps.md").read_text(encoding="utf-8"))
    assert page.keys() == printed.keys()
    for name, told in printed.items():
        assert page[name] == pytest.approx(told, abs=0.11, rel=0.005), name
