"""The senses of examples/senses as shared libraries, compiled for the library that the tests use."""

import functools
import shutil
import subprocess
import tempfile
from pathlib import Path

import pytest

from mimo._library import library_path

ROOT = Path(__file__).resolve().parents[2]
SENSES = ROOT / "examples/senses"


@functools.lru_cache(maxsize=None)
def _folder():
    return tempfile.TemporaryDirectory()


@functools.lru_cache(maxsize=None)
def sense_library(name):
    """The path of ct, events or imu."""
    compiler = shutil.which("c++")
    if compiler is None:
        pytest.skip("there is no C++ compiler, c++")
    made = Path(_folder().name) / f"{name}.so"
    options = ["-std=c++11", "-O2", "-fPIC", "-shared", f"-I{ROOT / 'include'}"]
    done = subprocess.run(
        [compiler, *options, str(SENSES / f"{name}.cpp"), str(library_path()), "-o", str(made)],
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stderr
    return str(made)
