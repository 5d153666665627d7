"""What nerves remember depends on no frame_skip and no looks, is part of a state, and ends with an episode.

The scene is one in which everything has something to tell: an infant that falls onto a hot floor in a cold room.
"""

import numpy as np
import pytest

import mimo

SKIN = ("sa1", "ra", "pc", "sa2", "temperature", "cold", "warm", "nociception_fast", "nociception_slow", "ct")
NERVES = [f"touch/{name}" for name in SKIN]
NERVES += [f"vestibular/{name}" for name in ("canals", "otoliths", "gravity")]
NERVES += [
    f"proprioception/{name}" for name in ("spindle_primary", "spindle_secondary", "tendon_organ", "joint_receptor")
]
STEPS = 60  # of physics


def scene():
    made = mimo.Scene("benchmark")
    made.add_agents(senses="all", vision=False)
    made.set_room_temperature(15)
    made.set_temperature("world", 300)  # it hurts within 0.3 s
    made.set_material("world", "steel")
    return made


def wish(world, number):
    """What its motors do in a step of physics: the same for ten of them, to let frame_skip differ."""
    return np.sin(np.arange(len(world.action_names)) + number // 10).astype(np.float32)


def told(world, count, looks, names=NERVES):
    """What nerves tell after so many steps of physics, looked at by the way or not."""
    for number in range(0, count, world.frame_skip):
        if looks:
            world.step(wish(world, number))
        else:
            world.step_into(None, wish(world, number))
    seen = world.observe()
    return {name: seen[name].copy() for name in names}


def assert_same(one, other):
    for name in NERVES:
        assert one[name].tobytes() == other[name].tobytes(), name


@pytest.fixture(scope="module")
def usual():
    with mimo.World(scene(), frame_skip=1) as world:
        fresh = world.reset(seed=3)
        begun = {name: fresh[name].copy() for name in NERVES}
        return begun, told(world, STEPS, looks=True)


def test_every_nerve_changes_its_rate(usual):
    begun, now = usual
    for name in NERVES:
        assert not np.array_equal(begun[name], now[name]), name


@pytest.mark.parametrize(("frame_skip", "looks"), [(1, False), (2, True), (5, False), (10, True)])
def test_neither_frame_skip_nor_looks_matter(frame_skip, looks, usual):
    with mimo.World(scene(), frame_skip=frame_skip) as world:
        world.reset(seed=3)
        assert_same(told(world, STEPS, looks), usual[1])


def test_a_loaded_state_continues_as_the_world_did(usual):
    with mimo.World(scene(), frame_skip=1) as world, mimo.World(scene(), frame_skip=1) as other:
        world.reset(seed=3)
        other.reset(seed=4)
        told(world, 30, looks=False)
        state = world.save()
        first = told(world, 30, looks=True)
        told(other, 10, looks=True)
        assert other.load(state) == mimo.LoadReport((), ())
        assert_same(told(other, 30, looks=False), first)
        with other.clone() as third:
            assert_same(told(third, 20, looks=False), told(other, 20, looks=True))


def test_receptors_start_an_episode_at_rest(usual):
    begun, _ = usual
    with mimo.World(scene(), frame_skip=1) as world:
        world.reset(seed=5)
        told(world, STEPS, looks=False)
        world.reset(seed=3)
        seen = world.observation
        assert_same({name: seen[name] for name in NERVES}, begun)
    for name in ("touch/ra", "touch/pc", "touch/nociception_fast"):  # what lies there has always lain there
        assert not begun[name].any(), name
    canals = begun["vestibular/canals"]
    assert canals == pytest.approx(np.tile([90, 60], (6, 1)))
    # Skin between blood of 37 degrees and air of 15: 21.4 and 9.5 W/(m^2 K).
    assert begun["touch/temperature"] == pytest.approx((21.4 * 37 + 9.5 * 15) / 30.9, abs=0.02)


def felt_on_a_hot_floor(*touch):
    made = mimo.Scene("benchmark")
    made.add_agent(vision=False, vestibular=False, proprioception=0, touch=touch, touch_scale=0.2)
    made.set_temperature("world", 300)
    made.set_material("world", "steel")
    return mimo.World(made, frame_skip=1)


# A sensor's nociceptors keep 16 bytes (a double, two floats), and so do its C-tactile afferents (two doubles).
@pytest.mark.parametrize(
    ("kept", "feels"),
    [("ct", "nociception_fast"), ("ct", "nociception_slow"), ("nociception_fast", "ct"), ("nociception_slow", "ct")],
)
def test_nerves_do_not_take_the_memory_of_others_for_theirs(kept, feels):
    with felt_on_a_hot_floor(kept) as one, felt_on_a_hot_floor(feels) as other, felt_on_a_hot_floor("force") as none:
        one.reset(seed=3)
        now = told(one, STEPS, looks=False, names=[f"touch/{kept}"])
        assert now[f"touch/{kept}"].max() > 1
        assert other.load(one.save()).fresh == ("receptors/touch",)
        first = other.step(wish(other, 0)).observation[f"touch/{feels}"].copy()
        # As where the state has no memory of nerves at all.
        none.load(one.save())
        assert "receptors/touch" in other.load(none.save()).fresh
        assert other.step(wish(other, 0)).observation[f"touch/{feels}"].tobytes() == first.tobytes()


@pytest.mark.parametrize("threads", [1, 3])
def test_batches_give_the_same_bytes_on_any_number_of_threads(threads, usual):
    with mimo.Batch(scene(), worlds=3, threads=threads, frame_skip=1) as batch:
        batch.reset(seeds=[3, 4, 3])
        for number in range(STEPS):
            batch.step(np.tile(wish(batch, number), (3, 1)))
        for index in (0, 2):
            assert_same({name: batch.observation[name][index] for name in NERVES}, usual[1])
