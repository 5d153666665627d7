"""Recordings: worlds that are made as they say, and play them bit for bit."""

import re

import numpy as np
import pytest
from recorded import record, recorder_or_skip, table_of

import mimo
from mimo.recorded_world import recorded_world

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


def test_a_recording_without_a_configuration_needs_a_scene(tmp_path):
    path = tmp_path / "bare.h5"
    with mimo.World("reach", vision=False) as world, recorder_or_skip(world, path, configuration=""):
        world.step(np.full(len(world.layout.actions), 0.3))
    with mimo.Recording(path) as recording:
        with pytest.raises(
            ValueError, match=r"bare.h5 has a configuration that cannot be made anew: it is empty; name"
        ):
            recording.world()
        with recording.world(0, "reach") as world:
            assert recording.play(world, compare_fields=False).identical


class Quiet(mimo.WorldTask):
    """A task that JSON cannot tell."""

    def evaluate(self, world, moment):
        return mimo.Judgement(0.0)


@pytest.mark.parametrize(
    ("configuration", "told"),
    [
        ("[]", "it is not an object"),
        ("no JSON", "Expecting value"),
        ('{"python": {"scene": {}, "calls": [["save", ["/tmp"], {}]], "options": {}}}', "call is 'save', expected one"),
        ('{"python": {"scene": {"wings": 2}, "calls": [], "options": {}}}', "wings"),
        ('{"python": 3}', "has a configuration that cannot be made anew"),
        ('{"age": ["old"]}', "could not convert string to float: 'old'"),
    ],
)
def test_a_file_without_a_configuration_is_refused(configuration, told, tmp_path):
    path = tmp_path / "run.h5"
    with mimo.World("reach", vision=False) as world, recorder_or_skip(world, path, configuration=configuration):
        pass
    with mimo.Recording(path) as recording, pytest.raises(ValueError, match=told):
        recording.world()


def test_a_custom_task_is_not_kept(tmp_path):
    path = tmp_path / "run.h5"
    scene = own_scene()
    scene.set_task(Quiet())
    with mimo.World(scene) as world, recorder_or_skip(world, path):
        world.step()
    with mimo.Recording(path) as recording:
        assert recording.configuration == ""


def test_files_that_are_not_recordings(tmp_path):
    h5py = pytest.importorskip("h5py", reason="h5py is not installed")
    with pytest.raises(mimo.NotFoundError, match=re.escape(f"cannot read {tmp_path}/none.h5: there is no such file")):
        mimo.Recording(tmp_path / "none.h5")
    (tmp_path / "text.h5").write_text("no HDF5")
    with pytest.raises(mimo.FileError, match=r"text.h5 is not a recording, or was cut off"):
        mimo.Recording(tmp_path / "text.h5")
    with h5py.File(tmp_path / "other.h5", "w") as other:
        other["x"] = [1]
    with pytest.raises(mimo.FileError, match=r"other.h5 is an HDF5 file, but not a recording"):
        mimo.Recording(tmp_path / "other.h5")
    with h5py.File(tmp_path / "other.h5", "a") as newer:
        newer.attrs["format"], newer.attrs["format_version"] = np.bytes_("mimo recording"), 99
    with pytest.raises(mimo.UnsupportedError, match="has format version 99, and this library reads up to 2"):
        mimo.Recording(tmp_path / "other.h5")
    with h5py.File(tmp_path / "other.h5", "a") as poor:
        poor.attrs["format_version"], poor.attrs["step_seconds"] = 1, 0.01
    with pytest.raises(mimo.FileError, match=r"other.h5 is not a whole recording"):
        mimo.Recording(tmp_path / "other.h5")


@pytest.mark.parametrize(
    ("configuration", "line"),
    [
        ("[" * 100000, "nested too deeply"),
        ('{"scene": ' + "9" * 5000 + "}", "cannot be made anew"),
        ("[]", "it is not an object"),
        ("{", "cannot be made anew"),
    ],
)
def test_empty_configurations(configuration, line):
    with pytest.raises(ValueError, match=line) as raised:
        recorded_world("run.h5", configuration, 0, None)
    assert str(raised.value).startswith("run.h5 has a configuration that cannot be made anew: ")
    assert "\n" not in str(raised.value)
