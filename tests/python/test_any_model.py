"""Models that know nothing of infants: our own in tests/models, and all those of two well-known packages."""

import subprocess
import sys
import zipfile

import numpy as np
import pytest

import mimo

PACKAGES = ["gymnasium==0.29.1", "dm_control==1.0.7"]  # dm_control 1.0.7 is the one for MuJoCo 2.2.2

# What cannot be loaded, and why: files that are no MJCF, or parts of a model that is put together by a program.
REFUSED = {
    "dm_control/mjcf/schema.xml": "the root element is <element>",
    "dm_control/mjcf/test_assets/attribute_test_schema.xml": "the root element is <element>",
    "dm_control/mjcf/test_assets/included_with_invalid_filenames.xml": "invalid_mesh_name.stl of <mesh",
    "dm_control/mjcf/test_assets/model_with_invalid_filenames.xml": "invalid_included_name.xml cannot be read",
    "dm_control/mjcf/test_assets/test_model.xml": "mass and inertia of moving bodies must be larger",
    "dm_control/mujoco/testing/assets/model_with_assets.xml": "included.xml cannot be read",
}


@pytest.fixture(scope="module")
def packages(tmp_path_factory):
    folder = tmp_path_factory.mktemp("packages")
    pip = [sys.executable, "-m", "pip", "download", "--quiet", "--no-deps", "--only-binary=:all:"]
    subprocess.run([*pip, "--dest", str(folder), *PACKAGES], check=True)
    for wheel in folder.glob("*.whl"):
        with zipfile.ZipFile(wheel) as file:
            file.extractall(folder)
    return folder


def run(path, steps=20):
    """A few random steps of everything in the file, with every sense that it has something for."""
    scene = mimo.Scene(file=path)
    scene.add_agent(body="scene", root="world", vision=False, vestibular_at="world", touch=True)
    scene.set_touch(None, 0.05)
    random = np.random.default_rng(0)
    with mimo.World(scene) as world:
        low = np.where(np.isfinite(world.action_low), world.action_low, -1)
        high = np.where(np.isfinite(world.action_high), world.action_high, 1)
        world.reset(seed=0)
        for _ in range(steps):
            world.step(random.uniform(low, high).astype(np.float32))
        assert all(np.isfinite(values).all() for values in world.observation.values())
        return {name: values.copy() for name, values in world.observation.items()}


def test_models_of_packages_run_or_are_refused_clearly(packages):
    ran, refused = {}, {}
    for path in sorted(packages.glob("*/**/*.xml")):
        name = path.relative_to(packages).as_posix()
        try:
            ran[name] = run(path)
        except mimo.Error as error:
            refused[name] = str(error)
    assert refused.keys() == REFUSED.keys()
    assert all(reason in refused[name] for name, reason in REFUSED.items())
    assert len(ran) == 59
    humanoid = ran["gymnasium/envs/mujoco/assets/humanoid.xml"]
    assert humanoid["proprioception/position"].shape == humanoid["proprioception/control"].shape == (17,)
    assert ran["dm_control/suite/manipulator.xml"]["proprioception/position"].shape == (14,)


@pytest.mark.parametrize(
    ("name", "joints", "actuators", "touched"),
    [
        ("humanoid", 8, 7, True),
        ("gripper", 3, 2, True),
        ("quadruped", 8, 8, True),
        ("meshes", 0, 0, True),
        ("rubble", 0, 0, True),
        ("still", 0, 0, False),
    ],
)
def test_models_of_the_library(root, name, joints, actuators, touched):
    seen = run(root / f"tests/models/{name}.xml", steps=250)
    assert seen.get("proprioception/position", np.empty(0)).shape == (joints,)
    assert seen.get("proprioception/control", np.empty(0)).shape == (actuators,)
    assert seen["touch/force"].any() == touched
    assert seen["vestibular/acceleration"] == pytest.approx([0, 0, 9.81])  # the world itself stays where it is


def test_a_world_tells_once_by_name_what_its_cameras_leave_out(tmp_path, caplog):
    """Pictures have eight lights, the headlight among them: of nine others the last two do not shine."""
    lights = "".join(f'<light name="lamp{i}" pos="0 0 3"/>' for i in range(9))
    file = tmp_path / "dazzling.xml"
    file.write_text(
        f'<mujoco><worldbody>{lights}<body name="robot"><freejoint/><geom size=".1"/><site name="nose"/>'
        '<camera name="front"/></body></worldbody><sensor><rangefinder site="nose"/></sensor></mujoco>'
    )
    scene = mimo.Scene(file=file)
    scene.add_agent(body="scene", root="robot", touch=False, vestibular=False, vision=True)
    with caplog.at_level("WARNING", "mimo"), mimo.Batch(scene, 3) as batch:
        batch.reset(seeds=0)
    told = [record.getMessage() for record in caplog.records if "shine" in record.message or "drawn" in record.message]
    caplog.clear()  # expected
    assert told == [
        'light "lamp7" is not drawn: a picture has at most 8 lights',
        'light "lamp8" is not drawn: a picture has at most 8 lights',
        "beams of range finders are not drawn",
    ]
