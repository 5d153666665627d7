"""Tasks that run inside the library's steps: what they are told, and what comes of what they say."""

import copy
import pickle

import numpy as np
import pytest
from gymnasium.spaces import Box

import mimo

ELBOW = "robot:left_elbow"
FIELDS = {"goal": Box(-1, 1, (), np.float32), "reached": Box(-np.inf, np.inf, (2,), np.float32)}
UNITS = {"goal": "rad"}


class Goal(mimo.WorldTask):
    """Two terms, a goal that each episode draws, a success that goes on, a cut after five steps."""

    terms = ("near", "lazy")
    fields = FIELDS
    units = UNITS
    memory = 1

    def reset(self, world, moment):
        assert moment.step == 0
        assert moment.action is None
        assert moment.observation is None
        assert moment.memory == [0]
        assert moment.fields["goal"] == 0
        moment.memory[0] = moment.fields["goal"][...] = world.random(1)[0]

    def evaluate(self, world, moment):
        assert moment.fields["goal"] == np.float32(moment.memory[0])
        sensed = moment.observation
        moment.fields["reached"][1] = 9 if sensed is None else sensed["proprioception/position"][0]
        lazy = 0 if moment.action is None else -moment.action[0]
        return mimo.Judgement(
            terms={"near": moment.step, "lazy": lazy}, success=moment.step == 2, truncated=moment.step == 5
        )


def scene_with(task):
    scene = mimo.Scene("free")
    scene.add_agent(vision=False, touch=False)
    scene.read_joint(ELBOW)
    scene.set_task(task)
    return scene


def test_fields_terms_and_ends():
    with mimo.World(scene_with(Goal())) as world:
        goal = world.layout.fields["goal"]
        assert (goal.unit, goal.shape, goal.low, goal.high) == ("rad", (1,), -1, 1)
        drawn = world.reset(seed=4)["goal"][0].copy()
        assert 0 < drawn < 1
        action = np.zeros(len(world.action_names))
        action[0] = -7  # the least is -1
        for number in range(1, 6):
            result = world.step(action)
            assert result.reward[0] == number + 1
            assert result.terms.tolist() == [number, 1]
            assert world.reward_terms() == {"near": number, "lazy": 1}
            assert result.outcome[0] == (mimo.Outcome.SUCCESS if number == 2 else mimo.Outcome.NONE)
            assert not result.terminated[0]
            assert result.truncated[0] == (number == 5)
            assert result.observation["goal"] == drawn
            assert result.observation["reached"][1] == result.observation["proprioception/position"][0]
        twin = world.clone()
        assert twin.step().reward[0] == 6
        assert world.step().reward[0] == 6


def test_batches_equal_single_worlds():
    seeds = [4, 5, 6, 7]
    with mimo.Batch(scene_with(Goal()), 4, threads=2) as batch:
        singles = [mimo.World(scene_with(Goal())) for _ in seeds]
        batch.reset(seeds)
        goals = [world.reset(seed)["goal"] for world, seed in zip(singles, seeds)]
        assert np.array_equal(batch.observation["goal"], goals)
        for _ in range(7):
            batch.step()
            for index, world in enumerate(singles):
                world.step()
                assert batch.reward[index] == world.reward
                assert batch.terms[index].tolist() == world.terms.tolist()
                assert batch.outcome[index] == world.outcome
                assert np.array_equal(batch.observation["reached"][index], world.observation["reached"])


def test_environments_show_its_fields():
    env = mimo.make(scene_with(Goal()))
    observation, _ = env.reset(seed=1)
    assert env.observation_space["goal"] == Box(-1, 1, (1,), np.float32)
    assert env.observation_space.contains(observation)
    *_, info = env.step(env.action_space.sample())
    assert set(info["reward_terms"]) == {"near", "lazy"}


def test_copies_and_pickles_have_the_task():
    world = mimo.World(scene_with(Goal()))
    world.reset(3)
    world.step()
    for twin in (copy.deepcopy(world), pickle.loads(pickle.dumps(world))):
        assert twin.step().reward[0] == 2
    scene = scene_with(Goal())
    scene.set_task(None)
    assert mimo.World(scene).step().reward[0] == 0


class Broken(Goal):
    """Does what a test tells it."""

    def __init__(self, work):
        self.work = work

    def evaluate(self, world, moment):
        return self.work(world, moment, super().evaluate(world, moment))


def leave(moment, name, value):
    moment.fields[name][...] = value


MISTAKES = {
    'the term "lazy" as nan': lambda world, moment, judged: judged._replace(terms={"near": 0, "lazy": np.nan}),
    "goal[0] as 2, expected a finite number from -1 to 1": lambda world, moment, judged: (
        leave(moment, "goal", 2) or judged
    ),
    "returned the terms ['near'], expected ['lazy', 'near']": lambda world, moment, judged: judged._replace(
        terms={"near": 1}
    ),
    "ZeroDivisionError: division by zero": lambda world, moment, judged: 1 / 0,
    "evaluate returned 3, expected a mimo.Judgement": lambda world, moment, judged: 3,
    "a task may not reset": lambda world, moment, judged: world.reset(),
    "evaluate returned info": lambda world, moment, judged: judged._replace(info={"a": 1}),
    "terminated without success or failure": lambda world, moment, judged: judged._replace(
        terminated=True, success=False
    ),
    "moment.memory has the shape (3,), expected (1,)": lambda world, moment, judged: (
        setattr(moment, "memory", np.zeros(3)) or judged
    ),
}


@pytest.mark.parametrize("message", MISTAKES)
def test_mistakes_are_errors_of_the_step(message):
    world = mimo.World(scene_with(Broken(MISTAKES[message])))
    world.reset(1)
    with pytest.raises(mimo.Error) as raised:
        world.step()
    assert message in str(raised.value)
    assert isinstance(raised.value, mimo.TaskError)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"terms": ("near", "near")}, 'two terms "near"'),
        ({"memory": -1}, "memory"),
        ({"fields": {"goal": Box(-1, 1, (), np.float64)}}, "float32"),
        ({"fields": {"goal": Box(np.array([0, 1], np.float32), np.array([2, 2], np.float32))}}, "the bounds of 'goal'"),
        ({"fields": {"touch/": Box(-1, 1, (), np.float32)}}, "no / at its ends"),
    ],
)
def test_descriptions_are_checked(change, message):
    with pytest.raises((ValueError, TypeError)) as raised:
        scene_with(type("Odd", (Goal,), change)())
    assert message in str(raised.value)


def test_other_kinds_of_tasks_are_refused():
    with pytest.raises(TypeError, match=r"expected a mimo\.WorldTask"):
        scene_with(mimo.Task())
