"""mimo.babybench: scores, logs and configurations of the competition.

Numbers are those of its own platform, measured there with MuJoCo 3.3.0 (tests/golden/babybench).
"""

import pickle
import subprocess
import sys

import numpy as np
import pytest
from competition import BLIND, logged, made, table

from mimo import babybench
from mimo.babybench import config, scores

# ---- Scores --------------------------------------------------------------------------------------------------------


def episodes(root, fingers=True):
    names = {"right_hand_touches": "right_hand_geoms_in_order", "left_hand_touches": "left_hand_geoms_in_order"}
    if fingers:
        names["right_hand_or_finger_touches"] = "right_hand_or_fingers_geoms"
        names["left_hand_or_finger_touches"] = "left_hand_or_fingers_geoms"
    rows = [row for row in table(root, "random_policy.csv") if row["config"] == "crib self_touch"]
    return [
        {"steps": 1000, **{key: [int(geom) for geom in row[column].split()] for key, column in names.items()}}
        for row in rows
    ]


EMPTY = {"steps": 0, "right_hand_touches": [], "left_hand_touches": []}


def test_scores_of_the_competition_s_random_policy(root):
    played = episodes(root)
    told = {count: scores.scores_of([EMPTY, *played[:count]]).competition for count in (1, 2, 5, 10, 20)}
    assert told == pytest.approx({1: 0.029, 2: 0.074, 5: 0.088, 10: 0.088, 20: 0.103}, abs=6e-4)
    assert told[20] == pytest.approx(7 / 68)
    single = [scores.self_touch([entry]) for entry in played]
    assert np.mean(single) == pytest.approx(0.0478, abs=5e-5)
    right = scores.scores_of([EMPTY, *played])
    assert right.right == pytest.approx((6 + 4) / 64)  # 3 7 8 10 11 12 and 7 8 17 18
    assert right.right_mean < right.right
    assert right.episodes == 20


def test_scores_of_incomplete_logs(root):
    told = scores.scores_of([EMPTY, *episodes(root, fingers=False)])
    assert (told.competition, told.right) == (pytest.approx(7 / 68), None)


def test_the_window(root):
    played = episodes(root)
    assert scores.scores_of(played[:1]).competition == 0  # the first entry does not count there
    assert scores.scores_of(played[:1]).right == pytest.approx(4 / 64)
    many = [played[0]] * 5 + [{**EMPTY, "steps": 1}] * 10000
    assert len(scores.window(many)) == 10000
    assert scores.self_touch(scores.window(many)) == 0
    assert len(scores.window(many[:100])) == 99


def test_hand_regard_s_scores():
    keys = [f"{eye}_eye_{hand}_hand" for eye in ("right", "left") for hand in ("right", "left")]
    empty = {"steps": 0, **dict.fromkeys(keys, 0)}
    entry = {"steps": 100, **dict(zip(keys, (10, 20, 30, 40))), **dict.fromkeys((f"{key}_in_view" for key in keys), 5)}
    told = scores.scores_of([empty, entry])
    assert (told.behavior, told.competition, told.right) == ("hand_regard", 100 / 400, 20 / 400)
    assert scores.scores_of([empty, empty]) == ("hand_regard", 0, None, None, None)  # there a division by zero
    assert scores.scores_of([{"steps": 7}]).behavior == "none"


def test_rewards_of_the_baselines():
    assert babybench.saliency(np.full((8, 8, 3), 70, np.uint8)) == pytest.approx(0, abs=1e-12)
    point = np.zeros((8, 8, 3), np.uint8)
    point[4, 3] = 255
    # The Laplacian is 4 at the point and -1 at its four neighbours.
    assert babybench.saliency(point) == pytest.approx(0.9999 * 255 * np.sqrt(16 + 4) / 64)
    corner = np.zeros((8, 8, 3), np.uint8)
    corner[0, 0] = 255  # at a border that reflects: 2 there, -1 at two neighbours
    assert babybench.saliency(corner) == pytest.approx(0.9999 * 255 * np.sqrt(4 + 2) / 64)
    touch = {"touch": np.array([0, -1, 0, 1, 0, 2, 0, 0, 0], np.float32)}
    env = made(**BLIND)
    assert babybench.TouchCount(env).intrinsic(touch) == pytest.approx(2 / 9)
    assert babybench.TouchedSensors(env).intrinsic(touch) == pytest.approx(2 / 3)


def test_the_reward_of_touching_is_of_the_competition_s_size():
    env = babybench.TouchCount(made("selftouch"))
    env.reset(seed=0)
    rewards = [env.step(env.action_space.sample())[1] for _ in range(100)]
    assert 0.004 < np.mean(rewards) < 0.012  # there 0.0080 to 0.0083, with a defect in how forces are spread


# ---- Logs ----------------------------------------------------------------------------------------------------------


def run(folder, steps=(3, 4), **switches):
    env = babybench.make({**babybench.load("selftouch"), "save_dir": str(folder), **BLIND, **switches})
    for count in steps:
        env.reset(seed=1)
        for _ in range(count):
            env.step(env.action_space.sample())
    return env


def test_training_is_logged(tmp_path):
    run(tmp_path).close()
    entries = logged(tmp_path)
    assert [entry["steps"] for entry in entries] == [0, 3, 4]
    assert all({"right_hand_touches", "left_hand_touches"} <= set(entry) for entry in entries)
    assert entries[0]["right_hand_touches"] == []


def test_logs_are_written_every_so_many_steps(tmp_path):
    env = run(tmp_path, (3, 4), save_logs_every=6)
    assert not (tmp_path / "logs" / "training.pkl").exists()  # 3, then 7 of which 4 are still running
    env.reset()
    assert [entry["steps"] for entry in logged(tmp_path)] == [0, 3, 4]


def test_logs_can_wait_for_the_end(tmp_path):
    env = run(tmp_path, (3, 4), save_logs_every=0)
    env.reset()
    assert not (tmp_path / "logs").exists()
    env.close()
    assert [entry["steps"] for entry in logged(tmp_path)] == [0, 3, 4, 0]


def test_keys_of_ones_own_stay_in_the_configuration():
    given = {"scene": "crib", "learning_rate": 3e-4, "touch_toes": True, **BLIND}
    with pytest.warns(UserWarning, match="is not a switch") as said:
        env = babybench.make(given)
    assert [str(warning.message) for warning in said if "config" in str(warning.message)] == [
        "config has 'learning_rate', which is not a switch and has no effect",
        "config has 'touch_toes', which is not a switch and has no effect; did you mean 'touch_legs'?",
    ]
    assert env.config["learning_rate"] == 3e-4


def test_an_earlier_log_is_kept(tmp_path):
    run(tmp_path).close()
    run(tmp_path, (5,)).close()
    assert [entry["steps"] for entry in logged(tmp_path, "training_1.pkl")] == [0, 3, 4]
    assert [entry["steps"] for entry in logged(tmp_path)] == [0, 5]


def test_evaluation(tmp_path, capsys):
    run(tmp_path).close()
    env = babybench.make({**babybench.load("selftouch"), "save_dir": str(tmp_path), **BLIND}, training=False)
    evaluation = babybench.EVALS["self_touch"](env, duration=5, save_dir=tmp_path)
    assert "training.pkl: self_touch, 2 episodes" in evaluation.eval_logs()
    for episode in range(2):
        env.reset(seed=episode)
        evaluation.reset()
        for _ in range(5):
            evaluation.eval_step(env.step(env.action_space.sample())[4])
        evaluation.end(episode)
    env.close()
    episode = logged(tmp_path, "evaluation_1.pkl")
    assert [len(episode[key]) for key in ("qpos", "info")] == [5, 5]
    assert episode["qpos"][0].shape == (54,)
    assert [entry["steps"] for entry in logged(tmp_path)] == [0, 3, 4]  # nothing of evaluations
    capsys.readouterr()


def evaluated(*arguments):
    command = [sys.executable, "-m", "mimo.babybench.evaluate", *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True)


def test_scores_on_the_command_line(tmp_path, root):
    (tmp_path / "logs").mkdir()
    (tmp_path / "logs/training.pkl").write_bytes(pickle.dumps([EMPTY, *episodes(root)]))
    infos = [{"steps": step, **EMPTY, "right_hand_touches": [8, 17]} for step in range(10)]
    (tmp_path / "logs/evaluation_0.pkl").write_bytes(pickle.dumps({"qpos": [np.zeros(54)] * 10, "info": infos}))
    done = evaluated(tmp_path)
    assert done.returncode == 0, done.stderr
    first, second = done.stdout.splitlines()
    assert first.startswith(
        "training.pkl: self_touch, 20 episodes; as the competition computes it 0.1029; right 0.1562"
    )
    assert second.startswith(
        "evaluation: self_touch, 1 episodes; as the competition computes it 0.0294; the log does not"
    )


def test_files_that_are_not_logs_are_refused(tmp_path):
    done = evaluated(tmp_path)
    assert (done.returncode, done.stdout) == (1, "")
    assert "expected a log, or a folder with training.pkl" in done.stderr
    (tmp_path / "training.pkl").write_bytes(b"nothing")
    assert "training.pkl is not a log" in evaluated(tmp_path).stderr
    (tmp_path / "training.pkl").write_bytes(pickle.dumps([1, 2]))
    assert "expected a list of episodes with steps" in evaluated(tmp_path).stderr
    (tmp_path / "training.pkl").write_bytes(pickle.dumps(subprocess.Popen))  # a program in disguise
    refused = evaluated(tmp_path / "training.pkl").stderr
    assert "it holds subprocess.Popen, expected numbers" in refused
    assert len(refused.splitlines()) == 1


# ---- Configurations ------------------------------------------------------------------------------------------------


def test_configurations_in_files(tmp_path):
    file = tmp_path / "mine.yml"
    file.write_text("behavior: self_touch\nscene: crib\nvision_active: false\ntouch_active: false\nframe_skip: 2\n")
    env = babybench.make(str(file))
    assert env.spec.id == "BabyBench-SelfTouch"
    assert (env.dt, env.action_space.shape) == (0.01, (44,))
    assert babybench.shipped() == ["handregard", "selftouch", "test_installation"]
    for name in babybench.shipped():
        assert set(babybench.load(name)) == set(config.DEFAULTS)


@pytest.mark.parametrize(
    ("given", "error", "line"),
    [
        ({"learning_rate": 3}, ValueError, "config has 'learning_rate', but no switch. There are: save_dir, behavior"),
        ({"save_logs_every": -1}, ValueError, "save_logs_every is -1, expected a whole number from 0 on"),
        ({"scene": "kitchen"}, ValueError, "scene is 'kitchen', expected 'base', 'crib', 'cubes'"),
        ({"behavior": "jump"}, ValueError, "behavior is 'jump', expected 'none', 'self_touch', 'hand_regard'"),
        ({"act_arms": 1}, ValueError, "act_arms is 1, expected true or false"),
        ({"frame_skip": 0}, ValueError, "frame_skip is 0, expected a whole number from 1 on"),
        ({"vision_resolution": True}, ValueError, "vision_resolution is True, expected a whole number"),
        ({"touch_scale": -1}, ValueError, "touch_scale is -1, expected a number from 0 on"),
        ({"save_dir": 3}, ValueError, "save_dir is 3, expected a folder"),
        (
            "nowhere.yml",
            FileNotFoundError,
            r"config is 'nowhere\.yml', expected a YAML file, a dict, or one of handregard",
        ),
    ],
)
def test_contradictory_configurations_are_refused(given, error, line):
    with pytest.raises(error, match=line) as raised:
        babybench.make(given)
    assert "\n" not in str(raised.value)


def test_files_without_a_configuration_are_refused(tmp_path):
    (tmp_path / "list.yml").write_text("- 1\n- 2\n")
    with pytest.raises(ValueError, match=r"list\.yml holds list, expected keys with values"):
        babybench.load(tmp_path / "list.yml")
    (tmp_path / "broken.yml").write_text("a: [1\n")
    with pytest.raises(ValueError, match=r"broken\.yml is not YAML") as raised:
        babybench.load(tmp_path / "broken.yml")
    assert "\n" not in str(raised.value)
