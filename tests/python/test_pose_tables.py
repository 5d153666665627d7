"""DeepLabCut's tables, and folders of OpenPose and MINI-RGBD, written after their manuals, and the names in them."""

import json
import subprocess

import numpy as np
import pytest
from known_points import NAMES, TOLD, infant, movement
from recorded import program

import mimo

motion = mimo.motion
CAMERA = motion.Camera.pinhole(45, 640, 480, position=[-1.2, 0.9, 1.1], look_at=[0.2, 0.1, 0.5])
ROWS = 3
JOINTS = {"shoulder": "Shoulder", "elbow": "Elbow", "wrist": "Wrist", "hip": "Hip", "knee": "Knee", "ankle": "Ankle"}
BODY_25 = [
    "Nose",
    "Neck",
    "RShoulder",
    "RElbow",
    "RWrist",
    "LShoulder",
    "LElbow",
    "LWrist",
    "MidHip",
    "RHip",
    "RKnee",
    "RAnkle",
    "LHip",
    "LKnee",
    "LAnkle",
    "REye",
    "LEye",
    "REar",
    "LEar",
    "LBigToe",
    "LSmallToe",
    "LHeel",
    "RBigToe",
    "RSmallToe",
    "RHeel",
]
COCO = [name for name in BODY_25[:19] if name != "MidHip"]
SMIL = [
    "global",
    "leftThigh",
    "rightThigh",
    "spine",
    "leftCalf",
    "rightCalf",
    "spine1",
    "leftFoot",
    "rightFoot",
    "spine2",
    "leftToes",
    "rightToes",
    "neck",
    "leftShoulder",
    "rightShoulder",
    "head",
    "leftUpperArm",
    "rightUpperArm",
    "leftForeArm",
    "rightForeArm",
    "leftHand",
    "rightHand",
    "leftFingers",
    "rightFingers",
    "noseVertex",
]
OF_SMIL = {"Thigh": "hip", "Calf": "knee", "Foot": "ankle", "UpperArm": "shoulder", "ForeArm": "elbow", "Hand": "wrist"}
OF_SMIL.update(Toes="toes", Fingers="fingers")
WITHOUT_PLACE = ["global", "spine", "spine1", "spine2", "neck", "leftShoulder", "rightShoulder", "head"]
ALL = [*NAMES, *(f"{side}_{part}" for side in ("left", "right") for part in ("toes", "fingers"))]
# Of the data set's pictures, 640 x 480, as its depth_to_3D.py has it.
FOCAL, MIDDLE = (588.67905803875317, 590.25690113005601), (322.22048191353628, 237.46785983766890)


@pytest.fixture(autouse=True)
def _with_the_program(monkeypatch):
    monkeypatch.setenv("MIMO_PROGRAM", program())


@pytest.fixture(scope="module")
def filmed():
    """Where the points of a known movement are in a picture of 640 x 480, by name."""
    with infant() as world:
        _, places = movement(world, rows=ROWS)
    pixels = np.stack([CAMERA.project(row) for row in places])
    return dict(zip(NAMES, pixels.transpose(1, 0, 2)))


def openpose(folder, pixels, names=BODY_25, confidence=0.9):
    folder.mkdir()
    for frame in range(ROWS):
        numbers = np.zeros((len(names), 3))
        for name, places in pixels.items():
            side, _, joint = name.partition("_")
            theirs = "Nose" if name == "nose" else side[0].upper() + JOINTS.get(joint, joint.title())
            if theirs in names:
                numbers[names.index(theirs)] = [*places[frame], confidence]
        people = {"people": [{"pose_keypoints_2d": numbers.ravel().tolist()}]}
        (folder / f"film_{frame:012d}_keypoints.json").write_text(json.dumps({"version": 1.3, **people}))


def deeplabcut(path, pixels):
    names = [name for name in pixels if name != "hip"]
    lines = ["scorer," + ",".join(["net"] * 3 * len(names))]
    lines.append("bodyparts," + ",".join(name for name in names for _ in range(3)))
    lines.append("coords," + ",".join(["x,y,likelihood"] * len(names)))
    for frame in range(ROWS):
        cells = [repr(float(it)) for name in names for it in [*pixels[name][frame], 0.9]]
        lines.append(",".join([str(frame), *cells]))
    path.write_text("\n".join(lines) + "\n")


@pytest.mark.parametrize(
    "write",
    [openpose, lambda *given: openpose(*given, names=COCO), deeplabcut],
    ids=["openpose", "coco", "deeplabcut"],
)
def test_a_film_is_fitted(filmed, tmp_path, write):
    write(tmp_path / "film", filmed)
    found = motion.fit(tmp_path / "film", CAMERA, rate=25, age=18)
    np.testing.assert_allclose(found.times, 0.04 * np.arange(ROWS))
    assert np.nanmax(found.errors) < 8  # pixels of 640 x 480
    assert {f"{side}_{joint}" for side in ("left", "right") for joint in JOINTS} <= set(found.points)
    assert found.points.count("left_ear") == 1


def test_other_points_of_openpose_are_named(filmed, tmp_path):
    openpose(tmp_path / "film", filmed)
    found = motion.fit(tmp_path / "film", CAMERA, rate=25, age=18)
    assert any("move nothing: Neck, MidHip, LSmallToe, LHeel, RSmallToe, RHeel" in note for note in found.notes)


def test_the_command_takes_them(filmed, tmp_path, capsys):
    openpose(tmp_path / "film", filmed)
    camera = {"fovy": 45, "width": 640, "height": 480, "position": [-1.2, 0.9, 1.1], "look_at": [0.2, 0.1, 0.5]}
    (tmp_path / "camera.json").write_text(json.dumps(camera))
    given = [str(tmp_path / "film"), "--camera", str(tmp_path / "camera.json"), "--out", str(tmp_path / "motion.csv")]
    assert motion.main([*given, "--age", "18"]) == 1
    assert "has no times: expected --rate, its frames a second" in capsys.readouterr().err
    assert not (tmp_path / "motion.csv").exists()
    assert motion.main([*given, "--age", "18", "--rate", "25"]) == 0
    assert "move nothing: Neck, MidHip" in capsys.readouterr().out


def test_points_that_were_not_found_have_no_weight(filmed, tmp_path):
    """The wrist of the middle frame lies somewhere else, with confidence 0."""
    openpose(tmp_path / "film", filmed)
    path = tmp_path / "film/film_000000000001_keypoints.json"
    people = json.loads(path.read_text())
    wrist = 3 * BODY_25.index("LWrist")
    people["people"][0]["pose_keypoints_2d"][wrist : wrist + 3] = [600.0, 10.0, 0.0]
    path.write_text(json.dumps(people))
    (tmp_path / "film/film_000000000003_keypoints.json").write_text('{"people": []}')
    found = motion.fit(tmp_path / "film", CAMERA, rate=25, age=18)
    assert np.isnan(found.errors[3]).all()
    assert found.errors[1, found.points.index("left_wrist")] < 8  # filled by a straight line
    assert any("left_wrist was not seen in 2 of 4 rows; 1 were filled" in note for note in found.notes)


# ---- MINI-RGBD -------------------------------------------------------------------------------------------------------


def lying(age, rows):
    """A known movement of an infant on its back, a metre below a camera: x right, y down, z away, m; and its angles."""
    with infant(age) as world:
        angles, points = movement(world, rows=rows, names=ALL)
    points = points - points.mean(axis=(0, 1))
    return angles, np.stack([points[..., 1], -points[..., 2], 1 - points[..., 0]], axis=-1)


def mini_rgbd(folder, places, noise=0.0, kind="joints_2Ddep"):
    """The data set's files: a line for each of SMIL's joints, x, y, depth and its number. Pixels, mm; or m in 3-D."""
    random = np.random.default_rng(3)
    (folder / kind).mkdir(parents=True)
    for frame, row in enumerate(places):
        lines = []
        for number, name in enumerate(SMIL):
            side = next((side for side in ("left", "right") if name.startswith(side)), "")
            ours = "nose" if name == "noseVertex" else f"{side}_{OF_SMIL.get(name[len(side) :])}"
            x, y, z = row[ALL.index(ours)] if ours in ALL else row.mean(axis=0)
            if kind == "joints_2Ddep":
                u, v = noise * random.standard_normal(2) + MIDDLE + np.multiply(FOCAL, (x, y)) / z
                lines.append(f"{u:.6f} {v:.6f} {1000 * z:.6f} {number}")
            else:
                lines.append(f"{x:.6f} {y:.6f} {z:.6f} {number}")
        (folder / kind / f"syn_{kind}_{frame:05d}.txt").write_text("\n".join(lines) + "\n")


def test_mini_rgbd_fits_within_eight_pixels(tmp_path):
    """Noise of 2 pixels; nobody tells age or camera."""
    _, places = lying(6, rows=4)
    mini_rgbd(tmp_path / "01", places, noise=2.0)
    found = motion.fit(tmp_path / "01", rate=30)
    assert found.rms < 8  # pixels of 640 x 480
    np.testing.assert_allclose(found.rms, np.sqrt(np.nanmean(found.errors**2)), rtol=1e-6)
    assert len(found.points) == len(SMIL) - len(WITHOUT_PLACE)
    # One view tells proportions, and noise hides those: how sure the age is stands in the notes.
    assert any(f"an infant of {found.age:.3g} months fits the points best; from" in note for note in found.notes)
    assert any("move nothing: " + ", ".join(WITHOUT_PLACE) in note for note in found.notes)


def test_mini_rgbd_in_space_gives_age_and_angles(tmp_path):
    angles, places = lying(4, rows=5)
    mini_rgbd(tmp_path / "01", places, kind="joints_3D")
    found = motion.fit(tmp_path / "01", rate=30)
    assert found.age == pytest.approx(4, abs=0.2)
    told = found.positions[:, [found.columns.index(name) for name in TOLD]]
    assert np.abs(told - angles).max() < np.radians(0.5)
    front = found.positions[0, found.columns.index("mimo_orientation:z")]
    assert -0.2 < front < 0.2  # below the camera


def test_a_frame_without_file_is_a_gap(tmp_path):
    _, places = lying(6, rows=4)
    mini_rgbd(tmp_path, places)
    (tmp_path / "joints_2Ddep/syn_joints_2Ddep_00002.txt").unlink()
    found = motion.fit(tmp_path / "joints_2Ddep", rate=30, age=6)
    assert len(found.times) == 4
    assert any("1 of 4 frames have no file" in note for note in found.notes)
    assert any("nose was not seen in 1 of 4 rows; 1 were filled" in note for note in found.notes)


def test_a_recording_has_all_senses(tmp_path):
    """What the infant senses as it moves so goes to files of other programs."""
    h5py = pytest.importorskip("h5py", reason="h5py is not installed")
    _, places = lying(6, rows=4)
    mini_rgbd(tmp_path / "01", places)
    command = [program(), "replay", "--motion", str(tmp_path / "01"), "--rate", "30", "--age", "6", "--scene", "free"]
    kept = ["--senses", "all", "--keep", "all", "--out", str(tmp_path / "run.h5")]
    done = subprocess.run([*command, *kept, "--joints", str(tmp_path / "joints.csv")], capture_output=True, text=True)
    if done.returncode != 0 and "HDF5" in done.stderr:
        pytest.skip(done.stderr.strip())
    assert done.returncode == 0, done.stderr
    with h5py.File(tmp_path / "run.h5") as file:
        assert {"proprioception", "touch", "vestibular"} <= set(file["fields"])
        assert len(file["time"]) == len(file["joints/position"]) == 10  # 3 / 30 s in steps of 10 ms
        assert np.isnan(file["actions"]).all()

    def again(*options):
        return subprocess.run([program(), "replay", str(tmp_path / "run.h5"), *options], capture_output=True, text=True)

    assert "its steps from 0 on follow a known movement; a replay by joints plays them: --by-joints" in again().stderr
    assert "10 steps from 0 s: identical" in again("--by-joints").stdout


BROKEN_JOINTS = {
    "cut": (lambda it: it[: it.index("\n10 ") if "\n10 " in it else 200], "expected"),
    "too few": (lambda it: "\n".join(it.split("\n")[:24]) + "\n", "has 24 joints, expected 25; was it cut off?"),
    "twice": (lambda it: it.split("\n")[0] + "\n" + it, "line 2: expected x, y, depth, and 1, the joint's number"),
    "more": (lambda it: it + "1 2 3 25\n", "line 26: expected x, y, depth, and 25, the joint's number; there are 25"),
    "a word": (lambda it: it.replace(" ", " here ", 1), "line 1: 'here', expected a number"),
    "nan": (lambda it: "nan" + it[it.index(" ") :], "line 1: 'nan', expected a number"),
    "three numbers": (lambda it: it.replace(" 0\n", "\n", 1), "line 1: expected x, y, depth, and 0"),
    "empty": (lambda it: "", "has 0 joints, expected 25"),
}


@pytest.mark.parametrize("kind", BROKEN_JOINTS)
def test_broken_files_of_mini_rgbd(tmp_path, kind):
    change, message = BROKEN_JOINTS[kind]
    mini_rgbd(tmp_path, np.ones((2, len(ALL), 3)))
    path = tmp_path / "joints_2Ddep/syn_joints_2Ddep_00001.txt"
    path.write_text(change(path.read_text()))
    with pytest.raises(ValueError, match=r"syn_joints_2Ddep_00001\.txt") as raised:
        motion.fit(tmp_path, rate=30, age=6)
    assert message in str(raised.value)


def test_options_that_pixels_have_no_use_for_are_refused(filmed, tmp_path):
    deeplabcut(tmp_path / "film.csv", filmed)
    for options, message in (({"scale": 2.0}, "--scale has no effect"), ({"up": "y"}, "--up has no effect")):
        with pytest.raises(ValueError, match=message):
            motion.fit(tmp_path / "film.csv", CAMERA, rate=25, age=18, **options)
    with pytest.raises(ValueError, match="its points are pixels, expected --camera"):
        motion.fit(tmp_path / "film.csv", rate=25, age=18)


BROKEN_TABLES = {
    "several animals": (lambda it: it.replace("bodyparts,", "individuals,a\nbodyparts,", 1), "has several animals"),
    "no coords": (lambda it: it.replace("coords,", "axes,", 1), "line 3: expected coords"),
    "a word": (lambda it: it.replace("0.9", "sure", 1), "line 4: column 'left_shoulder' is 'sure', expected a number"),
    "cut": (lambda it: it[:-40], "line 6: "),
    "no rows": (lambda it: "\n".join(it.split("\n")[:3]), "no rows of numbers follow the header"),
    "columns twice": (
        lambda it: it.replace("left_elbow", "left_shoulder"),
        "'left_shoulder' has not x, y, likelihood once",
    ),
    "confidence": (
        lambda it: it.replace("0.9", "1.9", 1),
        "line 4: the likelihood of 'left_shoulder' is 1.9, expected 0 to 1",
    ),
    "infinite": (lambda it: it.replace("0.9", "inf", 1), "line 4: column 'left_shoulder' is 'inf', expected a number"),
}


@pytest.mark.parametrize("kind", BROKEN_TABLES)
def test_broken_tables_of_deeplabcut(filmed, tmp_path, kind):
    change, message = BROKEN_TABLES[kind]
    deeplabcut(tmp_path / "film.csv", filmed)
    (tmp_path / "film.csv").write_text(change((tmp_path / "film.csv").read_text()))
    with pytest.raises(ValueError, match=r"film\.csv") as raised:
        motion.fit(tmp_path / "film.csv", CAMERA, rate=25, age=18)
    assert message in str(raised.value)


BROKEN_FRAMES = {
    "nothing": ("", "is no file of OpenPose"),
    "a list": ("[1]", "is no file of OpenPose"),
    "cut": ('{"people": [{"pose_key', "is no file of OpenPose"),
    "two people": (
        '{"people": [{"pose_keypoints_2d": [0]}, {"pose_keypoints_2d": [0]}]}',
        "has 2 people, expected one",
    ),
    "other joints": ('{"people": [{"pose_keypoints_2d": [1, 2, 3]}]}', "3 numbers of a person, expected 75 or 54"),
    "words": ('{"people": [{"pose_keypoints_2d": ["a"]}]}', "is no file of OpenPose"),
}


@pytest.mark.parametrize("kind", BROKEN_FRAMES)
def test_broken_frames_of_openpose(filmed, tmp_path, kind):
    text, message = BROKEN_FRAMES[kind]
    openpose(tmp_path / "film", filmed)
    (tmp_path / "film/film_000000000002_keypoints.json").write_text(text)
    with pytest.raises(ValueError, match="film") as raised:
        motion.fit(tmp_path / "film", CAMERA, rate=25, age=18)
    assert message in str(raised.value)


def test_a_folder_without_frames_is_refused(tmp_path):
    with pytest.raises(ValueError, match="has no files"):
        motion.fit(tmp_path, CAMERA, rate=25, age=18)
