"""Learned policies in files: what they compute, what is refused, and that the program reads them alike."""

import json
import subprocess
from pathlib import Path

import numpy as np
import pytest
from recorded import program, record, table_of

import mimo

POLICIES = Path(__file__).resolve().parents[2] / "examples/policies"
REACH = POLICIES / "reach.json"


def small(**others):
    """Two numbers in, two rows between, one action."""
    layers = [([[1, 0], [0, 2]], [0.5, 0]), ([[1, -1]], [0.25])]
    return mimo.Policy([("a", 1), ("b", 1)], ["act:x"], layers, [1, 2], [2, 4], **others)


def test_the_network_is_the_pages():
    # By hand: (3 - 1) / 2 = 1 and (4 - 2) / 4 = 0.5; tanh(1.5) - tanh(1) + 0.25 = 0.39355; of -2..4 that is 2.18066.
    action = small().act({"a": [3], "b": [4]}, [-2], [4])
    value = np.tanh(1.5) - np.tanh(1) + 0.25
    assert action.dtype == np.float32
    assert action == pytest.approx([-2 + 6 * (value + 1) / 2], abs=1e-6)
    assert small(clip=0.1).act({"a": [3], "b": [4]}, [-1], [1]) == pytest.approx([np.tanh(0.6) - np.tanh(0.2) + 0.25])


def test_a_file_gives_the_same_policy(tmp_path):
    small(scene="free", step_seconds=0.02, how={"seed": 1}).save(tmp_path / "small.json")
    again = mimo.Policy.load(tmp_path / "small.json")
    assert (again.scene, again.step_seconds, again.how) == ("free", 0.02, {"seed": 1})
    seen = {"a": [0.3], "b": [7]}
    assert np.array_equal(again.act(seen, [-1], [1]), small().act(seen, [-1], [1]))


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"mean": [1]}, r"mean has shape \(1,\)"),
        ({"deviation": [1, 0]}, "not above 0"),
        ({"mean": [1, np.nan]}, "no finite number"),
        ({"layers": [([[1, 2, 3]], [0])]}, "layer 0"),
        ({"actions": ["act:x", "act:y"]}, "expected 2, one for each action"),
    ],
)
def test_what_does_not_fit_together_is_named(change, said):
    parts = {
        "fields": [("a", 1), ("b", 1)],
        "actions": ["act:x"],
        "layers": [([[1, 2]], [0])],
        "mean": [0, 0],
        "deviation": [1, 1],
    }
    with pytest.raises(ValueError, match=said):
        mimo.Policy(**{**parts, **change})


def test_other_files_are_refused(tmp_path):
    (tmp_path / "other.json").write_text('{"format": "mimo-policy", "version": 3}')
    with pytest.raises(ValueError, match=r"other\.json: its version is 3, and this library reads versions 1 and 2"):
        mimo.Policy.load(tmp_path / "other.json")


def test_reach_reaches_and_is_small():
    policy = mimo.Policy.load(REACH)
    assert REACH.stat().st_size < 200_000
    world = mimo.World(policy.scene)
    policy.attach(world)
    reached = 0
    for seed in range(8):
        world.reset(seed=seed)
        while not (world.terminated or world.truncated):
            world.step(policy.act(world.observation, world.action_low, world.action_high))
        reached += bool(world.terminated)
    assert reached >= 5  # random actions reach the ball in one of twenty episodes: docs/learning.md


@pytest.mark.parametrize(
    ("options", "said"),
    [
        ({"body": "fingers"}, "field 'proprioception/position' has"),
        ({"frame_skip": 4}, "steps of 0.01 s, the world's last 0.02 s"),
        ({"proprioception": mimo.Proprioception.POSITION}, "no field 'proprioception/velocity'"),
    ],
)
def test_another_layout_is_refused(options, said):
    with pytest.raises(ValueError, match=said):
        mimo.Policy.load(REACH).attach(mimo.World("reach", **options))


# ---- The program --------------------------------------------------------------------------------------------------


def run(folder, *arguments):
    quiet = ["--vision", "off", "--touch", "off", "--out", str(folder)]
    return subprocess.run([program(), "run", *quiet, *map(str, arguments)], capture_output=True, text=True, timeout=600)


def constant(world, path, value):
    """A policy that gives one number whatever it sees."""
    count = sum(int(np.prod(field.shape)) for field in world.layout.fields.values())
    actions = len(world.action_names)
    layer = (np.zeros((actions, count)), np.full(actions, value))
    mimo.Policy.of(world, [layer], np.zeros(count), np.ones(count), scene="reach").save(path)


def test_the_program_acts_as_the_file_says(tmp_path):
    world = mimo.World("reach")
    constant(world, tmp_path / "still.json", 0.5)
    said = run(tmp_path, "--policy", tmp_path / "still.json", "--json", "--seed", 3)
    assert said.returncode == 0, said.stderr
    told = json.loads(said.stdout)
    world.reset(seed=3)
    total, steps, low, high = 0.0, 0, np.array(world.action_low), np.array(world.action_high)
    while not (world.terminated or world.truncated):
        world.step(low + 0.75 * (high - low))
        total, steps = total + float(np.ravel(world.reward)[0]), steps + 1
    assert told["scene"] == told["task"] == "reach"
    assert told["steps"] == steps
    assert told["over"]
    assert told["reward"] == pytest.approx(total, rel=1e-6)
    assert (told["outcome"] == "success") == bool(world.terminated)


def test_the_program_reaches_and_says_how_fast_it_thinks(tmp_path):
    told = [json.loads(run(tmp_path, "--policy", REACH, "--json", "--seed", seed).stdout) for seed in range(4)]
    assert sum(one["outcome"] == "success" for one in told) >= 2
    assert all(one["policy_us"] > 0 for one in told)
    assert all(one["measure"] is None for one in told)  # reach measures what its own terms say


LEARNED = [("sit", 6), ("sit", 9), ("stand-with-support", 12), ("walk-with-help", 9), ("walk-with-help", 18)]
LEARNED += [("roll-to-belly", 3), ("roll-to-belly", 12), ("roll-to-back", 6)]


@pytest.mark.parametrize(("scene", "age"), LEARNED)
def test_the_program_shows_what_was_learned(tmp_path, scene, age):
    """Sitting and standing for the WHO's 10 seconds; doing nothing, the infant falls within half a second."""
    file = POLICIES / f"{scene}.json"
    assert file.stat().st_size < 200_000
    episodes = ["--age", age, "--parameter", "behaviour/ends_on_success=1", "--json", "--seed"]
    told = [json.loads(run(tmp_path, "--policy", file, *episodes, seed).stdout) for seed in range(50, 54)]
    assert sum(one["outcome"] == "success" for one in told) >= 3
    if scene in ("sit", "stand-with-support"):
        assert all(one["measure"]["hold_seconds"] == 10 for one in told)
        assert max(one["measure"]["held_seconds"] for one in told) >= 10 - 1e-6


def test_the_age_is_the_policy_s_unless_another_is_asked_for(tmp_path):
    """It says 6 months, and at 3 the infant falls."""
    shown = [run(tmp_path, "--policy", POLICIES / "sit.json", "--json", *age) for age in ([], ["--age", 3])]
    assert [json.loads(one.stdout)["outcome"] for one in shown] == ["success", "none"]


def test_nerves_are_those_with_which_the_policy_has_learned(tmp_path):
    """Other nerves, another episode: those of its age, unless they are switched off or the file says nothing."""
    content = json.loads((POLICIES / "sit.json").read_text())
    assert content.pop("delays") is True
    (tmp_path / "fast.json").write_text(json.dumps(content))
    shown = [["--policy", POLICIES / "sit.json"], ["--policy", POLICIES / "sit.json", "--delays", "none"]]
    shown += [["--policy", tmp_path / "fast.json"]]
    rewards = [json.loads(run(tmp_path, *one, "--json").stdout)["reward"] for one in shown]
    assert rewards[0] != rewards[1] == rewards[2]


def test_nerves_without_an_age_are_those_of_18_months(tmp_path):
    content = {**json.loads(REACH.read_text()), "version": 2, "delays": True}
    late, older = tmp_path / "late.json", tmp_path / "older.json"
    late.write_text(json.dumps(content))
    older.write_text(json.dumps({**content, "age": 18}))
    rewards = [
        json.loads(run(tmp_path, "--policy", file, "--json", *more).stdout)["reward"]
        for file, more in ((late, []), (older, []), (late, ["--delays", "none"]))
    ]
    assert rewards[0] == rewards[1] != rewards[2]


def test_a_scene_that_is_not_there_is_the_policy_s(tmp_path):
    (tmp_path / "lost.json").write_text(json.dumps({**json.loads(REACH.read_text()), "scene": "reech"}))
    refused = run(tmp_path, "--policy", tmp_path / "lost.json")
    assert refused.returncode == 1
    assert 'lost.json: its scene: no scene named "reech"' in refused.stderr


def test_a_recording_of_a_policy_ends_with_its_episode(tmp_path):
    episode = ["--policy", POLICIES / "sit.json", "--seconds", 30]
    told = json.loads(run(tmp_path, *episode, "--json").stdout)
    path = record(tmp_path / "sit.h5", *map(str, episode), "--touch", "off", "--keep", "proprioception")
    angles = table_of(path, "fields/proprioception/position")
    assert len(angles) == told["steps"] == 1500  # the episode's 15 s
    assert table_of(path, "outcome")[-1] == mimo.Outcome.SUCCESS  # at the policy's age; at 18 months it falls


def test_the_program_prints_what_a_behaviour_measures(tmp_path):
    told = json.loads(run(tmp_path, "--scene", "sit", "--json", "--seconds", "0.1").stdout)
    assert told["measure"]["name"] == "tilt upper_body z"
    assert told["measure"]["unit"] == "deg"
    assert told["measure"]["threshold"] == told["goal"][0]
    assert told["measure"]["value"] == told["achieved"][0]
    assert told["task"] == "behaviour"
    assert told["outcome"] == "none"


@pytest.mark.parametrize(
    ("change", "arguments", "said"),
    [
        ({}, ["--body", "fingers"], 'field "proprioception/position" has'),
        (
            {},
            ["--scene", "standup"],
            'field "proprioception/control" has 27 numbers in this world, and 8 in the policy',
        ),
        ({"fields": [["proprioception/limit", 212 + 8]]}, [], 'field "proprioception/limit" has 47 numbers'),
        ({"version": 3}, [], "its version is 3, and this program reads versions 1 and 2"),
        ({"hold_s": 0.05}, [], '"hold_s" needs version 2, and its version is 1'),
        ({"format": "onnx"}, [], '"format" is not "mimo-policy"'),
        ({"mean": "AAAA"}, [], '"mean" holds 3 bytes of base 64, expected'),
        ({"mean": "!"}, [], '"mean" holds 0 bytes'),
        ({"layers": []}, [], 'no list "layers"'),
        ({"step_seconds": 0.02}, [], "steps of 0.02 s, and the world's last 0.01 s"),
        ({"fields": [["proprioception/position", 10**9]]}, [], "a field's count is 1000000000"),
    ],
)
def test_the_program_names_what_is_wrong(tmp_path, change, arguments, said):
    content = {**json.loads(REACH.read_text()), **change}
    (tmp_path / "policy.json").write_text(json.dumps(content))
    refused = run(tmp_path, "--policy", tmp_path / "policy.json", "--json", *arguments)
    assert refused.returncode == 1
    assert said in refused.stderr
    assert refused.stderr.count("\n") == 1


def test_values_nested_without_end_are_refused(tmp_path):
    lists = "[" * 300_000 + "]" * 300_000
    (tmp_path / "policy.json").write_text(REACH.read_text().replace('"version": 1', f'"version": {lists}'))
    assert lists in (tmp_path / "policy.json").read_text()
    refused = run(tmp_path, "--policy", tmp_path / "policy.json")
    assert refused.returncode == 1
    assert "nested more than 16 times" in refused.stderr


def test_no_json_is_refused(tmp_path):
    (tmp_path / "policy.json").write_text("reach!")
    refused = run(tmp_path, "--policy", tmp_path / "policy.json")
    assert refused.returncode == 1
    assert "no JSON object" in refused.stderr
