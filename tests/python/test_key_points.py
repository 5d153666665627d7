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

pytest.importorskip("scipy", reason="SciPy is not installed")
motion = mimo.motion


def seen(values, weights=None):
    ones = np.ones(values.shape[:2])
    return motion.KeyPoints(0.04 * np.arange(len(values)), NAMES, values, ones if weights is None else weights)


def columns(found, names):
    return found.positions[:, [found.columns.index(name) for name in names]]


def test_joints_come_back_from_exact_points():
    with infant() as world:
        angles, places = movement(world)
    with infant() as world:
        found = motion.fit(world, seen(places), stiffness=1e-3)
    assert found.errors.max() < 1e-4  # m
    assert np.abs(columns(found, TOLD) - angles).max() < 5e-3


def test_noise_of_half_a_centimetre_is_a_few_degrees():
    with infant() as world:
        angles, places = movement(world)
    noise = 0.005 * np.random.default_rng(1).standard_normal(places.shape)
    with infant() as world:
        found = motion.fit(world, seen(places + noise))
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
    with infant() as world:
        found = motion.fit(world, seen(places, weights))
    assert np.isnan(found.errors[:, gone]).all()
    assert np.delete(found.errors, gone, axis=1)[:3].max() < 1e-4


def test_a_camera_suffices_for_visible_movements():
    camera = motion.Camera.pinhole(45, 1280, 720, (-1.5, 0.3, 0.7), (0.2, 0.1, 0.5))
    middle = camera.project(np.array([[0.2, 0.1, 0.5], [0.2, 0.1, 0.6]]))
    assert np.allclose(middle[0], (640, 360))
    assert middle[1, 1] < 360  # up is up in the picture
    with infant() as world:
        _, places = movement(world)
    pixels = np.array([camera.project(row) for row in places])
    with infant() as world:
        found = motion.fit(world, seen(pixels), camera)
    assert np.median(found.errors) < 1  # pixels
    assert found.errors.max() < 8


def test_limits_hold():
    """A forearm that bends backwards by 0.6 rad: the elbow stays straight, and the wrist is off."""
    with infant() as world:
        hinge = ["robot:left_elbow"]
        high = world.get(Quantity.JOINT_RANGE, hinge)[0, 1]
        world.set(Quantity.JOINT_POSITION, [high + 0.6], hinge)
        world.update()
        places = np.array([[place(world, name) for name in NAMES]])
    with infant() as world:
        found = motion.fit(world, seen(places))
        limits = world.get(Quantity.JOINT_RANGE, found.columns[7:])
    hinges = found.positions[0, 7:]
    assert (hinges > limits[:, 0] - 1e-6).all()
    assert (hinges < limits[:, 1] + 1e-6).all()


@pytest.mark.parametrize(
    "table",
    [
        "time;left_wrist:x;left_wrist:y;left_wrist:z\n0;0,1;0,2;0,3\n",
        "time\tleft_wrist:x\tleft_wrist:y\tleft_wrist:z\n0\t0,1\t0,2\t0,3\n",
        '\ufeff"time","left_wrist:x","left_wrist:y","left_wrist:z"\n"0","0.1","0.2","0.3"\n',
    ],
)
def test_tables_of_spreadsheets_are_read(tmp_path, table):
    (tmp_path / "points.csv").write_text(table, encoding="utf-8")
    points = mimo.motion.read_points(str(tmp_path / "points.csv"))
    assert points.values.ravel().tolist() == [0.1, 0.2, 0.3]


def test_a_filter_removes_fast_and_keeps_slow_movements():
    """There and back, a Butterworth filter of second order leaves 1 / (1 + (f / cutoff)^4) of a wave."""
    times = np.arange(200) / 50
    waves = {"slow": np.sin(2 * np.pi * 1 * times), "fast": np.sin(2 * np.pi * 12 * times)}
    root = np.tile([0, 0, 0, 1.0, 0, 0, 0], (200, 1))
    root[1::2] *= np.array([1, 1, 1, -1, -1, -1, -1])  # the same orientation all the time
    found = motion.Found(
        times, ["root"] * 7 + list(waves), np.column_stack([root, *waves.values()]), [], np.empty((200, 0))
    )
    positions = found.smoothed(6).positions[50:150]
    assert np.abs(np.abs(positions[:, 3]) - 1).max() < 1e-9
    assert np.abs(positions[:, 7] - waves["slow"][50:150]).max() < 0.005
    assert np.abs(positions[:, 8]).max() < 0.06  # 1 / 17
    for cutoff in (0, 25, np.nan):
        with pytest.raises(ValueError, match="cutoff is"):
            found.smoothed(cutoff)
    with pytest.raises(ValueError, match="11 rows"):
        found._replace(times=times[:5]).smoothed(6)


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
    assert max(float(row["left_wrist"]) for row in rows) < 1e-4
    command = [program(), "replay", "--motion", str(tmp_path / "motion.csv"), "--scene", "free", "--age", "6", "--json"]
    done = subprocess.run([*command, "--touch", "off"], capture_output=True, text=True, check=True)
    assert json.loads(done.stdout)["rows"] == 4


@pytest.mark.parametrize(
    ("table", "message"),
    [
        ("x\n1\n", "no column 'time'"),
        ("time,left_elbow:x,left_elbow:y\n0,1,2\n", "no column 'left_elbow:z'"),
        ("time,nose:u,nose:v\n0,1,2\n", "camera is None"),
        ("time,nose:x,nose:y,nose:z\n0,1,2,three\n", "line 2: column 'nose:z'"),
        ("time,nose:x,nose:y,nose:z\n0,1,2\n", "line 2: expected 4 cells"),
        ("time,nose:x,nose:y,nose:z\n0,1,2,3\n0,1,2,3\n", "does not increase in row 2"),
        ("time,tail:x,tail:y,tail:z\n0,1,2,3\n", "key point 'tail'"),
        ("time,nose:x,nose:y,nose:z\n", "no rows"),
        ("time\n0\n", "no key points"),
        ("time,nose:x,nose:x,nose:y,nose:z\n0,9,1,2,3\n", "column 'nose:x' appears twice"),
        ("time,nose:x,nose:y,nose:z\ninf,1,2,3\n", "line 2: column 'time' is inf"),
        ("time,nose:x,nose:y,nose:z\n0,-inf,2,3\n", "line 2: column 'nose:x' is -inf"),
        ("time,nose:x,nose:y,nose:z,nose:w\n0,1,2,3,-1\n", "line 2: column 'nose:w' is -1"),
        (f"time,nose:x,nose:y,nose:z\n0,{'1' * 200000},2,3\n", "line 2: field larger than"),
        ('time,nose:x,nose:y,"nose:z\n0,1,2,3\n', "unexpected end of data"),
        ('time,nose:x,nose:y,nose:z\n0,1,"2"5,3\n', "line 2: ',' expected after '\"'"),
        ("time,nose:x,nose:y,nose:z\n0,1,1_0,3\n", "line 2: column 'nose:y' should be a number, not '1_0'"),
        ('time;"nose, x";nose:y;nose:z\n0;1;2;3\n', "no column 'nose, x:u'"),
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
        ({"matrix": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 3]]}, "expected pixels"),
        ({"matrix": [[0] * 4] * 3}, "three independent rows"),
        ({"fovy": 0, "width": 64, "height": 48, "position": [1, 0, 0], "look_at": [0, 0, 0]}, "fovy is 0"),
    ],
)
def test_bad_cameras(tmp_path, capsys, camera, message):
    (tmp_path / "points.csv").write_text("time,nose:x,nose:y,nose:z\n0,1,2,3\n")
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
    path = tmp_path / "camera.json"
    path.write_text(text)
    with pytest.raises(ValueError, match=r"is not a camera: |matrix has the shape") as raised:
        mimo.key_points.Camera.read(str(path))
    assert "\n" not in str(raised.value)
