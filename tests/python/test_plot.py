"""Pictures: what is drawn is what was sensed."""

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg

import mimo
from mimo import plot


@pytest.fixture(autouse=True)
def _close():
    yield
    plt.close("all")


def test_anaglyph_takes_red_from_the_left_eye():
    left, right = np.full((2, 2, 3), [10, 20, 30], np.uint8), np.full((2, 2, 3), [40, 50, 60], np.uint8)
    assert plot.anaglyph(left, right)[0, 0].tolist() == [10, 50, 60]


def test_eyes():
    world = mimo.World("benchmark", touch=False, vision_width=32, vision_height=24)
    figure = plot.eyes(world.reset(seed=1))
    shown = [axes.images[0].get_array() for axes in figure.axes]
    np.testing.assert_array_equal(shown[0], world.observation["vision/eye_left"])
    np.testing.assert_array_equal(shown[1], world.observation["vision/eye_right"])
    with pytest.raises(ValueError, match="vision"):
        plot.eyes(mimo.World("reach").reset(seed=1))


def test_touch_map(tmp_path):
    world = mimo.World("benchmark", vision=False, touch_scale=0.5)
    world.reset(seed=1)
    for _ in range(60):  # falls to the floor
        world.step()
    figure = plot.touch_map(world)
    every, felt = figure.axes[0].collections
    force = np.linalg.norm(world.observation["touch/force"], axis=1)
    assert len(every.get_offsets()) == world.layout.fields["touch/force"].receptors
    assert len(felt.get_offsets()) == np.count_nonzero(force) > 0
    # The floor is at height 0: what feels is near it.
    assert np.abs(np.asarray(felt.get_offsets())[:, 1]).max() < 0.05
    figure.savefig(tmp_path / "touch.png")
    with pytest.raises(ValueError, match="touch"):
        plot.touch_map(mimo.World("reach"))


def test_joint_angles_lie_between_their_limits():
    world = mimo.World("reach")
    joints = world.joints("robot:right_elbow", "robot:right_shoulder_ad_ab")
    world.reset(seed=1)
    angles = [joints.position for _ in range(3) if world.step(np.ones(8))]
    figure = plot.joint_angles([0, 1, 2], angles, joints)
    np.testing.assert_array_equal(figure.axes[0].lines[0].get_ydata(), np.array(angles)[:, 0])


def test_a_window_needs_a_display(monkeypatch):
    monkeypatch.delenv("DISPLAY", raising=False)
    monkeypatch.delenv("WAYLAND_DISPLAY", raising=False)
    with pytest.raises(mimo.UnsupportedError, match="no window"):
        plot.Window()
    monkeypatch.setenv("DISPLAY", ":99")
    with pytest.raises(mimo.UnsupportedError, match="install tkinter"):
        plot.Window()


def test_a_window_shows_the_last_picture(monkeypatch):
    monkeypatch.setattr(plot, "has_display", lambda: True)
    monkeypatch.setattr(FigureCanvasAgg, "required_interactive_framework", "headless")
    window = plot.Window()
    for value in (0, 200):
        window.show(np.full((4, 4, 3), value, np.uint8))
    assert window._image.get_array().min() == 200
    window.close()
