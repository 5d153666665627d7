"""Key points lead back to the joints that made them: forward kinematics is the physics engine's, noise is ours."""

import csv
import json
import subprocess

import numpy as np
import pytest
from known_points import NAMES, TOLD, infant, movement, place
from recorded import program

import mimo
from mimo.constants import Quantity

motion = mimo.motion
CAMERA = motion.Camera.pinhole(45, 1280, 720, (-1.5, 0.3, 0.7), (0.2, 0.1, 0.5))


@pytest.fixture(autouse=True)
def _with_the_program(monkeypatch):
    monkeypatch.setenv("MIMO_PROGRAM", program())


def seen(values, weights=None):
    ones = np.ones(values.shape[:2])
    return motion.KeyPoints(0.04 * np.arange(len(values)), NAMES, values, ones if weights is None else weights)


def columns(found, names):
    return found.positions[:, [found.columns.index(name) for name in names]]


def test_joints_come_back_from_exact_points():
    with infant() as world:
        angles, places = movement(world)
    found = motion.fit(seen(places), age=18)
    assert found.errors.max() < 1e-3  # m
    assert np.abs(columns(found, TOLD) - angles).max() < 5e-3
    assert found.age is None


def test_the_age_comes_back_from_exact_points():
    """Of an infant of six months; the standard's lengths of one of seven are 1.4 cm larger."""
    with infant(age=6) as world:
        angles, places = movement(world, rows=5)
    found = motion.fit(seen(places))
    assert found.age == pytest.approx(6, abs=0.1)
    assert np.abs(columns(found, TOLD) - angles).max() < np.radians(0.5)


def test_noise_of_half_a_centimetre_is_a_few_degrees():
    with infant() as world:
        angles, places = movement(world)
    noise = 0.005 * np.random.default_rng(1).standard_normal(places.shape)
    found = motion.fit(seen(places + noise), age=18)
    assert found.errors.max() < 0.02
    assert np.sqrt(np.mean((columns(found, TOLD) - angles) ** 2)) < np.radians(8)


def test_an_unseen_point_has_no_weight():
    with infant() as world:
        _, places = movement(world)
    weights = np.ones(places.shape[:2])
    gone = NAMES.index("nose")
    weights[:, gone] = 0
    places[:, gone] = np.nan
    places[3, NAMES.index("left_wrist")] += 0.5
    weights[3, NAMES.index("left_wrist")] = 0
    found = motion.fit(seen(places, weights), age=18)
    assert "nose" not in found.points
    assert found.errors[:3].max() < 1e-3
    assert found.errors[3, found.points.index("left_wrist")] < 0.01  # filled by a straight line, not half a metre away


def test_a_camera_suffices_for_visible_movements():
    middle = CAMERA.project(np.array([[0.2, 0.1, 0.5], [0.2, 0.1, 0.6]]))
    assert np.allclose(middle[0], (640, 360))
    assert middle[1, 1] < 360  # up is up in the picture
    with infant() as world:
        _, places = movement(world)
    pixels = np.array([CAMERA.project(row) for row in places])
    found = motion.fit(seen(pixels), CAMERA, age=18)
    assert np.median(found.errors) < 1  # pixels
    assert found.errors.max() < 8


def test_one_point_far_off_counts_less_where_the_fit_is_robust():
    with infant() as world:
        _, places = movement(world, rows=3)
    places[:, NAMES.index("left_wrist")] += (0, 0, 0.15)
    plain = motion.fit(seen(places), age=18, scale=1)
    robust = motion.fit(seen(places), age=18, scale=1, robust=True)
    others = [i for i, name in enumerate(robust.points) if name != "left_wrist"]
    assert robust.errors[:, others].mean() < 0.5 * plain.errors[:, others].mean()


def test_limits_hold():
    """A forearm that bends backwards by 0.6 rad: the elbow stays nearly straight, and the wrist is off.

    A radian beyond a limit costs as much as ten centimetres.
    """
    with infant() as world:
        hinge = ["robot:left_elbow"]
        high = world.get(Quantity.JOINT_RANGE, hinge)[0, 1]
        world.set(Quantity.JOINT_POSITION, [high + 0.6], hinge)
        world.update()
        places = np.array([[place(world, name) for name in NAMES]])
    found = motion.fit(seen(places), age=18)
    assert columns(found, hinge)[0, 0] < high + 0.3


def test_points_of_ones_own_have_places(tmp_path):
    """A sock is no usual name; the foot begins at the ankle."""
    with infant() as world:
        _, places = movement(world, rows=2)
        feet = world.get(Quantity.BODY_POSITION, ["left_foot"], now=True)
    sock = np.repeat(feet[None], 2, axis=0)
    names = [*NAMES, "sock"]
    values = np.concatenate([places, sock], axis=1)
    points = motion.KeyPoints(0.04 * np.arange(2), names, values, np.ones(values.shape[:2]))
    assert "sock" not in motion.fit(points, age=18).points
    kept = {name: (name, ()) for name in NAMES}
    found = motion.fit(points, age=18, places={**kept, "sock": ("left_foot", (0, 0, 0))})
    assert found.errors[1, found.points.index("sock")] < 2e-3


@pytest.mark.parametrize(
    "table",
    [
        "time;left_wrist:x;left_wrist:y;left_wrist:z\n0;0,1;0,2;0,3\n",
        "time\tleft_wrist:x\tleft_wrist:y\tleft_wrist:z\n0\t0,1\t0,2\t0,3\n",
        '\ufeff"time","left_wrist:x","left_wrist:y","left_wrist:z"\n"0","0.1","0.2","0.3"\n',
    ],
)
def test_tables_of_spreadsheets_are_read(tmp_path, table):
    """One point is too few for a fit; the message says that its name was known."""
    (tmp_path / "points.csv").write_text(table, encoding="utf-8")
    with pytest.raises(ValueError, match="1 markers have a name that tells where they are, expected 4 or more"):
        motion.fit(tmp_path / "points.csv", age=18)


def test_a_filter_removes_fast_and_keeps_slow_movements(tmp_path):
    """There and back, a Butterworth filter of second order leaves 1 / (1 + (f / cutoff)^4) of a wave."""
    times = np.arange(200) / 50
    waves = {
        "left_elbow": -0.7 + 0.3 * np.sin(2 * np.pi * times),
        "right_elbow": -0.7 + 0.3 * np.sin(24 * np.pi * times),
    }
    table = "time,left_elbow,right_elbow\n" + "".join(f"{t},{a},{b}\n" for t, a, b in zip(times, *waves.values()))
    (tmp_path / "motion.csv").write_text(table)

    def filtered(*options):
        command = [program(), "replay", "--motion", str(tmp_path / "motion.csv"), "--scene", "free", "--touch", "off"]
        return subprocess.run(
            [*command, "--joints", str(tmp_path / "joints.csv"), *options], capture_output=True, text=True
        )

    assert filtered("--cutoff", "6").returncode == 0
    with (tmp_path / "joints.csv").open() as file:
        rows = list(csv.DictReader(file))[50:150]
    found = {name: np.array([float(row[f"robot:{name}"]) for row in rows]) for name in waves}
    assert np.abs(found["left_elbow"] - waves["left_elbow"][50:150]).max() < 0.3 * 0.005
    assert np.abs(found["right_elbow"] + 0.7).max() < 0.3 * 0.06  # 1 / 17
    assert "--cutoff is 25 Hz, expected less than half of the rate, 25 Hz" in filtered("--cutoff", "25").stderr
    (tmp_path / "motion.csv").write_text("\n".join(table.split("\n")[:6]))
    assert "--cutoff needs 11 rows or more in equal steps of time; there are 5" in filtered("--cutoff", "6").stderr


def write(path, places, parts):
    with path.open("w") as file:
        file.write("time," + ",".join(f"{name}:{part}" for name in NAMES for part in parts) + "\n")
        for row, values in enumerate(places):
            file.write(f"{0.04 * row}," + ",".join(repr(float(value)) for value in values.ravel()) + "\n")


def test_the_command_writes_what_replay_follows(tmp_path, capsys):
    with infant(age=6) as world:
        _, places = movement(world, rows=4)
    write(tmp_path / "points.csv", places, "xyz")
    files = ["--out", str(tmp_path / "motion.csv"), "--errors", str(tmp_path / "errors.csv")]
    assert motion.main([str(tmp_path / "points.csv"), *files, "--age", "6"]) == 0
    assert "left_elbow" in capsys.readouterr().out
    with (tmp_path / "errors.csv").open() as file:
        rows = list(csv.DictReader(file))
    assert max(float(row["left_wrist"]) for row in rows) < 1e-3
    command = [program(), "replay", "--motion", str(tmp_path / "motion.csv"), "--scene", "free", "--age", "6", "--json"]
    done = subprocess.run([*command, "--touch", "off"], capture_output=True, text=True, check=True)
    assert json.loads(done.stdout)["rows"] == 4


@pytest.mark.parametrize(
    ("table", "message"),
    [
        ("nose:x,nose:y,nose:z\n1,2,3\n", "no column 'time'"),
        ("time,left_elbow:x,left_elbow:y\n0,1,2\n", "no column 'left_elbow:z'"),
        ("time,nose:u,nose:v\n0,1,2\n", "its points are pixels, expected --camera"),
        ("time,nose:u,nose:v,nose:x\n0,1,2,3\n", "nose has columns in m and in pixels"),
        ("time,nose:x,nose:y,nose:z\n0,1,2,three\n", "line 2: column 'nose:z' is 'three', expected a number"),
        ("time,nose:x,nose:y,nose:z\n0,1,2\n", "line 2: 3 cells, expected 4"),
        ("time,nose:x,nose:y,nose:z\n0,1,2,3\n0,1,2,3\n", "line 3: time is 0 s after 0 s, expected a later one"),
        ("time,nose:x,nose:y,nose:z\n,1,2,3\n", "line 2: time is empty"),
        ("time,nose:x,nose:y,nose:z,tail:x,tail:y,tail:z\n0,1,2,3,1,2,3\n", "expected 4 or more; it has tail"),
        ("time,nose:x,nose:y,nose:z\n", "no rows"),
        ("time,nose:x,nose:x,nose:y,nose:z\n0,9,1,2,3\n", "line 1: column 'nose:x' appears twice"),
        ("time,nose:x,nose:y,nose:z\ninf,1,2,3\n", "line 2: column 'time' is 'inf'"),
        ("time,nose:x,nose:y,nose:z\n0,-inf,2,3\n", "line 2: column 'nose:x' is '-inf'"),
        ("time,nose:x,nose:y,nose:z,nose:w\n0,1,2,3,-1\n", "line 2: column 'nose:w' is -1, expected 0 or more"),
        ("time,nose:x,nose:y,nose:z,nose:p\n0,1,2,3,-1\n", "column 'nose:p' is not :x, :y, :z or :u, :v, or :w"),
        ('time,nose:x,nose:y,"nose:z\n0,1,2,3\n', "is not closed"),
        ('time,nose:x,nose:y,nose:z\n0,1,"2"5,3\n', "line 2: the quoted cell '2' is followed by"),
        ("time,nose:x,nose:y,nose:z\n0,1,1_0,3\n", "line 2: column 'nose:y' is '1_0'"),
    ],
)
def test_bad_tables(tmp_path, capsys, table, message):
    (tmp_path / "bad.csv").write_text(table)
    assert motion.main([str(tmp_path / "bad.csv"), "--out", str(tmp_path / "motion.csv")]) == 1
    shown = capsys.readouterr().err
    assert message in shown
    assert shown.count("\n") == 1
    assert not (tmp_path / "motion.csv").exists()


@pytest.mark.parametrize(
    ("camera", "message"),
    [
        ({"matrix": [[1, 0, 0, 0], [0, 1, 0, 0]]}, "matrix is no 3 rows of 4 numbers"),
        ({"width": 64, "height": 48, "position": [1, 0, 0], "look_at": [0, 0, 0]}, "fx"),
        ({"fovy": 45, "width": 64, "height": 48, "position": [1, 0], "look_at": [0, 0, 0]}, "position has 2 numbers"),
        ({"fovy": 45, "width": 64, "height": 48, "position": [0, 0, 1], "look_at": [0, 0, 0]}, "lies along up"),
        ({"matrix": [[0] * 4] * 3}, "expected three independent rows"),
        ({"fovy": 0, "width": 64, "height": 48, "position": [1, 0, 0], "look_at": [0, 0, 0]}, "fovy is 0"),
    ],
)
def test_bad_cameras(tmp_path, capsys, camera, message):
    (tmp_path / "points.csv").write_text("time,nose:u,nose:v\n0,1,2\n")
    (tmp_path / "camera.json").write_text(json.dumps(camera))
    files = ["--camera", str(tmp_path / "camera.json"), "--out", str(tmp_path / "motion.csv")]
    assert motion.main([str(tmp_path / "points.csv"), *files]) == 1
    shown = capsys.readouterr().err
    assert message in shown
    assert shown.count("\n") == 1
    assert not (tmp_path / "motion.csv").exists()


def test_an_unwritable_table_of_errors_leaves_no_file(tmp_path, capsys):
    (tmp_path / "points.csv").write_text("time,nose:x,nose:y,nose:z\n0,0.1,0,0.5\n")
    files = ["--out", str(tmp_path / "motion.csv"), "--errors", str(tmp_path / "nowhere" / "errors.csv")]
    assert motion.main([str(tmp_path / "points.csv"), *files]) == 1
    assert "nowhere" in capsys.readouterr().err
    assert not (tmp_path / "motion.csv").exists()


@pytest.mark.parametrize("text", ["[" * 100000, '{"matrix": ' + "9" * 5000 + "}", "{", "[1]", ""])
def test_files_without_a_camera_are_refused(text, tmp_path):
    (tmp_path / "camera.json").write_text(text)
    (tmp_path / "points.csv").write_text("time,nose:u,nose:v\n0,1,2\n")
    with pytest.raises(ValueError, match=r"is not a camera: ") as raised:
        motion.fit(tmp_path / "points.csv", tmp_path / "camera.json")
    assert "\n" not in str(raised.value)
