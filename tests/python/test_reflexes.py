"""Reflexes of newborns, as a user of the package asks for them."""

import numpy as np
import pytest

import mimo

HEAD = "robot:head_swivel"
TURNED = [[1.0, np.deg2rad(60)]]  # locked, 60 degrees to the left
BLIND = {"vision": False, "touch": False}


def looking_aside(**options):
    """A world whose infant of one month has its head turned to the left, and the number of the neck's reflex."""
    world = mimo.World("free", age=1, reflexes="asymmetric_tonic_neck", **BLIND, **options)
    world.reset(seed=0)
    world.joints(HEAD).lock = TURNED
    return world


def test_reflexes_are_off_by_default():
    with mimo.World("free", age=1, **BLIND) as world:
        assert not [name for name in world.layout.fields if name.startswith("reflex")]


@pytest.mark.parametrize(
    "wanted", ["moro", ["moro"], mimo.Reflex.MORO, [mimo.Reflex.MORO]], ids=["word", "words", "bit", "bits"]
)
def test_reflexes_by_name_or_bit(wanted):
    with mimo.World("free", reflexes=wanted, **BLIND) as world:
        field = world.layout.fields["reflex/activation"]
        assert field.shape == (1, 2)
        assert field.dtype == np.float32
        assert list(field.labels) == ["moro/left", "moro/right"]


def test_all_that_the_body_can_do():
    names = [member.name.lower() for member in mimo.Reflex if member not in (mimo.Reflex.ALL, mimo.Reflex.FELT)]
    for body, can in ("fingers", names), ("mitten", names[1:]):
        env = mimo.make("free", body=body, age=0, reflexes="all", **BLIND)
        assert env.observation_space["reflex/activation"].shape == (len(can), 2)
        env.close()
        with mimo.World("free", body=body, reflexes="all", **BLIND) as world:
            labels = world.layout.fields["reflex/activation"].labels
            assert list(labels) == [f"{name}/{side}" for name in can for side in ("left", "right")]


def test_mittens_do_not_grasp():
    with pytest.raises(mimo.UnsupportedError, match="palmar_grasp"):
        mimo.World("free", body="mitten", reflexes=["moro", "palmar_grasp"])
    with pytest.raises(mimo.UnsupportedError, match="asymmetric_tonic_neck"):
        mimo.World("free", acts=["head", "right_arm"], reflexes=["asymmetric_tonic_neck"])
    with pytest.raises(ValueError, match="startle"):
        mimo.World("free", reflexes=["startle"])


def test_turned_head_stretches_and_bends():
    """0.3 of what a motor can do, which to stretch an elbow is 0.83, as the model says."""
    with looking_aside() as world:
        for _ in range(100):
            felt = world.step().observation["reflex/activation"]
        np.testing.assert_allclose(felt, [[1, 0]], atol=1e-6)
        elbows = world.actuators("act:left_elbow", "act:right_elbow").control
        np.testing.assert_allclose(elbows, [0.3 * 0.83, -0.3], atol=1e-9)


def test_over_at_18_months():
    with mimo.World("free", reflexes="asymmetric_tonic_neck", **BLIND) as world:
        world.reset(seed=0)
        world.joints(HEAD).lock = TURNED
        for _ in range(100):
            assert not world.step().observation["reflex/activation"].any()


def test_a_reset_sets_the_age():
    with looking_aside() as world:
        for age, strength in (0, 1), (5.5, 0.5), (7, 0), (1, 1):
            world.reset(age=age)
            world.joints(HEAD).lock = TURNED
            for _ in range(60):
                felt = world.step().observation["reflex/activation"]
            np.testing.assert_allclose(felt, [[strength, 0]], atol=1e-6)


def test_each_infant_has_its_own():
    scene = mimo.Scene("playdate")
    scene.add_agents(age=1, acts="all", reflexes="all", **BLIND)
    with mimo.World(scene) as world:
        world.reset(seed=0)
        world.joints("anna/" + HEAD).lock = TURNED
        for _ in range(60):
            observation = world.step().observation
        neck = list(world.layout.fields["anna/reflex/activation"].labels).index("asymmetric_tonic_neck/left")
        assert observation["anna/reflex/activation"].ravel()[neck] > 0.99
        assert observation["ben/reflex/activation"].ravel()[neck] == 0


def test_all_senses_have_the_field_but_change_nothing():
    def looked_aside(**options):
        with mimo.World("free", age=1, **BLIND, **options) as world:
            world.reset(seed=0)
            world.joints(HEAD).lock = TURNED
            for _ in range(60):
                observation = world.step().observation
            return world.bodies("left_hand", "right_hand", "left_foot").position.copy(), observation

    usual, _ = looked_aside()
    every, observation = looked_aside(senses="all")
    assert np.array_equal(usual, every)
    assert observation["reflex/activation"].shape == (6, 2)  # mittens do not grasp
    assert not observation["reflex/activation"].any()
    acting, observation = looked_aside(reflexes="all")
    assert observation["reflex/activation"].any()
    assert np.abs(usual - acting).max() > 0.01


def test_goes_on_from_a_copy():
    with looking_aside() as world:
        for _ in range(5):
            world.step()  # the reflex is on its way
        with world.clone() as other:
            for _ in range(50):
                one, same = (w.step().observation for w in (world, other))
                assert all(np.array_equal(one[name], same[name]) for name in one)
            assert one["reflex/activation"][0, 0] > 0.99


def run(threads, body="fingers"):
    """Observations of an hour of infants at play, in short."""
    batch = mimo.Batch("free", worlds=6, threads=threads, age=1, body=body, reflexes="all", **BLIND)
    batch.reset(seeds=np.arange(6))
    rng, seen = np.random.default_rng(0), []
    for _ in range(150):
        action = rng.uniform(-0.5, 0.5, (6, len(batch.action_names))).astype(np.float32)
        observation = batch.step(action).observation
        seen.append({name: values.copy() for name, values in observation.items()})
    batch.close()
    return seen


def test_threads_change_nothing():
    one, several = run(1), run(3)
    assert max(block["reflex/activation"].max() for block in one) > 0.99
    for left, right in zip(one, several):
        assert all(np.array_equal(left[name], right[name]) for name in left)
