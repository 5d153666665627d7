"""mimo.classic: what the original tolerates in scenes and arguments, and physics steps that Python makes one by one."""

import copy
import pickle
import struct
import zlib
from pathlib import Path

import gymnasium
import numpy as np
import pytest

import mimo
from mimo import classic
from mimo.classic import growth, utils
from mimo.classic.plain import PlainWorld

ROOM = """<mujoco>
  <include file="mimo/mitten.xml"/>
  <option timestep="0.005"/>
  <worldbody><geom name="ground" type="plane" size="0 0 1"/></worldbody>
</mujoco>"""


@pytest.fixture
def room(tmp_path):
    path = tmp_path / "room.xml"
    path.write_text(ROOM)
    return str(path)


class Counted(classic.MIMoDummyEnv):
    """Python makes its physics steps one by one."""

    substeps = 0

    def _substep_callback(self):
        self.substeps += 1


@pytest.mark.parametrize("model", [classic.SpringDamperModel, classic.MuscleModel, classic.PositionalModel])
@pytest.mark.parametrize("frame_skip", [1, 3])
def test_single_physics_steps_make_the_same_step(model, frame_skip):
    options = {"vision_params": None, "actuation_model": model, "frame_skip": frame_skip}
    whole, single = classic.MIMoDummyEnv(**options), Counted(**options)
    for env in (whole, single):
        env.reset(seed=4)
        env.action_space.seed(4)
    for _ in range(15):
        action = whole.action_space.sample()
        seen, same = whole.step(action)[0], single.step(action)[0]
        for name in seen:
            np.testing.assert_array_equal(seen[name], same[name], err_msg=name)
    assert single.substeps == 15 * frame_skip
    assert single.actuation_model.cost() == pytest.approx(whole.actuation_model.cost())
    np.testing.assert_allclose(single.actuation_model.observations(), whole.actuation_model.observations(), atol=1e-6)


def test_muscles_are_those_of_the_original_s_formulas():
    env = classic.MIMoMuscleDummyEnv(vision_params=None, touch_params=None, frame_skip=1)
    env.reset(seed=1)
    env.step(np.full(env.action_space.shape, 0.5, np.float32))
    muscles, n = env.actuation_model, env.n_actuators
    # Half way to the target in 5 ms of 10: 0.25. cost = sum(a^2 F) / (2 n sum F) = 0.25^2 / (2 n).
    np.testing.assert_allclose(muscles.activity, 0.25)
    assert muscles.cost() == pytest.approx(0.25**2 / (2 * n))
    # Lengths go from 0.75 to 1.05 over a joint's range.
    joint = env.model.joint(int(muscles.mimo_actuated_joints[0]))
    low, high = joint.range
    share = (float(env.data.qpos[joint.qposadr[0]]) - low) / (high - low)
    assert muscles.lce_1[0] == pytest.approx(0.75 + 0.3 * share, abs=1e-6)
    assert muscles.lce_2[0] == pytest.approx(1.05 - 0.3 * share, abs=1e-6)
    assert muscles.muscle_lengths.shape == muscles.muscle_forces.shape == muscles.fmax.shape == (2 * n,)
    user = env.model.actuator("act:hip_bend").user
    place = list(env.mimo_actuators).index(env.model.actuator("act:hip_bend").id)
    assert [muscles.vmax[place], muscles.fmax[place], muscles.fmax[place + n]] == user.ravel().tolist()


def test_costs_of_motors():
    env = classic.MIMoDummyEnv(vision_params=None, touch_params=None)
    env.reset(seed=1)
    env.step(np.full(env.action_space.shape, 0.1, np.float32))
    motors = env.actuation_model
    gear = env.model.actuator_gear[:, 0]
    # sum(u^2 T) / (n sum(T)); u is 0.1 for each, which is within all bounds.
    assert motors.cost() == pytest.approx(0.01 / len(gear))
    np.testing.assert_allclose(motors.simulation_torque(), 0.1 * gear)
    np.testing.assert_allclose(motors.observations(), [*[0.1] * 44, *(0.1 * gear)])
    motors.reset()
    assert not env.data.ctrl.any()


# ---- Scenes --------------------------------------------------------------------------------------------------------


def test_postures_beyond_a_limit_and_the_root_beside_a_file(room):
    pose = {"robot:left_elbow": -2.531, "mimo_location": [0.1, 0.2, 0.5, 1, 0, 0, 0]}  # the limit is -2.53073
    env = classic.MIMoEnv(room, initial_qpos=pose, goals_in_observation=False)
    for _ in range(2):
        assert env.data.joint("robot:left_elbow").qpos == -2.531
        np.testing.assert_allclose(env.data.joint("mimo_location").qpos, pose["mimo_location"])
        np.testing.assert_allclose(env.data.joint("mimo_orientation").qpos, pose["mimo_location"])
        np.testing.assert_allclose(env.init_qpos, env.data.qpos)
        env.step(env.action_space.sample())
        env.reset(seed=1)
    utils.set_joint_qpos(env.model, env.data, "mimo_location", [0, 0, 0.3, 1, 0, 0, 0])
    assert env.data.qpos[2] == 0.3
    with pytest.raises(mimo.NotFoundError, match="robot:tail"):
        classic.MIMoEnv(room, initial_qpos={"robot:tail": 0})


def test_includes_with_another_root(tmp_path):
    (tmp_path / "part.xml").write_text('<furniture><worldbody><geom name="desk" size="0.1"/></worldbody></furniture>')
    (tmp_path / "room.xml").write_text(ROOM.replace("<option", '<include file="part.xml"/><option'))
    env = classic.MIMoEnv(str(tmp_path / "room.xml"))
    assert env.model.geom("desk").size[0] == 0.1


def test_names_of_the_original_s_files(tmp_path):
    assert classic.MIMoEnv(str(tmp_path / "standup_scene.xml")).model.nu == 27
    assert classic.MIMoEnv(classic.BENCHMARK_XML_V2).model.nu == 88
    with pytest.raises(FileNotFoundError, match=r"nowhere\.xml', expected an MJCF file or one of benchmark"):
        classic.MIMoEnv(str(tmp_path / "nowhere.xml"))


def test_arguments_of_other_releases(room, capsys):
    with pytest.warns(UserWarning, match=r"mimo\.plot\.touch_map"):
        env = classic.MIMoEnv(
            room, age=None, show_sensors=True, print_space_sizes=True, default_camera_config={"trackbodyid": 1}
        )
    assert "Observation space: Dict(" in capsys.readouterr().out
    assert env.mujoco_renderer.render("rgb_array").shape == (500, 500, 3)
    chest = classic.MIMoEnv(room, touch_params={"scales": {"chest": 0.03, "upper_body": 0.03}})
    assert list(chest.touch.body_names.values()) == ["upper_body"]
    np.testing.assert_array_equal(chest.data.body("chest").xpos, chest.data.body("upper_body").xpos)
    with pytest.raises(NotImplementedError, match="custom_measurements"):
        classic.MIMoEnv(room, custom_measurements={"head": 40})


def test_methods_that_nothing_calls_are_told(room):
    class Unusual(classic.MIMoEnv):
        def _initialize_simulation(self):
            raise AssertionError

    with pytest.warns(UserWarning, match=r"Unusual\._initialize_simulation is never called here"):
        Unusual(room)


def test_set_ups_that_are_not_there():
    with pytest.raises(NotImplementedError, match=r"MIMoComplianceTest-v0, .* are not here: build such a set-up with"):
        gymnasium.make("MIMoComplianceTest-v0")


def test_growth(room):
    path = growth.adjust_mimo_to_age(3, room)
    env = classic.MIMoEnv(path)
    direct = classic.MIMoEnv(room, age=3)
    assert env.model.body_mass.sum() == pytest.approx(direct.model.body_mass.sum(), rel=1e-6)
    assert env.model.body_mass.sum() < classic.MIMoEnv(room).model.body_mass.sum()
    growth.delete_growth_scene(path)
    with pytest.raises(ValueError, match="expected the path that adjust_mimo_to_age returned"):
        growth.delete_growth_scene(room)


# ---- Pictures ------------------------------------------------------------------------------------------------------


def png(path, side):
    """A picture of that many pixels a side, in stripes."""
    row = b"\0" + bytes([200, 30, 30, 30, 30, 200]) * (side // 2)

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    head = struct.pack(">IIBBBBB", side, side, 8, 2, 0, 0, 0)
    path.write_bytes(
        b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(row * side, 1)) + chunk(b"IEND", b"")
    )


@pytest.fixture
def painted(tmp_path):
    png(tmp_path / "stripes.png", 3000)
    assets = '<asset><texture name="s" type="2d" file="stripes.png"/><material name="s" texture="s"/></asset>'
    text = ROOM.replace("<option", assets + "<option").replace('size="0 0 1"', 'size="0 0 1" material="s"')
    (tmp_path / "painted.xml").write_text(text)
    return str(tmp_path / "painted.xml")


def test_large_pictures_are_not_read_before_a_script_draws(painted):
    """A picture that is cut off behind its head harms only an environment that reads it."""
    picture = Path(painted).parent / "stripes.png"
    picture.write_bytes(picture.read_bytes()[:100])
    classic.MIMoEnv(painted).reset(seed=1)
    with pytest.raises(mimo.ModelError, match=r"stripes\.png"):
        classic.MIMoEnv(painted, render_mode="rgb_array")


def test_large_pictures_are_left_out_until_a_script_draws(painted, room):
    env = classic.MIMoEnv(painted)
    assert isinstance(env.world, PlainWorld)
    assert not isinstance(classic.MIMoEnv(room).world, PlainWorld)
    drawn = classic.MIMoEnv(painted, render_mode="rgb_array")
    seen = classic.MIMoEnv(painted, vision_params={"eye_left": {"width": 8, "height": 8}})
    assert not isinstance(seen.world, PlainWorld)
    for one in (env, drawn):
        one.reset(seed=1)
        one.step(np.full(one.action_space.shape, 0.3, np.float32))
        one.model.geom("head").rgba = [0.1, 0.9, 0.1, 1]
    np.testing.assert_array_equal(env.data.qpos, drawn.data.qpos)
    picture = env.mujoco_renderer.render("rgb_array")
    np.testing.assert_array_equal(picture, drawn.mujoco_renderer.render("rgb_array"))
    assert picture.std() > 5
    assert env.world.texture_count == drawn.world.texture_count > 0
    env.step(np.full(env.action_space.shape, 0.3, np.float32))
    for other in (copy.deepcopy(env), pickle.loads(pickle.dumps(env))):
        assert isinstance(other.world, PlainWorld)
        np.testing.assert_array_equal(other.data.qpos, env.data.qpos)
        np.testing.assert_array_equal(other.world.render(width=32, height=32), env.world.render(width=32, height=32))
