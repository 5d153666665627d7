"""Cubes' textures for programs that draw them with mipmaps.

A cube's six faces are stacked in one picture. In its smaller mipmaps a face's border mixes with the next face, which
shows as seams. So each face gets a margin.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .constants import TextureType
from .geometry import Texture

FACES = 6
PARTS = 8  # share of a face: mipmaps down to an eighth of the size show no seams


def _margin(texture: Texture) -> int:
    edge = texture.pixels.shape[1]
    return edge // PARTS if texture.type is TextureType.CUBE and texture.pixels.shape[0] == FACES * edge else 0


def picture(texture: Texture) -> NDArray[np.uint8]:
    """A texture's pixels, red, green and blue; a cube's faces get margins that repeat their borders."""
    pixels, margin = texture.pixels[..., :3], _margin(texture)
    if margin == 0:
        return pixels
    faces = pixels.reshape(FACES, pixels.shape[1], pixels.shape[1], 3)
    around = ((0, 0), (margin, margin), (margin, margin), (0, 0))
    return np.pad(faces, around, mode="edge").reshape(-1, pixels.shape[1] + 2 * margin, 3)


def places(texture: Texture, texcoords: NDArray[np.float32]) -> NDArray[np.float32]:
    """A mesh's texture coordinates in that picture."""
    margin = _margin(texture)
    if margin == 0:
        return texcoords
    edge = texture.pixels.shape[1]
    across, down = texcoords[:, 0], texcoords[:, 1] * FACES
    face = np.clip(np.floor(down), 0, FACES - 1)
    inside = (margin + np.stack([across, down - face], axis=1) * edge) / (edge + 2 * margin)
    return np.stack([inside[:, 0], (face + inside[:, 1]) / FACES], axis=1).astype(np.float32)
