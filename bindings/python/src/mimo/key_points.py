"""Key points of videos and marker sets: their places on an infant, their tables, and cameras.

A table has a column `time` in s, and for each point NAME:x, NAME:y, NAME:z in m, world frame, or NAME:u, NAME:v in
pixels from the upper left corner; NAME:w is its confidence, 0 to 1. An empty cell is an unseen point. Tables of
DeepLabCut and folders of OpenPose have no times: their frames a second have to be given.
"""

from __future__ import annotations

import csv
import json
from collections import Counter
from pathlib import Path
from typing import Dict, List, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike

from ._files import new_file
from .constants import Kind, Quantity
from .drawing import prefixes
from .errors import NotFoundError
from .frames import inverse, turned
from .pose_tables import Tracks, common_names, is_deeplabcut, read_deeplabcut, read_openpose
from .results import Numbers
from .world import World

# Common names of key points at joints, and the bodies that begin there.
JOINTS = {
    "shoulder": "upper_arm",
    "elbow": "lower_arm",
    "wrist": "hand",
    "hip": "upper_leg",
    "knee": "lower_leg",
    "ankle": "foot",
}
# On the head, in radii of its sphere from the centre: forward, left, up.
FACE = {"nose": (1.0, 0.0, -0.15), "left_ear": (0.0, 1.0, 0.0), "right_ear": (0.0, -1.0, 0.0)}

Place = Tuple[str, Union[Sequence[float], Numbers]]


class KeyPoints(NamedTuple):
    """Times of n rows, names of k points, their values (n, k, 3), m, or (n, k, 2), pixels, and weights (n, k)."""

    times: Numbers
    names: List[str]
    values: Numbers  # NaN for unseen points
    weights: Numbers  # 0 for unseen points
    left_out: Tuple[str, ...] = ()  # names in the file that have no place on the infant


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

    @classmethod
    def read(cls, path: str) -> "Camera":
        """From JSON: {"matrix": 3 rows of 4}, or the arguments of `pinhole`."""
        with open(path, encoding="utf-8") as file:
            try:
                given = json.load(file)
                return cls(given["matrix"]) if "matrix" in given else cls.pinhole(**given)
            except RecursionError:
                raise ValueError(f"{path} is not a camera: it is nested too deeply") from None
            except (ValueError, TypeError, KeyError) as error:
                raise ValueError(f"{path} is not a camera: {error}") from None

    def project(self, points: Numbers) -> Numbers:
        """Pixels (k, 2) of points (k, 3)."""
        seen = points @ self.matrix[:, :3].T + self.matrix[:, 3]
        return np.asarray(seen[:, :2] / seen[:, 2:])

    def slopes(self, points: Numbers) -> Numbers:
        """Derivatives of the pixels by the points: (k, 2, 3)."""
        linear = self.matrix[:, :3]
        depth = points @ linear[2] + self.matrix[2, 3]
        return np.asarray((linear[:2] - self.project(points)[:, :, None] * linear[2]) / depth[:, None, None])


def places_of(world: World, names: Sequence[str], own: Dict[str, Place], agent: int = 0) -> Tuple[List[int], Numbers]:
    """The body of each point, and the point in that body's frame.

    Names are keys of `own`, bodies, or common names: left_shoulder, ..., nose, left_ear; "left_eye" is a body.
    """
    lead = list(prefixes(world))[agent] if world.agents else ""
    bodies, offsets = [], []
    for name in names:
        body, offset = own[name] if name in own else _usual(world, lead, name)
        try:
            bodies.append(world.find(Kind.BODY, lead + body))
        except NotFoundError as error:
            usual = ", ".join(f"left_{joint}" for joint in JOINTS)
            raise ValueError(f"the infant has no place for the key point {name!r}: {error}; or {usual}, nose") from None
        offsets.append(np.asarray(offset, np.float64))
    return bodies, np.array(offsets).reshape(-1, 3)


def _usual(world: World, lead: str, name: str) -> Place:
    side, _, joint = name.partition("_")
    if name in FACE:
        middle = world.get(Quantity.GEOM_POSITION, [f"{lead}head"])[0]
        body = world.get(Quantity.BODY_POSE, [f"{lead}head"])[0]
        radius = world.get(Quantity.GEOM_SIZE, [f"{lead}head"])[0, 0]
        return "head", turned(inverse(body[3:]), middle - body[:3])[0] + radius * np.array(FACE[name])
    if side in ("left", "right") and joint in JOINTS:
        return _end_of_parent(world, f"{lead}{side}_{JOINTS[joint]}", lead)
    return name, (0, 0, 0)


def _end_of_parent(world: World, body: str, lead: str) -> Place:
    """The start of a body as a point of its parent, so that a hand's rotation does not move the wrist."""
    number = world.find(Kind.BODY, body)
    hinges = np.flatnonzero(world.joints().body_ids == number).tolist()
    parent = world.name(Kind.BODY, int(world.bodies().body_ids[number]))
    angles = world.get(Quantity.JOINT_POSITION, hinges).ravel()
    world.set(Quantity.JOINT_POSITION, np.zeros(len(hinges)), hinges)
    pose, at = world.get(Quantity.BODY_POSE, [parent, body], now=True)
    world.set(Quantity.JOINT_POSITION, angles, hinges)
    return parent[len(lead) :], turned(inverse(pose[3:]), at[:3] - pose[:3])[0]


def read_points(path: str, rate: Optional[float] = None) -> KeyPoints:
    """A table of key points; a ValueError names the wrong line and column.

    Tables of DeepLabCut and folders of OpenPose need `rate`, their frames a second. Names with capitals, as those of
    SMIL (`leftThigh`), are taken for the points that they mean; what has no place on the infant is left out.
    """
    if Path(path).is_dir() or is_deeplabcut(path):
        return _of_video(path, read_openpose(path) if Path(path).is_dir() else read_deeplabcut(path), rate)
    if rate is not None:
        raise ValueError(f"rate is {rate:g}, but {path} has times itself")
    points = _read_table(path)
    if not any(letter.isupper() for name in points.names for letter in name):
        return points
    return _chosen(path, points)


def _of_video(path: str, tracks: Tracks, rate: Optional[float]) -> KeyPoints:
    if rate is None or not 0 < rate < float("inf"):
        raise ValueError(f"{path} has no times, and rate is {rate}, expected its frames a second, more than 0")
    times = np.arange(len(tracks.pixels)) / rate
    return _chosen(path, KeyPoints(times, tracks.names, tracks.pixels, tracks.confidence))


def _chosen(path: str, points: KeyPoints) -> KeyPoints:
    """The points whose names are known, by the names that they have here."""
    common = common_names(points.names)
    if not common:
        raise ValueError(f"{path}: no name is known, of {', '.join(points.names)}")
    kept = [points.names.index(name) for name in common]
    left_out = tuple(name for name in points.names if name not in common)
    return KeyPoints(points.times, list(common.values()), points.values[:, kept], points.weights[:, kept], left_out)


def _read_table(path: str) -> KeyPoints:
    lines = _cells(path)
    header = [cell.strip() for cell in lines[0]] if lines else []
    if "time" not in header:
        raise ValueError(f"{path} has no column 'time'")
    twice = [name for name, count in Counter(header).items() if count > 1]
    if twice:
        raise ValueError(f"{path}, line 1: column {twice[0]!r} appears twice")
    if len(header) == 1:
        raise ValueError(f"{path} has no key points, expected columns NAME:x, NAME:y, NAME:z or NAME:u, NAME:v")
    rows = [_row(path, number + 2, header, cells) for number, cells in enumerate(lines[1:]) if cells]
    if not rows:
        raise ValueError(f"{path}: no rows of numbers follow the header")
    columns = dict(zip(header, np.array(rows).T))
    times = columns.pop("time")
    if not (np.diff(times) > 0).all() or np.isnan(times).any():
        raise ValueError(f"{path}: time does not increase in row {1 + int(np.argmin(np.diff(times) > 0)) + 1}")
    names = list(dict.fromkeys(column.rpartition(":")[0] or column for column in columns))
    parts = "xyz" if any(column.endswith(":x") for column in columns) else "uv"
    return _points(path, times, names, parts, columns)


def _cells(path: str) -> List[List[str]]:
    """Cells between commas, or between semicolons or tabs with decimal commas, as in `mimo replay`."""
    with open(path, newline="", encoding="utf-8-sig") as file:
        unquoted = "".join(file.readline().split('"')[::2])
        separator = next((one for one in ",;\t" if one in unquoted), ",")
        file.seek(0)
        reader = csv.reader(file, delimiter=separator, strict=True, skipinitialspace=True)
        try:
            lines = list(reader)
        except csv.Error as error:
            raise ValueError(f"{path}, line {reader.line_num}: {error}") from None
    if separator == ",":
        return lines
    return lines[:1] + [[cell.replace(",", ".") for cell in line] for line in lines[1:]]


def _row(path: str, line: int, header: List[str], cells: List[str]) -> List[float]:
    if len(cells) != len(header):
        raise ValueError(f"{path}, line {line}: expected {len(header)} cells as the header has, found {len(cells)}")
    row = []
    for name, cell in zip(header, cells):
        try:
            row.append(float(cell.replace("_", "?")) if cell.strip() else np.nan)  # 1_0 is a typing error here, not 10
        except ValueError:
            raise ValueError(f"{path}, line {line}: column {name!r} should be a number, not {cell!r}") from None
        if np.isinf(row[-1]) or (name.endswith(":w") and row[-1] < 0):
            least = "a weight of 0 or more" if name.endswith(":w") else "a finite number"
            raise ValueError(f"{path}, line {line}: column {name!r} is {cell.strip()}, expected {least}")
    return row


def _points(path: str, times: Numbers, names: List[str], parts: str, columns: Dict[str, Numbers]) -> KeyPoints:
    values, weights = [], []
    for name in names:
        wanted = [f"{name}:{part}" for part in parts]
        missing = [column for column in wanted if column not in columns]
        if missing:
            raise ValueError(f"{path} has no column {missing[0]!r}, expected {', '.join(wanted)}")
        values.append(np.column_stack([columns.pop(column) for column in wanted]))
        weights.append(columns.pop(f"{name}:w", np.ones(len(times))))
    if columns:
        raise ValueError(f"{path}: column {next(iter(columns))!r} is not :{', :'.join(parts)} or :w of a point")
    value, weight = np.stack(values, 1), np.stack(weights, 1)
    seen = np.isfinite(value).all(axis=2) & (np.nan_to_num(weight) > 0)
    return KeyPoints(times, names, np.where(seen[:, :, None], value, np.nan), np.where(seen, weight, 0))


def write_table(path: str, names: Sequence[str], rows: Union[Numbers, Sequence[Sequence[float]]]) -> None:
    """Numbers with all their digits; NaN becomes an empty cell."""
    with new_file(path) as beside, open(beside, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(names)
        for row in rows:
            writer.writerow(["" if np.isnan(value) else repr(float(value)) for value in row])
