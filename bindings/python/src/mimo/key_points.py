"""Key points of videos and marker sets, and the cameras that saw them, as files of `mimo replay --motion`."""

from __future__ import annotations

import csv
import json
from typing import List, NamedTuple, Sequence, Union

import numpy as np
from numpy.typing import ArrayLike

from ._files import new_file
from .results import Numbers


class KeyPoints(NamedTuple):
    """Times of n rows, names of k points, their values (n, k, 3), m, or (n, k, 2), pixels, and weights (n, k).

    Names are those of docs/guide/motion.md: left_shoulder, ..., nose, and bodies.
    """

    times: Numbers
    names: List[str]
    values: Numbers  # NaN for unseen points
    weights: Numbers  # 0 for unseen points

    def write(self, path: str) -> None:
        """A table for `mimo replay --motion`."""
        values, weights = np.asarray(self.values, np.float64), np.asarray(self.weights, np.float64)
        count = len(self.names)
        if values.shape[:2] != (len(self.times), count) or values.ndim != 3 or values.shape[2] not in (2, 3):
            raise ValueError(f"values has the shape {values.shape}, expected ({len(self.times)}, {count}, 2 or 3)")
        if weights.shape != values.shape[:2]:
            raise ValueError(f"weights has the shape {weights.shape}, expected {values.shape[:2]}")
        parts = "uvw" if values.shape[2] == 2 else "xyzw"
        columns = np.concatenate([values, weights[:, :, None]], axis=2).reshape(len(values), -1)
        names = ["time", *(f"{name}:{part}" for name in self.names for part in parts)]
        write_table(path, names, np.column_stack([self.times, columns]))


class Camera:
    """A camera by its matrix, 3 x 4, from the world to pixels: matrix @ (x, y, z, 1) = s (u, v, 1), s > 0 in front."""

    def __init__(self, matrix: ArrayLike) -> None:
        self.matrix = np.asarray(matrix, np.float64)
        if self.matrix.shape != (3, 4) or not np.isfinite(self.matrix).all():
            raise ValueError(f"matrix has the shape {self.matrix.shape}, expected 3 x 4 finite numbers")
        if np.linalg.matrix_rank(self.matrix) < 3:
            raise ValueError(f"matrix is {self.matrix.tolist()}, expected three independent rows")

    @classmethod
    def pinhole(
        cls, fovy: float, width: int, height: int, position: ArrayLike, look_at: ArrayLike, up: ArrayLike = (0, 0, 1)
    ) -> "Camera":
        """A camera without distortion; `fovy` is its vertical field of view, degrees."""
        if not 0 < fovy < 180:
            raise ValueError(f"fovy is {fovy}, expected more than 0 and less than 180 degrees")
        at = np.asarray(position, np.float64)
        forward = np.asarray(look_at, np.float64) - at
        right = np.cross(forward, np.asarray(up, np.float64))
        if np.linalg.norm(right) < 1e-9:
            raise ValueError(
                f"look_at {look_at!r} lies along up from position {position!r}, expected another direction"
            )
        forward, right = forward / np.linalg.norm(forward), right / np.linalg.norm(right)
        rotation = np.stack([right, np.cross(forward, right), forward])
        focal = 0.5 * height / np.tan(np.radians(fovy) / 2)
        inner = np.array([[focal, 0, width / 2], [0, focal, height / 2], [0, 0, 1]])
        return cls(inner @ np.column_stack([rotation, -rotation @ at]))

    def write(self, path: str) -> None:
        """The file that `mimo replay --camera` reads."""
        with new_file(path) as beside:
            beside.write_text(json.dumps({"matrix": self.matrix.tolist()}), encoding="utf-8")

    def project(self, points: Numbers) -> Numbers:
        """Pixels (k, 2) of points (k, 3)."""
        seen = points @ self.matrix[:, :3].T + self.matrix[:, 3]
        return np.asarray(seen[:, :2] / seen[:, 2:])


def write_table(path: str, names: Sequence[str], rows: Union[Numbers, Sequence[Sequence[float]]]) -> None:
    """Numbers with all their digits; NaN becomes an empty cell."""
    with new_file(path) as beside, open(beside, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(names)
        for row in rows:
            writer.writerow(["" if np.isnan(value) else repr(float(value)) for value in row])
