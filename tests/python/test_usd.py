"""USD files, checked by USD's own validators and read back against the library's poses."""

import subprocess
import sys

import numpy as np
import pytest

import mimo
from mimo import cubes, usd
from mimo.frames import placed

Usd = pytest.importorskip("pxr.Usd", reason="usd-core is not installed")
pytest.importorskip("PIL", reason="Pillow is not installed")
from pxr import Gf, UsdGeom, UsdLux, UsdShade, UsdUtils  # noqa: E402


@pytest.fixture(scope="module")
def written(tmp_path_factory):
    file = tmp_path_factory.mktemp("usd") / "infant.usdc"
    with mimo.World("showroom", vision=False, touch=False) as world:
        world.reset(seed=1)
        for _ in range(20):
            world.step(np.sin(np.arange(len(world.action_names))))
        usd.write(world, file)
        yield world, file, Usd.Stage.Open(str(file))


def complaints(file):
    """What USD's checker finds: of old versions the ComplianceChecker, of new ones all validators."""
    if hasattr(UsdUtils, "ComplianceChecker"):
        checker = UsdUtils.ComplianceChecker()
        checker.CheckCompliance(str(file))
        return checker.GetErrors() + checker.GetFailedChecks()
    from pxr import UsdValidation

    validators = UsdValidation.ValidationRegistry().GetOrLoadAllValidators()
    assert len(validators) > 10
    errors = UsdValidation.ValidationContext(validators).Validate(Usd.Stage.Open(str(file)))
    return [error.GetMessage() for error in errors]


def shape(stage, geom, name):
    (found,) = [prim for prim in stage.Traverse() if prim.GetName() == f"{name}_{geom}" and prim.IsA(UsdGeom.Mesh)]
    return UsdGeom.Mesh(found)


def test_usd_s_checker_finds_no_errors(written, tmp_path):
    _, file, _ = written
    assert complaints(file) == []
    packed = tmp_path / "infant.usdz"
    with mimo.World("playdate", vision=False, touch=False) as world:
        assert usd.write(world, packed) == [packed]
    assert complaints(packed) == []
    assert [it.name for it in tmp_path.iterdir()] == ["infant.usdz"]


def test_the_checker_finds_errors(tmp_path):
    stage = Usd.Stage.CreateNew(str(tmp_path / "bad.usda"))
    UsdGeom.Mesh.Define(stage, "/Mesh")
    stage.GetRootLayer().Save()
    assert complaints(tmp_path / "bad.usda") != []


def test_vertices_are_where_the_library_has_them(written):
    world, _, stage = written
    assert UsdGeom.GetStageUpAxis(stage) == "Z"
    assert UsdGeom.GetStageMetersPerUnit(stage) == 1
    poses, shown = world.poses("geom"), 0
    for geom, name in enumerate(world.geoms().names):
        if not name.isidentifier() or not world.appearance(geom).visible:
            continue
        found, ours = shape(stage, geom, name), world.mesh(geom)
        to_world = np.array(UsdGeom.XformCache().GetLocalToWorldTransform(found.GetPrim()))  # of rows
        points = np.array(found.GetPointsAttr().Get(), np.float64)
        there = np.column_stack([points, np.ones(len(points))]) @ to_world
        expected = placed(poses.positions[geom], poses.rotations[geom], ours.positions)
        np.testing.assert_allclose(there[:, :3], expected, atol=1e-5)
        np.testing.assert_array_equal(np.reshape(found.GetFaceVertexIndicesAttr().Get(), (-1, 3)), ours.triangles)
        shown += 1
    assert shown > 40


def test_materials_and_textures(written):
    from PIL import Image

    world, file, stage = written
    geom = world.find("geom", "head")
    look = world.appearance(geom)
    material, _ = UsdShade.MaterialBindingAPI(shape(stage, geom, "head")).ComputeBoundMaterial()
    surface = material.ComputeSurfaceSource()[0]
    assert surface.GetIdAttr().Get() == "UsdPreviewSurface"
    reader = UsdShade.Shader(surface.GetInput("diffuseColor").GetConnectedSource()[0].GetPrim())
    picture = np.asarray(Image.open(file.parent / reader.GetInput("file").Get().path))
    np.testing.assert_array_equal(picture, cubes.picture(world.texture(look.texture)))
    # 0.6 on a screen is 0.3185 of its light (sRGB, IEC 61966-2-1).
    assert look.color[0] == pytest.approx(0.6)
    assert reader.GetInput("scale").Get()[0] == pytest.approx(0.3185, abs=1e-4)
    assert surface.GetInput("opacity").Get() == look.color[3]


def test_lights(written):
    world, _, stage = written
    lights = [prim for prim in stage.Traverse() if prim.HasAPI(UsdLux.LightAPI)]
    sources = [light for light in world.light_sources() if light.active]
    assert len(lights) == 1 + len(sources) > 1  # and the one around
    for number, light in enumerate(sources):
        node = UsdGeom.Xformable(stage.GetPrimAtPath(f"/World/light_{number}"))
        to_world = node.ComputeLocalToWorldTransform(Usd.TimeCode.Default())
        np.testing.assert_allclose(to_world.ExtractTranslation(), light.position, atol=1e-6)
        np.testing.assert_allclose(to_world.TransformDir(Gf.Vec3d(0, 0, -1)), light.direction, atol=1e-6)


def exported(*arguments, cwd):
    command = [sys.executable, "-m", "mimo.export", *arguments]
    return subprocess.run(command, cwd=cwd, capture_output=True, text=True)


def test_the_program(tmp_path):
    done = exported("--usd", "reach.usda", "--scene", "reach", "--age", "6", cwd=tmp_path)
    assert (done.returncode, done.stderr) == (0, "")
    assert complaints(tmp_path / "reach.usda") == []
    for arguments, message in [
        (["--usd", "infant.obj"], "expected a name that ends in .usda, .usdc, .usdz"),
        (["--usd", "nowhere/infant.usdc"], "there is no folder"),
        (["--usd", "infant.usdc", "--scene", "nosuch"], 'no scene named "nosuch"'),
    ]:
        refused = exported(*arguments, cwd=tmp_path)
        assert (refused.returncode, refused.stdout, refused.stderr.count("\n")) == (1, "", 1)
        assert message in refused.stderr
    assert {it.name for it in tmp_path.iterdir()} == {"reach.usda", "reach_textures"}


def test_without_usd_core(monkeypatch, tmp_path):
    monkeypatch.setitem(sys.modules, "pxr.Usd", None)
    with mimo.World("reach") as world, pytest.raises(mimo.UnsupportedError, match=r"pip install 'mimo\[usd\]'"):
        usd.write(world, tmp_path / "infant.usdc")
