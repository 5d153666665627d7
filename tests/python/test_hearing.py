"""Hearing from Python: fields, sounds that are played, and what is refused."""

import numpy as np
import pytest

import mimo

RATE = 16000


def listening(**options):
    scene = mimo.Scene("benchmark")
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
