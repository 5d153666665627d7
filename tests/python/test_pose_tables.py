"""Tables of DeepLabCut and folders of OpenPose, written after their manuals, and names of other key points."""

import json

import numpy as np
import pytest
from known_points import NAMES, infant, movement

import mimo

pytest.importorskip("scipy", reason="SciPy is not installed")
from mimo.pose_tables import BODY_25, common_names

motion = mimo.motion
CAMERA = motion.Camera.pinhole(45, 640, 480, position=[-1.2, 0.9, 1.1], look_at=[0.2, 0.1, 0.5])
ROWS = 3
JOINTS = {"shoulder": "Shoulder", "elbow": "Elbow", "wrist": "Wrist", "hip": "Hip", "knee": "Knee", "ankle": "Ankle"}
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


@pytest.fixture(scope="module")
def filmed():
    """Where the points of a known movement are in a picture of 640 x 480, by name."""
    with infant() as world:
        _, places = movement(world, rows=ROWS)
    pixels = np.stack([CAMERA.project(row) for row in places])
    return dict(zip(NAMES, pixels.transpose(1, 0, 2)))


def openpose(folder, pixels, width=25, confidence=0.9):
    folder.mkdir()
    for frame in range(ROWS):
        numbers = np.zeros((width, 3))
        for name, places in pixels.items():
            side, _, joint = name.partition("_")
            theirs = "Nose" if name == "nose" else side[0].upper() + JOINTS.get(joint, joint.title())
            if theirs in BODY_25:
                numbers[BODY_25.index(theirs)] = [*places[frame], confidence]
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


def test_smil_s_joints_have_places():
    """All 25: limbs and nose are known; the spine, clavicles and the middle of the head are not."""
    found = common_names(SMIL)
    assert set(SMIL) - set(found) == {
        *("global", "spine", "spine1", "spine2", "neck", "head", "leftShoulder", "rightShoulder")
    }
    assert [found[it] for it in ("leftThigh", "rightCalf", "leftFoot", "leftUpperArm", "rightHand", "noseVertex")] == [
        *("left_hip", "right_knee", "left_ankle", "left_shoulder", "right_wrist", "nose")
    ]
    with infant() as world:
        motion.places_of(world, list(found.values()), {})


def test_openpose_s_joints_have_places():
    found = common_names(BODY_25)
    assert set(BODY_25) - set(found) == {"Neck", "MidHip", "LSmallToe", "RSmallToe", "LHeel", "RHeel"}
    assert (found["LBigToe"], found["REye"], found["LEar"]) == ("left_toes", "right_eye", "left_ear")
    with infant() as world:
        motion.places_of(world, [it for it in found.values()], {})


@pytest.mark.parametrize("write", [openpose, deeplabcut])
def test_a_film_is_fitted(filmed, tmp_path, write):
    pixels = filmed
    write(tmp_path / "film", pixels)
    points = motion.read_points(str(tmp_path / "film"), rate=25)
    np.testing.assert_allclose(points.times, 0.04 * np.arange(ROWS))
    elbow = points.names.index("left_elbow")
    np.testing.assert_allclose(points.values[:, elbow], pixels["left_elbow"])
    assert set(points.weights[:, elbow]) == {0.9}
    with infant() as world:
        found = motion.fit(world, points, CAMERA, stiffness=0.01)
    assert np.nanmax(found.errors) < 8  # pixels of 640 x 480


def test_the_command_takes_them(filmed, tmp_path, capsys):
    openpose(tmp_path / "film", filmed)
    camera = {"fovy": 45, "width": 640, "height": 480, "position": [-1.2, 0.9, 1.1], "look_at": [0.2, 0.1, 0.5]}
    (tmp_path / "camera.json").write_text(json.dumps(camera))
    given = [str(tmp_path / "film"), "--camera", str(tmp_path / "camera.json"), "--out", str(tmp_path / "motion.csv")]
    assert motion.main(given) == 1
    assert "has no times, and rate is None, expected its frames a second" in capsys.readouterr().err
    assert not (tmp_path / "motion.csv").exists()
    assert motion.main([*given, "--rate", "25"]) == 0
    assert "no places on the infant: Neck, MidHip" in capsys.readouterr().out


def test_points_that_were_not_found_have_no_weight(filmed, tmp_path):
    openpose(tmp_path / "film", {"nose": filmed["nose"], "left_wrist": filmed["left_wrist"]})
    (tmp_path / "film/film_000000000003_keypoints.json").write_text('{"people": []}')
    points = motion.read_points(str(tmp_path / "film"), rate=25)
    assert points.weights[:, points.names.index("right_wrist")].max() == 0
    assert points.weights[3].max() == 0
    assert np.isnan(points.values[3]).all()


BROKEN_TABLES = {
    "several animals": (lambda it: it.replace("bodyparts,", "individuals,a\nbodyparts,", 1), "has several animals"),
    "no coords": (lambda it: it.replace("coords,", "axes,", 1), "begins with scorer, bodyparts, axes, expected"),
    "a word": (lambda it: it.replace("0.9", "sure", 1), "line 4: a cell is 'sure', expected a number"),
    "cut": (lambda it: it[:-40], "line 6: "),
    "no rows": (lambda it: "\n".join(it.split("\n")[:3]), "no rows of numbers follow the header"),
    "columns twice": (
        lambda it: it.replace("left_elbow", "left_shoulder"),
        "'left_shoulder' has not x, y, likelihood once",
    ),
    "confidence": (lambda it: it.replace("0.9", "1.9", 1), "frame 0: expected finite pixels and a confidence from 0"),
    "infinite": (lambda it: it.replace("0.9", "inf", 1), "frame 0: expected finite pixels"),
}


@pytest.mark.parametrize("kind", BROKEN_TABLES)
def test_broken_tables_of_deeplabcut(filmed, tmp_path, kind):
    change, message = BROKEN_TABLES[kind]
    deeplabcut(tmp_path / "film.csv", filmed)
    (tmp_path / "film.csv").write_text(change((tmp_path / "film.csv").read_text()))
    with pytest.raises(ValueError, match=r"film\.csv") as raised:
        motion.read_points(str(tmp_path / "film.csv"), rate=25)
    assert message in str(raised.value)


BROKEN_FRAMES = {
    "nothing": ("", "is no file of OpenPose"),
    "a list": ("[1]", "is no file of OpenPose"),
    "cut": ('{"people": [{"pose_key', "is no file of OpenPose"),
    "two people": (
        '{"people": [{"pose_keypoints_2d": [0]}, {"pose_keypoints_2d": [0]}]}',
        "has 2 people, expected one",
    ),
    "other joints": ('{"people": [{"pose_keypoints_2d": [1, 2, 3]}]}', "numbers of a person, expected always 75 or 54"),
    "words": ('{"people": [{"pose_keypoints_2d": ["a"]}]}', "is no file of OpenPose"),
}


@pytest.mark.parametrize("kind", BROKEN_FRAMES)
def test_broken_frames_of_openpose(filmed, tmp_path, kind):
    text, message = BROKEN_FRAMES[kind]
    openpose(tmp_path / "film", filmed)
    (tmp_path / "film/film_000000000002_keypoints.json").write_text(text)
    with pytest.raises(ValueError, match="film") as raised:
        motion.read_points(str(tmp_path / "film"), rate=25)
    assert message in str(raised.value)


def test_a_folder_without_frames_is_refused(tmp_path):
    with pytest.raises(ValueError, match="has no files"):
        motion.read_points(str(tmp_path), rate=25)
