"""What a beginner is told first: what happened, what was expected, what to do. test_nothing_vanishes.py has more."""

import re

import gymnasium
import numpy as np
import pytest

import mimo

QUICK = {"vision": False, "touch": False}


def world(name="reach", **options):
    return mimo.World(name, **{**QUICK, **options})


def step_twice(envs, actions):
    envs.reset()
    envs.step(actions)


def two_infants(first, second):
    scene = mimo.Scene("free")
    scene.add_agent(name=first)
    scene.add_agent(name=second)


CASES = {
    "scene": (lambda: mimo.make("reech"), LookupError, 'no scene named "reech"; did you mean "reach"?'),
    "task": (lambda: world("free", task="reech"), LookupError, 'no task named "reech"; did you mean "reach"?'),
    "task without its body": (
        lambda: world("free", task="catch"),
        LookupError,
        r'task "catch" needs a body named "target", a free ball, and this scene has none: '
        r'take the built-in scene "catch", or add such a body to yours',
    ),
    "infants without names": (
        lambda: two_infants("", ""),
        ValueError,
        'name is "", but each of several agents needs a name of its own, such as "anna"',
    ),
    "infant beside one without a name": (
        lambda: two_infants("", "ben"),
        ValueError,
        'name is "ben", but the agent before it has none',
    ),
    "option": (lambda: mimo.make("reach", visoin=True), TypeError, "'visoin'; did you mean 'vision'?"),
    "part of an option": (lambda: mimo.World("reach", width=64), TypeError, "'width'; did you mean 'vision_width'?"),
    "option of a scene": (lambda: mimo.Scene(path="a.xml"), TypeError, "There are: confined, file, "),
    "name of the package": (lambda: mimo.Wrld, AttributeError, "no attribute 'Wrld'; did you mean 'World'?"),
    "member": (lambda: world(actuation="muscles"), ValueError, "names? of its members: torque, position, muscle"),
    "age": (lambda: world("free", age=36), ValueError, "age is 36, expected 0 to 24 months"),
    "number": (lambda: world(vision_width=64.5), TypeError, "vision_width is 64.5, expected a whole number"),
    "action": (
        lambda: world().step(np.zeros(3)),
        ValueError,
        r"\(3,\), expected \(8,\): a number for each of action_names",
    ),
    "actions": (
        lambda: step_twice(mimo.make_vec("reach", num_envs=2), np.zeros(8)),
        ValueError,
        r"\(8,\), expected \(2, 8\): a row for each world",
    ),
    "not a number": (lambda: world().step(np.full(8, np.nan)), ValueError, r"action\[0\] is not a number"),
    "no reset": (
        lambda: mimo.make("reach").step(np.zeros(8)),
        gymnasium.error.ResetNeeded,
        r"call reset\(\) before step",
    ),
    "no resets": (
        lambda: mimo.make_vec("reach", num_envs=2).step(np.zeros((2, 8))),
        gymnasium.error.ResetNeeded,
        r"call reset\(\) before step",
    ),
    "no resets, sent": (
        lambda: mimo.make_vec("reach", num_envs=2).send(np.zeros((2, 8))),
        gymnasium.error.ResetNeeded,
        r"call reset\(\) before step",
    ),
    "no worlds": (lambda: mimo.make_vec("reach", num_envs=0), ValueError, "num_envs is 0, expected 1 or more"),
    "field": (lambda: world().observe()["touch"], KeyError, "no field 'touch'; there are: proprioception/position"),
    "camera": (lambda: world().render(camera="eye"), LookupError, 'no camera named "eye"; .*eye_left, eye_right'),
    "render mode": (
        lambda: mimo.make("reach", render_mode="rgb"),
        ValueError,
        "expected 'rgb_array', 'depth_array', 'human'",
    ),
    "several infants": (
        lambda: mimo.make("playdate"),
        ValueError,
        "2 infants, expected one; for several use mimo.ParallelEnv",
    ),
    "file": (lambda: mimo.Scene(file="no.xml"), LookupError, "no.xml"),
    "no recording": (lambda: mimo.Recording("no.h5"), LookupError, "cannot read no.h5: the file does not exist"),
    "face": (lambda: world().set_face("happy"), LookupError, 'no face named "happy"; there are: neutral'),
}


@pytest.mark.parametrize("case", CASES.values(), ids=list(CASES))
def test_message(case):
    mistake, kind, said = case
    with pytest.raises(kind, match=said) as raised:
        mistake()
    assert "\n" not in str(raised.value)


def test_nothing_is_said_of_a_good_start():
    with mimo.make("reach") as env:
        env.reset(seed=0)
        env.step(np.zeros(8, np.float32))


def test_first_mistakes_of_the_page(root):
    page = (root / "docs/guide/errors.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| `(mimo\..+?)` \| `(.+?)` \| ", page, re.MULTILINE)
    assert len(rows) >= 12
    for code, said in rows:
        with pytest.raises(Exception, match=re.escape(said)) as raised:
            eval(code, {"mimo": mimo})
        assert str(raised.value).startswith(said), code
