"""Shapes as binary glTF files, the page's format for shapes with textures."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..geometry import Appearance, Mesh

ROUGHEST = 0.9


def roughness(material: Appearance) -> float:
    """Roughness from Phong's exponent n = 128 shininess: sqrt(2 / (n + 2))."""
    if material.specular == 0:
        return ROUGHEST
    return float(np.clip(np.sqrt(2 / (128 * material.shininess + 2)), 0.2, ROUGHEST))


def linear(color: Any) -> NDArray[np.float64]:
    """MuJoCo's screen colours as linear light."""
    srgb = np.asarray(color, np.float64)
    light: NDArray[np.float64] = np.where(srgb <= 0.04045, srgb / 12.92, ((srgb + 0.055) / 1.055) ** 2.4)
    return light


def binary(mesh: Mesh, material: Appearance, picture: Any, places: Any, normals: Any) -> bytes:
    """The shape with its vertices at `places`; picture: its texture (PIL), or None."""
    import trimesh

    paint = trimesh.visual.material.PBRMaterial(
        baseColorFactor=np.append(linear(material.color[:3]), material.color[3]),
        baseColorTexture=picture,
        metallicFactor=0.0,
        roughnessFactor=roughness(material),
        alphaMode="BLEND" if material.color[3] < 1 else "OPAQUE",
    )
    texcoords = np.stack([mesh.texcoords[:, 0], 1 - mesh.texcoords[:, 1]], axis=1)  # trimesh flips it back
    shape = trimesh.Trimesh(
        vertices=places,
        faces=mesh.triangles,
        vertex_normals=normals,
        visual=trimesh.visual.TextureVisuals(uv=texcoords, material=paint),
        process=False,
    )
    made: bytes = shape.export(file_type="glb", include_normals=True)
    return made
