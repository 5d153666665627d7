"""What the package writes is whole, or is not there: on full disks, at pipes, through links."""

import os
import resource
import signal
import stat
import subprocess
import sys
import threading

import numpy as np
import pytest

import mimo
from mimo._files import new_file, require_writable
from mimo.key_points import write_table

ROWS = np.linspace(0, 1, 30000).reshape(-1, 3)  # more than 500 KB as text

# What is written, by the file's name; each needs more than 20 KB. `path` is the file.
WRITERS = {
    "table.csv": "from mimo.key_points import write_table; write_table(path, 'abc', ROWS)",
    "log.pkl": "from mimo.babybench.logs import write; from pathlib import Path; write(Path(path), ROWS.tolist())",
    "infant.usdc": "import mimo.usd; mimo.usd.write(mimo.World('reach', vision=False, touch=False), path)",
    "infant.usda": "import mimo.usd; mimo.usd.write(mimo.World('reach', vision=False, touch=False), path)",
    "infant.usdz": "import mimo.usd; mimo.usd.write(mimo.World('reach', vision=False, touch=False), path)",
    "run.mp4": "from mimo import video; from mimo.view.source import Live; "
    "video.film(Live.asked('reach', 16, None), path, 1.0)",
}
NEEDS = {"infant.usdc": "pxr", "infant.usda": "pxr", "infant.usdz": "pxr", "run.mp4": "av", "log.pkl": "gymnasium"}
BEGINNING = "import sys, numpy as np, mimo; path = sys.argv[1]; ROWS = np.linspace(0, 1, 30000).reshape(-1, 3)\n"


def written(name, path, most=None):
    """The last line of what a process says that writes such a file, each of its files no longer than that."""
    pytest.importorskip(NEEDS.get(name, "numpy"))

    def small_disk():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (most, most))

    done = subprocess.run(
        [sys.executable, "-c", BEGINNING + WRITERS[name], str(path)],
        capture_output=True,
        text=True,
        timeout=300,
        preexec_fn=None if most is None else small_disk,
    )
    return done.returncode, (done.stderr.strip().splitlines() or [""])[-1]


@pytest.mark.parametrize("name", WRITERS)
def test_a_full_disk_keeps_the_old_file(name, tmp_path):
    path = tmp_path / name
    path.write_text("two years of data")
    code, said = written(name, path, 10_000)
    assert (code, path.read_text(), os.listdir(tmp_path)) == (1, "two years of data", [name])
    assert f"cannot write {path}: " in said
    assert written(name, path) == (0, "")
    assert path.stat().st_size > 10_000
    assert not any(it.startswith(".mimo-") for it in os.listdir(tmp_path))


@pytest.mark.parametrize("name", WRITERS)
def test_pipes_are_refused(name, tmp_path):
    os.mkfifo(tmp_path / name)
    code, said = written(name, tmp_path / name)
    assert code == 1
    assert said.endswith(f"cannot write {tmp_path / name}: it is a named pipe")
    assert os.listdir(tmp_path) == [name]


def test_links_and_rights_stay(tmp_path):
    real, link = tmp_path / "real.csv", tmp_path / "link.csv"
    real.write_text("old")
    real.chmod(0o640)
    link.symlink_to(real)
    write_table(str(link), ["a"], [[1.0]])
    assert link.is_symlink()
    assert real.read_text().split() == ["a", "1.0"]
    assert stat.S_IMODE(real.stat().st_mode) == 0o640
    assert sorted(os.listdir(tmp_path)) == ["link.csv", "real.csv"]


def test_new_files_have_the_rights_that_others_have(tmp_path):
    (tmp_path / "other").write_text("")
    write_table(str(tmp_path / "new.csv"), ["a"], [[1.0]])
    assert (tmp_path / "new.csv").stat().st_mode == (tmp_path / "other").stat().st_mode


def test_open_pipes_and_devices_are_written_to(tmp_path):
    reader, writer = os.pipe()
    heard = []
    thread = threading.Thread(target=lambda: heard.append(os.read(reader, 100)))
    thread.start()
    write_table(f"/dev/fd/{writer}", ["a"], [[1.0]])
    thread.join(10)
    assert heard[0].split() == [b"a", b"1.0"]
    write_table("/dev/null", ["a"], [[1.0]])
    assert stat.S_ISCHR(os.stat("/dev/null").st_mode)
    os.close(reader)
    os.close(writer)


@pytest.mark.parametrize("error", [ValueError("wings"), KeyboardInterrupt(), mimo.FileError("of something else")])
def test_a_block_that_fails_leaves_nothing(error, tmp_path):
    def write_half():
        with new_file(tmp_path / "file.txt") as beside:
            beside.write_text("half")
            assert os.listdir(tmp_path) == [beside.name]
            assert beside.suffix == ".txt"
            raise error

    with pytest.raises(type(error)) as raised:
        write_half()
    assert raised.value is error
    assert os.listdir(tmp_path) == []


def test_unwritable_files_are_refused_before_the_work(tmp_path):
    with pytest.raises(FileNotFoundError, match=r"there is no folder .*/nowhere"):
        require_writable(tmp_path / "nowhere" / "file")
    with pytest.raises(IsADirectoryError, match=r"it is a folder"):
        require_writable(tmp_path)
    require_writable(tmp_path / "file")
    assert os.listdir(tmp_path) == []
