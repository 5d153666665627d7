"""Spontaneous movements of simulated infants, beside published numbers."""

import numpy as np
import pytest

import mimo


def lying(age, **options):
    scene = mimo.Scene("rollover")
    scene.add_agent(age=age, touch=0)
    return mimo.World(scene, task="none", **options)


def test_actions_are_of_the_episode_and_within_bounds():
    world = lying(3)
    courses = []
    for seed in (1, 1, 2):
        world.reset(seed=seed)
        courses.append([])
        for _ in range(50):
            action = world.spontaneous()
            assert action.dtype == np.float32
            assert (action >= world.action_low).all()
            assert (action <= world.action_high).all()
            courses[-1].append(action)
            world.step(action)
    assert np.array_equal(courses[0], courses[1])
    assert not np.array_equal(courses[0], courses[2])


def test_two_infants_of_one_world_move_differently():
    world = mimo.World("playdate", vision=0, touch=0)
    world.reset(seed=1)
    both = [world.spontaneous(agent=agent) for agent in range(2)]
    assert all(one.any() for one in both)
    assert not np.array_equal(*both)


def test_kinds_are_chosen():
    world = lying(0)
    world.reset(seed=1)
    for _ in range(100):
        world.step(world.spontaneous(mimo.Movement.FIDGETS))
    assert not world.spontaneous(mimo.Movement.FIDGETS).any()  # newborns do not fidget
    both = world.spontaneous(mimo.Movement.GENERAL | mimo.Movement.KICKS)
    assert both.shape == (len(world.action_names),)
    assert not world.spontaneous(0).any()
    with pytest.raises((ValueError, mimo.UnsupportedError), match=r"which|Movement"):
        world.spontaneous(32)


def test_a_batch_moves_as_its_worlds_do():
    scene = mimo.Scene("rollover")
    scene.add_agent(age=3, touch=0)
    batch = mimo.Batch(scene, 3, task="none")
    batch.reset(seeds=5)
    batch.step(batch.spontaneous())
    actions = batch.spontaneous()
    for index, seed in enumerate((5, 6, 7)):
        world = mimo.World(scene, task="none")
        world.reset(seed=seed)
        world.step(world.spontaneous())
        assert np.array_equal(world.spontaneous(), actions[index])


def test_who_is_not_moved_by_torques_is_refused():
    scene = mimo.Scene("rollover")
    scene.add_agent(actuation=mimo.Actuation.MUSCLE, touch=0)
    world = mimo.World(scene, task="none")
    with pytest.raises(mimo.UnsupportedError, match="not moved by torques"):
        world.spontaneous()


def movements_of(world, seconds):
    """Durations, mean and peak accelerations of both ankles' movements, as sensors of 20 Hz find them."""
    step = world.timestep * world.frame_skip
    speeds = []
    for _ in range(round(seconds / step)):
        world.step(world.spontaneous())
        speeds.append(world.get(mimo.Quantity.BODY_VELOCITY, ["left_foot", "right_foot"]).reshape(2, -1)[:, :3].copy())
    accelerations = np.diff(speeds, axis=0) / step
    every = round(0.05 / step)
    kept = accelerations[: len(accelerations) // every * every]
    sensed = np.linalg.norm(kept.reshape(-1, every, 2, 3).mean(axis=1), axis=2)
    found = []
    for side in range(2):
        moving = np.concatenate(([False], sensed[:, side] > 0.8, [False]))  # m/s^2, above a sensor's noise
        starts, ends = (
            np.flatnonzero(np.diff(moving.astype(int)) == 1),
            np.flatnonzero(np.diff(moving.astype(int)) == -1),
        )
        for start, end in zip(starts, ends):
            one = sensed[start:end, side]
            found.append((0.05 * (end - start), one.mean(), one.max()))
    return np.array(found)


@pytest.mark.parametrize("age", [1, 3, 6, 12])
def test_legs_move_like_infants_legs(age):
    """Trujillo-Priego and Smith 2017: over visits 0.23 to 0.33 s, mean 1.59 to 3.88 and peak 3.10 to 8.83 m/s^2."""
    world = lying(age)
    world.reset(seed=1)
    found = movements_of(world, 60)
    duration, mean, peak = found[found[:, 0] >= 0.1].mean(axis=0)  # two samples: one is no movement
    assert 0.23 <= duration <= 0.33
    assert 1.59 <= mean <= 3.88
    assert 3.10 <= peak <= 8.83


# A hand that touches the body other than its own arm, the ground, and moves; as often as either hand, by a document.
HANDS = """
<mujoco>
  <include file="mimo/parts/room.xml"/>
  <custom>
    <numeric name="mimo:place" data="0 0 0.0635 0.7071067811865476 0 -0.7071067811865476 0"/>
    <text name="mimo:infant" data="parts/rollover_infant.xml"/>
    <text name="mimo:task" data="behaviour"/>
    <numeric name="mimo:frame_skip" data="2"/>
    <text name="mimo:behaviour" data="touches itself"/>
    <text name="mimo:reached" data="
      times (contacts left_hand body-left_hand-left_lower_arm at least 1 parts) at least 1000 times;
      times (contacts right_hand body-right_hand-right_lower_arm at least 1 parts) at least 1000 times;
      share (speed left_hand at least 0.05 m/s) at least 1;
      share (speed right_hand at least 0.05 m/s) at least 1"/>
    <numeric name="mimo:episode_seconds" data="300"/>
    <text name="mimo:norm_source" data="not found"/>
  </custom>
</mujoco>
"""


@pytest.mark.parametrize("age", [0.75, 2, 3])
def test_hands_touch_the_body_as_often_as_infants_hands(age):
    """DiMercurio et al. 2018, supine, from 3 weeks on: at most 200 touches in 5 minutes; moving half of the time."""
    counts = {}
    for kind in ("spontaneous", "random"):
        scene = mimo.Scene(xml=HANDS)
        scene.add_agent(age=age, touch=0)
        world = mimo.World(scene)
        world.reset(seed=1)
        random = np.random.default_rng(1)
        for _ in range(6000):  # a minute
            world.step(
                world.spontaneous() if kind == "spontaneous" else random.uniform(world.action_low, world.action_high)
            )
        *counts[kind], left, right = world.get(mimo.Quantity.AGENT_ACHIEVED, [0]).ravel()[:4]
        if kind == "spontaneous":
            assert 0.35 <= (left + right) / 2 <= 0.65
    assert 5 <= sum(counts["spontaneous"]) <= 200 / 5
    assert sum(counts["random"]) > 2 * 200 / 5  # which no infant does
