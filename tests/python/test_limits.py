"""Limited senses, as a lab would set them up."""

import copy
import pickle

import numpy as np
import pytest

import mimo


def infant(motors=None, **limits):
    scene = mimo.Scene("free")
    scene.add_agent(vision=False, touch=False)
    if limits:
        scene.limit_sense("proprioception/position", **limits)
    if motors:
        scene.limit_motor("left_arm", **motors)
    return mimo.World(scene)


def angles(world, steps=12):
    world.reset(seed=3)
    actions = np.linspace(-1, 1, len(world.action_low), dtype=np.float32)
    return np.array([world.step(actions).observation["proprioception/position"].copy() for _ in range(steps)])


def test_gain_and_delay():
    with infant() as perfect, infant(gain=0.5) as weak, infant(delay=0.03) as late:
        exact = angles(perfect)
        assert np.array_equal(angles(weak), exact / 2)
        assert np.array_equal(angles(late)[3:], exact[:-3])


def test_noise_is_the_seed_s_and_survives_copies():
    with infant(noise=0.01) as world, infant() as perfect:
        first = angles(world)
        assert np.array_equal(first, angles(world))
        error = first - angles(perfect)
        assert 0.008 < error.std() < 0.012
        assert np.array_equal(angles(copy.deepcopy(world)), first)


def test_noise_grows_with_what_is_sensed():
    with infant(signal_noise=0.1) as world, infant() as perfect:
        first, exact = angles(world), angles(perfect)
        assert np.array_equal(first, angles(copy.deepcopy(world)))
        share = (first - exact)[exact != 0] / exact[exact != 0]
        assert 0.08 < share.std() < 0.12
    with infant(motors={"signal_noise": 0.1}) as world, infant() as perfect:
        assert not np.array_equal(controls(world), controls(perfect))


def controls(world, steps=8):
    world.reset(seed=3)
    told = []
    for step in range(steps):
        actions = np.full(len(world.action_low), 0.1 * (step + 1), np.float32)
        told.append(world.step(actions).observation["proprioception/control"].copy())
    return np.array(told)


def test_motors_are_late_and_weak():
    with infant() as perfect, infant(motors={"delay": 0.02, "gain": 0.5}) as limited:
        arm = [i for i, name in enumerate(perfect.action_names) if "left_shoulder" in name or "left_elbow" in name]
        others = [i for i in range(len(perfect.action_names)) if i not in arm]
        now, then = controls(perfect), controls(limited)
        assert len(arm) == 4
        assert np.array_equal(now[:, others], then[:, others])
        assert not then[:2, arm].any()
        assert then[2:, arm] == pytest.approx(now[:-2, arm] / 2)


def test_motor_noise_is_the_seed_s_and_survives_copies():
    with infant(motors={"noise": 0.01, "delay": 0.05}) as world:
        first = controls(world)
        assert np.array_equal(first, controls(world))
        assert np.array_equal(controls(copy.deepcopy(world)), first)
        assert np.array_equal(controls(pickle.loads(pickle.dumps(world))), first)


def test_loading_reports_what_the_state_lacks():
    with infant() as perfect, infant(delay=0.05) as late, infant(motors={"delay": 0.02}) as slow:
        assert late.load(perfect.save()) == mimo.LoadReport(("delay/proprioception/position",), ())
        assert perfect.load(late.save()) == mimo.LoadReport((), ("delay/proprioception/position",))
        assert slow.load(late.save()) == (("agent/motor delay",), ("delay/proprioception/position",))
        assert late.load(late.save()) == ((), ())


def test_bad_limits_are_refused():
    with pytest.raises(ValueError, match=r"delay is -1.*expected 0 to 2 seconds"):
        infant(delay=-1)
    with pytest.raises(ValueError, match=r"delay is 11.*expected 0 to 2 seconds"):
        infant(delay=11)
    with pytest.raises(ValueError, match=r"signal_noise is -1.*expected a share of the value"):
        infant(signal_noise=-1)
    with pytest.raises(TypeError, match="delay is 'soon', expected a number"):
        infant(delay="soon")
    scene = mimo.Scene("free")
    scene.add_agent(vision=False)
    scene.limit_motor("tail", delay=0.1)
    with pytest.raises(mimo.NotFoundError, match='no motor "tail"; the agent has: act:'):
        mimo.World(scene)
