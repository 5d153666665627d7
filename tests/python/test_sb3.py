"""Stable-Baselines3: its checker, its contract of vectorised environments, and a very short training."""

import copy
import importlib.util
import re
import subprocess
import sys
import warnings

import numpy as np
import pytest
from test_tasks import Lift, ReachUp

import mimo
from mimo import classic

sb3 = pytest.importorskip("stable_baselines3", reason="Stable-Baselines3 (extra [train]) is not installed")
from stable_baselines3.common.env_checker import check_env  # noqa: E402
from stable_baselines3.common.vec_env import SubprocVecEnv, VecMonitor, VecNormalize  # noqa: E402

from mimo.sb3 import SB3VecEnv  # noqa: E402

# The same algorithms, compiled by JAX.
has_sbx = importlib.util.find_spec("sbx") is not None
needs_sbx = pytest.mark.skipif(not has_sbx, reason="sbx-rl (extra [train]) is not installed")

# Torques have three axes a sensor, touch three a place; policies flatten them themselves.
EXPLAINED = "has an unconventional shape"


@pytest.mark.parametrize("scene", ["reach", "standup", "selfbody"])
def test_checker(scene):
    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always")
        check_env(mimo.make(scene, normalize_actions=True))
    assert [str(w.message) for w in said if EXPLAINED not in str(w.message)] == []


@pytest.mark.parametrize("name", ["MIMoReach-v0", "MIMoStandup-v0", "MIMoCatch-v0"])
def test_checker_of_the_original_s_environments(name):
    # The original's environments have compute_reward, without goals in their observations.
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        check_env(classic.make(name))


def test_rewards_of_derived_classes():
    class Still(classic.MIMoReachEnv):
        def compute_reward(self, achieved_goal, desired_goal, info):
            return super().compute_reward(achieved_goal, desired_goal, info) - 10

        def step(self, action):
            observation, reward, *rest = super().step(action)
            assert reward == self.compute_reward(self.get_achieved_goal(), self.goal, rest[-1])
            return observation, reward, *rest

    env = Still()
    check_env(env, warn=False)
    env.reset(seed=1)
    assert -11 < env.step(np.zeros(8))[1] < -10
    assert hasattr(env, "compute_reward")


def test_existing_environments_are_taken():
    envs = mimo.make_vec("reach", 2, max_steps=2, autoreset_mode="SameStep")
    worlds, own = SB3VecEnv(envs), SB3VecEnv("reach", 2, max_steps=2)
    assert worlds.envs is envs
    for made in (worlds, own):
        made.seed(7)
        made.reset()
    actions = np.zeros((2, 8))
    for _ in range(3):
        (_, rewards, done, _), (_, expected, expected_done, _) = worlds.step(actions), own.step(actions)
        np.testing.assert_array_equal(rewards, expected)
        np.testing.assert_array_equal(done, expected_done)
    with pytest.raises(ValueError, match="autoreset_mode is 'NextStep', expected 'SameStep'"):
        SB3VecEnv(mimo.make_vec("reach", 2))
    with pytest.raises(ValueError, match="num_envs is 16, but the environment that was given has 2"):
        SB3VecEnv(envs, 16)
    with pytest.raises(TypeError, match="flatten comes too late: the environment that was given is made already"):
        SB3VecEnv(envs, flatten=True)
    assert SB3VecEnv(envs, 2).num_envs == 2


def test_a_step_that_ends_an_episode():
    envs, plain = SB3VecEnv("reach", 2, max_steps=2), mimo.make_vec("reach", 2, autoreset_mode="Disabled")
    envs.seed(7)
    envs.reset()
    plain.reset(seed=7)
    zeros = np.zeros((2, 8))
    for _ in range(2):
        observation, reward, done, infos = envs.step(zeros)
        last, last_reward, *_ = plain.step(zeros)
    assert done.all()
    np.testing.assert_allclose(reward, last_reward, rtol=1e-6)
    for i, info in enumerate(infos):
        assert info["TimeLimit.truncated"]
        assert info["is_success"] is False
        np.testing.assert_array_equal(
            info["terminal_observation"]["proprioception/position"], last["proprioception/position"][i]
        )
    assert not observation["proprioception/velocity"].any()  # already the next episode, at rest


def test_the_last_observation_survives_a_step():
    # PPO stores the observation before a step after that step.
    envs = SB3VecEnv("reach", 2)
    before = envs.reset()
    kept = copy.deepcopy(before)
    envs.step(np.ones((2, 8)))
    for name in kept:
        np.testing.assert_array_equal(before[name], kept[name])


def test_attributes_and_methods():
    envs = SB3VecEnv("reach", 3)
    assert envs.get_attr("num_envs") == [3, 3, 3]
    assert envs.env_method("save", indices=[1])[0] == envs.envs.batch.world(1).save()
    assert envs.env_is_wrapped(object) == [False] * 3
    envs.close()


def test_in_subprocesses():
    envs = SubprocVecEnv([mimo.make, mimo.make], start_method="spawn")
    assert envs.reset()["proprioception/position"].shape == (2, 47)
    envs.close()


@pytest.mark.parametrize("algorithm", ["PPO", "SAC"])
def test_learning_runs(algorithm):
    envs = SB3VecEnv("reach", 2, max_steps=10)
    some = {"n_steps": 16, "batch_size": 16, "n_epochs": 1} if algorithm == "PPO" else {"learning_starts": 16}
    model = getattr(sb3, algorithm)("MultiInputPolicy", envs, seed=0, device="cpu", **some)
    model.learn(48)
    assert model.num_timesteps >= 48
    action, _ = model.predict(envs.reset())
    assert action.shape == (2, 8)


FEW = "--worlds 2 --evaluate-every 64 --evaluation-episodes 3 --max-steps 8 --rollout 32 --batch 16 --random-steps 16"


@pytest.fixture
def train(root, tmp_path, monkeypatch, capsys):
    """Trains for seconds, and returns what was said."""
    monkeypatch.syspath_prepend(root / "examples/python")
    script = importlib.import_module("train")

    def run(options, out=tmp_path):
        script.run(script.parse([*FEW.split(), "--quiet", "--out", str(out), *options.split()]))
        return capsys.readouterr().out

    return run


def said(*command):
    return subprocess.run(list(map(str, command)), check=True, capture_output=True, text=True).stdout


def read_curve(folder):
    return np.genfromtxt(folder / "curve.csv", delimiter=",", names=True)


@pytest.mark.parametrize("library", ["sb3", pytest.param("sbx", marks=needs_sbx)])
def test_train_script_trains_resumes_and_its_curves_are_drawn(root, tmp_path, train, library):
    reach = f"--task reach --algorithm ppo --library {library}"
    train(f"{reach} --steps 128 --seed 0")
    train(f"{reach} --steps 128 --seed 1")
    assert "goes on from step 128" in train(f"{reach} --steps 192 --seed 0")
    curve = read_curve(tmp_path / "reach-ppo-0")
    assert curve["steps"].tolist() == [64, 128, 192]
    assert (curve["training_return"] < 0).all()
    assert (curve["training_success"] == 0).all()
    told = train(f"{reach} --steps 192 --seed 0")
    assert re.search(r"return -\d\.\d+ \+- \d\.\d+, success 0\.000\n$", told)
    assert "goes on" not in told
    curves = tmp_path / "curves.png"
    told = said(sys.executable, root / "examples/python/learning_curves.py", tmp_path, "--out", curves)
    assert "reach ppo, 2 seeds: mean_return -" in told
    assert curves.stat().st_size > 1000


@needs_sbx
@pytest.mark.parametrize("algorithm", ["ppo", "sac"])
def test_equal_seeds_learn_equally_and_others_do_not(tmp_path, train, algorithm):
    options = f"--task reach --algorithm {algorithm} --library sbx --steps 128 --note-every 32 --temperature 0.01"

    def curve(out, seed):
        train(f"{options} --normalize-observations --normalize-rewards --seed {seed}", tmp_path / out)
        return read_curve(tmp_path / out / f"reach-{algorithm}-{seed}")

    first, again, other = curve("first", 3), curve("again", 3), curve("other", 4)
    assert first["steps"].tolist() == [32, 64, 96, 128]
    assert np.isfinite(first["mean_return"]).tolist() == [False, True, False, True]  # evaluated every 64 steps
    for column in ("mean_return", "training_return"):
        np.testing.assert_array_equal(first[column], again[column])
        assert first[column][-1] != other[column][-1]


def test_train_script_keeps_scales_and_tells_targets(root, tmp_path, train):
    selfbody = "--task selfbody --algorithm ppo --noise-steps 4 --normalize-rewards --normalize-observations"
    folder = tmp_path / "selfbody-ppo-0"

    def scales():
        return VecNormalize.load(folder / "scales.pkl", VecMonitor(SB3VecEnv("selfbody", 2, flatten=True)))

    train(f"{selfbody} --steps 64")
    before = scales()
    assert before.obs_rms.mean.shape == before.observation_space.shape
    train(f"{selfbody} --steps 128")
    assert scales().ret_rms.count == pytest.approx(2 * before.ret_rms.count, rel=0.01)
    told = train(f"{selfbody} --steps 0")
    assert sum(int(count) for count in re.findall(r": \d of (\d)\n", told)) == 3
    told = said(sys.executable, root / "examples/python/learning_curves.py", tmp_path, "--out", tmp_path / "all.png")
    assert sum(int(count) for count in re.findall(r"^ppo, \w+: \d of (\d)$", told, flags=re.MULTILINE)) == 3


def test_lasting_noise_is_refused_for_libraries_without_it(train, capsys):
    with pytest.raises(SystemExit):
        train("--task reach --algorithm ppo --library sbx --noise-steps 4")
    assert "--noise-steps is 4, expected 0 with --library sbx" in capsys.readouterr().err


@needs_sbx
def test_figure4_trains_the_missing_runs(root, tmp_path):
    figure = [sys.executable, root / "examples/python/figure4.py", "--seeds", "1", "--out", tmp_path, "--steps", "64"]
    figure += FEW.split()
    both = said(*figure, "--task", "reach")
    assert re.findall(r"(\w+-\w+-\d): \d+ steps", both) == ["reach-ppo-0", "reach-sac-0"]
    assert said(*figure, "--task", "reach") == ""  # all is done


def test_times_of_a_training(root):
    profile = [sys.executable, root / "examples/python/profile_training.py", "--task", "reach", "--algorithm", "ppo"]
    told = said(*profile, "--steps", 64, "--worlds", 2, "--rollout", 32, "--batch", 16)
    shares = re.findall(r" (\d+) %; .* (\d+) %\n", told)
    assert len(shares) == 5
    for column in zip(*shares):  # of the clock, of the processor
        total, environment, learner, rest, library = map(int, column)
        assert environment + learner + rest == pytest.approx(total, abs=2)
        assert 0 < library <= environment < total == 100


def test_examples_of_learning(root):
    scripts = root / "examples/python"
    told = said(sys.executable, scripts / "her.py", "--steps", "320")
    assert float(told.split()[-1]) > 0  # "future" may choose the step itself
    told = said(sys.executable, scripts / "single_file_ppo.py", "--worlds", "2", "--rollout", "32", "--updates", "2")
    assert re.fullmatch(r"(update \d: mean reward -\d\.\d{4}\n){2}", told)


def test_hindsight_experience_replay_learns():
    envs = SB3VecEnv("reach", 2, task=ReachUp(), flatten=True, max_steps=8)
    assert set(envs.observation_space.spaces) == {"observation", "achieved_goal", "desired_goal"}
    model = sb3.SAC(
        "MultiInputPolicy",
        envs,
        replay_buffer_class=sb3.HerReplayBuffer,
        replay_buffer_kwargs={"n_sampled_goal": 4, "goal_selection_strategy": "future"},
        learning_starts=32,
        seed=0,
        device="cpu",
    )
    model.learn(64)
    sample = model.replay_buffer.sample(64)
    goals = sample.next_observations
    distance = (goals["achieved_goal"] - goals["desired_goal"]).norm(dim=1)
    np.testing.assert_allclose(sample.rewards[:, 0], -distance, atol=1e-6)  # also where the goal was replaced
    assert (distance == 0).any()  # "future" may choose the step itself


def test_a_task_s_infos_reach_sb3():
    envs = SB3VecEnv("reach", 2, task=Lift())
    envs.reset()
    for step in range(1, 4):
        _, reward, done, infos = envs.step(np.zeros((2, 8)))
        for i, info in enumerate(infos):
            assert info["steps"] == step
            assert sum(info["reward_terms"].values()) == pytest.approx(reward[i], abs=1e-7)
    assert done.all()
    for info in infos:
        assert (info["TimeLimit.truncated"], info["is_failure"], info["is_success"]) == (True, True, False)
    assert infos[0]["terminal_observation"]["lift/hands"].shape == (2, 3)


def test_the_checker_accepts_a_goal_view():
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        check_env(mimo.make("reach", task=ReachUp(), flatten=True, normalize_actions=True))


def test_vec_monitor():
    envs = VecMonitor(SB3VecEnv("reach", 2, max_steps=3), info_keywords=("is_success",))
    envs.reset()
    returns = np.zeros(2)
    for _ in range(3):
        _, reward, done, infos = envs.step(np.zeros((2, 8)))
        returns += reward
    assert done.all()
    for i, info in enumerate(infos):
        assert (info["episode"]["l"], info["episode"]["is_success"]) == (3, False)
        assert info["episode"]["r"] == pytest.approx(returns[i], abs=1e-5)


@pytest.mark.skipif(not hasattr(SB3VecEnv, "set_options"), reason="Stable-Baselines3 has options since 2.1")
def test_unknown_reset_options_are_refused():
    envs = SB3VecEnv("reach", 2)
    envs.set_options({"speed": 3})
    with pytest.raises(ValueError, match="options has 'speed'"):
        envs.reset()
