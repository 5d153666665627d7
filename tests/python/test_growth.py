"""Infants of other ages than 18 months, against the WHO Child Growth Standards, 2006."""

import csv
import ctypes
import dataclasses
import pickle

import numpy as np
import pytest

import mimo

MONTHS = (0, 1, 2, 3, 6, 12, 18, 24)
SEXES = {"male": "m", "female": "f"}


@pytest.fixture(scope="module")
def standard(root):
    """value(measure, sex, month, z): M (1 + L S z)^(1/L) of the tables."""
    with open(root / "src/growth/who_lms.csv") as file:
        rows = {(it["measure"], it["sex"], float(it["age_months"])): it for it in csv.DictReader(file)}

    def value(measure, sex, month, z=0):
        if sex == "mean":
            return (value(measure, "male", month, z) + value(measure, "female", month, z)) / 2
        row = rows[measure, SEXES[sex], float(month)]
        lms_l, median, spread = (float(row[name]) for name in "LMS")
        return median * (np.exp(spread * z) if lms_l == 0 else (1 + lms_l * spread * z) ** (1 / lms_l))

    return value


def agent_of(**growth):
    with mimo.World("free", vision=False, touch=False, **growth) as world:
        return world.agents[0]


@pytest.mark.parametrize("body", ["mitten", "fingers"])
@pytest.mark.parametrize("sex", ["mean", "female", "male"])
def test_length_and_weight_follow_the_standards(standard, body, sex):
    base = agent_of(body=body)
    for month in MONTHS:
        for z in (-2, 0, 2) if sex != "mean" else (0,):
            infant = agent_of(body=body, age=month, sex=sex, z_length=z, z_weight=z)
            length = standard("length", sex, month, z) / standard("length", "mean", 18)
            weight = standard("weight", sex, month, z) / standard("weight", "mean", 18)
            assert infant.height / base.height == pytest.approx(length, rel=0.001), (month, z)
            assert infant.mass / base.mass == pytest.approx(weight, rel=0.005), (month, z)


def test_percentiles_are_those_of_a_normal_distribution():
    # The standard normal distribution's 2.275 % and 97.725 % lie at -2 and 2.
    for percentile, z in ((2.2750132, -2), (50, 0), (97.7249868, 2)):
        one = agent_of(age=9, percentile=percentile)
        other = agent_of(age=9, z_length=z, z_weight=z, z_head=z)
        assert one.mass == pytest.approx(other.mass, rel=1e-6)
        assert one.height == pytest.approx(other.height, rel=1e-6)


def test_gymnasium_environments_have_an_age():
    env = mimo.make("free", age=6, sex="female", percentile=50, vision=False)
    base = mimo.make("free", vision=False)
    assert list(env.observation_space.keys()) == list(base.observation_space.keys())
    env.reset(seed=1)
    env.step(env.action_space.sample())


def test_impossible_growth_is_refused():
    for wrong, message in (
        ({"age": 24.5}, "age is 24.5, expected 0 to 24 months"),
        ({"age": float("nan")}, "age is nan"),
        ({"age": 3, "z_length": 3.5}, "z_length is 3.5"),
        ({"age": 3, "percentile": 100}, "percentile is 100"),
        ({"age": 3, "percentile": 10, "z_head": 1}, "percentile is 10"),
        ({"age": 3, "physiological_age": -1}, "physiological_age is -1"),
        ({"age": 0, "z_length": -3, "z_weight": 3, "z_head": -3}, "do not go together"),
    ):
        with pytest.raises(mimo.ArgumentError, match=message):
            agent_of(**wrong)
    with pytest.raises(ValueError, match="sex is 'boy', expected"):
        agent_of(sex="boy")
    with pytest.raises(ValueError, match=r"maturity is 'ears', expected mimo.Mature or a name"):
        agent_of(age=3, maturity=["eyes", "ears"])
    with pytest.raises(mimo.UnsupportedError, match="maturity is 0x20"):
        agent_of(age=3, maturity=32)
    scene = mimo.Scene(xml="<mujoco><worldbody><body name='box'><geom size='.1'/></body></worldbody></mujoco>")
    with pytest.raises(mimo.ArgumentError, match="only infants grow"):
        scene.add_agent(body="scene", root="box", age=3, vision=False, vestibular=False)


def test_a_batch_of_several_ages_has_one_layout():
    ages = [0, 6, {"age": 6, "sex": "male"}, 24]
    with mimo.Batch("free", 6, vision=False, ages=ages) as batch:
        masses = [batch.world(i).agents[0].mass for i in range(6)]
        single = [agent_of(**(age if isinstance(age, dict) else {"age": age})).mass for age in ages]
        assert masses == [*single, *single[:2]]
        batch.reset(seeds=1)
        batch.step(np.zeros((6, len(batch.action_names))))
        batch.reset(ages=[12, None, None, None, None, None])
        assert batch.world(0).agents[0].mass == agent_of(age=12).mass
        assert [batch.world(i).agents[0].mass for i in range(1, 6)] == masses[1:]
        with pytest.raises(ValueError, match="2 ages, expected 6"):
            batch.reset(ages=[1, 2])


def test_one_environment_grows_up():
    env = mimo.make("free", vision=False)
    old = env.observation_space
    for age in (0, 3, 18):
        observation, _ = env.reset(seed=5, options={"age": age})
        assert env.unwrapped.world.agents[0].mass == agent_of(age=age).mass
    assert env.observation_space == old
    again, _ = mimo.make("free", vision=False).reset(seed=5)
    assert all(np.array_equal(again[name], observation[name]) for name in again)
    with pytest.raises(ValueError, match="options has 'aeg'"):
        env.reset(options={"aeg": 3})


def test_states_of_several_ages():
    with mimo.Batch("free", 2, vision=False, touch=False, maturity="all", ages=[24, 0]) as batch:
        states = batch.save()
        assert len(states[0]) < len(states[1])  # a newborn's nerves are slower
        batch.world(1).load(states[1])
        batch.step(np.zeros((2, batch.action_low.size)))
        assert batch.save() != states
        batch.load(states)
        assert batch.save() == states
        with pytest.raises(ValueError, match="4 states, expected 1 or 2"):
            batch.load(states * 2)


def test_vector_environments_have_ages():
    envs = mimo.make_vec("free", num_envs=3, vision=False, touch=False, ages=[1, 2, 3])
    envs.reset(seed=0)
    envs.reset(options={"ages": [4, 5, 6]})
    assert envs.batch.world(2).agents[0].mass == agent_of(age=6).mass


def test_copies_are_as_old():
    with mimo.World("playdate", vision=False, touch=False) as world:
        world.reset(seed=1, age=[2, None])
        world.reset(age=[None, 6])
        masses = [agent.mass for agent in world.agents]
        for twin in (pickle.loads(pickle.dumps(world)), pickle.loads(pickle.dumps(world.clone()))):
            assert [agent.mass for agent in twin.agents] == masses


def test_a_girl_stays_a_girl():
    with mimo.World("free", vision=False, touch=False, sex="female") as world:
        world.reset(seed=1, age=6)
        assert world.agents[0].mass == agent_of(age=6, sex="female").mass
    with mimo.Batch("free", 2, vision=False, touch=False, sex="female", ages=[3, 6]) as batch:
        assert batch.world(1).agents[0].mass == agent_of(age=6, sex="female").mass


def test_maturity_selects_what_matures():
    old, young = agent_of().mass, agent_of(age=3).mass
    assert agent_of(age=3, maturity="all").mass == agent_of(age=3, maturity=mimo.Mature.BODY).mass == young
    assert agent_of(age=3, maturity=("eyes", "delays")).mass == old
    env = mimo.make("free", age=3, maturity="all", vision=False, touch=False)
    assert env.unwrapped.world.layout.delays("vestibular/acceleration").all()
    env.reset(seed=1, options={"age": 6})  # and stays as mature
    assert env.unwrapped.world.layout.delays("vestibular/acceleration").all()


def test_maturity_in_numbers():
    newborn, toddler = mimo.Maturity.at(0), mimo.Maturity.at(24)
    assert (newborn.acuity, toddler.acuity) == (0.70, 11.1)
    assert newborn.conduction_speed < toddler.conduction_speed
    raw = mimo._abi.Maturity()
    mimo._library.check(mimo._library.LIB.mimo_maturity_init(raw, ctypes.sizeof(raw)))
    assert {name: getattr(raw, name) for name in dataclasses.asdict(newborn)} == dataclasses.asdict(mimo.Maturity())
    for wrong, message in (
        (lambda: mimo.Maturity.at(25), "age is 25, expected 0 to 24 months"),
        (lambda: mimo.Scene("free").set_maturity(newborn), "agent"),
    ):
        with pytest.raises((mimo.ArgumentError, mimo.NotFoundError), match=message):
            wrong()


def test_custom_nerves():
    scene = mimo.Scene("free")
    scene.add_agent(vision=False, touch=False)
    scene.set_maturity(dataclasses.replace(mimo.Maturity.at(24), vestibular_delay=0.1))
    with mimo.World(scene) as world, mimo.World(pickle.loads(pickle.dumps(scene))) as twin:
        for one in (world, twin):
            assert one.layout.delays("vestibular/acceleration") == pytest.approx([0.1] * 3)
    scene.set_maturity(None)
    with mimo.World(scene) as world:
        assert not world.layout.delays("vestibular/acceleration").any()
    with pytest.raises(mimo.ArgumentError, match="chroma is 2, expected 0 to 1"):
        scene.set_maturity(mimo.Maturity(chroma=2))
    with pytest.raises(TypeError, match=r"maturity is 3, expected a mimo.Maturity or None"):
        scene.set_maturity(3)


def test_a_part_has_the_given_delay():
    scene = mimo.Scene("free")
    scene.add_agent(vision=False)
    scene.set_sensory_delay(None, 0.02)
    scene.set_sensory_delay("left_hand", 0.1)
    with pytest.raises(mimo.NotFoundError, match="paw"):
        scene.set_sensory_delay("paw", 0.1)
    with mimo.World(scene) as world:
        bodies = world.layout.receptors("touch/force").bodies
        late = world.layout.delays("touch/force").reshape(-1, 3)
        hand = bodies == world.find(mimo.Kind.BODY, "left_hand")
        assert hand.any()
        np.testing.assert_allclose(late[hand], 0.1)
        np.testing.assert_allclose(late[~hand], 0.02)


def test_foveated_pictures_have_directions():
    scene = mimo.Scene("free")
    scene.add_agent(vision_width=33, vision_height=33, vision_foveation=10)
    with mimo.World(scene) as world:
        towards = world.layout.directions("vision/eye_left")
        assert towards.shape == (33, 33, 3)
        np.testing.assert_allclose(np.linalg.norm(towards, axis=2), 1, atol=1e-6)
        np.testing.assert_allclose(towards[16, 16], [0, 0, -1], atol=1e-7)
        # R (11^(r / R) - 1) / 10 pixels from the middle, of a focal length of 16.5 / tan(30 degrees)
        corner = 16 * np.sqrt(2)
        right = corner * (11 ** (16 / corner) - 1) / 10
        np.testing.assert_allclose(
            towards[16, 32, 0] / -towards[16, 32, 2], right * np.tan(np.pi / 6) / 16.5, rtol=1e-5
        )
        with pytest.raises(mimo.ArgumentError, match="expected a picture"):
            world.layout.directions("touch/force")


def test_options_of_eyes_are_off_by_default():
    assert mimo.Maturity.at(3).flicker == 0
    assert not mimo.Maturity.at(3).contrast_threshold
    scene = mimo.Scene("free")
    scene.add_agent()
    scene.set_maturity(mimo.Maturity(acuity=2, flicker=4, contrast_threshold=True))
    with pytest.raises(mimo.ArgumentError, match="flicker is -1"):
        scene.set_maturity(mimo.Maturity(flicker=-1))
    eyes = ["body", "eyes", "threshold", "flicker"]
    mimo.make("free", age=3, maturity=eyes, vision_width=16, vision_height=16).close()


def test_a_mirrored_body_has_its_left_hand_where_its_right_ones_image_is():
    """The original's left mitten lies 14 mm off it."""

    def off(body):
        with mimo.make("free", body=body) as env:
            left, right = env.world.bodies("left_hand", "right_hand").center_of_mass
        return np.linalg.norm(left - right * (1, -1, 1))

    assert off("mitten") == pytest.approx(0.014, abs=1e-6)
    assert off("mitten-mirrored") == pytest.approx(0, abs=1e-6)
    assert off("fingers-mirrored") == pytest.approx(0, abs=1e-6)
