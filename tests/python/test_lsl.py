"""Streams by the Lab Streaming Layer, sent and received in one process by LSL's own library."""

import os
import time
import uuid

import numpy as np
import pytest

import mimo
from mimo import lsl

pylsl = pytest.importorskip("pylsl", reason="pylsl is not installed", exc_type=ImportError)
WAIT = 10.0  # s, for a stream to appear or a sample to come


@pytest.fixture
def world():
    with mimo.World("reach", vision=False, touch=False, hearing=True, vestibular=True) as made:
        made.reset(seed=1)
        yield made


@pytest.fixture
def name():
    """Of streams that no other program on this network has."""
    return f"mimo-{os.getpid()}-{uuid.uuid4().hex[:8]}"


def opened(name):
    """A receiver of a stream."""
    found = pylsl.resolve_byprop("name", name, timeout=WAIT)
    assert len(found) == 1, name
    inlet = pylsl.StreamInlet(found[0])
    inlet.open_stream(timeout=WAIT)
    return inlet


def outlet_ready(outlet):
    assert outlet.wait_for_consumers(WAIT)


def test_fields_arrive_with_names_units_and_frames(world, name):
    with lsl.Streams(world, name=name) as streams:
        assert streams.names == [it for it in world.layout.fields if it.startswith(("proprioception/", "vestibular/"))]
        inlet = opened(f"{name}/proprioception/position")
        info, sent = inlet.info(timeout=WAIT), []
        for _ in range(20):
            world.step(np.full(len(world.action_names), 0.5))
            streams.push()
            sent.append(world.observation["proprioception/position"].copy())
        received = [inlet.pull_sample(timeout=WAIT) for _ in sent]
        np.testing.assert_array_equal(np.array([row for row, _ in received], np.float32), np.array(sent))
        field = world.layout.fields["proprioception/position"]
        assert tuple(info.get_channel_labels()) == field.labels
        assert set(info.get_channel_units()) == {"rad"}
        assert info.desc().child_value("frame") == "joint"
        assert (info.type(), info.nominal_srate()) == ("MoCap", pytest.approx(100))
        times = [at for _, at in received]
        assert all(before <= after for before, after in zip(times, times[1:]))
        assert 0 <= pylsl.local_clock() - times[-1] < WAIT


def test_simulated_stamps_are_a_step_apart(world, name):
    """Steps are 10 ms; what is of contacts belongs to 5 ms before the end of a step."""
    fields = ["proprioception/position", "vestibular/acceleration"]
    with lsl.Streams(world, fields, name, clock="simulated") as streams:
        inlets = [opened(f"{name}/{field}") for field in fields]
        for _ in range(5):
            world.step()
            streams.push()
        times = np.array([[inlet.pull_sample(timeout=WAIT)[1] for _ in range(5)] for inlet in inlets])
    np.testing.assert_allclose(np.diff(times), 0.01, atol=1e-9)
    np.testing.assert_allclose(times[1] - times[0], -0.005, atol=1e-9)


def test_sound_is_one_stream_of_samples(world, name):
    with lsl.Streams(world, ["hearing/ear_left"], name) as streams:
        inlet = opened(f"{name}/hearing/ear_left")
        info, sent = inlet.info(timeout=WAIT), []
        for _ in range(3):
            world.step()
            streams.push()
            sent.append(world.observation["hearing/ear_left"].copy())
        samples = [inlet.pull_sample(timeout=WAIT) for _ in range(3 * 160)]
    np.testing.assert_array_equal(np.array([row[0] for row, _ in samples], np.float32), np.concatenate(sent))
    assert (info.nominal_srate(), info.channel_count(), info.type()) == (16000, 1, "Audio")
    assert samples[159][1] - samples[0][1] == pytest.approx(159 / 16000, abs=1e-6)


def test_pictures_keep_their_numbers(name):
    with mimo.World("reach", vision=True, vision_width=8, vision_height=6, touch=False) as world:
        world.reset(seed=1)
        with lsl.Streams(world, ["vision/eye_left"], name) as streams:
            inlet = opened(f"{name}/vision/eye_left")
            world.step()
            streams.push()
            row, _ = inlet.pull_sample(timeout=WAIT)
            assert inlet.info(timeout=WAIT).desc().child_value("shape") == "6 8 3"
        np.testing.assert_array_equal(np.reshape(row, (6, 8, 3)), world.observation["vision/eye_left"])


def sender(name, labels, count=None):
    info = pylsl.StreamInfo(name, "Control", count or len(labels), 0, "float32", name)
    if labels:
        info.set_channel_labels(labels)
    return pylsl.StreamOutlet(info)


def arrived(actions):
    until = time.monotonic() + WAIT
    while time.monotonic() < until:
        if actions.latest() is not None:
            return actions.latest()
        time.sleep(0.005)
    raise AssertionError("no sample came")


def until_it_fails(actions):
    until = time.monotonic() + WAIT
    while time.monotonic() < until:
        actions.latest()


def test_a_stream_moves_the_motors_by_label(world, name):
    names = list(world.action_names)
    outlet = sender(name, names[::-1])
    actions = lsl.Actions(world, name, WAIT)
    assert actions.latest() is None
    outlet_ready(outlet)
    given = np.linspace(-0.3, 0.3, len(names)).astype(np.float32)
    outlet.push_sample(np.zeros(len(names)).tolist())
    outlet.push_sample(given[::-1].tolist(), 5.25)
    until = time.monotonic() + WAIT
    while actions.time != 5.25 and time.monotonic() < until:
        actions.latest()
    np.testing.assert_array_equal(actions.latest(), given)
    world.step(actions.latest())
    np.testing.assert_allclose(world.observation["proprioception/control"], given, atol=1e-6)
    del outlet
    with pytest.raises(ConnectionError, match=f"the stream '{name}' has ended"):
        until_it_fails(actions)


def test_a_stream_without_labels_goes_by_order(world, name):
    outlet = sender(name, [], len(world.action_names))
    actions = lsl.Actions(world, name, WAIT)
    outlet_ready(outlet)
    outlet.push_sample([0.1 * number for number in range(len(world.action_names))])
    np.testing.assert_allclose(arrived(actions), 0.1 * np.arange(len(world.action_names)), rtol=1e-6)


@pytest.mark.parametrize(
    ("labels", "message"),
    [
        (lambda names: names[:-1], "lacks act:right_fingers; expected the labels act:"),
        (lambda names: [*names, "more"], "has more; expected the labels"),
        (lambda names: [*names, names[0]], "has a label twice; expected the labels"),
        (lambda names: [], "has 3 channels, expected 8, one per action"),
    ],
)
def test_other_channels_are_refused(world, name, labels, message):
    chosen = labels(list(world.action_names))
    outlet = sender(name, chosen, len(chosen) or 3)
    with pytest.raises(ValueError, match=message):
        lsl.Actions(world, name, WAIT)
    del outlet


def test_what_is_not_there_is_said(world, name):
    with pytest.raises(TimeoutError, match=f"no stream '{name}' appeared within 0.1 s"):
        lsl.Actions(world, name, 0.1)
    with pytest.raises(ValueError, match="no field 'sight'"):
        lsl.Streams(world, ["sight"], name)
    with pytest.raises(ValueError, match="vision is off here; make the world with vision=True"):
        lsl.Streams(world, ["vision/eye_left"], name)
    with pytest.raises(ValueError, match="clock is 'wall', expected 'real' or 'simulated'"):
        lsl.Streams(world, name=name, clock="wall")
    with pytest.raises(TypeError, match=r"expected a mimo\.World"):
        lsl.Streams("reach")


def test_without_pylsl(world, monkeypatch):
    import sys

    monkeypatch.setitem(sys.modules, "pylsl", None)
    with pytest.raises(mimo.UnsupportedError, match=r"pip install 'mimo\[lsl\]'"):
        lsl.Streams(world)


def test_the_command_streams_a_scene(name, capfd):
    assert lsl.main(["--scene", "reach", "--name", name, "--seconds", "0.1", "--fields", "proprioception"]) == 0
    assert f"streams {name}/proprioception/position" in capfd.readouterr().out
    assert lsl.main(["--scene", "nowhere", "--seconds", "0.1"]) == 1
    assert "nowhere" in capfd.readouterr().err
