"""Policies with a hold, a clock and a reflex: what they compute, by hand, and the same numbers in all three readers."""

import json
import math
import re
import shutil
import subprocess
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from recorded import program

import mimo

ROOT = Path(__file__).resolve().parents[2]
BEHAVIOUR, SIT = ROOT / "web/src/behaviour.js", ROOT / "examples/policies/sit.json"
STEP = 0.01


def fake():
    """A world of two joints, of which one motor turns the second."""
    field = SimpleNamespace(shape=(2,), labels=["robot:a", "robot:b"])
    names = ("proprioception/position", "proprioception/velocity", "a")
    layout = SimpleNamespace(fields=dict.fromkeys(names, field))
    return SimpleNamespace(timestep=STEP, frame_skip=1, action_names=["act:x"], layout=layout)


def seen(angle=0.0, velocity=0.0, a=(0.0, 0.0)):
    return {"proprioception/position": [9, angle], "proprioception/velocity": [9, velocity], "a": list(a)}


def attached(fields=(("a", 2),), **others):
    width = sum(count for _, count in fields) + 2 * len(others.get("clock_s", ()))
    parts = {"layers": [(np.ones((1, width)), [0])], "mean": np.zeros(width), "deviation": np.ones(width), **others}
    policy = mimo.Policy(fields, ["act:x"], **parts)
    policy.attach(fake())
    return policy


REFLEX = {"stiffness": 2, "damping": 0.5, "joints": ["robot:b"], "start": [0.25]}


def test_an_output_holds_and_an_episode_begins_it_anew():
    policy = attached(hold_s=0.03)
    given = [
        policy.act(seen(a=(step / 10, 0)), [-1], [1], time)[0]
        for step, time in enumerate([0, 0.01, 0.02, 0.03, 0.04, 0, 0.01, 0.05])
    ]
    # Steps 0, 3, again 0, and one of another hold: from each on, the number that was seen then.
    assert given == pytest.approx([0, 0, 0, 0.3, 0.3, 0.5, 0.5, 0.7], abs=1e-6)


def test_an_earlier_time_is_another_episode_s():
    policy = attached(hold_s=0.05)
    times = [0.01, 0.03, 0.02, 0.04, 0.01]
    given = [policy.act(seen(a=(number / 10, 0)), [-1], [1], time)[0] for number, time in enumerate(times)]
    assert given == pytest.approx([0, 0, 0.2, 0.2, 0.4], abs=1e-6)


def test_half_steps_hold_as_long():
    """A physics step of two in a step of the world: halves are rounded up, in all readers."""
    policy = attached(hold_s=0.02)
    times = [0.005, 0.015, 0.025, 0.035, 0.045]  # steps 1 to 5
    given = [policy.act(seen(a=(number / 10, 0)), [-1], [1], time)[0] for number, time in enumerate(times, 1)]
    assert given == pytest.approx([0.1, 0.2, 0.2, 0.4, 0.4], abs=1e-6)


def test_what_begins_within_a_hold_thinks_at_once():
    policy = attached(hold_s=0.05)
    assert policy.act(seen(a=(0.3, 0)), [-1], [1], 0.01) == pytest.approx([0.3])
    policy.attach(fake())
    assert policy.act(seen(a=(0.6, 0)), [-1], [1], 0.02) == pytest.approx([0.6])
    assert policy.act(seen(a=(0.9, 0)), [-1], [1], 0.03) == pytest.approx([0.6])


def test_a_file_that_cannot_be_written_leaves_the_old_one(tmp_path):
    policy = attached()
    policy.save(tmp_path / "kept.json")
    deep = []
    for _ in range(15):
        deep = [deep]
    for how, said in (
        ({"share": np.float32(0.5)}, "how holds what is no JSON: .*float32"),
        ({"share": float("nan")}, "how holds what is no JSON"),
        ({"deep": deep}, "how is nested more than 15 deep"),
    ):
        policy.how = how
        with pytest.raises(ValueError, match=said):
            policy.save(tmp_path / "kept.json")
    assert mimo.Policy.load(tmp_path / "kept.json").how == {}
    policy.how = deep[0]
    policy.save(tmp_path / "kept.json")
    said = subprocess.run([program(), "run", "--policy", str(tmp_path / "kept.json")], capture_output=True, text=True)
    assert "nested" not in said.stderr
    assert "the world has no field" in said.stderr  # the file itself is read


def test_a_clock_is_read_after_the_fields():
    policy = attached(clock_s=[0.4, 2], layers=[([[0, 0, 1, 10, 0.1, 0.01]], [0])], mean=[0, 0, 0.5, 0, 0, 0])
    sines = [math.sin(math.pi / 2), math.cos(math.pi / 2), math.sin(math.pi / 10), math.cos(math.pi / 10)]
    number = (sines[0] - 0.5) + 10 * sines[1] + 0.1 * sines[2] + 0.01 * sines[3]
    assert policy.act(seen(), [-1], [1], 0.1) == pytest.approx([number], abs=1e-5)
    with pytest.raises(ValueError, match=r"give time=world\.time"):
        policy.act(seen(), [-1], [1])


def test_a_reflex_pulls_in_each_step_towards_the_goal_that_holds():
    policy = attached(hold_s=0.02, reflex=REFLEX)
    # 2 (0.25 + 0.1 - 0.15) - 0.5 0.2 = 0.3; in the second step the goal holds, and angle and velocity are new.
    assert policy.act(seen(0.15, 0.2, (0.1, 0)), [-1], [1], 0) == pytest.approx([0.3], abs=1e-6)
    assert policy.act(seen(0.05, 0.4, (0.9, 0)), [-1], [1], STEP) == pytest.approx([0.4], abs=1e-6)
    assert policy.act(seen(-3, 0, (0.9, 0)), [-1], [0.5], 2 * STEP) == pytest.approx([0.5])


def test_a_posture_reads_nothing():
    posture = attached(fields=(), layers=[(np.zeros((1, 0)), [0.5])], reflex=REFLEX)
    assert posture.version == 2
    assert posture.act(seen(0.5), [-1], [1]) == pytest.approx([2 * (0.25 + 0.5 - 0.5)])


def test_a_file_keeps_all_members_and_says_its_version(tmp_path):
    reflex = mimo.policy.StretchReflex(**REFLEX)
    attached(hold_s=0.02, clock_s=[1.5], reflex=reflex, age=5, delays=True).save(tmp_path / "new.json")
    again = mimo.Policy.load(tmp_path / "new.json")
    assert (again.hold_s, again.clock_s, again.reflex) == (0.02, [1.5], reflex)
    assert (again.age, again.delays) == (5, True)
    assert json.loads((tmp_path / "new.json").read_text())["version"] == again.version == 2
    attached().save(tmp_path / "old.json")
    assert json.loads((tmp_path / "old.json").read_text())["version"] == 1


def test_another_world_is_refused():
    with pytest.raises(ValueError, match=r"hold_s is 0.015, expected a whole number of steps of 0.01 s"):
        attached(hold_s=0.015)
    with pytest.raises(ValueError, match="'robot:bb'; did you mean 'robot:b'"):
        attached(reflex={**REFLEX, "joints": ["robot:bb"]})
    with pytest.raises(ValueError, match="attach it to the world first"):
        mimo.Policy([("a", 1)], ["act:x"], [([[1]], [0])], [0], [1], reflex=REFLEX).act(seen(), [-1], [1])


# ---- The same in all readers ----------------------------------------------------------------------------------------


def learned(world):
    """Goals of the arm by a network of two layers that reads joints and a clock every 50 ms; scene reach."""
    random = np.random.default_rng(3)
    sitting = json.loads(SIT.read_text())
    joints = dict(zip(sitting["actions"], sitting["reflex"]["joints"]))
    return mimo.Policy(
        [(name, 47) for name in ("proprioception/position", "proprioception/velocity")],
        world.action_names,
        [(random.normal(0, 0.1, (16, 98)), random.normal(0, 0.1, 16)), (random.normal(0, 0.5, (8, 16)), [0.1] * 8)],
        random.normal(0, 0.1, 98),
        np.full(98, 2.0),
        scene="reach",
        step_seconds=STEP,
        hold_s=0.05,
        clock_s=[0.7, 1.3],
        reflex=mimo.policy.StretchReflex(2, 0.1, [joints[name] for name in world.action_names], [0.2] * 8),
    )


@pytest.fixture(scope="module")
def reaching(tmp_path_factory):
    """The file of a policy, an observation for each of 60 steps, what Python gave then, and the reward of all."""
    world = mimo.World("reach", touch=False, vision=False)
    world.reset(seed=5)
    path = tmp_path_factory.mktemp("policies") / "rhythm.json"
    learned(world).save(path)
    policy = mimo.Policy.load(path)
    policy.attach(world)
    rows, reward = [], 0.0
    for _ in range(60):
        feels = {name: np.ravel(world.observation[name]).tolist() for name, _ in policy.fields}
        action = policy.act(world.observation, world.action_low, world.action_high, world.time)
        rows.append((world.time, feels, action))
        world.step(action)
        reward += float(np.ravel(world.reward)[0])
    return path, rows, reward, world


def test_the_program_does_the_same(reaching):
    path, _, reward, _ = reaching
    off = ["--vision", "off", "--touch", "off", "--out", str(path.parent)]
    said = subprocess.run(
        [program(), "run", "--policy", str(path), "--json", "--seed", "5", "--seconds", "0.6", *off],
        capture_output=True,
        text=True,
        timeout=600,
    )
    assert said.returncode == 0, said.stderr
    told = json.loads(said.stdout)
    assert told["steps"] == 60
    assert told["reward"] == pytest.approx(reward, rel=1e-5)


NODE = """
import { Policy } from %(module)s;
import { readFileSync } from "node:fs";
const { content, world, rows } = JSON.parse(readFileSync(0, "utf8"));
const policy = new Policy(content);
const labels = world.labels;
const layout = { ...world, label: (name, i) => labels[i] };
const action = new Float32Array(layout.actions.length);
const all = [];
if (!policy.fits({ layout })) throw new Error("it does not fit");
for (const [time, observation] of [...rows, ...rows.slice(0, 2), "anew", rows[8], rows[7], rows[8]]) {
  if (time === "a") {
    policy.fits({ layout });
    continue;
  }
  policy.act({ layout, observation, time: () => time }, action);
  all.push([...action]);
}
console.log(JSON.stringify(all));
"""


def in_node(content, world=None, rows=()):
    told = json.dumps({"content": content, "world": world or {"fields": [], "actions": []}, "rows": rows})
    script = NODE % {"module": json.dumps(BEHAVIOUR.as_uri())}
    arguments = ["node", "--input-type=module", "--eval", script]
    return subprocess.run(arguments, input=told, capture_output=True, text=True, timeout=120)


needs_node = pytest.mark.skipif(shutil.which("node") is None, reason="Node.js runs the page's reader, and is not here")


@needs_node
def test_the_page_does_the_same(reaching):
    path, rows, _, world = reaching
    field = "proprioception/position"
    layout = {
        "stepSeconds": STEP,
        "labels": list(world.layout.fields[field].labels),
        "fields": [{"name": name, "shape": [47]} for name in (field, "proprioception/velocity")],
        "actions": [
            {"name": name, "low": float(low), "high": float(high)}
            for name, low, high in zip(world.action_names, world.action_low, world.action_high)
        ],
    }
    said = in_node(json.loads(path.read_text()), layout, [row[:2] for row in rows])
    assert said.returncode == 0, said.stderr
    given = np.array(json.loads(said.stdout))
    assert np.abs(given[:60] - [row[2] for row in rows]).max() < 2e-6
    assert np.array_equal(given[60:62], given[:2])  # another episode
    anew = mimo.Policy.load(path)
    anew.attach(world)  # in the middle of a hold, as the page's last one
    for row, page in zip((rows[8], rows[7], rows[8]), given[62:]):  # the second is an earlier state that was loaded
        observation = {name: np.array(values) for name, values in row[1].items()}
        action = anew.act(observation, world.action_low, world.action_high, row[0])
        assert np.abs(page - action).max() < 2e-6


WRONG = [
    ({"version": 3}, "its version is 3"),
    ({"holds_s": 0.05}, "holds_s"),
    ({"what": 3}, "what"),
    ({"scene": None}, "scene"),
    ({"age": None}, "age"),
    ({"hold_s": None}, "hold_s"),
    ({"reflex": None}, "reflex"),
    ({"step_seconds": None}, "step_seconds"),
    ({"clip": None}, "clip"),
    ({"clock_s": None}, "clock_s"),
    ({"delays": None}, "delays"),
    ({"actions": 5}, "actions"),
    ({"actions": "abc"}, "actions"),
    ({"actions": [1] * 8}, "actions"),
    ({"fields": [["a", 47, 47]]}, "fields"),
    ({"fields": [["a", True]]}, "a"),
    ({"fields": [["a", 5000]]}, "4096"),
    ({"layers": [5]}, "layers"),
    ({"layers": [{"rows": True, "weights": "", "bias": ""}]}, "rows"),
    ({"layers": [{"rows": "4", "weights": "", "bias": ""}]}, "rows"),
    ({"mean": ["AAAAAA=="]}, "mean"),
    ({"mean": "!"}, "mean"),
    ({"version": 1}, "needs version 2, and its version is 1"),
    ({"age": 25}, "age"),
    ({"delays": 1}, "delays"),
    ({"hold_s": 0}, "hold_s"),
    ({"hold_s": "0.05"}, "hold_s"),
    ({"hold_s": 1e30}, "expected seconds from 0.001 to 1e+06"),
    ({"clock_s": [0.5, -1]}, "clock_s"),
    ({"clock_s": [0.5, 1e-310]}, "expected seconds from 0.001 to 1e+06"),
    ({"clock_s": [1.0] * 65}, "has 65 periods, expected at most 64"),
    ({"clock_s": [0.7]}, "mean"),
    ({"reflex": []}, "reflex"),
    ({"reflex": {"stiffness": -2}}, "stiffness"),
    ({"reflex": {"damping": None}}, "damping"),
    ({"reflex": {"joints": ["robot:head_tilt"]}}, "has 1 elements, expected 8, one for each action"),
    ({"reflex": {"start": [0.5]}}, "has 1 elements, expected 8, one for each action"),
    ({"reflex": {"start": ["0"] * 8}}, "start"),
    ({"reflex": {"gain": 3}}, "gain"),
]


@pytest.mark.parametrize(("change", "said"), WRONG)
def test_all_readers_name_what_is_wrong(reaching, tmp_path, change, said):
    content = json.loads(reaching[0].read_text())
    changed = dict(change)
    if isinstance(change.get("reflex"), dict):
        changed["reflex"] = {**content["reflex"], **change["reflex"]}
    content.update(changed)
    file = tmp_path / "wrong.json"
    file.write_text(json.dumps(content))
    with pytest.raises(ValueError, match=re.escape(said)) as refused:
        mimo.Policy.load(file)
    assert str(refused.value).startswith(f"policy {file}: ")
    by_program = subprocess.run([program(), "run", "--policy", str(file)], capture_output=True, text=True, timeout=60)
    assert by_program.returncode == 1
    assert said in by_program.stderr
    assert by_program.stderr.count("\n") == 1
    if shutil.which("node"):
        assert said in in_node(content).stderr


@pytest.mark.parametrize(("text", "said"), [("reach!", "no JSON object"), ("[" * 100_000, "nested"), ("[]", "no JSON")])
def test_python_names_a_file_that_holds_no_policy(tmp_path, text, said):
    file = tmp_path / "policy.json"
    file.write_text(text)
    with pytest.raises(ValueError, match=f"policy {re.escape(str(file))}: .*{said}"):
        mimo.Policy.load(file)


def test_messages_cut_long_values(reaching, tmp_path):
    content = {**json.loads(reaching[0].read_text()), "age": [0] * 10_000, "n" * 10_000: 1}
    for name in ("age", "n" * 10_000):
        file = tmp_path / "long.json"
        file.write_text(
            json.dumps({key: value for key, value in content.items() if key in (name, *mimo.policy.MEMBERS)})
        )
        content.pop(name)
        by_program = subprocess.run([program(), "run", "--policy", str(file)], capture_output=True, text=True)
        assert len(by_program.stderr) < 600
        assert len(in_node(json.loads(file.read_text())).stderr) < 2500 or not shutil.which("node")
        with pytest.raises(ValueError, match="policy") as refused:
            mimo.Policy.load(file)
        assert len(str(refused.value)) < 600


def test_messages_are_cut_between_letters(reaching, tmp_path):
    """A name of letters of two bytes, once from an odd byte on."""
    content = json.loads(reaching[0].read_text())
    for wrong in ({"age": "ä" * 100}, {"ä" * 100: 1}, {"x" + "ä" * 100: 1}, {"fields": [["ä" * 100, 98 - 4]]}):
        (tmp_path / "long.json").write_text(json.dumps({**content, **wrong}, ensure_ascii=False), encoding="utf-8")
        arguments = ["--policy", str(tmp_path / "long.json"), "--vision", "off", "--out", str(tmp_path)]
        refused = subprocess.run([program(), "run", *arguments], capture_output=True)
        assert refused.returncode == 1
        assert "ää..." in refused.stderr.decode("utf-8")


def test_a_network_that_gives_no_number_is_named(reaching, tmp_path):
    """Two of the largest numbers added are infinite, and one such less another is none."""
    policy = mimo.Policy.load(reaching[0])
    weights, bias = policy.layers[0]
    policy.layers[0] = (np.where(np.arange(98) % 2, weights * 0 + 3e38, -3e38).astype(np.float32), bias)
    policy.layers[1] = (np.full_like(policy.layers[1][0], 3e38), policy.layers[1][1])
    policy.mean[:] = 3e38
    policy.save(tmp_path / "wild.json")
    policy.attach(reaching[3])
    with pytest.raises(ValueError, match="network gives what is no finite number"):
        policy.act(reaching[3].observation, [-1] * 8, [1] * 8, 0)
    arguments = ["--policy", str(tmp_path / "wild.json"), "--vision", "off", "--out", str(tmp_path)]
    said = subprocess.run([program(), "run", *arguments], capture_output=True, text=True)
    assert said.returncode == 1
    assert "wild.json: its network gives what is no finite number" in said.stderr


def test_the_program_names_what_does_not_fit_the_world(reaching, tmp_path):
    content = json.loads(reaching[0].read_text())
    joints = ["robot:tail", *content["reflex"]["joints"][1:]]
    for change, said in (
        ({"hold_s": 0.025}, '"hold_s" is 0.025, expected a whole number of steps of 0.01 s'),
        ({"reflex": {**content["reflex"], "joints": joints}}, '"joints" has "robot:tail"'),
    ):
        (tmp_path / "wrong.json").write_text(json.dumps({**content, **change}))
        arguments = ["--vision", "off", "--touch", "off", "--out", str(tmp_path)]
        refused = subprocess.run(
            [program(), "run", "--policy", str(tmp_path / "wrong.json"), *arguments],
            capture_output=True,
            text=True,
            timeout=60,
        )
        assert refused.returncode == 1
        assert said in refused.stderr
