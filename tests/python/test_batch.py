"""Batches: world i is a single world with seed i; masks; overlap; autoreset."""

import numpy as np
import pytest

import mimo


@pytest.fixture
def batch():
    with mimo.Batch("reach", 3, threads=2) as made:
        yield made


def test_a_world_of_a_batch_is_a_single_world(batch):
    actions = np.random.default_rng(1).uniform(-1, 1, (20, 3, 8)).astype(np.float32)
    batch.reset(seeds=7)
    for action in actions:
        result = batch.step(action)
    for i in range(3):
        single = mimo.World("reach")
        single.reset(seed=7 + i)
        for action in actions[:, i]:
            one = single.step(action)
        for name, field in one.observation.items():
            np.testing.assert_array_equal(result.observation[name][i], field)
        assert result.reward[i, 0] == one.reward[0]


def test_named_access_stacks_worlds(batch):
    batch.reset(seeds=[5, 6, 7])
    ball, hand = batch.bodies("target"), batch.bodies("right_fingers", "head")
    assert hand.position.shape == (3, 2, 3)
    assert batch.joints("robot:right_elbow").position.shape == (3, 1)
    np.testing.assert_array_equal(hand.position[1], batch.world(1).bodies("right_fingers", "head").position)
    before = ball.position
    ball.write("position", [0.3, 0.0, 0.7], mask=np.array([True, False, True]))
    np.testing.assert_allclose(ball.position[[0, 2], 0], [[0.3, 0, 0.7]] * 2, atol=1e-12)
    np.testing.assert_array_equal(ball.position[1], before[1])


def test_random_numbers_are_each_world_s_own(batch):
    batch.reset(seeds=7)
    some = batch.random(2, mask=np.array([False, True, False]))
    single = mimo.World("reach")
    single.reset(seed=8)
    np.testing.assert_array_equal(some[1], single.random(2))
    assert not some[[0, 2]].any()


def test_masks_restart_some_worlds(batch):
    batch.reset(seeds=1)
    batch.step(np.ones((3, 8)))
    times = [batch.world(i).time for i in range(3)]
    batch.reset(mask=np.array([False, True, False]))
    assert batch.world(1).time < times[1]
    assert [batch.world(i).time for i in (0, 2)] == [times[0], times[2]]
    with pytest.raises(ValueError, match="mask has the shape"):
        batch.reset(mask=np.array([True]))


def test_send_and_receive_are_a_step(batch):
    actions = np.full((3, 8), 0.5, np.float32)
    batch.reset(seeds=1)
    stepped = batch.step(actions).observation["proprioception/velocity"].copy()
    batch.reset(seeds=1)
    batch.send(actions)
    actions[:] = 0  # the batch has its own
    with pytest.raises(mimo.BusyError, match="receive"):
        batch.world(0).step()
    np.testing.assert_array_equal(batch.receive().observation["proprioception/velocity"], stepped)


def test_states_of_one_present(batch):
    batch.reset(seeds=1)
    single = mimo.World("reach")
    single.reset(seed=99)
    batch.load(single.save())
    result = batch.step(np.zeros((3, 8)))
    velocity = result.observation["proprioception/velocity"]
    np.testing.assert_array_equal(velocity, np.tile(velocity[0], (3, 1)))
    np.testing.assert_array_equal(velocity[0], single.step(np.zeros(8)).observation["proprioception/velocity"])


def test_same_step_keeps_the_last_block():
    batch = mimo.Batch("reach", 2, autoreset=mimo.Autoreset.SAME_STEP, max_steps=2)
    plain = mimo.Batch("reach", 2, max_steps=2)
    for each in (batch, plain):
        each.reset(seeds=1)
        each.step(np.zeros((2, 8)))
        each.step(np.zeros((2, 8)))
    assert batch.was_reset.all()
    np.testing.assert_array_equal(batch.final_blocks, plain.blocks)


def test_a_world_s_observation_is_a_row_of_the_batch(batch):
    batch.reset(seeds=1)
    second = batch.world(1)
    second.bodies("target").position = second.bodies("right_fingers").position  # reach succeeds at once
    result = batch.step(np.zeros((3, 8)))
    assert result.outcome[:, 0].tolist() == [mimo.Outcome.NONE, mimo.Outcome.SUCCESS, mimo.Outcome.NONE]
    assert [term.name for term in batch.layout.terms] == ["distance", "success"]
    np.testing.assert_array_equal(result.terms.sum(axis=1), result.reward[:, 0])
    assert second.reward_terms() == {"distance": result.terms[1, 0], "success": 100}
    assert second.outcome == mimo.Outcome.SUCCESS


def test_refused(batch):
    with pytest.raises(ValueError, match="expected \\(3, 8\\)"):
        batch.step(np.zeros(8))
    with pytest.raises(ValueError, match="2 seeds"):
        batch.reset(seeds=[1, 2])
    with pytest.raises(ValueError, match="worlds is 0"):
        mimo.Batch("reach", 0)
    actions = np.zeros((3, 8))
    actions[1, 2] = np.nan
    batch.reset(seeds=1)
    with pytest.raises(ValueError, match=r"action\[2\]"):
        batch.step(actions)
    assert isinstance(batch.error(1), ValueError)
    assert batch.error(0) is None


def test_a_world_keeps_its_batch():
    world = mimo.Batch("reach", 2).world(1)
    world.reset(seed=1)
    assert world.step(np.zeros(8)).reward[0] < 0


class Pressed(mimo.Task):
    """The force on the floor, by the contacts of each world; and what was sensed."""

    def setup(self, world):
        self.floor = int(world.geoms("floor").ids[0])

    def evaluate(self, world):
        assert len(world.observation["proprioception/position"]) in (47, world.world_count)
        self.sensed = world.observation["proprioception/velocity"].copy()
        forces = []
        for index in range(world.world_count):
            contacts = world.contacts(index)
            of_world = world.world(index).contacts()
            np.testing.assert_array_equal(contacts.force, of_world.force)
            forces.append(contacts.force[(contacts.geoms == self.floor).any(axis=1), 0].sum())
        return mimo.Judgement(np.array(forces) if world.world_count > 1 else forces[0])


def test_contacts_serve_one_world_and_many():
    options = {"vision": False, "touch": False, "proprioception": True}
    alone, among = Pressed(), Pressed()
    one, many = mimo.make("free", task=alone, **options), mimo.make_vec("free", 2, task=among, **options)
    one.reset(seed=4)
    many.reset(seed=4)
    for _ in range(60):
        action = np.zeros(44, np.float32)
        sensed, reward, *_ = one.step(action)
        many_sensed, rewards, *_ = many.step(np.stack([action, action]))
        np.testing.assert_array_equal(alone.sensed, sensed["proprioception/velocity"])
        np.testing.assert_array_equal(among.sensed, many_sensed["proprioception/velocity"])
    assert reward == rewards[0] > 10  # it has come down, with its 107 N
    assert len(many.batch) == many.batch.world_count == 2
