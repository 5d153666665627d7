"""Short recordings for tests; what they need and lack is a reason to skip them."""

import os
import shutil
import subprocess
from pathlib import Path

import pytest

import mimo


def program():
    """The program `mimo`: MIMO_PROGRAM, that of the package or of the build, or the one on the path."""
    library = Path(mimo.library_path())
    places = [library.with_name("mimo"), library.parent.parent / "bin" / "mimo"]
    found = os.environ.get("MIMO_PROGRAM") or next((str(it) for it in places if it.exists()), shutil.which("mimo"))
    if found is None:
        pytest.skip("there is no program mimo, which records")
    return found


def record(path, *options, command="record"):
    """A recording that the program makes, by `mimo record` or another command."""
    pytest.importorskip("h5py", reason="h5py is not installed")
    done = subprocess.run([program(), command, *options, "--out", str(path)], capture_output=True, text=True)
    if done.returncode != 0 and "HDF5" in done.stderr and "format" not in done.stderr:
        pytest.skip(done.stderr.strip())
    assert done.returncode == 0, done.stderr
    return path


def table_of(path, name):
    """A dataset of a recording, read with h5py."""
    h5py = pytest.importorskip("h5py", reason="h5py is not installed")
    with h5py.File(path) as file:
        return file[name][()]


def recorder_or_skip(world, path, **options):
    """A recorder, where there is a library HDF5."""
    try:
        return mimo.Recorder(world, path, **options)
    except mimo.UnsupportedError as error:
        pytest.skip(str(error))
