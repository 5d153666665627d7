"""mimo.babybench: behaviours that scenes describe, as environments of BabyBench with logs in its format."""

import pickle
import subprocess
import sys

import numpy as np
import pytest
from competition import BLIND, logged, made

import mimo
from mimo import babybench
from mimo.babybench import groups, scores
from mimo.babybench.described import described_in_scenes

CROUCH = """
<mujoco>
  <include file="mimo/parts/room.xml"/>
  <custom>
    <numeric name="mimo:place" data="0 0 0.36 1 0 0 0"/>
    <text name="mimo:task" data="behaviour"/>
    <text name="mimo:behaviour" data="crouches"/>
    <text name="mimo:reached" data="height head at most 0.3 from 0.6 m"/>
    <numeric name="mimo:episode_seconds" data="5"/>
  </custom>
</mujoco>
"""


def acted(env, steps, seed=1):
    env.reset(seed=seed)
    env.action_space.seed(seed)
    for _ in range(steps):
        result = env.step(env.action_space.sample())
    return result


# ---- Environments --------------------------------------------------------------------------------------------------


def test_there_are_twenty_five():
    assert len(described_in_scenes()) == 25


@pytest.mark.parametrize("name", described_in_scenes())
def test_each_behaviour_is_an_environment_of_the_form(name):
    env = made(behavior=name, **BLIND)
    _, reward, terminated, truncated, info = acted(env, 2)
    told = mimo.Scene(name).behaviour()
    assert (reward, terminated, truncated, info["steps"]) == (0, False, False, 1)
    assert (info["behavior"], info["measured"], info["unit"]) == (name, told.measure, told.unit)
    assert (info["threshold"], info["hold_seconds"]) == (told.threshold, told.hold_seconds)
    assert env.spec.max_episode_steps == round(told.episode_seconds / 0.01)  # a step has two of 5 ms
    motors = [env.model.actuator(number).name for number in range(env.model.nu)]
    assert motors == groups.in_order(motors)
    assert sorted(motors) == sorted(mimo.World(name, **{"touch": False, "vision": False}).action_names)
    env.close()


@pytest.mark.parametrize("name", ["sit", "stand-with-support", "reach-moving", "follow"])
def test_the_measure_is_that_of_the_library_s_own_world(name):
    still = {"behaviour/pose_noise": 0}
    config = babybench.load({"behavior": name, **BLIND})
    env = babybench.make(config, parameters=still)
    world = mimo.World(name, touch=False, vision=False, parameters=still)
    env.reset(seed=1)
    world.reset(seed=1)
    env.action_space.seed(1)
    motors = [env.unwrapped.model.actuator(number).name for number in range(env.unwrapped.model.nu)]
    order = [motors.index(name) for name in world.action_names]
    for _ in range(15):
        action = env.action_space.sample()
        info = env.step(action)[4]
        world.step(action[order])
        achieved = world.get(mimo.Quantity.AGENT_ACHIEVED).ravel()
        assert (info["measure"], info["held_seconds"]) == pytest.approx((achieved[0], achieved[-1]), rel=1e-6, abs=1e-9)


def test_what_holds_long_enough_is_reached():
    env = babybench.make({"behavior": "sit", **BLIND}, parameters={"behaviour/hold_seconds": 0.05})
    env.reset(seed=1)
    infos = [env.step(np.zeros(38, np.float32))[4] for _ in range(6)]
    # It sits at first. Ten physics steps of 5 ms, two a step: in the fifth.
    assert [info["reached"] for info in infos] == [False, False, False, False, True, True]
    assert infos[4]["held_seconds"] == pytest.approx(0.05)
    assert infos[4]["hold_seconds"] == 0.05


def test_an_episode_is_as_long_as_the_configuration_says():
    env = made(behavior="bang", max_episode_steps=510, frame_skip=2, **BLIND)  # the document says 500
    env.reset(seed=1)
    ends = [env.step(np.zeros(19, np.float32))[2:4] for _ in range(510)]
    assert ends[-1] == (False, True)
    assert not any(map(any, ends[:-1]))


@pytest.mark.parametrize(("frame_skip", "steps"), [(1, 3000), (2, 1500), (4, 750)])
def test_an_episode_lasts_as_long_with_other_steps(frame_skip, steps):
    """15 s in physics steps of 5 ms: shorter ones could not hold for 10 s."""
    assert babybench.load({"behavior": "sit", "frame_skip": frame_skip})["max_episode_steps"] == steps


def test_switches_change_what_the_scene_says():
    env = made(behavior="follow", act_arms=True, act_eyes=False, lock_feet=True, frame_skip=1, **BLIND)
    motors = [env.model.actuator(number).name for number in range(env.model.nu)]
    assert {groups.group_of(name) for name in motors} == {"head", "arms"}
    assert env.dt == 0.005
    acted(env, 20)
    assert abs(env.data.joint("robot:right_foot1").qpos[0]) < 0.03


def test_a_document_of_ones_own(tmp_path):
    file = tmp_path / "crouch.xml"
    file.write_text(CROUCH)
    env = made(behavior=str(file), **BLIND)
    info = acted(env, 3)[4]
    assert (info["behavior"], info["measured"], info["threshold"]) == (str(file), "height head", 0.3)
    # 5 s in steps of two physics steps of 5 ms, which a world has where its document says nothing.
    assert (env.spec.max_episode_steps, env.dt) == (500, 0.01)
    assert info["measure"] == pytest.approx(env.unwrapped.world.bodies("head").position[0, 2], abs=0.02)


@pytest.mark.parametrize(
    ("skip", "timestep", "frames"),
    [('data="3"', "0.005", 3), ('size="3" data="3"', "0.005", 2), ('data="0"', "0.002", 2), ('data="2 0"', "0.005", 2)],
)
def test_steps_are_those_of_the_library_s_world(tmp_path, skip, timestep, frames):
    """Only one number from 1 on is a number of physics steps."""
    file = tmp_path / "crouch.xml"
    more = f'<numeric name="mimo:frame_skip" {skip}/></custom><option timestep="{timestep}"/>'
    file.write_text(CROUCH.replace("</custom>", more))
    told = babybench.load({"behavior": str(file)})
    assert told["frame_skip"] == frames
    assert told["max_episode_steps"] == round(5 / (frames * float(timestep)))


def test_senses_and_pictures():
    env = made(behavior="sit", vision_resolution=16, touch_scale=5)
    seen, _ = env.reset(seed=1)
    assert sorted(seen) == ["eye_left", "eye_right", "observation", "touch", "vestibular"]
    assert babybench.utils.evaluation_img(env).shape == (480, 720, 3)


# ---- Logs ----------------------------------------------------------------------------------------------------------


def test_training_and_evaluation_are_logged(tmp_path, capsys):
    config = {"behavior": "sit", "save_dir": str(tmp_path), **BLIND}
    env = babybench.make(config, parameters={"behaviour/hold_seconds": 0.05})
    for steps in (3, 6):
        env.reset(seed=1)
        for _ in range(steps):
            env.step(np.zeros(38, np.float32))
    env.close()
    entries = logged(tmp_path)
    assert [entry["steps"] for entry in entries] == [0, 3, 6]
    assert [entry["reached"] for entry in entries] == [False, False, True]
    assert [entry["held_seconds"] for entry in entries] == pytest.approx([0, 0.03, 0.06])
    assert {entry["behavior"] for entry in entries} == {"sit"}

    env = babybench.make(config, training=False)
    evaluation = babybench.EVALS["sit"](env, duration=4)
    line = "training.pkl: sit, 2 episodes; reached in 0.5000 of them, in 0.5000 of those that the competition counts"
    assert evaluation.eval_logs() == f"{line}; held for 0.8000 of the time, mean of single episodes"
    env.reset(seed=1)
    evaluation.reset()
    for _ in range(4):
        evaluation.eval_step(env.step(env.action_space.sample())[4])
    evaluation.end(0)
    env.close()
    episode = logged(tmp_path, "evaluation_0.pkl")
    assert [len(episode[key]) for key in ("qpos", "info")] == [4, 4]
    assert [info["steps"] for info in episode["info"]] == [0, 1, 2, 3]
    capsys.readouterr()
    told = subprocess.run([sys.executable, "-m", "mimo.babybench.evaluate", tmp_path], capture_output=True, text=True)
    assert told.stdout.splitlines()[0].startswith(line)
    assert told.stdout.splitlines()[1].startswith("evaluation: sit, 1 episodes; reached in 0.0000")


def test_closing_twice_is_allowed(tmp_path):
    for behavior in ("sit", "self_touch", "none"):
        env = babybench.make({"behavior": behavior, "save_dir": str(tmp_path / behavior), **BLIND})
        acted(env, 2)
        env.close()
        env.unwrapped.close()
        assert [entry["steps"] for entry in logged(tmp_path / behavior)] == [0, 2]


def test_documents_of_ones_own_are_evaluated():
    assert babybench.EVALS["rooms/crouch.xml"] is babybench.Evaluation
    with pytest.raises(KeyError):
        babybench.EVALS["croutch"]


def entry(steps, held, reached=False, hold=10.0):
    return {"steps": steps, "behavior": "sit", "held_seconds": held, "hold_seconds": hold, "reached": reached}


def test_scores():
    played = [entry(1500, 10.0, True), entry(1500, 4.0), entry(1500, 12.0, True), entry(1500, 0.0)]
    told = scores.scores_of([entry(0, 0.0), *played])
    assert told == ("sit", 4, 0.5, 0.5, pytest.approx((1 + 0.4 + 1 + 0) / 4))
    assert scores.scores_of(played).competition == pytest.approx(1 / 3)  # the first entry does not count there
    assert scores.scores_of([entry(9, 0.0, hold=0), entry(9, 0.005, True, hold=0)]).right_mean == 0.5
    assert scores.scores_of([entry(0, 0.0)]) == ("sit", 0, None, None, None)


@pytest.mark.parametrize(
    ("change", "line"),
    [
        ({"held_seconds": -1}, "held_seconds of episode 0 is -1, expected seconds from 0 on"),
        ({"hold_seconds": "ten"}, "hold_seconds of episode 0 is 'ten', expected seconds from 0 on"),
        ({"reached": None}, "reached of episode 0 is None, expected true or false"),
        ({"behavior": 3}, "behavior of episode 0 is 3, expected a name"),
    ],
)
def test_logs_that_say_nothing_are_refused(tmp_path, change, line):
    path = tmp_path / "training.pkl"
    path.write_bytes(pickle.dumps([{**entry(9, 1.0), **change}]))
    with pytest.raises(ValueError, match=f"training.pkl is not a log: {line}"):
        babybench.reports.scores_in(path)


def test_many_worlds_log_the_same(tmp_path):
    config = {"behavior": "sit", "save_dir": str(tmp_path), "max_episode_steps": 5, **BLIND}
    envs = babybench.make_vec(config, 2, threads=1, autoreset_mode="SameStep")
    envs.reset(seed=1)
    for _ in range(5):
        _, rewards, terminated, truncated, infos = envs.step(np.zeros((2, 38), np.float32))
        assert rewards.tolist() == [0, 0]
    assert (terminated.tolist(), truncated.tolist()) == ([False, False], [True, True])
    assert infos["measure"].shape == infos["reached"].shape == (2,)
    envs.close()
    one = babybench.make(config)
    one.reset(seed=1)
    for _ in range(5):
        info = one.step(np.zeros(38, np.float32))[4]
    first = next(entry for entry in envs.log if entry["steps"] == 5)
    assert first == {**info, "steps": 5}
    assert pickle.loads((tmp_path / "logs/training.pkl").read_bytes()) == envs.log


# ---- Configurations ------------------------------------------------------------------------------------------------


def test_configurations_name_a_behaviour(tmp_path):
    (tmp_path / "mine.yml").write_text("behavior: stand\nvision_active: false\ntouch_active: false\nact_head: false\n")
    env = babybench.make(str(tmp_path / "mine.yml"))
    assert env.action_space.shape == (35,)
    assert env.spec.id == "BabyBench-Behavior"
    assert babybench.load(babybench.load("stand")) == babybench.load("stand")
    assert babybench.load("stand")["scene"] == "stand"
    assert babybench.load({"behavior": "stand", "scene": "stand"})["max_episode_steps"] == 1500


@pytest.mark.parametrize(
    ("given", "line"),
    [
        ({"behavior": "sitt"}, "behavior is 'sitt', expected 'none', 'self_touch', .*'mobile', or an MJCF file.*'sit'"),
        ({"behavior": "reach"}, "behavior is 'reach', whose scene describes no behaviour"),
        ({"behavior": 3}, "behavior is 3, expected 'none'"),
        ({"behavior": "nowhere.xml"}, "behavior is 'nowhere.xml', which is refused: .*nowhere.xml"),
        ({"behavior": "sit", "scene": "crib"}, "scene is 'crib', but behavior 'sit' has a scene of its own"),
        ({"behavior": "self_touch", "scene": "sit"}, "scene is 'sit', expected 'base', 'crib', 'cubes'"),
        ({"behavior": "sit", "frame_skip": 0}, "frame_skip is 0, expected a whole number from 1 on"),
    ],
)
def test_what_does_not_go_together_is_refused(given, line):
    with pytest.raises(ValueError, match=line) as raised:
        babybench.make(given)
    assert "\n" not in str(raised.value)


@pytest.mark.parametrize("option", ['timestep="abc"', 'timestep="0"', 'timestep="0.002 0.003"'])
def test_a_document_that_cannot_be_simulated_is_refused(tmp_path, option):
    (tmp_path / "bad.xml").write_text(CROUCH.replace("<custom>", f"<option {option}/><custom>"))
    with pytest.raises(ValueError, match=r"bad\.xml"):
        babybench.make({"behavior": str(tmp_path / "bad.xml"), **BLIND})


def test_a_document_that_says_nonsense_is_refused(tmp_path):
    (tmp_path / "bad.xml").write_text(CROUCH.replace("at most", "below"))
    with pytest.raises(ValueError, match=r"bad\.xml', which is refused: .*\"at least\" or \"at most\""):
        babybench.make({"behavior": str(tmp_path / "bad.xml")})
