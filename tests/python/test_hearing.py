"""Hearing from Python: fields, sounds that are played, and what is refused."""

import numpy as np
import pytest

import mimo

RATE = 16000


def listening(name="benchmark", **options):
    scene = mimo.Scene(name)
    scene.add_agent(vision=False, touch=False, hearing=True, **options)
    return scene


def test_senses_by_name():
    with mimo.make("benchmark", senses=["hearing"], vision=False, touch=False) as env:
        observation, _ = env.reset(seed=0)
        names = [name for name in observation if "hearing" in name]
    assert len(names) == 4
    with pytest.raises(ValueError, match="smell"):
        mimo.make("benchmark", senses=["smell"])


def test_a_sound_on_the_left_is_heard_on_the_left():
    scene = listening()
    scene.add_object(name="toy", shape=mimo.Shape.SPHERE, size=(0.03,), position=(0, 0.6, 0.3), fixed=True)
    with mimo.World(scene) as world:
        field = world.layout.fields["hearing/ear_left"]
        assert (field.sample_rate, field.period, field.shape) == (RATE, 0.01, (160,))
        world.reset(seed=0)
        world.play("toy", np.random.default_rng(0).normal(0, 0.02, 1600))
        for _ in range(8):
            heard = world.step().observation
        assert heard["hearing/time_difference"][0] > 1e-4
        left, right = heard["hearing/bands"].sum(axis=1)
        assert left > right > 0


def level(pressure):
    """In dB, of which 0 are 20 micropascals."""
    return 10 * np.log10(np.mean(np.square(pressure, dtype=np.float64)) / 4e-10)


def test_infants_hear_their_voice():
    """A cry is 82 dB at 1 m, 99 at the own ears: docs/guide/hearing.md."""
    with mimo.World(listening("free", voice=True)) as world:  # nothing is touched there
        names = list(world.action_names)
        assert names[-4:] == ["voice:loudness", "voice:pitch", "voice:opening", "voice:front"]
        cry = np.zeros(len(names), np.float32)
        cry[-4:] = 1, 0, 1, 1
        world.reset(seed=0)
        heard = [world.step(cry).observation["hearing/ear_left"].copy() for _ in range(50)]
        assert abs(level(heard[25:]) - 99) < 1
        cry[-4] = 0.5  # pressure grows with its square: 12 dB less
        heard = [world.step(cry).observation["hearing/ear_left"].copy() for _ in range(50)]
        assert abs(level(heard[25:]) - 87) < 1


def heard_in_batch(threads):
    """What three infants hear, two of them the same, of their voices, falls and taps: each block of each step."""
    with mimo.Batch(listening(voice=True), worlds=3, threads=threads) as batch:
        batch.reset(seeds=[3, 4, 3])
        blocks = []
        for number in range(40):
            wish = np.sin(np.arange(len(batch.action_names)) + number // 5).astype(np.float32)
            batch.step(np.tile(wish, (3, 1)))
            hearing = [name for name in batch.observation if name.startswith("hearing/")]
            blocks.append({name: batch.observation[name].copy() for name in hearing})
        return blocks


def test_batches_hear_the_same_bytes_on_any_number_of_threads():
    one, three = heard_in_batch(1), heard_in_batch(3)
    assert any(block["hearing/bands"].any() for block in one)
    for alone, shared in zip(one, three, strict=True):
        for name, heard in alone.items():
            assert heard.tobytes() == shared[name].tobytes(), name
            assert heard[0].tobytes() == heard[2].tobytes(), name


def test_bad_sounds_are_refused():
    scene = listening()
    scene.set_sources(1, 0.1)
    with mimo.World(scene) as world:
        world.reset(seed=0)
        with pytest.raises(mimo.ArgumentError, match="rate is 44100"):
            world.play("head", np.zeros(10), rate=44100)
        with pytest.raises(mimo.ArgumentError, match="count is 1601, expected up to 1600"):
            world.play("head", np.zeros(1601))
        with pytest.raises(mimo.ArgumentError, match=r"samples\[3\]"):
            world.play("head", [0, 0, 0, np.nan])
        with pytest.raises(ValueError, match="samples has shape"):
            world.play("head", np.zeros((2, 80)))
        with pytest.raises(mimo.NotFoundError, match="nobody"):
            world.play("nobody", np.zeros(10))
