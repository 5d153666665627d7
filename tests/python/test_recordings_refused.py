"""Files that are not as recordings are: each attribute and dataset of another kind, elsewhere, or huge."""

import os
import shutil
import threading
import time

import numpy as np
import pytest
from recorded import recorder_or_skip

import mimo

h5py = pytest.importorskip("h5py", reason="h5py is not installed")

TEXTS = ("format", "build", "configuration", "seed", "joint_names")
NUMBERS = ("format_version", "step_seconds")
TABLES = ("time", "actions", "rewards", "joints/position", "joints/velocity", "bodies/growth")
TABLES += ("states/state", "states/step", "states/given", "states/body")
HUGE = 1 << 40


@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    """A recording of four steps."""
    path = tmp_path_factory.mktemp("whole") / "run.h5"
    with mimo.World("free", vision=False, touch=False) as world, recorder_or_skip(world, path, state_seconds=0.02):
        for _ in range(4):
            world.step(np.zeros(len(world.action_names)))
    return path


@pytest.fixture
def changed(whole, tmp_path):
    """A function that changes a copy of the recording by h5py and opens it."""
    path = tmp_path / "run.h5"

    def change(edit):
        shutil.copy(whole, path)
        with h5py.File(path, "r+") as file:
            edit(file)
        return mimo.Recording(path)

    return change


def without(file, name):
    del file[name]
    return file


OTHER_VALUES = {
    "many": np.full(4096, 0x4141414141414141),  # of which eight bytes have room
    "none": np.zeros(0),
    "empty": h5py.Empty("f8"),
    "of any length": "text",
    "texts": np.array([b"text"] * 100),
    "compound": np.zeros((), [("a", "i8"), ("b", "f8")]),
    "array": np.zeros((), dtype=("i8", (100,))),
    "opaque": np.void(bytes(1000)),
    "complex": 1j,
    "truth": True,
    "long double": np.longdouble(1),
}


@pytest.mark.parametrize("kind", OTHER_VALUES)
@pytest.mark.parametrize("name", TEXTS + NUMBERS)
def test_an_attribute_is_of_another_kind(name, kind, changed):
    def edit(file):
        del file.attrs[name]
        file.attrs[name] = OTHER_VALUES[kind]

    with pytest.raises(mimo.FileError, match=f"'{name}'"):
        changed(edit)


@pytest.mark.parametrize("name", TEXTS + NUMBERS)
def test_an_attribute_is_a_number_or_text_instead(name, changed):
    for value in (np.bytes_(b"1"), 3.5) if name == "format_version" else (np.bytes_(b"1"), 3):
        if name in TEXTS and isinstance(value, bytes):
            continue
        with pytest.raises(mimo.FileError, match=f"'{name}' is not a"):
            changed(lambda file, value=value: file.attrs.__setitem__(name, value))
    with pytest.raises(mimo.FileError, match="'format_version' is -5"):
        changed(lambda file: file.attrs.__setitem__("format_version", -5))


def dataset(*args, **options):
    """An edit that puts another dataset in its place."""
    return lambda file, name: without(file, name).create_dataset(name, *args, **options)


def link(target):
    def edit(file, name):
        without(file, name)[name] = target(name)

    return edit


def group_elsewhere(file, name):
    group = name.split("/")[0]
    without(file, group)[group] = h5py.ExternalLink("other.h5", group)


def virtual(file, name):
    layout = h5py.VirtualLayout((4, 8), "f8")
    layout[:] = h5py.VirtualSource("other.h5", name, (4, 8))
    without(file, name).create_virtual_dataset(name, layout)


ELSEWHERE = {
    "external storage": dataset((4, 8), "f8", external=[("/etc/passwd", 0, h5py.h5f.UNLIMITED)]),
    "external link": link(lambda name: h5py.ExternalLink("other.h5", name)),
    "soft link": link(lambda name: h5py.SoftLink("/time" if name != "time" else "/rewards")),
    "link to itself": link(lambda name: h5py.SoftLink("/" + name)),
    "group of another file": group_elsewhere,
    "virtual": virtual,
}
OTHER_KINDS = {
    "one number": dataset(data=1.0),
    "empty": dataset(data=h5py.Empty("f8")),
    "other numbers": dataset(data=np.zeros((4, 3), np.int16)),
    "other byte order": dataset(data=np.zeros((4, 3), ">f8")),
    "more dimensions": dataset(data=np.zeros((4, 2, 2, 2))),
    "of any length": dataset((4,), h5py.vlen_dtype("i8")),
    "texts": dataset(data=np.array([b"abcdefgh"] * 4)),
    "compound": dataset(data=np.zeros(4, [("a", "i8"), ("b", "f8")])),
    "references": dataset((4,), h5py.ref_dtype),
    "rows of nothing": dataset((4, 0), "f8"),
    "a wrapped length": dataset((12, 2**32, 2**30), "f4", chunks=(1, 1024, 1)),
    "many rows": dataset((10**9,), "i8", chunks=(1024,)),
    "wide rows": dataset((4, HUGE), "u1", chunks=(1, 4096)),
    "large chunks": dataset((4, 1 << 27), "u1", chunks=(4, 1 << 27), compression=9),
    "another filter": dataset((4, 3), "f8", chunks=(1, 3), scaleoffset=2),
    "a group": lambda file, name: without(file, name).create_group(name),
}


@pytest.mark.parametrize("kind", OTHER_KINDS)
@pytest.mark.parametrize("name", TABLES)
def test_a_dataset_is_of_another_kind(name, kind, changed):
    with pytest.raises(mimo.FileError, match=f"'{name}'"):
        changed(lambda file: OTHER_KINDS[kind](file, name))


@pytest.mark.parametrize("kind", ELSEWHERE)
@pytest.mark.parametrize("name", TABLES)
def test_a_dataset_lies_elsewhere(name, kind, changed, whole, tmp_path):
    if kind == "group of another file" and "/" not in name:
        pytest.skip("it is in no group")
    shutil.copy(whole, tmp_path / "other.h5")
    with pytest.raises(mimo.FileError, match="somewhere else"):
        changed(lambda file: ELSEWHERE[kind](file, name))


def test_a_field_is_read_where_it_can_be(changed, whole, tmp_path):
    """Fields that nobody asked for are looked at when they are."""
    name = "fields/vestibular/acceleration"
    shutil.copy(whole, tmp_path / "other.h5")
    for kind in ("a wrapped length", "many rows", "wide rows", "of any length", "references"):
        recording = changed(lambda file, kind=kind: OTHER_KINDS[kind](file, name))
        with recording, pytest.raises(mimo.FileError, match=name):
            recording.read(name, np.float32)
    for edit in ELSEWHERE.values():
        recording = changed(lambda file, edit=edit: edit(file, name))
        with recording, pytest.raises(mimo.FileError, match="somewhere else"):
            recording.read(name, np.float32)


def test_a_recorded_world_does_not_wait_for_other_files(whole, tmp_path):
    """Its steps go on while another thread opens and reads files, of which some are damaged."""
    damaged = bytearray(whole.read_bytes())
    damaged[20] ^= 1  # of the superblock
    (tmp_path / "damaged.h5").write_bytes(damaged)
    stop = threading.Event()

    def bother():
        while not stop.is_set():
            with pytest.raises(mimo.FileError):
                mimo.Recording(tmp_path / "damaged.h5")
            with mimo.Recording(whole) as recording:
                recording.read("states/state", np.uint8)

    world = mimo.World("free", vision=False, touch=False)
    with world, recorder_or_skip(world, tmp_path / "run.h5", flush_seconds=0):
        other = threading.Thread(target=bother)
        other.start()
        begin, steps = time.monotonic(), 0
        while time.monotonic() - begin < 2:
            world.step(np.zeros(len(world.action_names)))
            steps += 1
        stop.set()
        other.join()
    assert steps > 20
    with mimo.Recording(tmp_path / "run.h5") as recording:
        assert recording.steps == steps
        np.testing.assert_allclose(recording.read("time", np.float64).ravel(), 0.01 * np.arange(1, steps + 1))


def test_a_pipe_is_refused_as_a_recording(tmp_path):
    os.mkfifo(tmp_path / "pipe")
    with pytest.raises(mimo.FileError, match="not a plain file"):
        mimo.Recording(tmp_path / "pipe")
