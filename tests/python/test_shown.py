"""What pages, figures and logs show of an environment's world is what its step returned. Needs [view,rerun]."""

import webbrowser

import numpy as np
import pytest

import mimo
from mimo.drawing import heat, strength

for _needed in ("viser", "PIL", "rerun", "matplotlib"):
    pytest.importorskip(_needed, reason=f"{_needed} is not installed")

EYES = {"vision_width": 16, "vision_height": 16}


class Nothing(mimo.Task):
    """A task in Python, for which an environment asks the world before it returns."""

    def evaluate(self, world):
        return mimo.Judgement(0.0)


@pytest.fixture(params=[None, Nothing()], ids=["the scene's task", "a task in Python"])
def env(request, monkeypatch):
    """An infant that lies on the floor."""
    monkeypatch.setattr(webbrowser, "open", lambda url: True)
    with mimo.make("benchmark", render_mode="human", task=request.param, **EYES) as env:
        env.reset(seed=1)
        for _ in range(30):
            env.step(rest(env))
        yield env


def rest(env):
    return np.zeros(env.action_space.shape, np.float32)


def felt(observation):
    force = np.linalg.norm(observation["touch/force"], axis=1)
    assert force.any()
    return force[force > 0]


def test_the_page(env):
    page = env._viewer._page
    skin = page._marks[0]
    skin.visible = True
    for _ in range(3):
        observation, *_ = env.step(rest(env))
        page._frames = 0
        page.update()
        eyes = page._senses._pictures[""].image
        np.testing.assert_array_equal(eyes[:, :16], observation["vision/eye_left"])
        np.testing.assert_array_equal(eyes[:, -16:], observation["vision/eye_right"])
        np.testing.assert_array_equal(skin._handle.colors[1:], heat(strength(felt(observation))))


def test_the_map_of_touch(env):
    observation, *_ = env.step(rest(env))
    _, points = mimo.plot.touch_map(env.unwrapped.world).axes[0].collections
    np.testing.assert_array_equal(np.sort(points.get_array()), np.sort(felt(observation)))


def test_the_log(env, monkeypatch):
    logged = {}
    monkeypatch.setattr(
        mimo.rerun, "_field", lambda world, field, values, *to: logged.update({field.name: values.copy()})
    )
    observation, *_ = env.step(rest(env))
    mimo.rerun.log(env.unwrapped.world, recording=mimo.rerun.sdk.RecordingStream("test"))
    assert logged.keys() == observation.keys()
    for name, field in observation.items():
        np.testing.assert_array_equal(logged[name], field, name)
