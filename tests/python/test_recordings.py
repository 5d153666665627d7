"""Recordings: worlds that are made as they say, and play them bit for bit."""

import re

import numpy as np
import pytest
from recorded import record

import mimo
from mimo.recordings import Recording


@pytest.mark.parametrize(
    "options",
    [
        ["--scene", "reach"],
        ["--scene", "catch", "--actuation", "muscle", "--senses", "all"],
        ["--scene", "playdate", "--age", "6", "--reflexes", "all", "--eyes", "perfect"],
        ["--sex", "female", "--percentile", "80", "--touch", "0.5", "--effects", "none", "--senses", "hearing"],
    ],
)
def test_a_run_is_played_again(options, tmp_path):
    with Recording(record(tmp_path / "run.h5", "--seconds", "1.3", "--seed", "7", *options)) as recording:
        table = recording.file["joints/position"][()]
        with recording.world(eyes=0) as world:
            assert recording.start(world, 0) == 0
            for step in range(recording.steps):
                recording.step(world, step)
                np.testing.assert_array_equal(world.get(mimo.Quantity.JOINT_POSITION), table[step])
            for step in (20, 115):  # back, and past the second kept state
                recording.seek(world, step)
                np.testing.assert_array_equal(world.get(mimo.Quantity.JOINT_POSITION), table[step - 1])
            with pytest.raises(ValueError, match="step is 131, expected 0 to 130, where"):
                recording.seek(world, 131)


def test_what_is_felt_and_heard_is_what_was_recorded(tmp_path):
    options = ["--scene", "showroom", "--senses", "hearing", "--seconds", "0.6", "--keep", "touch,hearing"]
    with Recording(record(tmp_path / "run.h5", *options)) as recording, recording.world(eyes=0) as world:
        recording.start(world, 0)
        for step in range(recording.steps):
            recording.step(world, step)
            for name in ("touch/force", "hearing/ear_left", "hearing/ear_right"):
                np.testing.assert_array_equal(world.observation[name], recording.file[f"fields/{name}"][step])


def test_what_is_no_recording(tmp_path):
    h5py = pytest.importorskip("h5py", reason="h5py is not installed")
    with pytest.raises(mimo.NotFoundError, match=re.escape(f"there is no file {tmp_path}/none.h5")):
        Recording(tmp_path / "none.h5")
    (tmp_path / "text.h5").write_text("no HDF5")
    with pytest.raises(ValueError, match=r"text.h5 is not a recording, or was cut off"):
        Recording(tmp_path / "text.h5")
    with h5py.File(tmp_path / "other.h5", "w") as other:
        other["x"] = [1]
    with pytest.raises(ValueError, match=r"other.h5 is an HDF5 file, but not a recording"):
        Recording(tmp_path / "other.h5")
    with h5py.File(tmp_path / "other.h5", "a") as newer:
        newer.attrs["format"], newer.attrs["format_version"] = "mimo recording", 99
    with pytest.raises(mimo.UnsupportedError, match="has format version 99, and this package reads up to 2"):
        Recording(tmp_path / "other.h5")
    with h5py.File(tmp_path / "other.h5", "a") as poor:
        poor.attrs["format_version"], poor.attrs["step_seconds"] = 1, 0.01
    with pytest.raises(ValueError, match=r"other.h5 is not a whole recording"):
        Recording(tmp_path / "other.h5")
