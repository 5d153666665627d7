"""mimo.classic: the original's environments under their names.

Sizes, orders and counts are those of the original, release 1.1: of its models and spaces as they were recorded with
tests/golden.
"""

import copy
import csv
import json
import pickle
import warnings

import gymnasium
import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env

import mimo
from mimo import classic
from mimo.classic import utils

SMALL = {"eye_left": {"width": 24, "height": 16}, "eye_right": {"width": 8, "height": 8}}

# Numbers in `observation`, actions, step limit, bodies, positions and velocities of all joints.
RECORDED = {
    "MIMoBench-v0": (292, 44, 6000, 26, 68, 65),
    "MIMoBenchV2-v0": (608, 88, 6000, 58, 112, 109),
    "MIMoShowroom-v0": (608, 88, 500, 71, 196, 181),
    "MIMoReach-v0": (220, 8, 1000, 25, 61, 59),
    "MIMoStandup-v0": (258, 27, 500, 25, 54, 53),
    "MIMoSelfBody-v0": (220, 8, 500, 24, 54, 53),
    "MIMoCatch-v0": (411, 40, 800, 57, 105, 103),
    "MIMoMuscle-v0": (784, 176, 6000, 58, 112, 109),  # 4 x 88 for muscles in place of 2 x 88
}
SEES = {"MIMoBench-v0", "MIMoBenchV2-v0", "MIMoShowroom-v0", "MIMoMuscle-v0"}


ON_ITS_BACK = {"position": [0, 0, 0.1], "orientation": [0.5**0.5, 0, -(0.5**0.5), 0]}


def made(name, **arguments):
    return classic.make(name, **{**({"vision_params": SMALL} if name in SEES else {}), **arguments})


@pytest.mark.parametrize("name", RECORDED)
def test_sizes_are_the_original_s(name):
    env = made(name)
    observation, _ = env.reset(seed=1)
    numbers, actions, steps, bodies, positions, velocities = RECORDED[name]
    assert observation["observation"].shape == (numbers,)
    assert env.action_space.shape == (actions,)
    assert env.spec.max_episode_steps == steps
    inner = env.unwrapped
    assert (inner.model.nbody, inner.model.nq, inner.model.nv) == (bodies, positions, velocities)
    assert observation in env.observation_space
    types = {"observation": np.float64, "touch": np.float32, "vestibular": np.float64, "eye_left": np.uint8}
    assert {key: observation[key].dtype for key in types if key in observation} == {
        key: np.dtype(kind) for key, kind in types.items() if key in observation
    }
    env.close()


@pytest.mark.parametrize(
    ("name", "keys"),
    [
        ("MIMoBench-v0", ["eye_left", "eye_right", "observation", "touch", "vestibular"]),
        ("MIMoReach-v0", ["observation"]),
        ("MIMoStandup-v0", ["observation", "vestibular"]),
        ("MIMoSelfBody-v0", ["achieved_goal", "desired_goal", "observation", "touch"]),
        ("MIMoCatch-v0", ["observation", "touch"]),
    ],
)
def test_keys_of_observations(name, keys):
    env = made(name)
    observation, info = env.reset(seed=1)
    assert sorted(observation) == keys
    assert {"is_success", "is_failure"} <= set(info)
    assert ("desired_goal" in info) == ("desired_goal" not in keys)


def test_order_of_the_observation(root):
    # v1: 88 of actuation (control, torque), 47 limits, 47 qpos, 47 qvel, 63 torques.
    with open(root / "tests/golden/v1_benchmark/actuators.csv") as file:
        gears = {row["name"]: float(row["gear"].split()[0]) for row in csv.DictReader(file)}
    env = made("MIMoBench-v0").unwrapped
    env.reset(seed=1)
    action = np.linspace(-1, 1, 44, dtype=np.float32)
    seen = env.step(action)[0]["observation"]
    control = np.clip(action, env.action_space.low, env.action_space.high)
    np.testing.assert_allclose(seen[:44], control, atol=1e-6)
    motors = [env.model.actuator(number).name for number in env.mimo_actuators]
    np.testing.assert_allclose(seen[44:88], control * [gears[name] for name in motors], rtol=1e-5)
    joints = [env.model.joint(int(number)) for number in env.mimo_joints]
    addresses = [joint.qposadr[0] for joint in joints]
    np.testing.assert_allclose(seen[135:182], env.data.qpos[addresses], rtol=1e-6, atol=1e-9)
    speeds = [env.model.jnt_dofadr[joint.id] for joint in joints]
    np.testing.assert_allclose(seen[182:229], env.data.qvel[speeds], rtol=1e-5, atol=1e-7)
    torque = env.world.observation["proprioception/torque"]
    np.testing.assert_array_equal(seen[229:292], torque.ravel())


def test_limits_by_the_original_s_formula():
    # u = min(q - (lo + th), (hi - th) - q) / th, and what is felt is max(0, -u); th = 0.035 rad.
    env = made("MIMoReach-v0").unwrapped
    env.reset(seed=1)
    env.step(np.full(8, 0.3, np.float32))
    low = [env.model.joint(int(joint)).range[0] for joint in env.mimo_joints]
    joint = next(int(number) for number in env.mimo_joints if env.model.joint(int(number)).name == "robot:left_elbow")
    qpos = env.data.qpos.copy()
    place = env.model.joint(joint).qposadr[0]
    qpos[place] = env.model.joint(joint).range[0] + 0.01
    env.set_state(qpos, np.zeros(env.model.nv))
    index = list(env.mimo_joints).index(joint)
    assert len(low) == 47
    assert env._get_obs()["observation"][16 + index] == pytest.approx((0.035 - 0.01) / 0.035, rel=1e-5)


def test_reach_rewards_as_recorded(root):
    recorded = json.loads((root / "tests/golden/rewards_reach.json").read_text())
    env = made("MIMoReach-v0", parameters={"reach/original_rules": 1}).unwrapped
    places = [(it["xpos_used"]["right_fingers"], it["xpos_used"]["target"]) for it in recorded]
    achieved, desired = (np.array(column) for column in zip(*places))
    infos = [{"is_success": it["is_success"]} for it in recorded]
    expected = [it["reward"] for it in recorded]
    assert {it["is_success"] for it in recorded} == {True, False}
    np.testing.assert_allclose(env.compute_reward(achieved, desired, infos), expected, atol=1e-12)
    one = env.compute_reward(achieved[0], desired[0], infos[0])
    assert one == pytest.approx(expected[0], abs=1e-12)


def test_reach_rewards_follow_from_its_goals():
    env = made("MIMoReach-v0", goals_in_observation=True)
    env.reset(seed=3)
    for _ in range(5):
        seen, reward, *_ = env.step(env.action_space.sample())
        assert reward == pytest.approx(env.unwrapped.world.reward[0], abs=1e-12)
        assert reward == pytest.approx(-np.linalg.norm(seen["achieved_goal"] - seen["desired_goal"]))
    world = env.unwrapped.world
    world.bodies("target").position = world.bodies("right_fingers").position  # the ball is in the hand
    _, reward, terminated, _, info = env.step(np.zeros(8, np.float32))
    assert (reward, terminated, info["is_success"]) == (100, True, True)
    assert reward == world.reward[0]


def test_done_active():
    env = made("MIMoReach-v0", done_active=False)
    env.reset(seed=3)
    world = env.unwrapped.world
    world.bodies("target").position = world.bodies("right_fingers").position
    _, _, terminated, _, info = env.step(np.zeros(8, np.float32))
    assert (terminated, info["is_success"]) == (False, True)


def test_episodes_are_cut_off_at_the_original_s_limit():
    env = made("MIMoSelfBody-v0", touch_params={"scales": {"left_lower_arm": 0.1}})
    env.reset(seed=1)
    ends = [env.step(np.zeros(8, np.float32))[3] for _ in range(500)]
    assert (any(ends[:-1]), ends[-1]) == (False, True)


def test_standup_reward():
    # z(head) - 0.2 - 0.01 sum(ctrl^2), of the original.
    env = made("MIMoStandup-v0").unwrapped
    env.reset(seed=1)
    action = np.full(27, 0.2, np.float32)
    _, reward, terminated, _, info = env.step(action)
    control = np.clip(action, env.action_space.low, env.action_space.high).astype(float)
    assert reward == pytest.approx(env.data.body("head").xpos[2] - 0.2 - 0.01 * np.sum(control**2), abs=1e-9)
    assert (terminated, info["is_success"]) == (False, False)
    assert info["desired_goal"] == [0.5]


def test_goals_of_self_body(root):
    with open(root / "tests/golden/selfbody/bodies.csv") as file:
        bodies = {row["name"]: int(row["id"]) for row in csv.DictReader(file)}
    env = made("MIMoSelfBody-v0").unwrapped
    targets = set()
    for seed in range(12):
        seen, _ = env.reset(seed=seed)
        assert seen["desired_goal"].shape == seen["achieved_goal"].shape == (37,)
        assert np.flatnonzero(seen["desired_goal"]).tolist() == [bodies[env.target_body]]
        assert not seen["achieved_goal"].any()
        targets.add(env.target_body)
    assert len(targets) > 3
    assert not targets & {"right_fingers", "right_hand", "right_lower_arm", "right_upper_arm"}


def test_the_ball_s_radius_ends_the_observation_of_catch():
    env = made("MIMoCatch-v0").unwrapped
    radii = [env.reset(seed=seed)[0]["observation"][-1] for seed in range(5)]
    assert len(set(radii)) == 5
    assert all(0.005 <= radius <= 0.025 for radius in radii)


def test_catch_s_options():
    env = made("MIMoCatch-v0", jitter=True, position_inaccurate=True, action_penalty=False).unwrapped
    chosen = env.scene.parameters
    assert (chosen["catch/jitter"], chosen["catch/gaze_error"], chosen["catch/effort_weight"]) == (0.2, 0.005, 0)
    assert made("MIMoCatch-v0").unwrapped.scene.parameters["catch/jitter"] == 0


# Sensors of parts that are the same after any pruning: those of the original (tests/golden/touch_counts.json).
def test_touch_by_body(root):
    env = made("MIMoBench-v0").unwrapped
    observation, _ = env.reset(seed=1)
    counts = {env.touch.body_names[body]: len(it) for body, it in env.touch.sensor_positions.items()}
    recorded = {"hip": 119, "lower_body": 116, "head": 404, "left_eye": 1, "left_fingers": 1944, "right_upper_leg": 82}
    assert {name: counts[name] for name in recorded} == recorded
    assert list(env.touch.sensor_positions) == sorted(env.touch.sensor_positions)
    assert observation["touch"].shape == (3 * sum(counts.values()),)


def test_touch_of_a_body_that_lies():
    env = made("MIMoBench-v0").unwrapped
    env.reset(seed=1)
    for _ in range(120):
        seen = env.step(np.zeros(44, np.float32))[0]["touch"]
    outputs = env.touch.sensor_outputs
    np.testing.assert_array_equal(np.concatenate([outputs[body].ravel() for body in sorted(outputs)]), seen)
    total = sum(utils.matrix(env.data.body(body).xquat) @ forces.sum(axis=0) for body, forces in outputs.items())
    floor, mimo_s = 0, set(utils.get_child_bodies(env.model, env.model.body("hip").id))
    contacts, pushed = env.world.contacts(), np.zeros(3)
    for (first, second), frame, force in zip(contacts.bodies, contacts.frame, contacts.force):
        if first == floor and second in mimo_s:  # the force acts on the second body, in the contact's frame
            pushed += frame.T @ force
    assert pushed[2] > 50  # half of its weight of 107 N
    np.testing.assert_allclose(total, pushed, rtol=1e-4, atol=1e-3)


def test_touch_functions():
    scales = {"scales": {"left_foot": 0.015, "right_foot": 0.015, "hip": 0.025}}
    envs = {
        function: made("MIMoBench-v0", touch_params={**scales, "touch_function": function}, **ON_ITS_BACK).unwrapped
        for function in ("force_vector", "force_vector_global", "normal_force")
    }
    felt = {}
    for function, env in envs.items():
        env.reset(seed=1)
        for _ in range(40):
            env.step(np.zeros(44, np.float32))
        felt[function] = env.touch.sensor_outputs
    env = envs["force_vector"]
    body = max(felt["force_vector"], key=lambda it: np.abs(felt["force_vector"][it]).sum())
    turned = felt["force_vector"][body] @ utils.matrix(env.data.body(body).xquat).T
    np.testing.assert_allclose(felt["force_vector_global"][body], turned, atol=1e-3)
    contacts = envs["normal_force"].world.contacts()
    normal = contacts.force[(contacts.bodies == body).any(axis=1), 0].sum()  # along the contacts' normals
    assert normal > 1
    assert np.linalg.norm(felt["normal_force"][body], axis=1).sum() == pytest.approx(normal, rel=1e-5)
    upwards = felt["normal_force"][body] @ utils.matrix(env.data.body(body).xquat).T
    assert upwards[:, 2].sum() > 0  # the floor presses upwards


def test_senses_are_chosen():
    env = made(
        "MIMoReach-v0",
        proprio_params={"components": ["velocity"], "threshold": 0.1},
        touch_params={"scales": {"right_hand": 0.01}, "response_function": "nearest"},
        vision_params={"eye_left": {"width": 12, "height": 10}},
        vestibular_params={"sensors": ["vestibular_gyro"]},
    )
    observation, _ = env.reset(seed=1)
    assert observation["observation"].shape == (94,)
    assert observation["eye_left"].shape == (10, 12, 3)
    assert "eye_right" not in observation
    assert observation["vestibular"].shape == (3,)
    assert list(env.unwrapped.touch.body_names.values()) == ["right_hand"]


def test_vestibular_is_acceleration_then_rotation():
    env = made("MIMoBench-v0", touch_params=None, vision_params=None).unwrapped
    env.model.opt.gravity = [0, 0, 0]
    env.reset(seed=1)
    qvel = np.zeros(env.model.nv)
    qvel[15:18] = (
        0,
        0,
        2.0,
    )  # behind two objects of six velocities each: the whole infant turns about its own axis, rad/s
    env.set_state(env.init_qpos, qvel)
    seen = env._get_obs()["vestibular"]
    assert seen[5] == pytest.approx(2.0, abs=1e-3)


def test_actuation_models():
    for model, actions, numbers in (
        (classic.MuscleModel, 16, 4 * 8 + 204),
        (classic.PositionalModel, 8, 8 + 204),
        (classic.SpringDamperModel(), 8, 2 * 8 + 204),
        ("torque", 8, 220),
    ):
        env = made("MIMoReach-v0", actuation_model=model)
        assert env.action_space.shape == (actions,)
        assert env.reset(seed=1)[0]["observation"].shape == (numbers,)
    muscles = made("MIMoReach-v0", actuation_model=classic.MuscleModel).action_space
    assert (muscles.low.min(), muscles.high.max()) == (0, 1)


class Wave(classic.MIMoEnv):
    """An environment as people write them for the original."""

    def __init__(self, model_path, **arguments):
        super().__init__(model_path, goals_in_observation=True, done_active=True, **arguments)

    def sample_goal(self):
        return np.array([0.5])

    def get_achieved_goal(self):
        return self.data.body("left_hand").xpos[2:].copy()

    def compute_reward(self, achieved_goal, desired_goal, info):
        return float(achieved_goal[0] - desired_goal[0])

    def is_success(self, achieved_goal, desired_goal):
        return achieved_goal[0] > desired_goal[0]

    def is_failure(self, achieved_goal, desired_goal):
        return False

    def reset_model(self):
        qpos = self.init_qpos.copy()
        qpos[:2] = 0.1, 0.2
        self.set_state(qpos, self.init_qvel)
        return self._get_obs()


ROOM = """<mujoco>
  <include file="mimo/mitten.xml"/>
  <option timestep="0.005"/>
  <worldbody><geom name="ground" type="plane" size="0 0 1"/></worldbody>
</mujoco>"""


def test_a_custom_environment(tmp_path):
    (tmp_path / "room.xml").write_text(ROOM)
    env = Wave(str(tmp_path / "room.xml"), initial_qpos={"robot:left_elbow": -0.5}, frame_skip=4)
    seen, _ = env.reset(seed=1)
    assert env.dt == 0.02
    assert env.data.joint("robot:left_elbow").qpos == -0.5
    np.testing.assert_allclose(env.data.qpos[:2], [0.1, 0.2])
    assert set(seen) == {"observation", "achieved_goal", "desired_goal"}
    seen, reward, terminated, _, info = env.step(env.action_space.sample())
    assert reward == pytest.approx(seen["achieved_goal"][0] - 0.5)
    assert terminated == info["is_success"] == (reward > 0)


def test_a_place_of_the_root():
    env = classic.MIMoEnv("free", initial_qpos={"mimo_location": [0.1, 0.2, 0.5, 0.7071068, 0, 0, 0.7071068]})
    np.testing.assert_allclose(env.init_qpos[:3], [0.1, 0.2, 0.5])
    with pytest.raises(ValueError, match=r"initial_qpos\['mimo_location'\] is \[1\.0\], expected 7 numbers"):
        classic.MIMoEnv("benchmark", initial_qpos={"mimo_location": [1]})


def test_functions_of_utils():
    env = made("MIMoBench-v0", touch_params=None, vision_params=None, **ON_ITS_BACK).unwrapped
    env.reset(seed=1)
    model, data = env.model, env.data
    hip = utils.get_body_id(model, body_name="hip")
    # Of the original's model: hip is body 4, behind two objects; 22 bodies hang together there, with 36 geoms.
    assert hip == 4
    below = utils.get_child_bodies(model, hip)
    assert below == list(range(4, 26))
    assert sum(len(utils.get_geoms_for_body(model, body)) for body in below) == 36
    utils.set_joint_qpos(model, data, "robot:left_elbow", -0.7)
    joint = model.joint("robot:left_elbow").id
    assert data.qpos[utils.get_joint_qpos_addr(model, joint)] == -0.7
    # Three free joints, of two objects and the root, have seven positions and six velocities each.
    assert utils.get_joint_qvel_addr(model, joint)[0] == utils.get_joint_qpos_addr(model, joint)[0] - 3
    assert len(utils.get_joint_qpos_addr(model, 0)) == 7
    utils.lock_joint(model, "robot:left_elbow", -0.7)
    assert env.world.locked("robot:left_elbow") == -0.7
    utils.unlock_joint(model, "robot:left_elbow")
    assert env.world.locked("robot:left_elbow") is None
    np.testing.assert_allclose(utils.body_pos_to_world(data, [0, 0, 0], hip), utils.get_body_position(data, "hip"))
    there = utils.body_pos_to_world(data, [0.1, 0.2, 0.3], hip)
    np.testing.assert_allclose(there, np.add(data.body("hip").xpos, [-0.3, 0.2, 0.1]), atol=1e-9)  # -90 degrees about y
    np.testing.assert_allclose(utils.world_pos_to_body(data, there, hip), [0.1, 0.2, 0.3], atol=1e-12)
    with pytest.raises(ValueError, match="expected one of them"):
        utils.get_body_id(model)
    with pytest.raises(TypeError, match=r"expected env\.model or env\.data"):
        utils.lock_joint(env, "robot:left_elbow", 0)


def test_assignments_without_effect_are_refused():
    env = made("MIMoReach-v0").unwrapped
    env.reset(seed=1)
    with pytest.raises(ValueError, match=r"data\.xpos cannot be written: the physics computes it: move bodies with"):
        env.data.xpos[0] = 1
    with pytest.raises(AttributeError, match=r"model has no 'tex_rgb' here; docs/guide/classic\.md says"):
        env.model.tex_rgb  # noqa: B018
    with pytest.raises(AttributeError, match="data has no 'qfrc_bias' here"):
        env.data.qfrc_bias  # noqa: B018
    with pytest.raises(AttributeError, match="body 'head' of data has no 'cinert' here"):
        env.data.body("head").cinert  # noqa: B018


def test_pictures():
    env = made("MIMoReach-v0", render_mode="rgb_array", default_camera_config={"distance": 2, "lookat": [0, 0, 0.4]})
    env.reset(seed=1)
    assert env.render().shape == (500, 500, 3)
    renderer = env.unwrapped.mujoco_renderer
    assert renderer.render("rgb_array", camera_name="eye_left").shape == (500, 500, 3)
    assert renderer.render(render_mode="depth_array", camera_id=0).shape == (500, 500)
    with pytest.raises(ValueError, match="default_camera_config has 'zoom', expected lookat, distance"):
        made("MIMoReach-v0", default_camera_config={"zoom": 1})


def test_seeds_repeat():
    runs = []
    for _ in range(2):
        env = made("MIMoCatch-v0")
        env.reset(seed=5)
        env.action_space.seed(5)
        runs.append([env.step(env.action_space.sample())[1] for _ in range(3)])
    assert runs[0] == runs[1]
    with pytest.raises(AssertionError):
        np.testing.assert_array_equal(*(made("MIMoReach-v0").reset()[0]["observation"] for _ in range(2)))


def test_gymnasium_registers_them():
    env = gymnasium.make("MIMoReach-v0")
    assert isinstance(env.unwrapped, classic.MIMoReachEnv)
    many = gymnasium.make_vec("MIMoReach-v0", num_envs=2, vectorization_mode="sync")
    assert many.reset(seed=1)[0]["observation"].shape == (2, 220)
    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always")
        check_env(made("MIMoSelfBody-v0").unwrapped, skip_render_check=True)
    known = ("symmetric and normalized", "infinity", "is -inf", "is inf", "render")
    assert [str(it.message) for it in said if not any(text in str(it.message) for text in known)] == []


def test_differences_are_listed():
    lines = classic.differences("MIMoReach-v0")
    assert any("reach/original_rules" in line for line in lines)
    with pytest.warns(classic.DifferenceWarning) as told:
        made("MIMoReach-v0", tell_differences=True)
    assert [str(it.message) for it in told] == lines


@pytest.mark.parametrize(
    ("call", "error", "line"),
    [
        (
            lambda: classic.make("MIMoReech-v0"),
            ValueError,
            "name is 'MIMoReech-v0', expected one of .*did you mean 'MIMoR",
        ),
        (lambda: classic.make("CartPole-v1"), ValueError, "name is 'CartPole-v1', expected one of MIMoBench-v0"),
        (lambda: classic.differences("reach"), ValueError, "name is 'reach', expected one of"),
        (lambda: classic.MIMoEnv("nowhere.xml"), FileNotFoundError, r"model_path is 'nowhere\.xml', expected an MJCF"),
        (lambda: made("MIMoReach-v0", touch_params={"scale": 1}), ValueError, "touch_params has 'scale', expected 'sc"),
        (lambda: made("MIMoReach-v0", touch_params={"scales": {"tail": 1}}), mimo.NotFoundError, "tail"),
        (
            lambda: made("MIMoReach-v0", touch_params={"touch_function": "heat"}),
            ValueError,
            r"touch_params\['touch_function'\] has 'heat', expected 'force_vector', 'force_vector_global', 'normal_f",
        ),
        (
            lambda: made("MIMoReach-v0", proprio_params={"components": ["speed"]}),
            ValueError,
            "'speed', expected 'veloc",
        ),
        (lambda: made("MIMoReach-v0", vision_params={"eye_left": 64}), TypeError, r"vision_params\['eye_left'\] is 64"),
        (lambda: made("MIMoReach-v0", vestibular_params=True), TypeError, "vestibular_params is True, expected a dict"),
        (
            lambda: made("MIMoReach-v0", actuation_model=int),
            TypeError,
            "actuation_model is .*expected SpringDamperModel",
        ),
        (lambda: made("MIMoReach-v0", touch=True), TypeError, "MIMoReachEnv does not take 'touch'"),
        (lambda: made("MIMoReach-v0", widht=3), TypeError, "unexpected keyword argument 'widht'"),
        (lambda: classic.MIMoReachEnv(render_mode="ascii"), ValueError, "render_mode is 'ascii', expected"),
        (
            lambda: made("MIMoStandup-v0").unwrapped.compute_reward(np.zeros((2, 1)), np.zeros((2, 1)), {}),
            TypeError,
            "one at",
        ),
    ],
)
def test_contradictory_arguments(call, error, line):
    with pytest.raises(error, match=line):
        call()


def test_copies_continue_alike():
    env = classic.MIMoSelfBodyEnv()
    env.reset(seed=2)
    env.step(np.zeros(8, np.float32))
    copies = [env, pickle.loads(pickle.dumps(env)), copy.deepcopy(env)]
    rows = [one.step(np.full(8, 0.4, np.float32))[0] for one in copies]
    for row in rows[1:]:
        for name, values in rows[0].items():
            np.testing.assert_array_equal(row[name], values)
    assert len({id(one.world) for one in copies}) == 3
    np.testing.assert_array_equal(copies[1].data.qpos, env.data.qpos)
