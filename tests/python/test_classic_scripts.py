"""Scripts as people write them for the original and for the competition's kit, run as they are.

The scripts in classic_scripts know nothing of this library, except notebook.py. Numbers expected of them follow from
the script's own rules, or are the original's sizes, as recorded with tests/golden.
"""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

SCRIPTS = Path(__file__).parent / "classic_scripts"


@pytest.fixture
def folder(tmp_path):
    """A folder of the user's, with the scripts in it."""
    shutil.copytree(SCRIPTS, tmp_path / "scripts")
    return tmp_path


def python(folder, *arguments):
    told = subprocess.run(
        [sys.executable, *map(str, arguments)],
        cwd=folder,
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
        env={**os.environ, "MPLBACKEND": "Agg"},
    )
    return told


def run(folder, script, *arguments):
    told = python(folder, "-m", "mimo.classic", f"scripts/{script}", *arguments)
    assert told.returncode == 0, told.stderr
    first = told.stderr.splitlines()[0]
    assert re.match(rf"mimo\.classic: {Path(script).name}: .* on libmimo \d+\.\d+\.\d+.*, Gymnasium \d", first)
    assert "nothing is missing" in first
    return told.stdout.splitlines()


def test_a_training_script_with_arguments(folder):
    assert run(folder, "train_reach.py", "--env", "reach", "--train_for", 5, "--render_video") == [
        "actions 8 images 4 (500, 500, 3)"
    ]
    # Its relative paths are those of the folder in which it runs. No reach succeeds in 5 steps: minus a distance in m.
    assert -1 < float((folder / "models/best.txt").read_text()) < 0
    assert run(folder, "train_reach.py", "--env", "catch", "--use_muscle") == ["actions 40 images 0 "]


def test_an_environment_of_ones_own_on_a_scene_beside_the_script(folder):
    told = run(folder, "student_rollover.py")
    assert re.match(r"goal 0\.95 height 0\.\d+", told[0])
    assert 0.02 < float(told[0].split()[-1]) < 0.12  # the hip of a body that lies on its back
    assert told[1] == "rewards True achieved below True gravity -9.81"


def test_a_touch_of_ones_own(folder):
    assert run(folder, "itch_touch.py") == ["touch (5685,) (5685,) 1", "hurts True felt True"]


def test_the_experiment_of_the_page(folder, root):
    shutil.copy(root / "examples/python/kit_selftouch.py", folder / "scripts")
    shutil.copy(root / "bindings/python/src/mimo/babybench/configs/selftouch.yml", folder)
    (line,) = run(folder, "kit_selftouch.py", "--episodes", "2", "--duration", "400")
    score = float(re.match(r"score (0\.\d+) after 2 episodes, \d+ steps a second", line)[1])
    # In the kit random hands touch 2 to 5 of 68 places in an episode: tests/golden/babybench/random_policy.csv.
    assert 0 < score <= 2 * 5 / 68
    rows = (folder / "selftouch.csv").read_text().split()
    assert rows[0] == "episode,score"
    assert round(float(rows[2].split(",")[1]), 3) == score
    assert (folder / "results/self_touch/logs/training.pkl").is_file()


def test_poses_locks_and_forces_of_contacts(folder):
    told = run(folder, "paper_contacts.py")
    push, weight = map(float, re.match(r"push ([\d.]+) weight ([\d.]+)", told[0]).groups())
    assert weight == 107.0  # 10.9049 kg of the original's first body at 9.81 m/s^2
    assert 0.5 < push < 1.5  # it has just landed
    assert told[1:] == ["elbow held True bodies True", "root moves hip True"]


def test_the_old_gym(folder):
    told = run(folder, "old_api.py")
    assert re.match(r"touch \(1800,\) target \d+", told[0])  # 600 sensors of three numbers
    assert re.match(r"steps \d+ cut (True|False) True", told[1])
    assert int(told[1].split()[1]) <= 500


def test_motors_of_ones_own(folder):
    # 4 steps of 3 physics steps, each a quarter of the way to 0.5: 0.5 (1 - 0.75^12) = 0.4842, squared 0.2344.
    assert run(folder, "own_motors.py") == [
        "observation 248",  # 292 of the original's less 88 for two numbers a motor, and 44 of the script's own
        "level 0.4842 cost 0.2344",
        "updates 12 substeps 12 time 0.06",
        "control 0.4842",
    ]


def test_the_package_of_version_3(folder):
    assert run(folder, "infant3.py") == [
        "version 3.0.0",
        "spaces ['observation', 'vestibular'] goal 0.8 7",
        "on the back True",
        "late True True False",  # three steps wait for the first observation, of which the reset is one
        "blurred True",
        "centre True edge differs True",
        "head True",
    ]


def test_changes_count(folder):
    told = run(folder, "changed_body.py")
    # The golden masses of the original: hip 1.15837 kg, head 1.77399 kg: 5 - 1.15837 + 1.77399 more.
    assert told[0].split()[1] == "5.0"
    assert float(told[0].split()[2]) == pytest.approx(5 - 1.15837 + 1.77399, abs=2e-3)
    assert told[1:] == [
        "friction [0.2, 0.01, 0.001] 0.3",
        "elbow -1.0 0.5 -0.7 0.25",
        "control 0.3 gravity [0.0, 0.0, -1.62]",
        "force 2.0",
        "kept arrays follow True True",
    ]


def test_an_entry_to_the_competition(folder):
    told = run(folder, "competition.py", "--config", "scripts/config.yml")
    assert told[0] == "geoms 36 sensors 231 reward True"
    assert "picture (48, 48, 3)" in told[1]
    assert (folder / "results/self_touch/logs/training.pkl").exists()


def test_processes_of_a_script(folder):
    assert run(folder, "workers.py") == ["spawn 2 True", "forkserver 2 True"]


def test_a_fork_with_its_own_environments_scenes_and_functions(folder):
    said = python(folder, "-m", "mimo.classic", "scripts/fork/train_itch.py").stderr
    theirs = folder / "scripts/fork/mimoEnv"
    assert f"mimoEnv (in place of {theirs}, except modules that only these have) on libmimo" in said
    told = run(folder, "fork/train_itch.py")
    assert re.match(r"goal (right_hand|left_lower_arm) height 0\.5 elbow \[-2\.5312\]", told[0])
    assert re.match(r"steps \d+ 2 robot:left_elbow", told[1])
    assert told[2] == "mimo.classic.envs mimoEnv"
    assert run(folder, "fork/mimoEnv/experiments/show_itch.py") == ["scratched 2 True"]
    assert run(folder, "fork/nap.py") == ["mimoEnv.babybench.nap steps 5 touches True"]


def test_everything_of_modules_and_members_through_wrappers(folder):
    # 5 ms a step, as self-body has in the original.
    assert run(folder, "everything.py") == ["True ['sensors'] True", "600 (48, 64, 3) 0.005 True"]


def test_a_notebook(folder):
    told = python(folder, "scripts/notebook.py")
    assert told.returncode == 0, told.stderr
    assert told.stdout.splitlines() == [
        "True (12, 16, 3) (30, 40, 3)",
        "(220,) ['actuation', 'limits', 'qpos', 'qvel', 'torques']",
    ]


# ---- Checks and refusals -------------------------------------------------------------------------------------------

LACKING = """
import mimoEnv.utils as env_utils
import mujoco
import gymnasium as gym
from mimoEnv.envs.mimo_env import MIMoEnv
env = gym.make("MIMoReach-v0")
model = env.unwrapped.model
print(model.nq, model.tex_rgb.shape)
model.opt.iterations = 20
env.unwrapped.data.xpos[3] = 0
env.unwrapped.data.qpos[3] = 0.1
env_utils.determine_geom_masses(model, env.data, [3], 1)
mujoco.mj_inverse(model, env.data)
class Own(MIMoEnv):
    def reset_model(self):
        self.shelf = self.data.body("hip").xmat + self.data.body("hip").cinert
        return self._get_obs()
"""


def test_a_check_lists_what_is_used_and_what_is_missing(folder):
    (folder / "lacking.py").write_text(LACKING)
    told = python(folder, "-m", "mimo.classic", "--check", "lacking.py")
    assert told.returncode == 1
    lines = told.stdout.splitlines()
    assert lines[0] == "modules of the original: mimoEnv, mujoco"
    assert "uses model.nq (line 8)" in lines
    assert [line for line in lines if line.startswith("missing")] == [
        "missing: line 8: model.tex_rgb",
        "missing: line 9: model.opt.iterations = ... (write it in the scene's document)",
        "missing: line 10: data.xpos = ... "
        "(the physics computes it: move bodies with data.qpos, or data.joint(...).qpos)",
        "missing: line 12: mimoEnv.utils.determine_geom_masses",
        "missing: line 13: mujoco.mj_inverse",
        "missing: line 16: data.body.cinert",
    ]
    assert re.match(r"\d+ members, 6 missing; docs/guide/classic\.md says what to write instead", lines[-1])
    clean = python(folder, "-m", "mimo.classic", "--check", "scripts/paper_contacts.py")
    assert (clean.returncode, clean.stdout.splitlines()[-1][-9:]) == (0, "0 missing")


def test_a_script_stops_at_the_first_call_that_cannot_be_had(folder):
    (folder / "lacking.py").write_text(LACKING)
    told = python(folder, "-m", "mimo.classic", "lacking.py")
    assert told.returncode == 1
    assert "not there: line 8: model.tex_rgb; line 9: " in told.stderr.splitlines()[0]
    assert "line 8" in told.stderr
    assert "AttributeError: model has no 'tex_rgb' here; docs/guide/classic.md says" in told.stderr.splitlines()[-1]
    (folder / "calls.py").write_text("import mujoco, gymnasium, mimoEnv\nmujoco.mj_inverse(1, 2)\n")
    told = python(folder, "-m", "mimo.classic", "calls.py")
    assert "NotImplementedError: mujoco.mj_inverse is not there" in told.stderr


@pytest.mark.parametrize(
    ("text", "line"), [(None, "there is no script nowhere.py"), ("def :\n", "invalid syntax"), ("\0", "null bytes")]
)
def test_scripts_that_are_none(folder, text, line):
    if text is not None:
        (folder / "nowhere.py").write_text(text)
    told = python(folder, "-m", "mimo.classic", "nowhere.py")
    assert told.returncode == 2
    assert line in told.stderr
    assert len(told.stderr.splitlines()) == 1
