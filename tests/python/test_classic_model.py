"""env.model and env.data of mimo.classic: MuJoCo's arrays, what writing to them does, and MuJoCo's functions on them.

Constants are those of the original's compiled models (tests/golden); the rest follows from definitions, shown here.
"""

import copy
import csv
import pickle

import numpy as np
import pytest

import mimo
from mimo import classic
from mimo.classic import engine, mathematics, rotations
from mimo.classic.columns import DATA, MODEL
from mimo.classic.model import DataView, ModelView

mujoco = engine.stand_in(None)
SCENES = {
    "v1_benchmark": ("benchmark", "mitten"),
    "v2_benchmark": ("benchmark", "fingers"),
    "reach": ("reach", "mitten"),
    "standup": ("standup", "mitten"),
    "selfbody": ("selfbody", "mitten"),
}


def numbers(text):
    return [float(it) for it in text.split()]


def rows(root, scene, table):
    with open(root / f"tests/golden/{scene}/{table}.csv") as file:
        return list(csv.DictReader(file))


@pytest.fixture(scope="module")
def views():
    made = {}

    def of(scene):
        if scene not in made:
            name, body = SCENES[scene]
            world = mimo.World(name, body=body, vision=False, touch=False)
            made[scene] = ModelView(world)
        return made[scene]

    return of


@pytest.fixture
def env():
    env = classic.MIMoDummyEnv(touch_params=None, vision_params=None)
    env.reset(seed=1)
    return env


@pytest.mark.parametrize("scene", SCENES)
def test_joints_are_the_original_s(root, views, scene):
    model = views(scene)
    for row in rows(root, scene, "joints"):
        joint = model.joint(row["name"]) if row["name"] else model.joint(int(row["id"]))
        if row["type"] == "free":
            assert joint.type == 0
            continue
        assert joint.type == 3
        assert joint.limited == int(row["limited"])
        np.testing.assert_allclose(joint.range, numbers(row["range_rad"]), atol=1e-6)
        np.testing.assert_allclose(joint.stiffness, float(row["stiffness"]), rtol=1e-6)
        np.testing.assert_allclose(joint.armature, float(row["armature"]), rtol=1e-6)
        np.testing.assert_allclose(joint.frictionloss, float(row["frictionloss"]), rtol=1e-6)
        np.testing.assert_allclose(joint.damping, float(row["damping"]), rtol=1e-6)
        np.testing.assert_allclose(joint.qpos_spring, np.radians(float(row["springref_deg"])), atol=1e-6)
        np.testing.assert_allclose(joint.axis, numbers(row["axis"]), atol=1e-6)
        np.testing.assert_allclose(joint.pos, numbers(row["pos"]), atol=1e-6)


@pytest.mark.parametrize("scene", ["v1_benchmark", "v2_benchmark"])
def test_places_in_arrays_are_the_original_s(root, views, scene):
    model = views(scene)
    for row in rows(root, scene, "joints"):
        joint = model.joint(int(row["id"]))
        assert (joint.qposadr, joint.dofadr) == (int(row["qposadr"]), int(row["dofadr"]))
    assert model.nq == sum(len(numbers(row["qpos0"])) for row in rows(root, scene, "qpos0"))


@pytest.mark.parametrize("scene", SCENES)
def test_geoms_are_the_original_s(root, views, scene):
    model = views(scene)
    kinds = ("plane", "hfield", "sphere", "capsule", "ellipsoid", "cylinder", "box", "mesh")
    by_body, compared = {}, 0
    for row in rows(root, scene, "geoms"):
        by_body.setdefault(row["body"], []).append(row)
    for body, expected in by_body.items():
        found = [geom for geom in range(model.ngeom) if model.body(model.geom(geom).bodyid).name == body]
        if body == "world" or len(found) != len(expected):
            continue  # the rooms have their own walls
        compared += len(found)
        for geom, row in zip(found, expected):
            assert kinds[int(model.geom_type[geom])] == row["type"]
            assert model.geom_contype[geom] == int(row["contype"])
            assert model.geom_conaffinity[geom] == int(row["conaffinity"])
            assert model.geom_condim[geom] == int(row["condim"])
            size = numbers(row["size"])
            np.testing.assert_allclose(model.geom_size[geom][: len(size)], size, atol=1e-6)
            np.testing.assert_allclose(model.geom_pos[geom], numbers(row["pos"]), atol=1e-5)
            turned = abs(np.dot(model.geom_quat[geom], numbers(row["quat_wxyz"])))
            assert turned == pytest.approx(1, abs=1e-5)
            np.testing.assert_allclose(model.geom_rbound[geom], float(row["rbound"]), atol=1e-5)
            np.testing.assert_allclose(model.geom_friction[geom], numbers(row["friction"]), rtol=1e-6)
            np.testing.assert_allclose(model.geom_solref[geom], numbers(row["solref"]), rtol=1e-6)
    assert compared >= 36  # the infant's


@pytest.mark.parametrize("scene", SCENES)
def test_bodies_are_the_original_s(root, views, scene):
    model = views(scene)
    for row in rows(root, scene, "bodies")[1:]:
        if row["name"] == "crib" or row["name"].startswith("crib_"):
            continue
        body = model.body(row["name"])
        assert model.body(body.parentid).name == row["parent"]
        np.testing.assert_allclose(body.mass, float(row["mass"]), rtol=1e-4)
        np.testing.assert_allclose(body.subtreemass, float(row["subtreemass"]), rtol=1e-4)
        np.testing.assert_allclose(body.ipos, numbers(row["ipos"]), atol=1e-4)
        assert (body.geomnum, body.jntnum) == (int(row["n_geoms"]), int(row["n_joints"]))
        if not int(row["n_joints"]) or row["name"] not in ("target", "mimo_location"):
            np.testing.assert_allclose(body.pos, numbers(row["pos"]), atol=1e-5)
            assert abs(np.dot(np.ravel(body.quat), numbers(row["quat_wxyz"]))) == pytest.approx(1, abs=1e-5)


@pytest.mark.parametrize("scene", SCENES)
def test_motors_are_the_original_s(root, views, scene):
    model = views(scene)
    expected = rows(root, scene, "actuators")
    assert model.nu == len(expected)
    assert model.nuser_actuator == 3
    for row in expected:
        motor = model.actuator(row["name"])
        assert model.joint(int(motor.trnid[0])).name == row["joint"]
        np.testing.assert_allclose(motor.gear, numbers(row["gear"]), rtol=1e-6)
        np.testing.assert_allclose(motor.forcerange, numbers(row["forcerange"]), rtol=1e-6)
        np.testing.assert_allclose(motor.ctrlrange, numbers(row["ctrlrange"]), rtol=1e-6)
        np.testing.assert_allclose(motor.user, numbers(row["user_vmax_fmaxneg_fmaxpos"]), rtol=1e-6)


def test_sensors_and_locks_are_the_original_s(root, views):
    model = views("v1_benchmark")
    for row in rows(root, "v1_benchmark", "sensors"):
        sensor = model.sensor(row["name"])
        assert (sensor.dim, sensor.adr) == (int(row["dim"]), int(row["adr"]))
    held = {row["obj1"]: row for row in rows(root, "v1_benchmark", "equalities") if row["type"] == "joint"}
    for number in range(model.neq):
        lock = model.equality(number)
        row = held[model.joint(lock.obj1id).name]
        assert lock.active == int(row["active"])
        np.testing.assert_allclose(np.ravel(lock.data)[:5], numbers(row["data"])[:5], atol=1e-6)
    assert model.neq == len(held)


def test_options_are_the_document_s(views):
    opt = views("v1_benchmark").opt
    assert (opt.timestep, opt.iterations, opt.tolerance, opt.cone, opt.solver) == (0.005, 50, 1e-10, 1, 2)
    assert opt.wind.tolist() == [0, 0, 0]


def test_every_array_can_be_read(env):
    for view, table in ((env.model, MODEL), (env.data, DATA)):
        for name in table:
            array = getattr(view, name)
            assert np.isfinite(array).all(), name


# ---- Writing -------------------------------------------------------------------------------------------------------


def test_writes_count(env):
    model, data, world = env.model, env.data, env.world
    model.body("hip").mass = 5
    assert world.bodies("hip").mass[0] == 5
    model.body("test_object1").mass[:] += 1.5
    assert world.bodies("test_object1").mass[0] == pytest.approx(8 + 1.5, rel=1e-3)  # 8 kg of the original's box
    data.joint("robot:left_elbow").qpos = -0.5
    assert world.joints("robot:left_elbow").position[0] == -0.5
    data.qpos[3] = 0.5
    data.qpos[4:7] *= -1
    assert data.qpos[3] == world.joints().position[3]
    data.actuator("act:left_elbow").ctrl = 0.3
    assert world.actuators("act:left_elbow").control[0] == 0.3
    data.ctrl[:] = 0.1
    assert (world.actuators().control == 0.1).all()
    model.geom("floor").friction = [0.5, 0.1, 0.01]
    assert world.geoms("floor").friction.ravel().tolist() == [0.5, 0.1, 0.01]
    model.opt.gravity[2] = -1.62
    model.opt.gravity[:2] = 0.5, 0.25
    assert world.gravity.tolist() == [0.5, 0.25, -1.62]
    data.qvel[6] = 0.25
    assert world.joints().velocity[6] == 0.25
    model.dof_damping[model.joint("robot:left_elbow").dofadr] = 0.5
    assert world.joints("robot:left_elbow").damping[0] == 0.5
    model.eq_data[model.equality("robot:left_elbow").id, 0] = -0.5
    model.eq_active[model.equality("robot:left_elbow").id] = True
    assert world.locked("robot:left_elbow") == -0.5
    np.add(data.ctrl, 0.1, out=data.ctrl)
    np.copyto(data.qfrc_applied, 0.0)
    np.add.at(data.qfrc_applied, [3, 3], 0.5)
    assert data.qfrc_applied[3] == 1.0  # both
    assert (data.ctrl == 0.2).all()


def test_a_static_body_can_be_placed():
    scene = mimo.Scene(
        xml='<mujoco><worldbody><body name="shelf" pos="1 0 0"><geom size=".1"/></body></worldbody></mujoco>'
    )
    env = classic.MIMoEnv(scene, goals_in_observation=False)
    assert env.model.body("shelf").pos.tolist() == [1, 0, 0]
    env.model.body("shelf").pos = [0.5, 0.5, 0.25]
    env.model.body("shelf").quat = [0, 1, 0, 0]
    env.step(np.zeros(env.action_space.shape))
    np.testing.assert_allclose(env.data.body("shelf").xpos, [0.5, 0.5, 0.25])
    np.testing.assert_allclose(env.model.body("shelf").quat, [0, 1, 0, 0])


@pytest.mark.parametrize(
    ("write", "error", "line"),
    [
        (lambda env: setattr(env.model.body("hip"), "pos", [0, 0, 1]), ValueError, "place of 'hip' on its parent is a"),
        (lambda env: setattr(env.model.body("hip"), "quat", [1, 1, 0, 0]), ValueError, "place of 'hip' on its parent"),
        (lambda env: setattr(env.model.opt, "iterations", 20), AttributeError, r"write <option iterations=\.\.\./> in"),
        (lambda env: setattr(env.model.opt, "timestep", 0.001), AttributeError, r"write <option timestep=\.\.\./> in"),
        (lambda env: setattr(env.model.opt, "gravty", 1), AttributeError, r"model\.opt has no 'gravty'"),
        (lambda env: setattr(env.model.body("hip"), "masss", 1), AttributeError, "body 'hip' of model has no 'masss'"),
        (lambda env: setattr(env.model, "body_mas", 1), AttributeError, "model has no 'body_mas' here"),
        (lambda env: setattr(env.data, "time", 0), AttributeError, r"data\.time cannot be assigned"),
        (
            lambda env: env.data.xpos.__setitem__(3, 0),
            ValueError,
            r"data\.xpos cannot be written: the physics computes",
        ),
        (lambda env: env.data.body("hip").xpos.__setitem__(2, 1), ValueError, r"data\.xpos cannot be written"),
        (lambda env: env.data.xmat.fill(0), ValueError, r"data\.xmat cannot be written"),
        (lambda env: env.model.jnt_stiffness.__setitem__(5, 0), ValueError, r"model\.jnt_stiffness cannot be written"),
        (lambda env: env.model.actuator_gear.__setitem__((0, 1), 2), ValueError, r"set actuator_gear\[:, 0\]"),
        (lambda env: setattr(env.model.body("hip"), "mass", -1), ValueError, "mass"),
        (lambda env: env.data.qpos.sort(), ValueError, "read-only"),
        (lambda env: np.asarray(env.data.qpos).__setitem__(0, 1), ValueError, "read-only"),
        (lambda env: setattr(env.data, "qpos", [1, 2]), ValueError, "broadcast"),
        (lambda env: env.data.contact.geom1.__setitem__(0, 1), ValueError, "copy"),
    ],
)
def test_other_writes_are_refused(env, write, error, line):
    before = env.world.save()
    with pytest.raises(error, match=line):
        write(env)
    assert env.world.save() == before


def test_arrays_follow_the_world(env):
    qpos, height, ctrl = env.data.qpos, env.data.body("head").xpos, env.data.ctrl
    for _ in range(5):
        env.step(np.full(env.action_space.shape, 0.2))
        np.testing.assert_array_equal(qpos, env.world.joints().position)
        np.testing.assert_array_equal(height, env.world.bodies("head").position[0])
    assert (ctrl != 0).all()
    mujoco.mj_step(env.model, env.data, nstep=3)
    np.testing.assert_array_equal(qpos, env.world.joints().position)
    env.reset(seed=1)
    np.testing.assert_array_equal(qpos, env.world.joints().position)
    for plain in (qpos + 1, qpos.copy(), qpos[[0, 1]], np.concatenate([qpos, ctrl]), copy.deepcopy(qpos), abs(qpos)):
        assert type(plain) is np.ndarray
    assert type(pickle.loads(pickle.dumps(qpos))) is np.ndarray


def test_a_write_that_fails_changes_nothing(env):
    masses = env.model.body_mass
    before = masses.copy()
    with pytest.raises(ValueError, match="mass"):
        masses[2:4] = -1
    np.testing.assert_array_equal(masses, before)


# ---- MuJoCo's functions --------------------------------------------------------------------------------------------


def test_names(env):
    model = env.model
    kind = mujoco.mjtObj
    assert mujoco.mj_id2name(model, kind.mjOBJ_BODY, 4) == "hip"
    assert mujoco.mj_id2name(model, int(kind.mjOBJ_BODY), model.geom(3).bodyid) == "hip"
    assert mujoco.mj_id2name(model, kind.mjOBJ_BODY, 999) is None
    assert mujoco.mj_name2id(model, kind.mjOBJ_ACTUATOR, "act:head_swivel") == model.actuator("act:head_swivel").id
    assert mujoco.mj_name2id(model, kind.mjOBJ_JOINT, "nowhere") == -1
    assert mujoco.mj_name2id(model, kind.mjOBJ_JOINT, "mimo_location") == mujoco.mj_name2id(
        model, kind.mjOBJ_JOINT, "mimo_orientation"
    )
    assert mujoco.mj_id2name(model, kind.mjOBJ_EQUALITY, 0) == "robot:hip_lean1"
    assert (mujoco.mjtJoint.mjJNT_HINGE, mujoco.mjtGeom.mjGEOM_CAPSULE) == (3, 3)


def test_steps_and_resets(env):
    env.data.ctrl[:] = 0.2
    mujoco.mj_step(m=env.model, d=env.data, nstep=4)
    assert env.data.time == pytest.approx(4 * 0.005)
    env.model.body("hip").mass = 3
    mujoco.mj_resetData(env.model, env.data)
    assert (env.data.time, env.data.qvel.any(), env.data.ctrl.any()) == (0, False, False)
    np.testing.assert_array_equal(env.data.qpos, env.init_qpos)
    assert env.model.body("hip").mass == 3


def test_a_forward_pass_finds_contacts(env):
    env.data.joint("mimo_location").qpos[2] = 0.05
    mujoco.mj_forward(env.model, env.data)
    assert env.data.ncon == len(env.data.contact) == len(env.data.contact.geom1) > 0
    deepest = int(np.argmin(env.data.contact.dist))
    assert env.data.contact[deepest].dist == env.data.contact.dist[deepest] < -0.01
    assert env.data.contact.frame.shape == (env.data.ncon, 9)
    assert [one.geom1 for one in env.data.contact] == env.data.contact.geom1.tolist()


def test_jacobians_are_derivatives(env):
    # A small turn of the elbow moves the hand by the Jacobian's column times the angle.
    model, data = env.model, env.data
    hand, joint = model.body("left_hand").id, model.joint("robot:left_elbow")
    place, turn = np.zeros((3, model.nv)), np.zeros((3, model.nv))
    mujoco.mj_jacBody(model, data, place, turn, hand)
    center = np.zeros((3, model.nv))
    mujoco.mj_jacBodyCom(model, data, center, None, hand)
    velocities = data.qvel.copy()
    before, com, frame = data.xpos[hand].copy(), data.xipos[hand].copy(), data.xmat[hand].copy().reshape(3, 3)
    angle = 1e-6
    data.qpos[joint.qposadr] += angle
    mujoco.mj_kinematics(model, data)
    column = int(joint.dofadr[0])
    np.testing.assert_allclose((data.xpos[hand] - before) / angle, place[:, column], atol=1e-5)
    np.testing.assert_allclose((data.xipos[hand] - com) / angle, center[:, column], atol=1e-5)
    spin = (data.xmat[hand].reshape(3, 3) @ frame.T - np.eye(3)) / angle
    np.testing.assert_allclose([spin[2, 1], spin[0, 2], spin[1, 0]], turn[:, column], atol=1e-5)
    np.testing.assert_array_equal(data.qvel, velocities)


def test_what_the_package_lacks_says_so(env):
    with pytest.raises(NotImplementedError, match=r"mujoco\.mj_inverse is not there"):
        mujoco.mj_inverse(env.model, env.data)
    with pytest.raises(TypeError, match=r"expected env\.model and env\.data; the package mujoco is not installed"):
        mujoco.mj_step(None, None)
    with pytest.raises(AttributeError, match="mujoco has no 'nonsense'"):
        mujoco.nonsense  # noqa: B018


def test_rotations():
    # A quarter turn about z takes x to y; about x, then about the moving z, takes z to -y and x to where y was: z.
    quarter = np.zeros(4)
    mujoco.mju_axisAngle2Quat(quarter, [0, 0, 1], np.pi / 2)
    np.testing.assert_allclose(quarter, [0.5**0.5, 0, 0, 0.5**0.5])
    turned = np.zeros(3)
    mujoco.mju_rotVecQuat(turned, [1, 0, 0], quarter)
    np.testing.assert_allclose(turned, [0, 1, 0], atol=1e-15)
    both = np.zeros(4)
    mujoco.mju_euler2Quat(both, [np.pi / 2, 0, np.pi / 2], "xyz")
    nine = np.zeros(9)
    mujoco.mju_quat2Mat(nine, both)
    np.testing.assert_allclose(nine.reshape(3, 3) @ [0, 0, 1], [0, -1, 0], atol=1e-15)
    np.testing.assert_allclose(nine.reshape(3, 3) @ [1, 0, 0], [0, 0, 1], atol=1e-15)
    back = np.zeros(4)
    mujoco.mju_mat2Quat(back, nine)
    np.testing.assert_allclose(abs(np.dot(back, both)), 1)
    # Fixed axes: z first, then x about the world's axis.
    np.testing.assert_allclose(rotations.from_euler([0.3, 0, 0.4], "XYZ"), rotations.from_euler([0.4, 0, 0.3], "zyx"))
    spin = np.zeros(3)
    mathematics.FUNCTIONS["mju_quat2Vel"](spin, quarter, 0.5)
    np.testing.assert_allclose(spin, [0, 0, np.pi])  # a quarter turn in half a second


def test_a_view_of_a_world_alone():
    world = mimo.World("free", vision=False)
    model, data = ModelView(world), DataView(world)
    mujoco.mj_step(model, data)
    assert data.time == pytest.approx(0.005)


def test_constants_follow_classes_of_defaults():
    # As MuJoCo's manual says: a class has the attributes of the class around it; an element those of its `class`, else
    # of the nearest `childclass`, else of the outermost class; the outermost one of several sections grows.
    text = """<mujoco>
      <default><geom condim="4" group="2"/><default class="soft"><geom solref="0.1 1"/></default></default>
      <default><geom margin="0.01"/><default class="low"><geom condim="1"/></default></default>
      <worldbody>
        <geom name="a" size="1"/>
        <body name="b" childclass="soft" pos="0 0 9" euler="90 0 0">
          <geom name="c" size="1"/><geom name="d" size="1" class="low" condim="6"/>
          <body name="e"><joint name="h" type="slide"/><geom name="f" size="1" class="low"/>
            <geom name="g" size="1" class="soft"/></body>
        </body>
      </worldbody></mujoco>"""
    model = ModelView(mimo.World(mimo.Scene(xml=text)))
    table = {name: model.geom(name) for name in "acdfg"}
    assert {name: int(geom.condim[0]) for name, geom in table.items()} == {"a": 4, "c": 4, "d": 6, "f": 1, "g": 4}
    assert {name: int(geom.group[0]) for name, geom in table.items()} == dict.fromkeys("acdfg", 2)
    assert table["c"].solref.tolist() == [0.1, 1]
    assert table["f"].margin == 0.01
    np.testing.assert_allclose(model.body("b").quat, [0.5**0.5, 0.5**0.5, 0, 0])  # a quarter turn about x, in degrees
    assert (model.joint("h").type, model.joint("h").limited) == (2, 0)


def test_sizes_of_pictures_and_statistics(env):
    assert env.model.stat.extent > 0
    env.model.vis.global_.offwidth = 2048
    assert env.model.vis.global_.offwidth == 2048
    with pytest.raises(AttributeError, match=r"model\.stat\.extent is a constant here"):
        env.model.stat.extent = 1
    with pytest.raises(AttributeError, match=r"model\.vis has no 'map' here"):
        env.model.vis.map  # noqa: B018


def test_models_without_an_environment(tmp_path):
    # A ball falls for n steps of t: by t^2 g n (n + 1) / 2, as MuJoCo sets the velocity first.
    ball = '<mujoco><worldbody><body name="ball" pos="0 0 1"><freejoint/><geom size="0.1"/></body></worldbody></mujoco>'
    (tmp_path / "ball.xml").write_text(ball)
    for model in (mujoco.MjModel.from_xml_string(ball), mujoco.MjModel.from_xml_path(tmp_path / "ball.xml")):
        data = mujoco.MjData(model)
        mujoco.mj_step(model, data, nstep=10)
        assert 1 - data.qpos[2] == pytest.approx(0.002**2 * 9.81 * 55, rel=1e-9)
        mujoco.mj_resetData(model, data)
        assert data.qpos[2] == 1
    original = mujoco.MjModel.from_xml_path(tmp_path / "benchmarkv2_scene.xml")
    assert (original.nu, original.body(name="hip").name, original.camera("eye_left").fovy) == (88, "hip", 60)
    assert original.sensor("vestibular_gyro").type == 3
    assert original.geom("head").matid >= 0
    with pytest.raises(TypeError, match="use from_xml_path or from_xml_string"):
        mujoco.MjModel()


def test_mocap_bodies_and_tendons(env):
    text = """<mujoco><worldbody>
      <body name="hand" mocap="true" pos="0 0 1"><geom size="0.1" contype="0" conaffinity="0"/></body>
      <body><joint name="j"/><geom size="0.1"/></body></worldbody></mujoco>"""
    model = mujoco.MjModel.from_xml_string(text)
    data = mujoco.MjData(model)
    assert (model.nmocap, model.body("hand").mocapid) == (1, 0)
    data.mocap_pos[0] = [0.5, 0.25, 2]
    data.mocap_quat[0] = [0, 1, 0, 0]
    mujoco.mj_step(model, data)
    assert data.body("hand").xpos.tolist() == [0.5, 0.25, 2]
    np.testing.assert_allclose(data.body("hand").xmat.reshape(3, 3), np.diag([1, -1, -1]), atol=1e-15)
    first = mujoco.mj_id2name(env.model, mujoco.mjtObj.mjOBJ_TENDON, 0)
    assert mujoco.mj_name2id(env.model, mujoco.mjtObj.mjOBJ_TENDON, first) == 0
    assert env.model.ntendon == 9  # the original's: three in the trunk, six in the head
