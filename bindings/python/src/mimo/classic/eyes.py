"""Eyesight by age and enlarged centres of pictures, as mimo_infant's `acuity` and `foveation` say."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..maturity import Maturity


def blur_of(age: float) -> float:
    """The cycles per degree that keep half their contrast for the eyesight of an age in months.

    There contrast falls as (10 f)^b, b = -2 / (1 + log10 of the finest visible lines), so that those keep 1 %.
    """
    finest = Maturity.at(min(max(age, 0.0), 24.0)).acuity
    return float(0.1 * 2 ** ((1 + np.log10(finest)) / 2))


class Fovea:
    """Enlarges the middle of a picture: a distance r from it shows what was at R (e^(r/R log(1 + s)) - 1) / s.

    s is the strength, R half of the picture's diagonal.
    """

    def __init__(self, width: int, height: int, strength: float) -> None:
        middle = np.array([height, width]) / 2
        away = np.indices((height, width)) - middle[:, None, None]
        reach, distance = np.linalg.norm(middle), np.linalg.norm(away, axis=0)
        source = reach * np.expm1(distance / reach * np.log1p(strength)) / strength
        scale = np.divide(source, distance, out=np.zeros_like(source), where=distance > 0)
        places = np.clip(middle[:, None, None] + away * scale, 0, np.array([height - 1, width - 1])[:, None, None])
        self._first = np.floor(places).astype(np.intp)
        self._next = np.minimum(self._first + 1, np.array([height - 1, width - 1])[:, None, None])
        self._share = (places - self._first)[..., None]

    def seen(self, picture: NDArray[np.uint8]) -> NDArray[np.uint8]:
        """The picture, with its middle enlarged."""
        (y, x), (below, beside), (down, right) = self._first, self._next, self._share
        upper = picture[y, x] * (1 - right) + picture[y, beside] * right
        lower = picture[below, x] * (1 - right) + picture[below, beside] * right
        mixed: Any = upper * (1 - down) + lower * down
        return np.rint(mixed).astype(np.uint8)
