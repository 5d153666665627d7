"""The Gymnasium environment, by Gymnasium's own checker and by what users rely on."""

import subprocess
import sys
import warnings

import gymnasium
import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env

import mimo

NAMES = [
    "mimo/Reach-v0",
    "mimo/Standup-v0",
    "mimo/SelfBody-v0",
    "mimo/Catch-v0",
    "mimo/Rollover-v0",
    "mimo/SelfTouch-v0",
    "mimo/HandRegard-v0",
    "mimo/Benchmark-v0",
    "mimo/Free-v0",
    "mimo/Showroom-v0",
    "mimo/HeadLift-v0",
    "mimo/ChestLift-v0",
    "mimo/RollToBelly-v0",
    "mimo/RollToBack-v0",
    "mimo/SitWithHands-v0",
    "mimo/Sit-v0",
    "mimo/SitUp-v0",
    "mimo/HandsAndKnees-v0",
    "mimo/Crawl-v0",
    "mimo/PullToStand-v0",
    "mimo/StandWithSupport-v0",
    "mimo/Stand-v0",
    "mimo/Cruise-v0",
    "mimo/WalkWithHelp-v0",
    "mimo/Walk-v0",
    "mimo/HandToMouth-v0",
    "mimo/HandsTogether-v0",
    "mimo/FootGrasp-v0",
    "mimo/ReachMoving-v0",
    "mimo/Lift-v0",
    "mimo/Bang-v0",
    "mimo/Drop-v0",
    "mimo/Follow-v0",
    "mimo/Prefer-v0",
    "mimo/Mobile-v0",
]
SMALL = {"vision_width": 16, "vision_height": 16, "touch_scale": 0.25}

# What the checker warns of, and why it may: velocities, torques and forces have no bounds in nature, and torques of
# motors are actions by choice; motors have ranges of their own, which normalize_actions maps to -1..1.
# Whatever else it says fails the test.
EXPLAINED = (
    "we recommend using a symmetric and normalized space",
    "space minimum value is -infinity",
    "space maximum value is infinity",
    "minimum value is -inf",
    "maximum value is inf",
    # Gymnasium before 1.0
    "maximum value is -infinity",
    "has an unconventional shape",
)


class RecordingViewer:
    """In place of the page in the browser, whose tests are test_view.py."""

    shown = 0

    def __init__(self, env):
        assert isinstance(env.world, mimo.World)

    def show(self):
        RecordingViewer.shown += 1

    def close(self):
        pass


@pytest.mark.parametrize("name", NAMES)
def test_gymnasium_s_checker(name, monkeypatch):
    monkeypatch.setattr(mimo.view, "opened_for_people", RecordingViewer)
    env = gymnasium.make(name, render_mode="rgb_array", **SMALL)
    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always")
        check_env(env.unwrapped)
    unexplained = [str(w.message) for w in said if not any(text in str(w.message) for text in EXPLAINED)]
    assert unexplained == []
    env.close()
    assert RecordingViewer.shown > 0


@pytest.mark.parametrize(("scene", "numbers"), [("reach", 220), ("standup", 258 + 6)])
def test_flat_observations(scene, numbers):
    # 220 and 264: sizes of the original's observations.
    env = mimo.make(scene, flatten=True)
    assert env.observation_space.shape == (numbers,)
    flat, _ = env.reset(seed=4)
    named, _ = mimo.make(scene).reset(seed=4)
    np.testing.assert_array_equal(flat, np.concatenate([field.ravel() for field in named.values()]))
    assert flat in env.observation_space


def test_make_and_gymnasium_make_are_the_same():
    one, other = mimo.make("reach"), gymnasium.make("mimo/Reach-v0")
    for env in (one, other):
        env.reset(seed=1)
    action = one.action_space.sample()
    assert one.step(action)[1] == other.step(action)[1]


def test_earlier_observations_do_not_change():
    env = mimo.make("reach")
    first, _ = env.reset(seed=1)
    kept = {name: field.copy() for name, field in first.items()}
    env.step(env.action_space.sample())
    for name, field in first.items():
        np.testing.assert_array_equal(field, kept[name])


def test_info_has_terms_and_success():
    env = mimo.make("selfbody")
    env.reset(seed=1)
    _, reward, _, _, info = env.step(env.action_space.sample())
    assert set(info) == {"is_success", "is_failure", "reward_terms"}
    assert sum(info["reward_terms"].values()) == reward


def test_info_tells_success():
    env = mimo.make("reach")
    _, info = env.reset(seed=1)
    assert info == {"is_success": False, "is_failure": False, "reward_terms": {"distance": 0, "success": 0}}
    env.world.bodies("target").position = env.world.bodies("right_fingers").position  # the ball is in the hand
    _, _, terminated, _, info = env.step(np.zeros(8))
    assert (terminated, info["is_success"], info["is_failure"]) == (True, True, False)
    assert env.reset()[1]["is_success"] is False


def test_episodes_are_cut_off():
    env = mimo.make("reach", max_steps=3)
    env.reset(seed=1)
    assert [env.step(np.zeros(8))[3] for _ in range(3)] == [False, False, True]


def test_episodes_without_a_seed_are_random():
    starts = [mimo.make("reach").reset()[0]["proprioception/position"] for _ in range(2)]
    assert not np.array_equal(*starts)


def test_render_modes():
    env = mimo.make("reach", render_mode="rgb_array", camera=None)
    env.reset(seed=1)
    assert env.render().shape == (360, 480, 3)
    assert mimo.make("reach").render() is None
    with pytest.raises(ValueError, match="render_mode"):
        mimo.make("reach", render_mode="ascii")
    with pytest.raises(ValueError, match="'rgb_array', 'depth_array', 'human' or None"):
        mimo.make("reach", render_mode="ascii")


def test_depth_and_the_size_of_pictures():
    env = gymnasium.make("mimo/Reach-v0", render_mode="depth_array", width=640, height=480)
    env.reset(seed=1)
    depth = env.render()
    assert (depth.shape, depth.dtype) == ((480, 640), np.float32)
    drawn = env.unwrapped.world.draw(width=640, height=480)
    np.testing.assert_array_equal(depth, drawn.depth)
    ball = env.unwrapped.world.bodies("target").position
    right, down, distance = env.unwrapped.world.project(ball, width=640, height=480)[0]
    radius = 0.025  # models' reach: the ball is that much nearer than its centre
    assert depth[int(down), int(right)] == pytest.approx(distance - radius, abs=0.003)
    envs = mimo.make_vec("reach", num_envs=2, render_mode="depth_array", width=32, height=16)
    envs.reset(seed=1)
    assert [picture.shape for picture in envs.render()] == [(16, 32)] * 2
    many = mimo.ParallelEnv("reach", render_mode="rgb_array", width=32, height=16)
    many.reset(seed=1)
    assert many.render().shape == (16, 32, 3)
    with pytest.raises(ValueError, match="width is -1, expected 0 to"):
        mimo.make("reach", render_mode="rgb_array", width=-1)


def test_unknown_options_of_a_reset_are_refused():
    with pytest.raises(ValueError, match="options has 'speed', expected 'age'"):
        mimo.make("reach").reset(options={"speed": 3})
    with pytest.raises(ValueError, match="options has 'mask', expected 'reset_mask' or 'ages'"):
        mimo.make_vec("reach", num_envs=2).reset(options={"mask": np.array([True, False])})
    mimo.make("reach").reset(seed=1, options={})


def test_after_a_plain_import_of_gymnasium():
    code = """if True:
        import gymnasium
        print(gymnasium.make("mimo:mimo/Reach-v0").reset(seed=1)[0]["proprioception/position"].shape)
        if __name__ == "__main__":
            envs = gymnasium.make_vec("mimo:mimo/Reach-v0", num_envs=2)
            print(envs.reset(seed=1)[0]["proprioception/position"].shape)
            envs.close()
    """
    told = subprocess.run([sys.executable, "-W", "ignore", "-c", code], capture_output=True, text=True)
    assert (told.stdout, told.stderr) == ("(47,)\n(2, 47)\n", "")


def test_gymnasium_is_imported_for_environments_only():
    code = """if True:
        import sys
        import mimo
        mimo.World("reach").reset(seed=1)
        mimo.Batch("reach", 2).close()
        assert "gymnasium" not in sys.modules
        import gymnasium
        assert not any(type(finder).__module__.startswith("mimo") for finder in sys.meta_path)
        print(sorted(name for name in gymnasium.registry if name.startswith("mimo/")))
    """
    told = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert (told.stdout, told.stderr) == (f"{sorted(NAMES)}\n", "")


class NearBall(mimo.Task):
    """Reward: height of the hand; ends when it is higher than the goal."""

    def __init__(self, goal=0.36):
        self.goal = goal

    def setup(self, world):
        self.hand = world.bodies("right_fingers")
        self.ball = world.bodies("target")

    def reset(self, world, mask):
        place = np.array([0.3, 0.0, 0.7]) + 0.1 * world.random(3, mask)
        self.ball.write("position", place[..., None, :], mask)

    def evaluate(self, world):
        height = self.hand.position[..., 0, 2]
        return mimo.Judgement(height, terminated=height > self.goal, success=height > self.goal)


def test_a_custom_task():
    env = mimo.make("reach", task=NearBall(), max_steps=5)
    observation, _ = env.reset(seed=2)
    twin = mimo.World("reach", task="none")
    twin.reset(seed=2)
    expected = np.array([0.3, 0.0, 0.7]) + 0.1 * twin.random(3)
    np.testing.assert_allclose(env.world.bodies("target").position[0], expected, atol=1e-12)
    assert observation in env.observation_space
    _, reward, terminated, _, info = env.step(np.zeros(8))
    assert reward == env.world.bodies("right_fingers").position[0, 2]
    assert terminated == info["is_success"] == (reward > 0.36)


def test_options_reach_the_infant():
    env = mimo.make(
        "reach",
        acts=mimo.Act.RIGHT_ARM,
        actuation=mimo.Actuation.POSITION,
        normalize_actions=True,
        vision=mimo.Vision.RGB | mimo.Vision.DEPTH,
        vision_width=24,
        vision_height=16,
        proprioception=False,
    )
    assert env.action_space.shape == (4,)
    assert (env.action_space.low == -1).all()
    assert set(env.observation_space.spaces) == {
        "vision/eye_left",
        "vision/eye_left_depth",
        "vision/eye_right",
        "vision/eye_right_depth",
    }
    observation, _ = env.reset(seed=0)
    assert observation["vision/eye_left"].shape == (16, 24, 3)
    assert observation["vision/eye_left"].dtype == np.uint8
    assert env.observation_space["vision/eye_left"].high.max() == 255


def test_true_means_the_default():
    fields = mimo.World("reach", touch=True, touch_scale=0.25, vision=False, proprioception=True).layout.fields
    assert "touch/force" in fields
    assert "proprioception/joint_torque" not in fields
    assert "proprioception/position" in fields
