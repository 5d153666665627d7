"""What Python does with a world is recorded, and played again bit for bit."""

import numpy as np
import pytest
from recorded import recorder_or_skip

import mimo


@pytest.fixture
def run(tmp_path):
    """A file for a recording, in which nothing is yet."""
    path = tmp_path / "run.h5"
    with mimo.World("reach", vision=False) as world, recorder_or_skip(world, path, keep="none"):
        pass
    path.unlink()
    return path


def move(world, steps):
    generator = np.random.default_rng(1)
    for _ in range(steps):
        world.step(generator.uniform(-1, 1, len(world.layout.actions)))


def test_a_recorded_program_is_replayed(run):
    with mimo.World("benchmark", vision=False, touch_scale=0.5) as world:
        world.reset(3)
        with mimo.Recorder(
            world, run, keep="touch,proprioception", state_seconds=0.1, configuration="{}", seed=2**64 - 1
        ) as recorder:
            move(world, 12)
            world.reset()
            move(world, 5)
            world.set(mimo.Quantity.WORLD_GRAVITY, [0, 0, -1])
            world.step(None)
            recorder.flush()
        assert recorder.closed
        recorder.close()
        last = world.get(mimo.Quantity.JOINT_POSITION)
        touch = world.observation["touch/force"].copy()
    with mimo.Recording(run) as recording, mimo.World("benchmark", vision=False, touch_scale=0.5) as world:
        assert (recording.steps, recording.configuration, recording.seed) == (18, "{}", 2**64 - 1)
        assert recording.same_build
        assert recording.format_version == 3
        for step in (0, 11, 18):
            report = recording.play(world, step)
            assert report == (True, 18, report.steps, 0, 0.0, "")
            assert 18 - step <= report.steps < 18 - step + 10
        np.testing.assert_array_equal(world.get(mimo.Quantity.JOINT_POSITION), last)
        np.testing.assert_array_equal(recording.read("joints/position", np.float64)[-1], last)
        np.testing.assert_array_equal(recording.read("fields/touch/force", np.float32, 17, 1).ravel(), touch.ravel())
        assert np.isnan(recording.read("actions", np.float32)[17]).all()  # the motors were left as they were
        with pytest.raises(mimo.EndError, match="ends at step 18"):
            recording.step(world)
        with pytest.raises(mimo.NotFoundError, match="wings"):
            recording.read("wings", np.float32)


def test_a_recording_is_kept_unless_replaced(run):
    with mimo.World("benchmark", vision=False, touch=False) as world:
        with mimo.Recorder(world, run):
            move(world, 3)
        for options in ({}, {"replace": False}):
            with pytest.raises(mimo.FileError, match=r"run.h5: a recording exists already .* only if `replace` is set"):
                mimo.Recorder(world, run, **options)
        with mimo.Recording(run) as recording:
            assert recording.steps == 3
        with mimo.Recorder(world, run, replace=True):
            move(world, 2)
    with mimo.Recording(run) as recording:
        assert recording.steps == 2


def test_ages_and_environments(run):
    env = mimo.make("benchmark", vision=False, touch=False)
    with mimo.Recorder(env, run):
        for age in (3, 9):
            env.reset(seed=1, options={"age": age})
            for _ in range(4):
                env.step(env.action_space.sample())
    with mimo.Recording(run) as recording:
        assert recording.bodies == 3  # the one that it had at first is the third
        assert recording.play(env).identical
        assert env.world.get(mimo.Quantity.AGENT_AGE) == 9
        mass = env.world.agents[0].mass
        recording.seek(env, 0)
        assert env.world.get(mimo.Quantity.AGENT_AGE) == 3
        assert env.world.agents[0].mass < mass
    env.close()


def test_hearing_is_recorded(run):
    scene = mimo.Scene("benchmark")
    scene.add_agents(vision=False, touch=False, hearing=mimo.Hearing.EARS)
    scene.set_sources(1, 0.05)
    with mimo.World(scene) as world, mimo.Recorder(world, run, keep="hearing/ear_left"):
        world.play("head", 0.1 * np.sin(2 * np.pi * 500 / 16000 * np.arange(640)))
        heard = [world.step(None).observation["hearing/ear_left"].copy() for _ in range(4)]
    with mimo.Recording(run) as recording:
        kept = recording.read("fields/hearing/ear_left", np.float32)
    np.testing.assert_array_equal(kept, heard)
    assert abs(kept).max() > 0.05


def test_refused_values(run, tmp_path):
    with mimo.World("benchmark", vision=False, touch=False) as world, mimo.World("reach", vision=False) as other:
        with pytest.raises(mimo.NotFoundError, match='"wings"'):
            mimo.Recorder(world, tmp_path / "new.h5", keep="wings")
        with pytest.raises(TypeError, match="wings"):
            mimo.Recorder(world, tmp_path / "new.h5", wings=2)
        with pytest.raises(TypeError, match=r"expected a mimo\.World"):
            mimo.Recorder(3, tmp_path / "new.h5")
        assert not (tmp_path / "new.h5").exists()
        with mimo.Recorder(world, run):
            with pytest.raises(mimo.BusyError, match="already"):
                mimo.Recorder(world, tmp_path / "new.h5")
            move(world, 2)
        with mimo.Recording(run) as recording, pytest.raises(mimo.MismatchError, match="joints that differ"):
            recording.play(other)
        with mimo.Recorder(world, run, replace=True) as recorder:
            world.close()  # closes the file, too
            recorder.flush()
