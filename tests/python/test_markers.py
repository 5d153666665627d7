"""Files of motion capture, followed by `mimo replay --motion`: a known movement of our body comes back from each."""

import csv
import json
import struct
import subprocess

import numpy as np
import pytest
from known_points import NAMES, TOLD, infant, movement
from recorded import program

RATE = 25.0
DEGREE = np.pi / 180
KEPT = [name for name in NAMES if name != "hip"]
# Names of other places for the same points: Plug-in Gait, SMIL and MINI-RGBD, OpenPose.
GAIT = {"shoulder": "SHO", "elbow": "ELB", "wrist": "WRA", "hip": "HJC", "knee": "KNE", "ankle": "ANK"}
SMIL = {"shoulder": "UpperArm", "elbow": "ForeArm", "wrist": "Hand", "hip": "Thigh", "knee": "Calf", "ankle": "Foot"}
OPENPOSE = {"shoulder": "Shoulder", "elbow": "Elbow", "wrist": "Wrist", "hip": "Hip", "knee": "Knee", "ankle": "Ankle"}


def renamed(name, family):
    side, _, joint = name.partition("_")
    if joint not in OPENPOSE:
        return {"nose": "noseVertex" if family is SMIL else "Nose"}.get(name, name)
    if family is SMIL:
        return side + SMIL[joint]
    return side[0].upper() + family[joint]


@pytest.fixture(scope="module")
def known():
    """Angles, and where the points are: rows x points x 3."""
    with infant() as world:
        angles, points = movement(world, rows=25)
    return angles, points[:, [NAMES.index(name) for name in KEPT]]


# ---- Writers, after the formats' manuals -----------------------------------------------------------------------------


def write_trc(path, names, points, unit=1000.0, word="mm", **changed):
    header = {"frames": len(points), "markers": len(names), **changed}
    keys = "DataRate\tCameraRate\tNumFrames\tNumMarkers\tUnits\tOrigDataRate\tOrigDataStartFrame\tOrigNumFrames"
    lines = [
        f"PathFileType\t4\t(X/Y/Z)\t{path.name}",
        keys,
        f"{RATE}\t{RATE}\t{header['frames']}\t{header['markers']}\t{word}\t{RATE}\t1\t{header['frames']}",
        "Frame#\tTime\t" + "\t\t\t".join(names) + "\t\t",
        "\t\t" + "\t".join(f"{axis}{i + 1}" for i in range(len(names)) for axis in "XYZ"),
        "",
    ]
    for row, places in enumerate(unit * points):
        cells = ["" if np.isnan(value) else repr(float(value)) for value in places.ravel()]
        lines.append("\t".join([str(row + 1), repr(row / RATE), *cells]))
    path.write_text("\r\n".join(lines) + "\r\n")


def write_qualisys(path, names, points, titled=True):
    lines = [f"NO_OF_FRAMES\t{len(points)}", "NO_OF_CAMERAS\t8", f"NO_OF_MARKERS\t{len(names)}", f"FREQUENCY\t{RATE:g}"]
    lines += ["NO_OF_ANALOG\t0", "ANALOG_FREQUENCY\t0", "DESCRIPTION\t--", "TIME_STAMP\t2026-05-01, 12:00:00.000\t1.5"]
    lines += ["DATA_INCLUDED\t3D", "MARKER_NAMES\t" + "\t".join(names)]
    if titled:
        lines.append("Frame\tTime\t" + "\t".join(f"{name} {axis}" for name in names for axis in "XYZ"))
    for row, places in enumerate(1000 * points):
        cells = [repr(float(value)) for value in np.nan_to_num(places).ravel()]  # a gap is three zeros
        lines.append("\t".join(([str(row + 1), f"{row / RATE:.5f}"] if titled else []) + cells))
    path.write_text("\n".join(lines) + "\n")


MIXAMO = {"shoulder": "Arm", "elbow": "ForeArm", "wrist": "Hand", "hip": "UpLeg", "knee": "Leg", "ankle": "Foot"}


def write_skeleton(path, names, points, reference="GLOBAL"):
    """Qualisys' _s_Q: a place and a quaternion of each segment."""
    segments = [i for i, name in enumerate(names) if name.partition("_")[2] in MIXAMO]
    lines = [f"NO_OF_FRAMES\t{len(points)}", "NO_OF_CAMERAS\t8", f"FREQUENCY\t{RATE:g}", f"REFERENCE\t{reference}"]
    titles = [f"{names[i].partition('_')[0].title()}{MIXAMO[names[i].partition('_')[2]]}" for i in segments]
    lines.append("Frame\tTime\t" + "\t".join(f"{it} X\tY\tZ\tQX\tQY\tQZ\tQW" for it in titles).replace("\tY", "\tY"))
    for row, places in enumerate(1000 * points):
        cells = [repr(float(value)) for i in segments for value in [*places[i], 0, 0, 0, 1]]
        lines.append("\t".join([str(row + 1), f"{row / RATE:.5f}", *cells]))
    path.write_text("\n".join(lines) + "\n")


def c3d_bytes(names, points, floats=True, unit="mm", frames=None):
    """The format's manual: a header, parameters, and frames of points, in blocks of 512 bytes, as Intel has numbers."""
    scale = -0.01 if floats else 0.05  # mm a step of whole numbers
    count = frames or len(points)

    def group(number, name):
        return struct.pack("<bb", len(name), -number) + name.encode() + struct.pack("<hb", 3, 0)

    def parameter(number, name, kind, sizes, data):
        body = struct.pack(f"<bb{len(sizes)}B", kind, len(sizes), *sizes) + data + b"\0"
        return struct.pack("<bb", len(name), number) + name.encode() + struct.pack("<h", len(body) + 2) + body

    labels = "".join(name.ljust(16) for name in names).encode()
    parameters = group(1, "POINT") + parameter(1, "USED", 2, [], struct.pack("<h", len(names)))
    parameters += parameter(1, "SCALE", 4, [], struct.pack("<f", scale))
    parameters += parameter(1, "RATE", 4, [], struct.pack("<f", RATE))
    parameters += parameter(1, "DATA_START", 2, [], struct.pack("<h", 4))
    parameters += parameter(1, "FRAMES", 2, [], struct.pack("<H", count))
    parameters += parameter(1, "UNITS", -1, [2], unit.encode().ljust(2))
    parameters += parameter(1, "LABELS", -1, [16, len(names)], labels) + b"\0\0"
    parameters = struct.pack("<BBBB", 1, 0x50, 2, 84) + parameters
    assert len(parameters) <= 1024
    header = struct.pack("<BBHHHHHfHHf", 2, 0x50, len(names), 0, 1, count, 10, scale, 4, 0, RATE).ljust(512, b"\0")
    data = b""
    for places in 1000 * points:
        for place in places:
            gap = np.isnan(place).any()
            x, y, z = np.nan_to_num(place) if floats else np.rint(np.nan_to_num(place) / scale).astype(int)
            data += struct.pack("<ffff" if floats else "<hhhh", x, y, z, -1 if gap else 0)
    return header + parameters.ljust(1024, b"\0") + data.ljust(-(-len(data) // 512) * 512, b"\0")


def write_c3d(path, names, points, **how):
    path.write_bytes(c3d_bytes(names, points, **how))


# ---- Following -------------------------------------------------------------------------------------------------------


def replay(path, *options, code=0):
    command = [
        program(),
        "replay",
        "--motion",
        str(path),
        "--scene",
        "free",
        "--touch",
        "off",
        "--vision",
        "off",
        "--json",
    ]
    done = subprocess.run([*command, *options], capture_output=True, text=True)
    assert done.returncode == code, done.stderr
    return json.loads(done.stdout) if code == 0 else done.stderr


AGE = ("--age", "18")  # of the infant that moves


def angles_of(path, *options, age=AGE):
    """The elbows and knees that the program finds, and its report."""
    joints = path.with_suffix(".joints.csv")
    report = replay(path, "--joints", str(joints), *age, *options)
    with joints.open() as file:
        rows = list(csv.DictReader(file))
    return np.array([[float(row[name]) for name in TOLD] for row in rows]), report


FORMATS = {
    "trc": write_trc,
    "qualisys.tsv": write_qualisys,
    "bare.tsv": lambda *given: write_qualisys(*given, titled=False),
    "run_s_Q.tsv": write_skeleton,
    "floats.c3d": write_c3d,
    "whole.c3d": lambda *given: write_c3d(*given, floats=False),
}


@pytest.mark.parametrize("kind", FORMATS)
def test_a_known_movement_comes_back_within_half_a_degree(known, tmp_path, kind):
    angles, points = known
    file = tmp_path / (f"run.{kind}" if "." not in kind else kind)
    FORMATS[kind](file, KEPT, points)
    found, report = angles_of(file)
    assert np.abs(found - angles).max() < 0.5 * DEGREE
    assert max(error["distance_largest"] for error in report["pose_errors"].values()) < 2e-3
    assert set(report["pose_errors"]) <= {*KEPT, "leftear", "rightear"}


@pytest.mark.parametrize("family", [GAIT, SMIL, OPENPOSE], ids=["gait", "smil", "openpose"])
def test_names_of_other_families(known, tmp_path, family):
    angles, points = known
    names = [renamed(name, family) for name in KEPT]
    if family is SMIL:  # which has clavicles by the names that others have for shoulders
        names = [*names, "leftShoulder", "rightShoulder", "spine1"]
        points = np.concatenate([points, points[:, [0, 6, 0]] + 0.02], axis=1)
    write_trc(tmp_path / "run.trc", names, points)
    found, report = angles_of(tmp_path / "run.trc")
    assert np.abs(found - angles).max() < 0.5 * DEGREE
    assert family is not SMIL or any("leftShoulder, rightShoulder, spine1" in note for note in report["notes"])


def test_other_units_axes_and_sizes(known, tmp_path):
    """A file in metres, y up, of a child whose limbs are 1.2 times as long."""
    angles, points = known
    turned = 1.2 * points[:, :, [1, 2, 0]]
    write_trc(tmp_path / "run.trc", KEPT, turned, unit=1.0, word="m")
    found, report = angles_of(tmp_path / "run.trc", "--up", "y")
    assert np.abs(found - angles).max() < 0.5 * DEGREE
    assert any("1.2 times as long" in note for note in report["notes"])


def test_noise_and_gaps_within_eight_degrees(known, tmp_path):
    """Noise of 5 mm in each axis, and a tenth of all places not seen."""
    angles, points = known
    random = np.random.default_rng(1)
    noisy = points + 0.005 * random.standard_normal(points.shape)
    noisy[random.random(points.shape[:2]) < 0.1] = np.nan
    write_trc(tmp_path / "run.trc", KEPT, noisy)
    found, report = angles_of(tmp_path / "run.trc", age=())  # which is fitted as well
    errors = np.sqrt(np.mean((found - angles) ** 2, axis=0))
    assert errors.max() < 8 * DEGREE
    gaps = [note for note in report["notes"] if "was not seen" in note]
    assert len(gaps) > 10
    assert all("of 25 rows" in note for note in gaps)


def test_a_map_gives_other_names(known, tmp_path):
    angles, points = known
    names = [f"m{i}" for i in range(len(KEPT))]
    write_trc(tmp_path / "run.trc", names, points)
    (tmp_path / "map.csv").write_text("".join(f"{name},{point}\n" for name, point in zip(names, KEPT)))
    found, _ = angles_of(tmp_path / "run.trc", "--map", str(tmp_path / "map.csv"))
    assert np.abs(found - angles).max() < 0.5 * DEGREE
    told = replay(tmp_path / "run.trc", code=1)
    assert "0 markers have a name that tells where they are, expected 4 or more; it has m0, m1" in told
    (tmp_path / "map.csv").write_text("m0,tail\n")
    assert "no point or body 'tail'" in replay(tmp_path / "run.trc", "--map", str(tmp_path / "map.csv"), code=1)


def test_ezc3d_reads_what_we_wrote(known, tmp_path):
    """The writer of this test is right where another reader says so."""
    ezc3d = pytest.importorskip("ezc3d", reason="ezc3d is not installed")
    _, points = known
    write_c3d(tmp_path / "run.c3d", KEPT, points)
    read = ezc3d.c3d(str(tmp_path / "run.c3d"))
    assert read["parameters"]["POINT"]["LABELS"]["value"] == KEPT
    np.testing.assert_allclose(read["data"]["points"][:3].T / 1000, points, atol=1e-6)


# ---- What is refused -------------------------------------------------------------------------------------------------


def changed(text, line, cell, value):
    lines = text.split("\r\n")
    cells = lines[line - 1].split("\t")
    cells[cell] = value
    lines[line - 1] = "\t".join(cells)
    return "\r\n".join(lines)


TRC = {
    "empty": (lambda it: "", "ends after line 0"),
    "not one": (lambda it: "time,x\n0,1\n", "line 1: expected PathFileType"),
    "cut": (lambda it: "\r\n".join(it.split("\r\n")[:12]), "it has 6 rows and says 25; was it cut off?"),
    "fewer markers": (
        lambda it: changed(it, 3, 3, "3"),
        "line 4: 15 names of markers, expected Frame#, Time, and the 3",
    ),
    "no number of frames": (lambda it: changed(it, 3, 2, "many"), "NumFrames is 'many', expected a number"),
    "half a frame": (lambda it: changed(it, 3, 2, "2.5"), "NumFrames is 2.5, expected a whole number"),
    "other unit": (lambda it: changed(it, 3, 4, "inch"), "Units is 'inch', expected mm, cm or m"),
    "twice": (lambda it: changed(it, 4, 5, "left_shoulder"), "line 4: the marker 'left_shoulder' is there twice"),
    "no name": (lambda it: changed(it, 4, 5, ""), "line 4: marker 2 has no name"),
    "a word": (lambda it: changed(it, 9, 4, "there"), "line 9: left_shoulder z is 'there', expected a number"),
    "infinite": (lambda it: changed(it, 9, 4, "inf"), "line 9: left_shoulder z is 'inf', expected a number"),
    "half a point": (lambda it: changed(it, 9, 4, ""), "line 9: left_shoulder z is '', expected a number"),
    "time goes back": (lambda it: changed(it, 9, 1, "0.01"), "line 9: time is 0.01 s after 0.04 s"),
    "too many cells": (lambda it: changed(it, 9, -1, "1\t2\t3"), "line 9: 49 cells, expected Frame#, Time and 45"),
}


@pytest.mark.parametrize("kind", TRC)
def test_broken_trc(known, tmp_path, kind):
    change, message = TRC[kind]
    write_trc(tmp_path / "run.trc", KEPT, known[1])
    text = (tmp_path / "run.trc").read_bytes().decode()
    (tmp_path / "run.trc").write_bytes(change(text).encode())
    told = replay(tmp_path / "run.trc", "--joints", str(tmp_path / "joints.csv"), code=1)
    assert message in told
    assert "run.trc" in told
    assert told.count("\n") == 1
    assert [it.name for it in tmp_path.iterdir()] == ["run.trc"]


def test_a_row_more_is_said(known, tmp_path):
    write_trc(tmp_path / "run.trc", KEPT, known[1], frames=24)
    assert any("it has 25 rows and says 24" in note for note in replay(tmp_path / "run.trc", *AGE)["notes"])


QUALISYS = {
    "empty": (lambda it: "", "NO_OF_FRAMES"),
    "no rate": (lambda it: it.replace("FREQUENCY\t25", "RATE_OF\t25", 1), "the header has no FREQUENCY above 0"),
    "2D": (lambda it: it.replace("\t3D", "\t2D"), "DATA_INCLUDED is '2D', expected 3D"),
    "fewer names": (
        lambda it: it.replace("NO_OF_MARKERS\t15", "NO_OF_MARKERS\t16"),
        "15 names in MARKER_NAMES, expected the 16",
    ),
    "cut": (lambda it: "\n".join(it.split("\n")[:15]) + "\n", "it has 4 rows and says 25; was it cut off?"),
    "a word": (lambda it: it.replace("2\t0.04000\t", "2\t0.04000\there", 1), "left_shoulder x is 'here"),
    "twice": (lambda it: it.replace("left_elbow", "left_shoulder"), "the marker 'left_shoulder' is there twice"),
}


@pytest.mark.parametrize("kind", QUALISYS)
def test_broken_qualisys(known, tmp_path, kind):
    change, message = QUALISYS[kind]
    write_qualisys(tmp_path / "run.tsv", KEPT, known[1])
    (tmp_path / "run.tsv").write_text(change((tmp_path / "run.tsv").read_text()))
    told = replay(tmp_path / "run.tsv", code=1)
    assert message in told
    assert told.count("\n") == 1


def test_a_skeleton_in_its_own_frames_is_refused(known, tmp_path):
    write_skeleton(tmp_path / "run.tsv", KEPT, known[1], reference="LOCAL")
    assert "REFERENCE is 'LOCAL', expected GLOBAL" in replay(tmp_path / "run.tsv", code=1)


C3D = {
    "empty": (lambda it: b"", "is no C3D file"),
    "a text": (lambda it: b"time,x\n" * 200, "is no C3D file"),
    "cut in a frame": (lambda it: it[:3000], "ends in frame 7, expected 25 frames; was it cut off?"),
    "cut in the parameters": (lambda it: it[:600], "ends after 600 bytes; was it cut off?"),
    "other processor": (lambda it: it[:515] + b"\x07" + it[516:], "processor type 7, expected 84 (Intel)"),
    "other unit": (lambda it: it.replace(b"mm\0", b"ft\0", 1), "POINT:UNITS is 'ft', expected mm, cm or m"),
    "no points": (lambda it: it[:2] + b"\0\0" + it[4:], "has no points"),
    "twice": (
        lambda it: it.replace(b"left_elbow      ", b"left_shoulder   "),
        "the marker 'left_shoulder' is there twice",
    ),
    "no rate": (lambda it: it.replace(struct.pack("<f", RATE), struct.pack("<f", 0)), "POINT:RATE is 0"),
    "ends before it begins": (
        lambda it: it[:6] + b"\x20\0\x10\0" + it[10:],
        "its last frame is 16, before the first, 32",
    ),
}


@pytest.mark.parametrize("kind", C3D)
def test_broken_c3d(known, tmp_path, kind):
    change, message = C3D[kind]
    (tmp_path / "run.c3d").write_bytes(change(c3d_bytes(KEPT, known[1])))
    told = replay(tmp_path / "run.c3d", code=1)
    assert message in told
    assert told.count("\n") == 1


def test_any_cut_of_a_c3d_file_is_an_error(known, tmp_path):
    whole = c3d_bytes(KEPT, known[1][:3])
    for length in [0, 1, 2, 20, 511, 512, 513, 516, 520, 700, 1023, 1100, 1535, 1537, 1800]:
        (tmp_path / "run.c3d").write_bytes(whole[:length])
        assert "run.c3d" in replay(tmp_path / "run.c3d", code=1)


def test_gaps_of_a_whole_point(known, tmp_path):
    """A marker that is never seen says nothing."""
    angles, points = known
    points = points.copy()
    points[:, KEPT.index("nose")] = np.nan
    write_c3d(tmp_path / "run.c3d", KEPT, points)
    found, report = angles_of(tmp_path / "run.c3d")
    assert np.abs(found - angles).max() < 0.5 * DEGREE
    assert "nose" not in report["pose_errors"]
    assert any("nose was not seen in 25 of 25 rows" in note for note in report["notes"])


@pytest.mark.parametrize("age", [3, 9, 15])
def test_the_age_that_nobody_gives_is_fitted(tmp_path, age):
    """With noise of 2 mm the age comes back within a month, and the scale is then that of the file."""
    with infant(age) as world:
        _, points = movement(world, rows=25)
    points = points[:, [NAMES.index(name) for name in KEPT]]
    write_trc(tmp_path / "run.trc", KEPT, points + 0.002 * np.random.default_rng(2).standard_normal(points.shape))
    report = replay(tmp_path / "run.trc")
    assert report["fitted_age"] == pytest.approx(age, abs=1)
    factor = next(note for note in report["notes"] if "times as long" in note)
    assert float(factor.split("limbs are ")[1].split()[0]) == pytest.approx(1, abs=0.02)
    assert report["points_rms"] < 0.005
    assert replay(tmp_path / "run.trc", "--age", str(age))["fitted_age"] is None


def test_the_age_is_fitted_to_an_infant_of_the_given_sex(tmp_path):
    """At 9 months boys measure 72.0 cm, girls 70.1 (WHO's medians), who are as long a month and a half later."""
    with infant(9) as world:
        _, points = movement(world, rows=25)
    points = points[:, [NAMES.index(name) for name in KEPT]]
    write_trc(tmp_path / "run.trc", KEPT, points)
    boy, girl = (replay(tmp_path / "run.trc", "--sex", sex)["fitted_age"] for sex in ("male", "female"))
    assert boy < 9 < girl
    assert girl - boy == pytest.approx(1.5, abs=0.8)
