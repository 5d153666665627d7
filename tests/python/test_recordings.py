"""Recordings: worlds that are made as they say, and play them bit for bit."""

import ctypes
import json
import pickle
import re

import numpy as np
import pytest
from recorded import record, recorder_or_skip, table_of

import mimo
from mimo import _abi
from mimo._library import LIB, check, defaults

ROOM = """<mujoco><worldbody><geom type="plane" size="3 3 .1"/><light pos="0 0 3"/></worldbody></mujoco>"""


@pytest.mark.parametrize(
    "options",
    [
        ["--scene", "reach"],
        ["--scene", "catch", "--actuation", "muscle", "--senses", "all"],
        ["--scene", "playdate", "--age", "6", "--reflexes", "all", "--eyes", "perfect"],
        ["--sex", "female", "--percentile", "80", "--touch", "0.5", "--effects", "none", "--senses", "hearing"],
    ],
)
def test_a_recording_is_replayed(options, tmp_path):
    run = record(tmp_path / "run.h5", "--seconds", "1.3", "--seed", "7", *options)
    table = table_of(run, "joints/position")
    with mimo.Recording(run) as recording, recording.world(eyes=0) as world:
        assert recording.seek(world, 0, compare_fields=False) == 0
        for step in range(recording.steps):
            recording.step(world)
            np.testing.assert_array_equal(world.get(mimo.Quantity.JOINT_POSITION), table[step])
        assert recording.report().identical
        for step in (20, 115):  # back, and past the second kept state
            recording.move_to(world, step)
            np.testing.assert_array_equal(world.get(mimo.Quantity.JOINT_POSITION), table[step - 1])
        with pytest.raises(mimo.ArgumentError, match=r"step is 131, but .*run.h5 ends at step 130"):
            recording.move_to(world, 131)


def test_touch_and_sound_are_those_of_the_recording(tmp_path):
    h5py = pytest.importorskip("h5py", reason="h5py is not installed")
    options = ["--scene", "showroom", "--senses", "hearing", "--seconds", "0.6", "--keep", "touch,hearing"]
    run = record(tmp_path / "run.h5", *options)
    with mimo.Recording(run) as recording, recording.world(eyes=0) as world, h5py.File(run) as file:
        recording.seek(world, 0, compare_fields=False)
        for step in range(recording.steps):
            seen = recording.step(world).observation
            for name in ("touch/force", "hearing/ear_left", "hearing/ear_right"):
                np.testing.assert_array_equal(seen[name], file[f"fields/{name}"][step])


@pytest.mark.parametrize(("level", "filters"), [(0, (None, None)), (4, (None, "gzip")), (5, ("gzip", "gzip"))])
def test_up_to_level_4_narrow_rows_are_not_compressed(level, filters, tmp_path):
    h5py = pytest.importorskip("h5py", reason="h5py is not installed")
    options = ["--scene", "showroom", "--seconds", "0.05", "--keep", "touch", "--compression", str(level)]
    with h5py.File(record(tmp_path / "run.h5", *options)) as file:
        narrow, wide = file["joints/position"], file["fields/touch/force"]
        assert narrow[0].nbytes <= 4096 < wide[0].nbytes
        assert (narrow.compression, wide.compression) == filters


@pytest.fixture(scope="module")
def short_run(tmp_path_factory):
    return record(tmp_path_factory.mktemp("short") / "run.h5", "--seconds", "0.1")


# Of mimo_env_config; every other member, also a new one, comes from the recording.
CHOSEN = {"renderer", "timing", "render", "samples", "render_threads", "step_contacts"}


@pytest.mark.parametrize(
    "name", [name for name, _ in _abi.EnvConfig._fields_ if not re.search("size|log|reserved", name)]
)
def test_callers_choose_pictures_and_times_of_a_replay_only(name, short_run):
    config, env = defaults(_abi.EnvConfig), ctypes.c_void_p()
    usual = getattr(config, name)
    setattr(config, name, b"none" if usual is None or isinstance(usual, bytes) else usual + 1)
    with mimo.Recording(short_run) as recording:
        if name in CHOSEN:
            check(LIB.mimo_recording_env(recording._handle, config, None, env))
            LIB.mimo_env_destroy(env)
        else:
            with pytest.raises(mimo.ArgumentError, match=f"^config: {name} comes from the recording"):
                check(LIB.mimo_recording_env(recording._handle, config, None, env))


def own_scene():
    scene = mimo.Scene(xml=ROOM)
    scene.add_agent(vision=False, touch=mimo.Touch.NORMAL_FORCE, touch_scale=0.5, position=[0, 0, 0.4])
    scene.add_object("brick", mass=0.2, size=np.array([0.05, 0.05, 0.05]), position=(0.1, 0, 0.9))
    scene.limit_sense("proprioception", delay=0.03)
    return scene


def test_the_scene_of_a_program_is_rebuilt(tmp_path):
    path = tmp_path / "own.h5"
    generator = np.random.default_rng(4)
    with mimo.World(own_scene(), frame_skip=3) as world, recorder_or_skip(world, path, keep="all"):
        for _ in range(20):
            last = world.step(generator.uniform(-1, 1, len(world.layout.actions))).observation.copy()
    with mimo.Recording(path) as recording:
        with recording.world(eyes=16) as world:
            assert world.observation["vision/eye_left"].shape == (16, 16, 3)
            assert recording.play(world, compare_fields=False).identical
            felt = world.observation["touch/force"]
            np.testing.assert_array_equal(felt, last["touch/force"])
            assert felt.any()
        with recording.world(eyes=0) as world:
            assert recording.play(world).identical  # fields, too


class Counting(mimo.WorldTask):
    """A task that no file holds."""

    def evaluate(self, world, moment):
        return mimo.Judgement(float(moment.step))


def test_rewards_of_a_custom_task_are_those_of_the_file(tmp_path):
    path = tmp_path / "run.h5"
    scene = own_scene()
    scene.set_task(Counting())
    with mimo.World(scene) as world, recorder_or_skip(world, path):
        for _ in range(3):
            world.step()
    with mimo.Recording(path) as recording, recording.world(eyes=0) as world:
        recording.seek(world)
        assert [recording.step(world).reward[0] for _ in range(3)] == [1, 2, 3]
        assert recording.report().identical
        with pytest.raises(mimo.EndError, match="ends at step 3"):
            recording.step(world)
        with pytest.raises(TypeError, match="cannot be pickled"):
            pickle.dumps(world)


def test_joints_are_replayed_without_states(tmp_path):
    run = record(tmp_path / "run.h5", "--seconds", "0.2")
    table = table_of(run, "joints/position")
    with mimo.Recording(run) as recording, recording.world(eyes=0) as world:
        recording.seek(world, joints=True, compare_fields=False)
        for step in range(recording.steps):
            recording.step(world)
            np.testing.assert_allclose(world.get(mimo.Quantity.JOINT_POSITION), table[step], atol=1e-12)


def test_damaged_worlds_are_refused(tmp_path):
    h5py = pytest.importorskip("h5py", reason="h5py is not installed")
    run = record(tmp_path / "run.h5", "--seconds", "0.1")
    with h5py.File(run) as file:
        calls = json.loads(bytes(file["world"][()]))

    def expect(changed, error, line, eyes=0):
        text = changed if isinstance(changed, bytes) else json.dumps(changed).encode()
        with h5py.File(run, "a") as file:
            del file["world"]
            file["world"] = np.frombuffer(text, np.uint8)
        with mimo.Recording(run) as recording, pytest.raises(error, match=line) as raised:
            recording.world(eyes=eyes)
        with h5py.File(run, "a"):  # free while the error is still there
            assert "\n" not in str(raised.value)

    agents, env = calls
    expect(b"[" * 100000, mimo.FileError, "'world' of the recording: it is no list")
    expect({}, mimo.FileError, "it is no list")
    expect([3], mimo.FileError, "a call is no object")
    expect([{"call": "fly"}], mimo.UnsupportedError, '"fly" is a call that this library does not know')
    expect([agents, {"call": "env_create"}], mimo.FileError, 'lacks "config"')
    wide = {**agents, "config": {**agents["config"], "touch_scale": 1e9}}
    for eyes in (0, 10**6):
        expect([wide, env], mimo.FileError, "'world' of the recording: touch_scale is 1000000000, expected", eyes)
    expect(calls, mimo.ArgumentError, "vision_width is 1000000, expected", eyes=10**6)
    slow = {**env, "config": {**env["config"], "frame_skip": 10**9}}
    expect([agents, slow], mimo.FileError, "'world' of the recording: frame_skip is 1000000000, expected")
    limit = {"call": "limit_sense", "agent": 0, "path": "smell", "limits": {}}
    expect([agents, limit, env], mimo.FileError, "'world' of the recording: limits: no field \"smell\"")
    newer = {**agents, "config": {**agents["config"], "smell": 1}}
    expect([newer, env], mimo.UnsupportedError, "newer library")
    expect([agents] * 10001, mimo.FileError, "10001 calls")


def test_scenes_of_others_are_checked(tmp_path):
    h5py = pytest.importorskip("h5py", reason="h5py is not installed")
    run = record(tmp_path / "run.h5", "--seconds", "0.1")
    with h5py.File(run, "a") as file:
        document = bytes(file["scene/document"][0]).rstrip(b"\0")
        name = next(iter(file["scene/assets"]))
        del file[f"scene/assets/{name}"]
    with (
        mimo.Recording(run) as recording,
        pytest.raises(mimo.ModelError, match=r"there is no file .* beside the document"),
    ):
        recording.world(eyes=0)
    with h5py.File(run, "a") as file:
        file["scene/document"][0] = np.frombuffer(
            document.replace(b'file="assets/', b'file="/etc/').ljust(file["scene/document"].shape[1], b"\0")[
                : file["scene/document"].shape[1]
            ],
            np.uint8,
        )
    with mimo.Recording(run) as recording, pytest.raises(mimo.ModelError, match=r"no file .*/etc/"):
        recording.world(eyes=0)


def test_files_that_are_not_recordings(tmp_path):
    h5py = pytest.importorskip("h5py", reason="h5py is not installed")
    with pytest.raises(mimo.NotFoundError, match=re.escape(f"cannot read {tmp_path}/none.h5: the file does not exist")):
        mimo.Recording(tmp_path / "none.h5")
    (tmp_path / "text.h5").write_text("no HDF5")
    with pytest.raises(mimo.FileError, match=r"text.h5 is not a recording, or is truncated"):
        mimo.Recording(tmp_path / "text.h5")
    with h5py.File(tmp_path / "other.h5", "w") as other:
        other["x"] = [1]
    with pytest.raises(mimo.FileError, match=r"other.h5 is an HDF5 file, but not a recording"):
        mimo.Recording(tmp_path / "other.h5")
    with h5py.File(tmp_path / "other.h5", "a") as newer:
        newer.attrs["format"], newer.attrs["format_version"] = np.bytes_("mimo recording"), 99
    with pytest.raises(mimo.UnsupportedError, match="has format version 99, and this library reads up to 3"):
        mimo.Recording(tmp_path / "other.h5")
    with h5py.File(tmp_path / "other.h5", "a") as poor:
        poor.attrs["format_version"], poor.attrs["step_seconds"] = 1, 0.01
    with pytest.raises(mimo.FileError, match=r"other.h5 is not a complete recording"):
        mimo.Recording(tmp_path / "other.h5")
