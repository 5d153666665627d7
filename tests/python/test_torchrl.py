"""TorchRL: its checker of environments, and PPO for a moment."""

import re
import subprocess
import sys

import numpy as np
import pytest

import mimo

torch = pytest.importorskip("torch", reason="PyTorch is not installed")
envs_of = pytest.importorskip("torchrl.envs", reason="TorchRL (torchrl, with a PyTorch of today) is not installed")


def many(**options):
    return mimo.make_vec("reach", 3, flatten=True, autoreset_mode="Disabled", max_steps=20, **options)


def test_checker():
    envs_of.check_env_specs(envs_of.GymWrapper(mimo.make("reach", flatten=True)))
    envs_of.check_env_specs(envs_of.GymWrapper(many()))


def test_a_rollout_is_the_steps_of_the_worlds():
    wrapped, plain = envs_of.GymWrapper(many()), many()
    wrapped.set_seed(0)
    torch.manual_seed(0)
    kept = wrapped.rollout(15, break_when_any_done=False)
    assert kept.shape == (3, 15)
    plain.reset(seed=0)  # TorchRL begins an episode with its seed, and the rollout the next one
    np.testing.assert_array_equal(kept["observation"][:, 0], plain.reset()[0])
    for step in range(15):
        observation, reward, terminated, *_ = plain.step(kept["action"][:, step].numpy())
        np.testing.assert_array_equal(kept["next", "observation"][:, step], observation)
        np.testing.assert_array_equal(kept["next", "reward"][:, step, 0], reward.astype(np.float32))
        np.testing.assert_array_equal(kept["next", "terminated"][:, step, 0], terminated)
        if terminated.any():
            break


def test_the_example_learns_for_a_moment(root, tmp_path):
    example = root / "examples/python/torchrl_ppo.py"
    command = [sys.executable, example, "--worlds", "2", "--rollout", "32", "--updates", "2"]
    told = subprocess.run(map(str, command), check=True, capture_output=True, text=True, cwd=tmp_path).stdout
    assert re.fullmatch(r"(update \d: mean reward -\d\.\d{4}\n){2}", told)
