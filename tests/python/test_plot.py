"""Pictures: what is drawn is what was sensed."""

import resource
import signal
import subprocess
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from recorded import record

import mimo
from mimo import plot
from mimo.body_map import BodyMap
from mimo.frames import inverse, turned
from mimo.traces import traces


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
    for _ in range(200):  # falls to the floor, and over
        world.step()
    figure = plot.touch_map(world)
    every, felt = figure.axes[0].collections
    force = np.linalg.norm(world.observation["touch/force"], axis=1)
    assert len(every.get_offsets()) == world.layout.fields["touch/force"].receptors
    assert len(felt.get_offsets()) == np.count_nonzero(force) > 0
    # It lies on its back: of what its head and trunk feel, nearly all is on the right, where the back is drawn.
    body = BodyMap(world)
    sensors = world.layout.receptors("touch/force")
    names = np.array(world.bodies().names)[sensors.bodies]
    trunk = np.isin(names, ["head", "upper_body", "lower_body"])
    assert np.average(body.places[trunk, 0] > body.width / 2, weights=force[trunk]) > 0.9
    figure.savefig(tmp_path / "touch.png")
    with pytest.raises(ValueError, match="touch"):
        plot.touch_map(mimo.World("reach"))


def test_the_skin_unfolded():
    """Every sensor on its side of the body, left and right as on a doctor's sheet."""
    with mimo.World("benchmark", vision=False) as world:
        world.reset(seed=1)
        body, sensors = BodyMap(world), world.layout.receptors("touch/force")
        names = np.array(world.bodies().names)[sensors.bodies]
        left, right = (np.char.startswith(names, side) for side in ("left_", "right_"))
        on_front = body.places[:, 0] < body.width / 2
        np.testing.assert_array_equal(on_front, body.front)
        for side, sign in ((left, 1), (right, -1)):
            assert (sign * (body.places[side & body.front, 0] - body.middles[0]) > 0).all()
            assert (sign * (body.places[side & ~body.front, 0] - body.middles[1]) < 0).all()
        assert (body.places.min(axis=0) >= 0).all()
        assert (body.places.max(axis=0) <= [body.width + 1e-9, 1]).all()
        heights = [np.median(body.places[names == part, 1]) for part in ("head", "upper_body", "left_foot")]
        assert heights == sorted(heights, reverse=True)
        before = world.save()
        BodyMap(world)
        assert world.save() == before  # the world itself does not move


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    options = ["--scene", "showroom", "--senses", "hearing", "--keep", "hearing,touch", "--seconds", "0.8"]
    return record(tmp_path_factory.mktemp("plot") / "run.h5", *options)


def test_a_recording_over_time(run):
    h5py = pytest.importorskip("h5py", reason="h5py is not installed")
    with mimo.Recording(run) as recording, recording.world(eyes=0) as world, h5py.File(run) as file:
        seen = traces(recording)
        columns = file["joints/position"].attrs["names"].decode().split("\n")
        elbow = file["joints/position"][:, columns.index("robot:left_elbow")]
        low, high = world.joints("robot:left_elbow").range.ravel()
        np.testing.assert_allclose(seen.bends[:, seen.joints.index("left elbow")], 2 * (elbow - low) / (high - low) - 1)
        force = np.linalg.norm(file["fields/touch/force"], axis=2)
        np.testing.assert_allclose(seen.forces.sum(axis=1), force.sum(axis=1), rtol=1e-5)
        hand = world.layout.receptors("touch/force").bodies == world.find("body", "left_hand")
        np.testing.assert_allclose(seen.forces[:, seen.parts.index("left hand")], force[:, hand].sum(axis=1), rtol=1e-5)
        heard = np.sqrt((file["fields/hearing/ear_right"][()].astype(float) ** 2).mean(axis=1))
        np.testing.assert_allclose(10 ** (seen.levels[:, 1] / 20) * 20e-6, np.maximum(heard, 20e-6), rtol=1e-4)
        assert heard.max() > 1e-3
        recording.play(world, compare_fields=False)
        gaze, head = world.gaze(), world.bodies("head").orientation
        ahead, left, up = turned(inverse(head), gaze.left.direction)[0]
        np.testing.assert_allclose(seen.gaze[-1, :2], np.degrees([np.arctan2(left, ahead), np.arcsin(up)]), atol=1e-6)


def test_a_recording_at_a_glance(run, tmp_path, monkeypatch, capsys):
    monkeypatch.setattr("sys.argv", ["mimo.plot", str(run), "--out", str(tmp_path / "run.png")])
    assert plot.main() == 0
    assert plt.imread(tmp_path / "run.png").shape[2] == 4
    with mimo.Recording(run) as recording:
        seen = traces(recording)
    titles = [axes.get_title(loc="left") for axes in plot.run(seen).axes if axes.get_title(loc="left")]
    assert [title.split(",")[0] for title in titles] == ["joints", "touch", "gaze", "sound at the ears"]
    quiet = seen._replace(levels=None, rewards=np.ones(len(seen.time)))
    titles = [axes.get_title(loc="left") for axes in plot.run(quiet).axes if axes.get_title(loc="left")]
    assert titles[-1] == "reward"
    capsys.readouterr()
    for options, told in (
        ([str(run), "--infant", "2"], "infant is 2, expected 0 to 0"),
        (["no.h5"], "the file does not exist"),
        ([str(run), "--out", str(tmp_path / "nowhere" / "no.png")], "there is no folder"),
        ([str(run), "--out", str(tmp_path)], "it is a folder"),
    ):
        monkeypatch.setattr("sys.argv", ["mimo.plot", "--out", str(tmp_path / "no.png"), *options])
        assert plot.main() == 1
        assert told in capsys.readouterr().err
    assert not (tmp_path / "no.png").exists()


@pytest.mark.parametrize("ending", ["png", "pdf", "svg"])
def test_a_full_disk_keeps_the_old_picture(run, tmp_path, ending):
    path = tmp_path / f"run.{ending}"
    path.write_text("of yesterday")

    def small_disk():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (10_000, 10_000))

    command = [sys.executable, "-m", "mimo.plot", str(run), "--out", str(path)]
    done = subprocess.run(command, capture_output=True, text=True, preexec_fn=small_disk)
    assert (done.returncode, done.stdout) == (1, "")
    assert f"python -m mimo.plot: cannot write {path}: File too large\n" in done.stderr
    assert path.read_text() == "of yesterday"
    assert len(list(tmp_path.iterdir())) == 1


def test_touch_over_time_is_a_running_mean():
    """A sensor that is pressed in every fourth step of 10 ms, with 4 N, feels 1 N on an average over 0.25 s or so."""
    time = np.arange(1, 201) / 100
    values = np.zeros((200, 2))
    values[::4, 0] = 4
    values[100, 1] = 25
    mean = plot.running_mean(time, values)
    assert np.abs(mean[20:-20, 0] - 1).max() < 0.15  # 25 steps have six or seven
    np.testing.assert_allclose(np.flatnonzero(mean[:, 1]), np.arange(88, 113))  # 12 steps before and after
    assert mean[100, 1] == pytest.approx(1)
    np.testing.assert_allclose(plot.running_mean(time, np.full((200, 1), 3.0)), 3)  # at the ends too
    assert plot.running_mean(time[:1], values[:1]).tolist() == [[4, 0]]


def test_figures_for_papers(run):
    """No title unless it is asked for, legends that cover nothing, units as acousticians write them; not in pyplot."""
    with mimo.Recording(run) as recording:
        seen = traces(recording)
    figure = plot.run(seen)
    assert figure.get_suptitle() == ""
    assert plot.run(seen, "night 3").get_suptitle() == "night 3"
    FigureCanvasAgg(figure).draw()
    legends = [axes for axes in figure.axes if axes.get_legend()]
    assert len(legends) == 2
    for axes in legends:
        assert axes.get_legend().get_window_extent().y0 >= axes.get_window_extent().y1 - 1
    assert "dB re 20 µPa" in [axes.get_ylabel() for axes in figure.axes]
    with mimo.World("benchmark", vision_width=8, vision_height=8) as world:
        skin = plot.touch_map(world, world.reset(seed=1))
        plot.eyes(world.observation)
        plot.joint_angles([0], [world.joints("robot:left_elbow").position], world.joints("robot:left_elbow"))
    idle = skin.axes[0].collections[0]
    assert idle.get_facecolor().ravel()[0] <= 0.6  # of white; a printer prints that
    assert np.sqrt(idle.get_sizes()[0]) >= 1.5  # points of 1/72 inch, across
    assert plt.get_fignums() == []


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
