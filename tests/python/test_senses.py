"""Senses attached to a simulation that is not ours."""

import ctypes
import importlib.util

import numpy as np
import pytest

import mimo


class Host:
    """A simulation in MuJoCo's own C library, as any other program would run it."""

    def __init__(self, path):
        lib = ctypes.CDLL(f"libmujoco.so.{mimo.mujoco_version()}")  # the one that libmimo has loaded
        lib.mj_loadXML.restype = lib.mj_makeData.restype = ctypes.c_void_p
        for name in ("mj_makeData", "mj_deleteModel", "mj_deleteData"):
            getattr(lib, name).argtypes = [ctypes.c_void_p]
        lib.mj_step.argtypes = [ctypes.c_void_p, ctypes.c_void_p]
        error = ctypes.create_string_buffer(500)
        self.lib, self.version = lib, lib.mj_version()
        self.model = lib.mj_loadXML(str(path).encode(), None, error, len(error))
        assert self.model, error.value
        self.data = lib.mj_makeData(self.model)

    def step(self, count=1):
        for _ in range(count):
            self.lib.mj_step(self.model, self.data)

    def close(self):
        self.lib.mj_deleteData(self.data)
        self.lib.mj_deleteModel(self.model)


@pytest.fixture
def humanoid(root):
    host = Host(root / "tests/models/humanoid.xml")
    yield host
    host.close()


def described(root_body, **options):
    scene = mimo.Scene()
    scene.add_agent(body="scene", root=root_body, **{"vision": False, "vestibular": False, "touch": False, **options})
    return scene


def test_a_foreign_model_is_sensed(humanoid):
    scene = described("torso", vestibular=True, vestibular_at="inner_ear", touch=True, vision=mimo.Vision.RGB)
    scene.set_touch("shin_left", 0.02)
    scene.read_joint("knee_left")
    with mimo.Senses(scene, humanoid.model, mujoco_version=humanoid.version) as senses:
        humanoid.step()
        falling = senses.observe(humanoid.data)
        humanoid.step(400)
        lying = senses.observe(humanoid.data)
    # In free fall an accelerometer shows nothing, on the ground the reaction to gravity.
    assert np.linalg.norm(falling["vestibular/acceleration"]) < 1
    assert np.linalg.norm(lying["vestibular/acceleration"]) == pytest.approx(9.81, abs=1)
    assert not falling["touch/force"].any()
    assert lying["touch/force"].any()
    assert senses.layout.fields["proprioception/position"].labels == ("knee_left",)
    assert falling["vision/sight"].shape == (256, 256, 3)


def test_an_environment_of_the_same_model_senses_the_same(humanoid, root):
    scene = mimo.Scene(file=root / "tests/models/humanoid.xml")
    scene.add_agent(body="scene", root="torso", vision=False, vestibular=False)
    scene.set_touch(None, 0.04)
    scene.add_field("shin/velocity", "body_velocity", "shin_left", relative_to="torso")
    with (
        mimo.World(scene, frame_skip=1) as world,
        mimo.Senses(scene, humanoid.model, mujoco_version=humanoid.version) as senses,
    ):
        world.reset()
        for _ in range(300):
            world.step(np.zeros(7, np.float32))
            humanoid.step()
        seen = senses.observe(humanoid.data)
        assert seen.keys() == world.observation.keys()
        for name, values in world.observation.items():
            assert np.array_equal(values, seen[name]), name
        assert seen["touch/force"].any()
        assert seen["shin/velocity"].any()
        assert senses.layout.fields == world.layout.fields
        for ours, theirs in zip(senses.layout.receptors("touch/force"), world.layout.receptors("touch/force")):
            assert np.array_equal(ours, theirs)


def test_attached_senses_have_no_goals(humanoid):
    scene = described("torso")
    scene.add_field("goal", mimo.Quantity.AGENT_GOAL, "")
    with pytest.raises(mimo.UnsupportedError, match="goal"):
        mimo.Senses(scene, humanoid.model, mujoco_version=humanoid.version)


def test_objects_that_are_not_models_are_refused(humanoid):
    scene = described("torso")
    with pytest.raises(mimo.UnsupportedError, match="mujoco_version is 237"):
        mimo.Senses(scene, humanoid.model, mujoco_version=237)
    with pytest.raises(TypeError, match="an address needs mujoco_version"):
        mimo.Senses(scene, humanoid.model)
    with pytest.raises(TypeError, match="neither an object of the mujoco package nor an address"):
        mimo.Senses(scene, "humanoid.xml", mujoco_version=humanoid.version)
    with pytest.raises(mimo.NotFoundError, match="there are: world, torso"):
        mimo.Senses(described("tail"), humanoid.model, mujoco_version=humanoid.version)


@pytest.mark.skipif(importlib.util.find_spec("mujoco") is None, reason="the mujoco package is not installed")
def test_the_mujoco_package_is_understood(root):
    import mujoco

    model = mujoco.MjModel.from_xml_path(str(root / "tests/models/humanoid.xml"))
    data = mujoco.MjData(model)
    if mujoco.__version__ != mimo.mujoco_version():
        with pytest.raises(mimo.UnsupportedError, match="mujoco_version"):
            mimo.Senses(described("torso"), model)
        return
    mujoco.mj_step(model, data)
    with mimo.Senses(described("torso"), model) as senses:
        assert senses.observe(data)["proprioception/position"] == pytest.approx(data.qpos[7:], abs=1e-6)


def late_senses(humanoid):
    scene = described("torso")
    scene.limit_sense("proprioception/position", delay=0.05)
    scene.limit_sense("proprioception/velocity", delay=0.05, noise=0.01)  # which is new in every step
    return mimo.Senses(scene, humanoid.model, mujoco_version=humanoid.version, step=0.01)


def test_senses_remember_what_they_advance_over(humanoid):
    with late_senses(humanoid) as senses, late_senses(humanoid) as others:
        assert senses.reset(humanoid.data, seed=5) is None
        first = senses.observe(humanoid.data)["proprioception/position"].copy()
        for _ in range(5):
            humanoid.step(2)
            senses.advance(humanoid.data)
            assert np.array_equal(senses.observe(humanoid.data)["proprioception/position"], first)
        assert others.load(senses.save()) == mimo.LoadReport((), ())
        humanoid.step(2)
        for each in (senses, others):
            each.advance(humanoid.data)
        now = senses.observe(humanoid.data)
        assert not np.array_equal(now["proprioception/position"], first)
        for again in (others.observe(humanoid.data), senses.observe(humanoid.data)):
            assert all(np.array_equal(now[name], again[name]) for name in now)


def test_options_of_worlds_are_refused_by_attached_senses(humanoid):
    scene = described("torso")
    scene.limit_motor(delay=0.1)
    with pytest.raises(mimo.UnsupportedError, match="the host commands them"):
        mimo.Senses(scene, humanoid.model, mujoco_version=humanoid.version)
    with pytest.raises(TypeError, match=r"frame_skip.*There are: .*step"):
        mimo.Senses(described("torso"), humanoid.model, mujoco_version=humanoid.version, frame_skip=2)
    with late_senses(humanoid) as senses, pytest.raises(mimo.FileError, match=r"state: .* too few"):
        senses.load(b"nothing")
