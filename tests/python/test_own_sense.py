"""Senses in Python, which fill their fields of whole batches; shared libraries that cannot be loaded."""

from types import MappingProxyType

import numpy as np
import pytest
from gymnasium.spaces import Box

import mimo


class Effort(mimo.Sense):
    """The mean speed of the joints, and the numbers of worlds that it was told about."""

    name = "effort"
    fields = MappingProxyType({"": Box(0, np.inf, (1,), np.float32), "worlds": Box(0, 100, (), np.int32)})
    units = MappingProxyType({"": "rad/s"})

    def __init__(self):
        self.called = 0

    def fill(self, observation, out):
        self.called += 1
        velocity = observation["proprioception/velocity"]
        out[""][:, 0] = np.abs(velocity).mean(axis=1)
        out["worlds"][:] = len(velocity)


def scene_with(sense):
    scene = mimo.Scene("free")
    scene.add_agents(vision=False, touch=False)
    scene.add_sense(sense)
    return scene


def mean_speed(observation, axis):
    return np.abs(observation["proprioception/velocity"]).mean(axis=axis)


def test_the_fields_of_a_batch_are_filled_at_once():
    sense = Effort()
    batch = mimo.Batch(scene_with(sense), 5)
    fields = batch.layout.fields
    assert fields["effort"].unit == "rad/s"
    assert fields["effort/worlds"].dtype == np.int32
    observation = batch.reset(seeds=1)
    assert sense.called == 1
    for _ in range(3):
        observation = batch.step().observation
        np.testing.assert_array_equal(observation["effort"][:, 0], mean_speed(observation, 1))
    assert sense.called == 4
    assert (observation["effort/worlds"] == 5).all()
    assert (observation["effort"] > 0).all()
    own = batch.layout.new_block(5)
    batch.step_into(own)
    views = batch.layout.views(own)
    np.testing.assert_array_equal(views["effort"][:, 0], mean_speed(views, 1))


def test_a_single_world_counts_as_one():
    world = mimo.World(scene_with(Effort()))
    world.reset(seed=1)
    observation = world.step().observation
    assert observation["effort/worlds"] == [1]
    assert observation["effort"] == mean_speed(observation, 0)
    again = world.observe()
    assert again["effort"] == mean_speed(again, 0)


def test_the_last_observation_of_an_episode_is_filled():
    batch = mimo.Batch(scene_with(Effort()), 2, autoreset="same_step", max_steps=2)
    batch.reset(seeds=1)
    batch.step()
    batch.step()
    assert batch.was_reset.all()
    final = batch.layout.views(batch.final_blocks)
    np.testing.assert_array_equal(final["effort"][:, 0], mean_speed(final, 1))
    assert (final["effort"] > 0).all()


def test_copies_of_a_scene_share_the_sense():
    sense = Effort()
    world = mimo.World(scene_with(sense).copy())
    world.reset(seed=1)
    assert sense.called == 1


class Wide(Effort):
    fields = MappingProxyType({"": Box(np.zeros(2, np.float32), np.array([1, 2], np.float32))})


class Words(Effort):
    fields = MappingProxyType({"": Box(0, 1, (2,), np.int64)})


class Unnamed(Effort):
    name = "Left Nose"


class Taken(Effort):
    name, fields = "proprioception", {"position": Box(0, 1, (2,), np.float32)}


def test_wrong_senses_are_refused():
    scene = mimo.Scene("free")
    scene.add_agents(vision=False, touch=False)
    with pytest.raises(TypeError, match="sense is the class Effort, expected an object of it"):
        scene.add_sense(Effort)
    with pytest.raises(TypeError, match=r"expected a mimo\.Sense"):
        scene.add_sense("effort")
    with pytest.raises(TypeError, match="Words: the space of '' is"):
        scene.add_sense(Words())
    with pytest.raises(ValueError, match="Wide: the bounds of '' differ"):
        scene.add_sense(Wide())
    with pytest.raises(ValueError, match='name is "Left Nose"'):
        scene.add_sense(Unnamed())
    with pytest.raises(mimo.FileError, match=r"/none/nose\.so"):
        scene.load_sense("/none/nose.so")
    scene.add_sense(Effort())
    with pytest.raises(ValueError, match='agent 0 has a sense "effort" already'):
        scene.add_sense(Effort())
    scene.add_sense(Taken())
    with pytest.raises(ValueError, match='two fields "proprioception/position"'):
        mimo.World(scene)


def test_a_sense_without_fill_says_what_to_write():
    class Empty(mimo.Sense):
        name, fields = "empty", {"": Box(0, 1, (1,), np.float32)}

    world = mimo.World(scene_with(Empty()))
    with pytest.raises(NotImplementedError, match="fill"):
        world.reset(seed=1)


def test_limits_do_not_concern_it():
    scene = scene_with(Effort())
    scene.limit_sense("effort", noise=1)
    with pytest.raises(ValueError, match='"effort"'):
        mimo.World(scene)


def test_a_recording_names_the_sense_that_it_needs(tmp_path):
    world = mimo.World(scene_with(Effort()))
    world.reset(seed=1)
    try:
        recorder = mimo.Recorder(world, tmp_path / "run.h5")
    except mimo.UnsupportedError:
        pytest.skip("HDF5 is not installed")
    with recorder:
        world.step()
    with mimo.Recording(tmp_path / "run.h5") as recording:
        with pytest.raises(mimo.UnsupportedError, match='the recording needs the sense "effort"'):
            recording.world()
        recording.add_sense(Effort())
        with recording.world(eyes=0) as replayed:
            assert recording.play(replayed, compare_fields=False).identical
