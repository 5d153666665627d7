"""A world's shapes, materials, textures, lights and poses, for programs that draw it themselves."""

from __future__ import annotations

import ctypes
from dataclasses import dataclass
from typing import Any, List, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _abi
from ._library import LIB, check, defaults, from_struct, result
from .access import Access
from .arguments import real_number, whole_number
from .constants import HEADLIGHT, Axes, Kind, TextureType

Floats = NDArray[np.float32]
AxesOf = Union[Axes, int, str]  # "unity" as well


@dataclass(frozen=True, eq=False)
class Mesh:
    """A geom as triangles, in the geom's own frame."""

    positions: Floats  # n x 3
    normals: Floats  # n x 3, unit vectors
    texcoords: Floats  # n x 2; (0, 0) is where the texture's first row begins
    triangles: NDArray[np.uint32]  # m x 3, vertex indices in the engine's winding order for front faces


@dataclass(frozen=True)
class Appearance:
    """Look of a geom."""

    visible: bool  # MuJoCo would draw it
    group: int
    texture: int  # -1: none
    color: Tuple[float, float, float, float]  # red, green, blue, opacity; times the texture's
    emission: float
    specular: float
    shininess: float  # Phong's exponent is 128 times this
    reflectance: float


@dataclass(frozen=True, eq=False)
class Texture:
    """A texture; the six pictures of a cube are stacked."""

    type: TextureType
    pixels: NDArray[np.uint8]  # height x width x 4: red, green, blue, 255


@dataclass(frozen=True, eq=False)
class Light:
    """The current state of a light."""

    active: bool
    directional: bool
    casts_shadow: bool
    cutoff: float  # half angle of its cone, degrees
    exponent: float
    position: Floats
    direction: Floats
    ambient: Floats  # red, green, blue, like the next two
    diffuse: Floats
    specular: Floats
    attenuation: Floats  # 1 / (a0 + a1 d + a2 d^2) at a distance of d metres


@dataclass(frozen=True, eq=False)
class Poses:
    """Poses of all elements of a kind."""

    positions: Floats  # n x 3
    rotations: Floats  # n x 4: w x y z in the library's axes, x y z w in all others


class Geometry(Access):
    """Base of worlds, for programs that draw them; see docs/engines.md."""

    def _geom(self, geom: Union[int, str]) -> int:
        return self.find(Kind.GEOM, geom) if isinstance(geom, str) else _int32("geom", geom)

    def mesh(self, geom: Union[int, str], axes: AxesOf = Axes.MIMO, segments: int = 24, plane: float = 20.0) -> Mesh:
        """A geom as triangles. segments: pieces of a circle; plane: half the size of endless planes, m."""
        mesh = defaults(_abi.Mesh)
        mesh.axes, mesh.segments = whole_number("axes", axes, Axes), _uint32("segments", segments)
        mesh.plane, number = real_number("plane", plane), self._geom(geom)
        check(LIB.mimo_env_mesh(self._names_handle, number, mesh))
        vertices, triangles = mesh.vertex_count, mesh.index_count // 3
        made = Mesh(
            np.empty((vertices, 3), np.float32),
            np.empty((vertices, 3), np.float32),
            np.empty((vertices, 2), np.float32),
            np.empty((triangles, 3), np.uint32),
        )
        mesh.positions, mesh.normals = made.positions.ctypes.data, made.normals.ctypes.data
        mesh.texcoords, mesh.indices = made.texcoords.ctypes.data, made.triangles.ctypes.data
        mesh.vertex_capacity, mesh.index_capacity = vertices, made.triangles.size
        check(LIB.mimo_env_mesh(self._names_handle, number, mesh))
        return made

    def meshes(self, axes: AxesOf = Axes.MIMO, segments: int = 24, plane: float = 20.0) -> List[Mesh]:
        """All geoms as triangles, in the order of their ids."""
        return [self.mesh(geom, axes, segments, plane) for geom in range(self.count(Kind.GEOM))]

    def appearance(self, geom: Union[int, str]) -> Appearance:
        """The current look of a geom."""
        raw = _abi.Appearance()
        check(LIB.mimo_env_appearance(self._names_handle, self._geom(geom), raw))
        return from_struct(Appearance, raw)

    @property
    def texture_count(self) -> int:
        """The number of textures; ids are 0 to texture_count - 1."""
        return int(result(ctypes.c_size_t, LIB.mimo_env_texture_count, self._names_handle))

    def texture(self, texture: int) -> Texture:
        """A texture as pixels."""
        raw, number = _abi.Texture(), _int32("texture", texture)
        check(LIB.mimo_env_texture(self._names_handle, number, raw))
        pixels = np.empty((raw.height, raw.width, 4), np.uint8)
        raw.pixels, raw.pixel_bytes = pixels.ctypes.data, pixels.size
        check(LIB.mimo_env_texture(self._names_handle, number, raw))
        return Texture(TextureType(raw.type), pixels)

    def light(self, light: int = HEADLIGHT, axes: AxesOf = Axes.MIMO) -> Light:
        """A light, or the one that every camera carries."""
        raw = _abi.Light(axes=whole_number("axes", axes, Axes))
        check(LIB.mimo_env_light(self._names_handle, _int32("light", light), raw))
        return from_struct(Light, raw)

    def light_sources(self, axes: AxesOf = Axes.MIMO) -> List[Light]:
        """All lights except the headlight."""
        return [self.light(light, axes) for light in range(self.count(Kind.LIGHT))]

    def poses(self, kind: Kind = Kind.GEOM, axes: AxesOf = Axes.MIMO) -> Poses:
        """Current poses of all bodies, geoms, sites or cameras."""
        number, frame = whole_number("kind", kind, Kind), whole_number("axes", axes, Axes)
        all_of = np.empty((self.count(kind), 7), np.float32)
        check(LIB.mimo_env_poses(self._names_handle, number, frame, all_of.ctypes.data, all_of.size))
        return Poses(all_of[:, :3], all_of[:, 3:])


def converted(function: Any, name: str, width: int, values: ArrayLike, axes: AxesOf) -> Floats:
    """A copy of rows of numbers, converted by a function of the library."""
    rows = np.array(values, np.float32, order="C")
    if rows.ndim == 0 or rows.shape[-1] != width:
        raise ValueError(f"{name} has the shape {rows.shape}, expected rows of {width} numbers")
    check(function(whole_number("axes", axes, Axes), rows.ctypes.data, rows.size // width))
    return rows


def _int32(name: str, value: Any) -> int:
    return _within(name, value, -(2**31), 2**31 - 1)


def _uint32(name: str, value: Any) -> int:
    return _within(name, value, 0, 2**32 - 1)


def _within(name: str, value: Any, low: int, high: int) -> int:
    """A number in a range; ctypes would silently wrap it."""
    number = whole_number(name, value)
    if not low <= number <= high:
        raise ValueError(f"{name} is {value!r}, expected {low} to {high}")
    return number
