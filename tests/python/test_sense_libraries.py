"""The option --sense of the programs in Python: worlds and recordings with a user's own sense in a shared library."""

import subprocess
import sys

import pytest
from recorded import record
from sense_libraries import sense_library

import mimo
from mimo.view.recorded import Recorded
from mimo.view.source import Live


@pytest.fixture(scope="module")
def imu():
    return sense_library("imu")


@pytest.fixture(scope="module")
def run(imu, tmp_path_factory):
    path = tmp_path_factory.mktemp("own senses") / "run.h5"
    return record(path, "--scene", "free", "--sense", imu, "--touch", "off", "--keep", "imu", "--seconds", "0.1")


def refused(module, *arguments):
    done = subprocess.run([sys.executable, "-m", module, *map(str, arguments)], capture_output=True, text=True)
    assert done.returncode == 1
    assert len(done.stderr.splitlines()) == 1
    return done.stderr


def test_the_viewer_and_videos_show_scenes_with_the_sense(imu):
    live = Live.asked("playdate", 0, None, own_senses=[imu])
    infants = [agent.name for agent in live.world.agents]
    assert len(infants) == 2
    for infant in infants:
        assert f"{infant}/imu/acceleration" in live.world.layout.fields
    live.change("free", "")
    assert "imu/acceleration" in live.world.layout.fields
    live.close()
    with pytest.raises(mimo.FileError, match=r"none\.so"):
        Live.asked("free", 0, None, own_senses=["none.so"])


def test_recordings_are_shown_with_the_sense_that_they_name(imu, run):
    with pytest.raises(mimo.UnsupportedError, match=r'needs the sense "imu".*--sense'):
        Recorded(run, 0)
    source = Recorded(run, 0, own_senses=[imu])
    source.advance(None, True)
    assert "imu/acceleration" in source.world.layout.fields
    source.close()
    with pytest.raises(mimo.NotFoundError, match='no sense "ct" of its own; it has: imu'):
        Recorded(run, 0, own_senses=[sense_library("ct")])


def test_recordings_are_exported_with_the_sense(imu, run, tmp_path):
    assert 'needs the sense "imu"' in refused("mimo.export", run, "--csv", tmp_path / "tables")
    command = [sys.executable, "-m", "mimo.export", run, "--csv", tmp_path / "tables", "--sense", imu]
    subprocess.run(list(map(str, command)), check=True)
    header = (tmp_path / "tables/imu_acceleration.csv").read_text().splitlines()[0]
    assert header.startswith("time,left_foot/x,left_foot/y,left_foot/z,right_foot/x,")
    said = refused("mimo.export", "--usd", tmp_path / "free.usda", "--scene", "free", "--sense", imu)
    assert "--sense has no effect on --usd" in said


def test_recordings_are_drawn_with_the_sense(imu, run, tmp_path):
    pytest.importorskip("matplotlib", reason="matplotlib is not installed")
    picture = tmp_path / "run.png"
    assert 'needs the sense "imu"' in refused("mimo.plot", run, "--out", picture)
    command = [sys.executable, "-m", "mimo.plot", str(run), "--out", str(picture), "--sense", imu]
    subprocess.run(command, check=True)
    assert picture.read_bytes()[:4] == b"\x89PNG"
