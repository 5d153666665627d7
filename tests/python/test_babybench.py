"""mimo.babybench: scenes, switches, episodes and counts of the competition, in one world and in many.

Numbers are those of its own platform, measured there with MuJoCo 3.3.0 (tests/golden/babybench).
"""

import warnings

import numpy as np
import pytest
from competition import BLIND, logged, made, table
from gymnasium.utils.env_checker import check_env

from mimo import Kind, Quantity, babybench
from mimo.babybench import counts, groups, scores
from mimo.classic.utils import matrix

OFF = {f"{kind}_{group}": False for kind in ("act", "lock", "touch") for group in groups.GROUPS}


# ---- Scenes and spaces ---------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "numbers", "actions", "keys"),
    [
        ("test_installation", 292, 44, ["eye_left", "eye_right", "observation", "touch", "vestibular"]),
        ("selftouch", 264, 30, ["observation", "touch", "vestibular"]),
        ("handregard", 466, 17, ["eye_left", "eye_right", "observation"]),
    ],
)
def test_spaces_of_the_shipped_configurations(name, numbers, actions, keys):
    env = made(name)
    seen, info = env.reset(seed=1)
    assert sorted(seen) == keys
    assert info == {}
    assert seen["observation"].shape == (numbers,)
    assert env.action_space.shape == (actions,)
    assert all(seen[key].shape == (64, 64, 3) for key in keys if key.startswith("eye"))
    assert seen in env.observation_space
    assert env.spec.max_episode_steps == 1000
    assert env.dt == 0.005


@pytest.mark.parametrize(
    ("scene", "behavior", "geoms", "positions", "velocities"),
    [
        ("base", "self_touch", 39, 54, 53),
        ("crib", "self_touch", 73, 54, 53),
        ("cubes", "self_touch", 55, 166, 149),
        ("base", "hand_regard", 77, 98, 97),
        ("crib", "hand_regard", 111, 98, 97),
        ("cubes", "hand_regard", 93, 210, 193),
    ],
)
def test_sizes_of_the_scenes(scene, behavior, geoms, positions, velocities):
    env = made(scene=scene, behavior=behavior, **BLIND)
    assert (env.model.ngeom, env.model.nq, env.model.nv) == (geoms, positions, velocities)
    assert env.model.nu == (88 if behavior == "hand_regard" else 44)


def test_motors_come_by_groups(root):
    rows = [row for row in table(root, "groups.csv") if row["kind"] == "actuator"]
    for version, behavior in (("v1", "self_touch"), ("v2", "hand_regard")):
        env = made(behavior=behavior, **BLIND)
        names = [env.model.actuator(number).name for number in range(env.model.nu)]
        assert names == [row["name"] for row in rows if row["body_version"] == version]


def test_groups_of_joints_motors_and_skin(root):
    rows = table(root, "groups.csv")
    assert {row["group"] for row in rows} == set(groups.GROUPS)
    assert [row["name"] for row in rows if groups.group_of(row["name"]) != row["group"]] == []


def test_numbers_of_geoms_are_the_competition_s(root):
    rows = table(root, "self_touch_geoms.csv")
    for scene in ("base", "crib", "cubes"):
        env = made(scene=scene, behavior="self_touch", **BLIND)
        assert env.mimo_geoms == [int(row["geom_id"]) for row in rows] == list(range(3, 39))
        bodies = [env.model.body(int(env.model.geom_bodyid[number])).name for number in env.mimo_geoms]
        assert bodies == [row["body"] for row in rows]
        assert (env.right_hand_geoms, env.left_hand_geoms) == ([13, 14], [19, 20])


def test_objects_of_cubes():
    world = made(scene="cubes", behavior="hand_regard", **BLIND).unwrapped.world
    masses = {
        "red_cube": 0.0432,
        "blue_cube": 0.0128,
        "red_sphere": 0.838,
        "castle_bridge": 0.225,
        "castle_tower1": 0.072,
    }
    for name, mass in masses.items():
        assert world.bodies(name).mass[0] == pytest.approx(mass, rel=1e-3)
    # Not kicked by legs that start in the floor, as it is in the competition's scene.
    np.testing.assert_allclose(world.bodies("castle_top2").position[0], [0.35, -0.03, 0.03], atol=2e-3)


@pytest.mark.parametrize(
    ("scene", "column", "tolerance"),
    [
        # Lying on the floor is chaotic to some mrad; the two versions of MuJoCo differ by up to 0.16 here ...
        ("base", "after_settling_3.3.0", 0.01),
        # ... and in the crib by 0.05. Ours is nearer in age to 2.3.7.
        ("crib", "after_settling_2.3.7", 0.01),
    ],
)
def test_poses_after_settling(scene, column, tolerance, root):
    for version, behavior in (("v1", "self_touch"), ("v2", "hand_regard")):
        env = made(**{**OFF, "scene": scene, "behavior": behavior, **BLIND})
        rows = [row for row in table(root, "start_poses.csv") if (row["scene"], row["body"]) == (scene, version)]
        assert len(rows) == env.model.njnt
        for row in rows:
            expected = [float(number) for number in row[column].split()]
            start = env.model.joint(row["joint"]).qposadr[0]
            np.testing.assert_allclose(
                env.init_qpos[start : start + len(expected)], expected, atol=tolerance, err_msg=row["joint"]
            )


def test_locked_joints_start_and_stay_at_zero():
    env = made(
        scene="crib", behavior="self_touch", **{**OFF, "lock_feet": True, "lock_arms": True, "act_legs": True}, **BLIND
    )
    env.reset(seed=1)
    names = [env.model.joint(int(joint)).name for joint in env.mimo_joints]
    locked = groups.of_groups(names, ["feet", "arms"])
    assert len(locked) == 16
    for _ in range(20):
        env.step(env.action_space.high)
        angles = [env.data.joint(name).qpos[0] for name in locked]
        assert np.abs(angles).max() < 0.03
    assert np.abs(env.data.joint("robot:right_knee").qpos) > 0.05


def test_the_posture_of_cubes():
    # The scene's locks have the last word over those of the configuration.
    env = made(scene="cubes", behavior="hand_regard", **{**OFF, "lock_legs": True, "lock_head": True}, **BLIND)
    angles = {"robot:left_knee": -2.14, "robot:right_hip1": -1.22, "robot:hip_bend1": 0.532, "robot:head_tilt": 0.4}
    for name, angle in angles.items():
        assert env.data.joint(name).qpos[0] == pytest.approx(angle, abs=0.02)
    assert env.data.joint("robot:head_swivel").qpos[0] == pytest.approx(0, abs=0.02)


# ---- Switches ------------------------------------------------------------------------------------------------------


def test_touch_by_groups_and_scale(root):
    spacings = {row["name"]: row for row in table(root, "groups.csv") if row["kind"] == "touch_body"}
    env = made("selftouch", touch_scale=5, touch_hands=False)
    names = env.touch.body_names.values()
    assert sorted(names) == sorted(it for it in spacings if groups.group_of(it) not in ("eyes", "hands"))
    counts = {env.touch.body_names[body]: len(places) for body, places in env.touch.sensor_positions.items()}
    for name in ("head", "hip", "lower_body"):  # which any pruning leaves the same
        assert counts[name] == int(spacings[name]["sensors_at_touch_scale_1_2_5_10"].split()[2])
    again = made("selftouch", touch_scale=5, touch_hands=False)
    assert again.observation_space["touch"].shape == env.observation_space["touch"].shape
    assert made("selftouch", touch_scale=0).touch is None
    assert made("handregard", touch_active=True, vision_active=False).touch is not None  # skin of five fingers


def test_switches_of_proprioception():
    env = made("selftouch", proprio_torque=False, proprio_limits=False, **BLIND)
    assert env.observation_space["observation"].shape == (264 - 63 - 47,)


def test_no_group_acts():
    env = made(scene="base", **{**OFF, **BLIND})
    env.reset(seed=1)
    assert env.action_space.shape == (0,)
    env.step(np.zeros(0, np.float32))


@pytest.mark.parametrize(("skip", "active"), [(1, 0.5), (2, 0.75), (4, 0.9375)])
def test_muscles(skip, active):
    env = made("selftouch", actuation_model="muscle", frame_skip=skip, behavior="none", **BLIND)
    env.reset(seed=1)
    assert env.observation_space["observation"].shape == (324,)
    assert (env.action_space.low.min(), env.action_space.high.max()) == (0, 1)
    seen = env.step(np.ones(60, np.float32))[0]["observation"]
    np.testing.assert_allclose(seen[:60], active, atol=1e-6)
    assert env.dt == 0.005 * skip


def test_positions():
    env = made("selftouch", actuation_model="positional", frame_skip=2, **BLIND)
    env.reset(seed=1)
    target = np.clip(np.full(30, 0.3, np.float32), env.action_space.low, env.action_space.high)
    seen = env.step(target)[0]["observation"]
    np.testing.assert_allclose(seen[:30], target, atol=1e-6)  # and not 0 from the second physics step on
    assert seen.shape == (30 + 204,)


# ---- Episodes ------------------------------------------------------------------------------------------------------


def test_a_seed_repeats_a_reset():
    env = made("selftouch", **BLIND)
    first, second, other = (env.reset(seed=seed)[0]["observation"] for seed in (4, 4, 5))
    np.testing.assert_array_equal(first, second)
    assert not np.array_equal(first, other)
    assert not np.array_equal(env.data.qpos, env.init_qpos)  # ten random physics steps
    still = made(**BLIND)
    still.reset(seed=1)
    np.testing.assert_allclose(still.data.qpos, still.init_qpos, atol=1e-12)


def test_info_and_ends():
    env = made("selftouch", max_episode_steps=3, **BLIND)
    env.reset(seed=1)
    steps = [env.step(env.action_space.sample()) for _ in range(3)]
    assert [(reward, terminated, truncated) for _, reward, terminated, truncated, _ in steps] == [
        (0, False, False),
        (0, False, False),
        (0, False, True),
    ]
    assert [info["steps"] for *_, info in steps] == [0, 1, 2]
    assert set(steps[0][4]) == {
        "steps",
        "right_hand_touches",
        "left_hand_touches",
        "right_hand_or_finger_touches",
        "left_hand_or_finger_touches",
    }


def test_infos_of_earlier_steps_do_not_change():
    env = made("selftouch", **BLIND)
    env.reset(seed=2)
    infos = [env.step(env.action_space.sample())[4] for _ in range(250)]
    told = [len(info["right_hand_or_finger_touches"]) for info in infos]
    assert told == sorted(told)
    assert told[0] < told[-1]
    env.reset(seed=2)
    assert env.step(env.action_space.sample())[4]["steps"] == 0


def test_random_actions_touch_what_they_touch_there():
    # There in all of 20 episodes both hands reach the head (geom 8) from beside the hips.
    env = made("selftouch", **BLIND)
    env.reset(seed=0)
    env.action_space.seed(0)
    for _ in range(1000):
        info = env.step(env.action_space.sample())[4]
    assert 8 in info["right_hand_touches"]
    assert 8 in info["left_hand_touches"]
    assert set(info["right_hand_touches"]) <= set(info["right_hand_or_finger_touches"])


def test_gymnasium_s_checker():
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # what it warns of is explained in test_env.py
        check_env(made("selftouch", touch_scale=5).unwrapped, skip_render_check=True)


def test_pictures():
    env = made("handregard", vision_active=False, render_size=64)
    env.reset(seed=1)
    for camera in ("corner", "top", "side1", "side2", "closeup"):
        assert babybench.utils.render(env, camera).shape == (64, 64, 3)
    both = babybench.utils.view_binocular(env)
    np.testing.assert_array_equal(both[..., 1], both[..., 2])
    assert env.unwrapped.world.count(Kind.CAMERA) == 7


# ---- Counts: the rules themselves are tested where they are, in tests/unit/babybench_test.cpp ------------------------


def credited(env, pairs):
    """Touches by the rules that the page gives, written down a second time: keys of `info` and geoms."""
    model = env.model
    palms = {hand: set(getattr(env, f"{hand}_geoms")) for hand in counts.HANDS}
    hands = {hand: set(counts.geoms_below(model, hand)) for hand in counts.HANDS}
    body = set(env.mimo_geoms)
    for pair in pairs:
        ways = [(hand, one, other) for hand in counts.HANDS for one, other in (pair, pair[::-1])]
        first = next(((hand, other) for hand, one, other in ways if one in palms[hand]), None)
        if first and first[1] in body:
            yield f"{first[0]}_touches", first[1]
        for hand, one, other in ways:
            if one in hands[hand] and other in body - hands[hand]:
                yield f"{hand}_or_finger_touches", other


def test_touches_are_those_of_the_contacts():
    env = made("selftouch", **BLIND).unwrapped
    env.reset(seed=0)
    env.action_space.seed(0)  # both palms reach the head
    found = {key: [] for key in counts.TOUCH_KEYS}
    for _ in range(600):
        info = env.step(env.action_space.sample())[4]
        for key, geom in credited(env, env.world.contacts().geoms.tolist()):
            if geom not in found[key]:
                found[key].append(geom)
        assert {key: sorted(info[key]) for key in found} == {key: sorted(geoms) for key, geoms in found.items()}
    assert all(found.values())


def test_geoms_that_each_hand_can_touch(root):
    rows = table(root, "self_touch_geoms.csv")
    reachable = {hand: sum(row[f"{hand}_hand_can_count"] == "1" for row in rows) for hand in ("right", "left")}
    assert reachable == {"right": 31, "left": 29}  # of 34 each by which the competition divides
    wanted = made(behavior="self_touch", scene="base", **BLIND).unwrapped.world.get(Quantity.AGENT_GOAL)
    assert wanted.reshape(4, -1).sum(axis=1).tolist() == [34, 34, scores.OUTSIDE, scores.OUTSIDE]


def test_counters_are_those_of_the_poses():
    """Within a wide cone, so that there is something to count."""
    wide = 1.1
    config = {**babybench.load("handregard"), "vision_active": False, "save_dir": None}
    env = babybench.make(config, parameters={"handregard/angle": wide}).unwrapped
    env.reset(seed=1)
    env.action_space.seed(1)
    found = dict.fromkeys(counts.REGARD_KEYS, 0)
    for _ in range(200):
        info = env.step(env.action_space.sample())[4]
        for eye in counts.EYES:
            axes = matrix(env.world.bodies(eye).orientation[0])
            for hand in counts.HANDS:
                offset = env.world.bodies(hand).position[0] - env.world.bodies(eye).position[0]
                for axis, in_view in ((-axes[:, 2], False), (axes[:, 0], True)):
                    cosine = offset @ axis / np.linalg.norm(offset)
                    found[counts.regard_key(eye, hand, in_view)] += bool(np.arccos(cosine) < wide)
        assert {key: info[key] for key in found} == found
    assert any(found.values())
    env.close()


def test_parameters_are_added_to_those_of_the_behaviour():
    """Without a behaviour nothing moves at random, whatever else is given: seeds make no difference."""
    config = {"behavior": "none", "save_dir": None, **BLIND}
    given = {"parameters": {"selftouch/settle_steps": 7}}
    usual, single, many = made(**config), babybench.make(config, **given), babybench.make_vec(config, 2, **given)
    starts = [single.reset(seed=seed)[0]["observation"] for seed in (1, 2)]
    np.testing.assert_array_equal(starts[0], starts[1])
    np.testing.assert_array_equal(many.reset(seed=1)[0]["observation"], starts)
    assert np.abs(usual.reset(seed=1)[0]["observation"] - starts[0]).max() > 1e-3  # 100 steps
    for env in (usual, single, many):
        env.close()


# ---- Many worlds -----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("mode", ["NextStep", "SameStep", "Disabled"])
@pytest.mark.parametrize("name", ["selftouch", "handregard"])
def test_a_batch_does_what_single_worlds_do(name, mode):
    small = {"vision_resolution": 16, "touch_scale": 5, "max_episode_steps": 20, "save_dir": None}
    config = {**babybench.load(name), **small}
    envs = babybench.make_vec(config, 3, autoreset_mode=mode)
    seen, infos = envs.reset(seed=5)
    singles = [babybench.make(config) for _ in range(3)]
    firsts = [env.reset(seed=5 + number)[0] for number, env in enumerate(singles)]
    assert envs.single_observation_space == singles[0].observation_space
    assert envs.single_action_space == singles[0].action_space
    assert seen in envs.observation_space
    assert infos == {}
    for number, first in enumerate(firsts):
        for key, array in first.items():
            np.testing.assert_array_equal(seen[key][number], array, err_msg=key)
    envs.action_space.seed(1)
    for step in range(20):
        actions = envs.action_space.sample()
        seen, rewards, terminated, truncated, infos = envs.step(actions)
        for number, env in enumerate(singles):
            alone, _, _, cut, info = env.step(actions[number])
            last = infos["final_obs"][number] if cut and mode == "SameStep" else None
            assert (rewards[number], terminated[number], truncated[number]) == (0, False, cut)
            assert infos["steps"][number] == info["steps"] == step
            for key, array in alone.items():
                of_batch = seen[key][number] if last is None else last[key]
                np.testing.assert_array_equal(of_batch, array, err_msg=key)
            for key in set(info) - {"steps"}:
                told = infos[key][number]
                if name == "selftouch":
                    geoms = np.array(env.unwrapped.mimo_geoms)
                    assert sorted(info[key]) == geoms[told].tolist()
                else:
                    assert told == info[key]
    for env in singles:
        env.close()
    if mode == "Disabled":
        assert [entry["steps"] for entry in envs.log] == [0, 0, 0]  # they go on until the reset
        envs.reset(options={"reset_mask": np.ones(3, bool)})
    # Three resets without steps, then three episodes.
    assert [entry["steps"] for entry in envs.log] == [0, 0, 0, 20, 20, 20]
    assert envs.log[3:] == [env.unwrapped.log[1] for env in singles]
    assert babybench.scores_of(envs.log).episodes == 3
    if mode == "NextStep":
        infos = envs.step(envs.action_space.sample())[4]  # begins new episodes
        assert not infos["_steps"].any()
    for step in range(3):
        assert envs.step(envs.action_space.sample())[4]["steps"].tolist() == [step] * 3
    envs.close()
    assert [entry["steps"] for entry in envs.log[6:]] == [3, 3, 3]


def test_without_automatic_resets_an_episode_is_logged_once():
    config = {**babybench.load("handregard"), "max_episode_steps": 5, "save_dir": None, **BLIND}
    wide = {"handregard/angle": np.pi}  # every step counts
    envs = babybench.make_vec(config, 2, autoreset_mode="Disabled", parameters=wide)
    envs.reset(seed=1)
    for _ in range(8):
        envs.step(envs.action_space.sample())
    assert [entry["steps"] for entry in envs.log] == [0, 0]
    envs.reset(options={"reset_mask": np.array([True, False])})
    envs.step(envs.action_space.sample())
    envs.close()
    assert [entry["steps"] for entry in envs.log] == [0, 0, 8, 1, 9]
    for entry in envs.log:
        assert {entry[key] for key in counts.REGARD_KEYS} == {entry["steps"]}
    assert babybench.scores_of(envs.log).competition == 1


@pytest.mark.parametrize("mode", ["NextStep", "SameStep"])
def test_rewards_of_a_batch(mode):
    config = {**babybench.load("selftouch"), "touch_scale": 5, "max_episode_steps": 3, "save_dir": None}
    envs = babybench.make_vec(config, 2, reward=babybench.touch_count, autoreset_mode=mode)
    envs.reset(seed=1)
    envs.action_space.seed(4)  # so few sensors feel nothing after some movements
    for step in range(1, 9):
        seen, rewards, _, truncated, infos = envs.step(envs.action_space.sample())
        last = infos["final_obs"] if mode == "SameStep" and truncated.any() else None
        for number in range(2):
            if mode == "NextStep" and step % 4 == 0:
                assert rewards[number] == 0  # the step that begins an episode
            else:
                touch = seen["touch"][number] if last is None else last[number]["touch"]
                assert rewards[number] == pytest.approx(np.mean(touch > 1e-6))
                assert rewards[number] > 0  # the mattress
    envs.close()


def test_a_batch_logs_what_it_does(tmp_path):
    config = {**babybench.load("selftouch"), "save_dir": str(tmp_path), "max_episode_steps": 4, **BLIND}
    envs = babybench.make_vec(config, 2)
    envs.reset(seed=1)
    for _ in range(7):  # an episode, the step that begins the next, and two more
        envs.step(envs.action_space.sample())
    envs.close()
    assert [entry["steps"] for entry in logged(tmp_path)] == [0, 0, 4, 4, 2, 2]
    quiet = babybench.make_vec(config, 2, training=False)
    quiet.reset(seed=1)
    assert quiet.log == []
    quiet.close()
