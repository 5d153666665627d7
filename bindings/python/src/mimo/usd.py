"""Writes the current state of a world as a USD file: shapes, materials, textures, lights. Needs the extra [usd].

mimo.usd.write(world, "infant.usdc")    # or .usda (text), or .usdz (with the textures inside)
"""

from __future__ import annotations

import os
import shutil
import tempfile
from dataclasses import replace
from pathlib import Path
from typing import Any, Dict, List, Union

import numpy as np

from ._files import MARK, failures_named, new_file, put, require_writable
from .constants import Kind, TextureType
from .cubes import picture, places
from .drawing import on_bodies
from .errors import UnsupportedError
from .frames import placed, turned
from .geometry import Appearance, Light, Mesh
from .view.glb import linear, roughness
from .world import World

ENDINGS = (".usda", ".usdc", ".usdz")
LAMP = 0.05  # radius of lamps, m


def write(world: World, file: Union[str, "os.PathLike[str]"], segments: int = 24, plane: float = 20.0) -> List[Path]:
    """Writes a world, with its textures in a folder beside the file, or inside a .usdz file.

    Returns the written files. Units are metres, z is up; each body is a transform with its geoms below it.
    """
    path = Path(file)
    if path.suffix not in ENDINGS:
        raise ValueError(f"the file is {str(path)!r}, expected a name that ends in {', '.join(ENDINGS)}")
    require_writable(path)
    _need()
    with failures_named(path), tempfile.TemporaryDirectory(prefix=MARK, dir=path.parent) as beside:
        document, *textures = _made(world, Path(beside), path, segments, plane)
        places = [path.parent / texture.relative_to(beside) for texture in textures]
        with new_file(path) as file:
            shutil.copyfile(document, file)
            for texture, place in zip(textures, places):
                place.parent.mkdir(exist_ok=True)
                put(texture, place)
    return [path, *places]


def _made(world: World, folder: Path, path: Path, segments: int, plane: float) -> List[Path]:
    """The document and its textures, in a temporary folder."""
    from pxr import Sdf, Tf, UsdUtils

    packed = path.suffix == ".usdz"
    inside = folder / (f"{path.stem}.usdc" if packed else path.name)
    try:
        written = _Writer(world, inside, segments, plane).written
        if not packed:
            return written
        if UsdUtils.CreateNewUsdzPackage(Sdf.AssetPath(str(inside)), str(folder / path.name)):
            return [folder / path.name]
    except Tf.ErrorException as error:
        raise OSError(f"cannot write {path}: {' '.join(str(error).split())}") from None
    raise OSError(f"cannot write {path}: the package cannot be made; is the disk full?")


def _need() -> None:
    try:
        import PIL.Image  # noqa: F401
        import pxr.Usd  # noqa: F401
    except ImportError:
        raise UnsupportedError("USD files need usd-core and Pillow: pip install 'mimo[usd]'") from None


class _Writer:
    def __init__(self, world: World, path: Path, segments: int, plane: float) -> None:
        from pxr import Usd, UsdGeom

        self._world, self._path, self.written = world, path, [path]
        self._textures: Dict[int, str] = {}
        self._stage = Usd.Stage.CreateNew(str(path))
        UsdGeom.SetStageUpAxis(self._stage, UsdGeom.Tokens.z)
        UsdGeom.SetStageMetersPerUnit(self._stage, 1.0)
        root = UsdGeom.Xform.Define(self._stage, "/World")
        self._stage.SetDefaultPrim(root.GetPrim())
        Usd.ModelAPI(root).SetKind("component")
        self._bodies = self._add_bodies()
        self._add_geoms(segments, plane)
        self._add_lights()
        self._stage.GetRootLayer().Save()

    def _add_bodies(self) -> List[str]:
        from pxr import Gf, UsdGeom

        poses, paths = self._world.poses(Kind.BODY), []
        for body, name in enumerate(self._world.bodies().names):
            node = UsdGeom.Xform.Define(self._stage, f"/World/{_identifier(name, 'body', body)}")
            node.AddTranslateOp().Set(Gf.Vec3d(*poses.positions[body].tolist()))
            w, x, y, z = poses.rotations[body].tolist()
            node.AddOrientOp().Set(Gf.Quatf(w, x, y, z))
            paths.append(str(node.GetPath()))
        return paths

    def _add_geoms(self, segments: int, plane: float) -> None:
        names = self._world.geoms().names
        owners, positions, rotations = on_bodies(self._world)
        for geom, owner in enumerate(owners):
            material = self._world.appearance(geom)
            if material.visible:
                path = f"{self._bodies[owner]}/{_identifier(names[geom], 'geom', geom)}"
                mesh = self._world.mesh(geom, segments=segments, plane=plane)
                if material.texture >= 0:
                    texcoords = places(self._world.texture(material.texture), mesh.texcoords)
                    mesh = replace(mesh, texcoords=texcoords)
                self._add_mesh(path, mesh, positions[geom], rotations[geom])
                self._add_material(path, material)

    def _add_mesh(self, path: str, mesh: Mesh, place: Any, rotation: Any) -> None:
        from pxr import Sdf, UsdGeom, Vt

        shape = UsdGeom.Mesh.Define(self._stage, path)
        points = np.ascontiguousarray(placed(place, rotation, mesh.positions), np.float32)
        normals = np.ascontiguousarray(turned(rotation, mesh.normals), np.float32)
        texcoords = np.ascontiguousarray(np.stack([mesh.texcoords[:, 0], 1 - mesh.texcoords[:, 1]], axis=1), np.float32)
        shape.CreatePointsAttr(Vt.Vec3fArray.FromNumpy(points))
        shape.CreateNormalsAttr(Vt.Vec3fArray.FromNumpy(normals))
        shape.SetNormalsInterpolation(UsdGeom.Tokens.vertex)
        shape.CreateFaceVertexCountsAttr(Vt.IntArray.FromNumpy(np.full(len(mesh.triangles), 3, np.int32)))
        shape.CreateFaceVertexIndicesAttr(Vt.IntArray.FromNumpy(mesh.triangles.astype(np.int32).ravel()))
        shape.CreateSubdivisionSchemeAttr(UsdGeom.Tokens.none)
        shape.CreateExtentAttr(Vt.Vec3fArray.FromNumpy(np.stack([points.min(axis=0), points.max(axis=0)])))
        primvar = UsdGeom.PrimvarsAPI(shape).CreatePrimvar(
            "st", Sdf.ValueTypeNames.TexCoord2fArray, UsdGeom.Tokens.vertex
        )
        primvar.Set(Vt.Vec2fArray.FromNumpy(texcoords))

    def _add_material(self, path: str, look: Appearance) -> None:
        from pxr import Gf, Sdf, UsdShade

        material = UsdShade.Material.Define(self._stage, f"{path}/material")
        surface = UsdShade.Shader.Define(self._stage, f"{path}/material/surface")
        surface.CreateIdAttr("UsdPreviewSurface")
        surface.CreateInput("roughness", Sdf.ValueTypeNames.Float).Set(roughness(look))
        surface.CreateInput("metallic", Sdf.ValueTypeNames.Float).Set(0.0)
        surface.CreateInput("opacity", Sdf.ValueTypeNames.Float).Set(look.color[3])
        color = linear(look.color[:3])
        for name, strength in (("diffuseColor", 1.0), ("emissiveColor", look.emission)):
            wanted = surface.CreateInput(name, Sdf.ValueTypeNames.Color3f)
            amount = (color * strength).tolist()
            if look.texture < 0 or strength == 0:
                wanted.Set(Gf.Vec3f(*amount))
            else:
                wanted.ConnectToSource(self._reader(f"{path}/material", name, look.texture, amount))
        material.CreateSurfaceOutput().ConnectToSource(surface.ConnectableAPI(), "surface")
        shape = self._stage.GetPrimAtPath(path)
        UsdShade.MaterialBindingAPI.Apply(shape).Bind(material)

    def _reader(self, path: str, name: str, texture: int, amount: List[float]) -> Any:
        """A shader of a texture times a colour."""
        from pxr import Gf, Sdf, UsdShade

        reader = UsdShade.Shader.Define(self._stage, f"{path}/places")
        reader.CreateIdAttr("UsdPrimvarReader_float2")
        reader.CreateInput("varname", Sdf.ValueTypeNames.String).Set("st")
        image = UsdShade.Shader.Define(self._stage, f"{path}/{name}")
        image.CreateIdAttr("UsdUVTexture")
        image.CreateInput("file", Sdf.ValueTypeNames.Asset).Set(Sdf.AssetPath(self._texture(texture)))
        image.CreateInput("sourceColorSpace", Sdf.ValueTypeNames.Token).Set("sRGB")
        for side in ("wrapS", "wrapT"):
            image.CreateInput(side, Sdf.ValueTypeNames.Token).Set("repeat")
        image.CreateInput("scale", Sdf.ValueTypeNames.Float4).Set(Gf.Vec4f(*amount, 1.0))
        found = reader.CreateOutput("result", Sdf.ValueTypeNames.Float2)
        image.CreateInput("st", Sdf.ValueTypeNames.Float2).ConnectToSource(found)
        return image.CreateOutput("rgb", Sdf.ValueTypeNames.Float3)

    def _texture(self, number: int) -> str:
        from PIL import Image

        if number not in self._textures:
            folder = self._path.parent / f"{self._path.stem}_textures"
            folder.mkdir(exist_ok=True)
            file = folder / f"{number}.png"
            texture = self._world.texture(number)
            assert texture.type is not TextureType.SKY  # a name that no geom has
            Image.fromarray(picture(texture)).save(file)
            self.written.append(file)
            self._textures[number] = f"./{folder.name}/{file.name}"
        return self._textures[number]

    def _add_lights(self) -> None:
        """Adds the lights. MuJoCo's have no units; white things near infants get the same brightness."""
        from pxr import UsdLux

        head = self._world.light()
        dome = UsdLux.DomeLight.Define(self._stage, "/World/around")  # half: the camera's light reaches one side
        _set_light(dome, head.ambient + head.diffuse / 2, 1.0)
        for number, light in enumerate(self._world.light_sources()):
            if light.active:
                self._add_light(f"/World/light_{number}", light)

    def _add_light(self, path: str, light: Light) -> None:
        from pxr import Gf, UsdGeom, UsdLux

        if light.directional:
            lamp = UsdLux.DistantLight.Define(self._stage, path)
            lamp.CreateNormalizeAttr(True)
            _set_light(lamp, light.diffuse, np.pi)
        else:
            lamp = UsdLux.SphereLight.Define(self._stage, path)
            lamp.CreateRadiusAttr(LAMP)
            _set_light(lamp, light.diffuse, max(float(np.linalg.norm(light.position)), LAMP) ** 2 / LAMP**2)
        if not light.directional and light.cutoff < 90:
            UsdLux.ShapingAPI.Apply(lamp.GetPrim()).CreateShapingConeAngleAttr(light.cutoff)
        node = UsdGeom.Xformable(lamp)
        node.AddTranslateOp().Set(Gf.Vec3d(*light.position.tolist()))
        turn = Gf.Rotation(Gf.Vec3d(0, 0, -1), Gf.Vec3d(*light.direction.tolist())).GetQuat()  # lamps shine along -z
        node.AddOrientOp().Set(Gf.Quatf(turn))


def _set_light(light: Any, color: Any, intensity: float) -> None:
    from pxr import Gf

    strongest = float(max(np.max(color), 1e-6))
    light.CreateColorAttr(Gf.Vec3f(*(np.asarray(color) / strongest).tolist()))
    light.CreateIntensityAttr(strongest * intensity)


def _identifier(name: str, kind: str, number: int) -> str:
    from pxr import Tf

    return f"{Tf.MakeValidIdentifier(name or kind)}_{number}"
