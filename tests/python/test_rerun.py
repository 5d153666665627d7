"""Worlds in Rerun's files, read back by Rerun's own reader."""

import importlib
import sys

import numpy as np
import pytest

import mimo
from mimo.drawing import SEGMENTS
from mimo.frames import placed

sdk = pytest.importorskip("rerun", reason="rerun-sdk is not installed")
if not hasattr(sdk, "chunk"):
    pytest.skip("this rerun-sdk has no reader of files", allow_module_level=True)

STEPS = 20


@pytest.fixture(scope="module")
def logged(tmp_path_factory):
    """A file, and what was sensed meanwhile."""
    file = tmp_path_factory.mktemp("rerun") / "infant.rrd"
    recording = sdk.RecordingStream("test")
    recording.save(file)
    seen = []
    with mimo.World("benchmark", vision_width=32, vision_height=24, hearing=True) as world:
        world.reset(seed=1)
        for _ in range(STEPS):
            world.step(np.sin(np.arange(len(world.action_names))))
            mimo.rerun.log(world, recording=recording)
            observation = {name: value.copy() for name, value in world.observation.items()}
            seen.append((world.time, observation, world.poses("body")))
        recording.flush()
        recording.disconnect()
        yield Read(file), seen, world


class Read:
    """A file's columns, by entity and component."""

    def __init__(self, file):
        self.chunks = list(sdk.chunk.RrdReader(file).stream())

    def entities(self):
        return {chunk.entity_path for chunk in self.chunks}

    def column(self, entity, component):
        """The times (s) and values of a component, in the order of time; those of static ones have no time."""
        rows = []
        for chunk in self.chunks:
            if chunk.entity_path != entity:
                continue
            batch = chunk.to_record_batch()
            names = [name for name in batch.schema.names if name.endswith(component)]
            if not names:
                continue
            values = batch.column(names[0]).to_pylist()
            times = [None] * len(values)
            if mimo.rerun.TIMELINE in batch.schema.names:
                times = batch.column(mimo.rerun.TIMELINE).cast("int64").to_pylist()
            rows += [(time, value) for time, value in zip(times, values) if value is not None]
        rows.sort(key=lambda row: row[0] or 0)
        return [None if time is None else time / 1e9 for time, _ in rows], [value for _, value in rows]


def test_every_field_is_on_the_timeline(logged):
    read, seen, world = logged
    for name in world.layout.fields:
        assert f"/world/senses/{name}" in read.entities()
    times, values = read.column("/world/senses/proprioception/position", "Scalars:scalars")
    np.testing.assert_allclose(times, [time for time, *_ in seen], atol=1e-9)
    np.testing.assert_allclose(values, [o["proprioception/position"] for _, o, _ in seen], rtol=1e-6)
    _, (names,) = read.column("/world/senses/proprioception/position", "SeriesLines:names")
    assert tuple(names) == world.layout.fields["proprioception/position"].labels


def test_pictures(logged):
    read, seen, _ = logged
    _, values = read.column("/world/senses/vision/eye_left", "Image:buffer")
    assert len(values) == STEPS
    picture = np.asarray(values[-1][0], np.uint8).reshape(24, 32, 3)
    np.testing.assert_array_equal(picture, seen[-1][1]["vision/eye_left"])


def test_shapes_once_and_bodies_by_time(logged):
    """A vertex with its body's transform is where the library has it."""
    read, _, world = logged
    head, geom = world.find("body", "head"), world.find("geom", "head")
    _, vertices = read.column(f"/world/bodies/{head}/{geom}", "Mesh3D:vertex_positions")
    assert len(vertices) == 1
    _, positions = read.column(f"/world/bodies/{head}", "Transform3D:translation")
    _, rotations = read.column(f"/world/bodies/{head}", "Transform3D:quaternion")
    x, y, z, w = rotations[-1][0]
    there = placed(positions[-1][0], [w, x, y, z], vertices[0])
    poses = world.poses("geom")
    mesh = world.mesh("head", segments=SEGMENTS)
    np.testing.assert_allclose(there, placed(poses.positions[geom], poses.rotations[geom], mesh.positions), atol=1e-5)
    assert len(positions) == STEPS


def test_touch_lies_on_the_skin(logged):
    read, seen, world = logged
    _, points = read.column("/world/senses/touch/force", "Points3D:positions")
    felt = [np.linalg.norm(o["touch/force"], axis=1) > 0 for _, o, _ in seen]
    assert [len(at) for at in points] == [on.sum() for on in felt]
    assert len(points[-1]) > 10
    receptors, poses = world.layout.receptors("touch/force"), seen[-1][2]
    bodies = receptors.bodies[felt[-1]]
    expected = placed(poses.positions[bodies], poses.rotations[bodies], receptors.position[felt[-1]])
    np.testing.assert_allclose(points[-1], expected, atol=1e-5)


def test_wrong_arguments(monkeypatch):
    with pytest.raises(TypeError, match=r"expected a mimo\.World"):
        mimo.rerun.log("benchmark")
    monkeypatch.setitem(sys.modules, "rerun", None)
    monkeypatch.delitem(sys.modules, "mimo.rerun")
    with pytest.raises(ImportError, match="mimo\\[rerun\\]"):
        importlib.import_module("mimo.rerun")
