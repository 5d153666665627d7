"""Behaviours that scenes' documents describe, in Python."""

import numpy as np
import pytest

import mimo
from mimo.registration import ENVIRONMENTS


def behaviours():
    found = []
    for name in mimo.scenes():
        try:
            mimo.Scene(name).behaviour()
        except mimo.NotFoundError:
            continue
        found.append(name)
    return found


def test_twenty_and_more_have_names_in_gymnasium():
    names = behaviours()
    assert len(names) >= 20
    assert set(names) <= {scene for _, scene in ENVIRONMENTS}


def test_a_behaviour_says_what_it_measures_and_when_infants_show_it():
    stand = mimo.Scene("stand").behaviour()
    assert (stand.measure, stand.unit, stand.at_most, stand.hold_seconds) == ("height head", "m", False, 10)
    assert "contacts feet ground at least 2 from 0 parts" in stand.conditions
    assert (stand.norm.early, stand.norm.late) == (6.9, 16.9)  # WHO's window
    assert "WHO" in stand.norm.source
    unknown = mimo.Scene("lift").behaviour().norm
    assert unknown.age is None
    assert unknown.source.startswith("not found")


def test_a_batch_measures_each_world():
    envs = mimo.make_vec("head-lift", num_envs=3, threads=2)
    envs.reset(seed=1)
    actions = np.zeros((3, envs.single_action_space.shape[0]), np.float32)
    for _ in range(5):
        envs.step(actions)
    batch = envs.batch if hasattr(envs, "batch") else envs
    values = batch.get(mimo.Quantity.AGENT_ACHIEVED)
    assert values.reshape(3, -1).shape[1] == 3  # the angle, contacts of the head, seconds held
    assert (values.reshape(3, -1)[:, 0] > 135).all()  # the face looks down
    envs.close()


def test_a_document_of_ones_own_makes_a_task(tmp_path):
    (tmp_path / "crouch.xml").write_text("""
      <mujoco>
        <include file="mimo/parts/room.xml"/>
        <custom>
          <numeric name="mimo:place" data="0 0 0.36 1 0 0 0"/>
          <text name="mimo:task" data="behaviour"/>
          <text name="mimo:behaviour" data="crouches"/>
          <text name="mimo:reached" data="height head at most 0.3 from 0.6 m; for 0.1 s"/>
          <numeric name="mimo:episode_seconds" data="3"/>
        </custom>
      </mujoco>""")
    scene = mimo.Scene(file=tmp_path / "crouch.xml")
    assert scene.behaviour().about == "crouches"
    scene.add_agent()
    world = mimo.World(scene)
    world.reset(seed=1)
    reached = False
    while not world.truncated:
        world.step(np.zeros(len(world.action_names), np.float32))
        reached |= bool(world.outcome == 1)
    assert reached  # an infant that nobody moves falls down


def test_parameters_change_threshold_and_time():
    scene = mimo.Scene("sit")
    scene.add_agent()
    scene.parameters["behaviour/threshold"] = 60
    scene.parameters["behaviour/hold_seconds"] = 2
    goal = mimo.World(scene).get(mimo.Quantity.AGENT_GOAL).ravel()
    assert (goal[0], goal[-1]) == (60, 2)


def test_ages_at_which_a_pose_is_impossible_are_refused():
    with pytest.raises(mimo.UnsupportedError, match=r"age is 0 months.*is to start at"):
        mimo.make("stand", age=0)


def test_mittens_do_not_grasp():
    with pytest.raises(ValueError, match="made for fingers only"):
        mimo.make("lift", body="mitten")
