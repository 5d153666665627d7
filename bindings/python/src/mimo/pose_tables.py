"""Key points as programs of pose estimation write them: DeepLabCut's tables and OpenPose's folders; and their names.

Names of SMIL's 25 joints, of MINI-RGBD, OpenPose, DeepLabCut's users and Plug-in Gait become those of mimo.motion.
"""

from __future__ import annotations

import csv
import json
import re
from pathlib import Path
from typing import Any, Dict, List, NamedTuple, Sequence

import numpy as np
from numpy.typing import NDArray

# Names without their side, in small letters.
OF_SIDES: Dict[str, Sequence[str]] = {
    "shoulder": ("shoulder", "sho", "shld", "acromion", "upperarm", "arm"),
    "elbow": ("elbow", "elb", "forearm", "lowerarm"),
    "wrist": ("wrist", "wri", "wra", "wrb", "hand"),
    "hip": ("hip", "hjc", "upleg", "thigh", "upperleg"),
    "knee": ("knee", "kne", "calf", "leg", "lowerleg", "shin"),
    "ankle": ("ankle", "ank", "foot"),
    "toes": ("toes", "toe", "bigtoe", "toebase"),
    "eye": ("eye",),
    "ear": ("ear",),
    "fingers": ("fingers",),
}
NOSE = ("nose", "nosevertex")
CLAVICLES = ("leftshoulder", "rightshoulder")  # where the arms begin at leftUpperArm
BODY_25 = [
    "Nose",
    "Neck",
    "RShoulder",
    "RElbow",
    "RWrist",
    "LShoulder",
    "LElbow",
    "LWrist",
    "MidHip",
    "RHip",
    "RKnee",
    "RAnkle",
    "LHip",
    "LKnee",
    "LAnkle",
    "REye",
    "LEye",
    "REar",
    "LEar",
    "LBigToe",
    "LSmallToe",
    "LHeel",
    "RBigToe",
    "RSmallToe",
    "RHeel",
]
COCO_18 = [name for name in BODY_25[:19] if name != "MidHip"]
PEOPLE = {3 * len(names): names for names in (BODY_25, COCO_18)}


class Tracks(NamedTuple):
    """Pixels (n, k, 2) of k points in n frames, NaN where they were not found, and their confidence (n, k)."""

    names: List[str]
    pixels: NDArray[np.float64]
    confidence: NDArray[np.float64]


def common_names(names: Sequence[str]) -> Dict[str, str]:
    """The names that have a place on the infant: "LBigToe" is "left_toes". Others are left out."""
    arms = any(_plain(name) in ("leftupperarm", "leftarm") for name in names)
    found: Dict[str, str] = {}
    for name in names:
        common = "" if arms and _plain(name) in CLAVICLES else _common(_plain(name))
        if common and common not in found.values():
            found[name] = common
    return found


def _plain(name: str) -> str:
    return re.sub(r"[^a-z0-9]", "", name.rsplit(":", 1)[-1].lower())


def _common(plain: str) -> str:
    if plain in NOSE:
        return "nose"
    for side in ("left", "right"):
        short = side[0]
        for part in (
            plain[len(side) :] if plain.startswith(side) else "",
            plain[: -len(side)] if plain.endswith(side) else "",
            plain[1:] if plain.startswith(short) else "",
        ):
            for point, words in OF_SIDES.items():
                if part in words:
                    return f"{side}_{point}"
    return ""


def is_deeplabcut(path: str) -> bool:
    """Whether a table begins as DeepLabCut's do."""
    if Path(path).is_dir():
        return False
    with open(path, encoding="utf-8-sig", errors="replace") as file:
        return file.readline().startswith("scorer,")


def read_deeplabcut(path: str) -> Tracks:
    """A table of DeepLabCut with one animal: scorer, bodyparts, coords (x, y, likelihood), and a row for each frame."""
    with open(path, newline="", encoding="utf-8-sig") as file:
        lines = list(csv.reader(file))
    heads = {line[0]: line[1:] for line in lines[:4] if line and not line[0][:1].isdigit()}
    if "individuals" in heads:
        raise ValueError(f"{path} has several animals, expected one; export each into a table of its own")
    if list(heads) != ["scorer", "bodyparts", "coords"]:
        raise ValueError(f"{path} begins with {', '.join(heads) or 'numbers'}, expected scorer, bodyparts, coords")
    parts, coords = heads["bodyparts"], heads["coords"]
    names = list(dict.fromkeys(parts))
    columns = [[i for i, part in enumerate(parts) if part == name] for name in names]
    for name, places in zip(names, columns):
        if [coords[i] for i in places if i < len(coords)] != ["x", "y", "likelihood"]:
            raise ValueError(f"{path}, line 3: {name!r} has not x, y, likelihood once each")
    rows = [_row(path, number + 4, line, len(parts)) for number, line in enumerate(lines[3:]) if line]
    if not rows:
        raise ValueError(f"{path}: no rows of numbers follow the header")
    table = np.array(rows)[:, np.array(columns)]
    return _checked(path, names, table)


def _row(path: str, line: int, cells: List[str], width: int) -> List[float]:
    if len(cells) != width + 1:
        raise ValueError(f"{path}, line {line}: {len(cells)} cells, expected {width + 1}")
    row = []
    for cell in cells[1:]:
        try:
            row.append(float(cell.replace("_", "?")) if cell.strip() else np.nan)
        except ValueError:
            raise ValueError(f"{path}, line {line}: a cell is {cell!r}, expected a number") from None
    return row


def _checked(path: str, names: List[str], table: NDArray[np.float64]) -> Tracks:
    """Of frames x points x (x, y, confidence)."""
    sure = np.nan_to_num(table[:, :, 2])
    if (sure < 0).any() or (sure > 1).any() or np.isinf(table).any():
        frame = int(np.argmax(((sure < 0) | (sure > 1) | np.isinf(table).any(axis=2)).any(axis=1)))
        raise ValueError(f"{path}, frame {frame}: expected finite pixels and a confidence from 0 to 1")
    seen = np.isfinite(table).all(axis=2) & (sure > 0)
    return Tracks(names, np.where(seen[:, :, None], table[:, :, :2], np.nan), np.where(seen, sure, 0.0))


def read_openpose(folder: str) -> Tracks:
    """A folder of OpenPose: a file *_keypoints.json for each frame, with one person at most (BODY_25 or COCO)."""
    files = sorted(Path(folder).glob("*_keypoints.json"))
    if not files:
        raise ValueError(f"{folder} has no files *_keypoints.json, as OpenPose writes them (--write_json)")
    frames: List[Any] = [_person(file) for file in files]
    kinds = {len(frame) for frame in frames if frame is not None}
    if not kinds:
        raise ValueError(f"{folder}: nobody was found in any of {len(files)} frames")
    if len(kinds) > 1 or not kinds <= set(PEOPLE):
        raise ValueError(
            f"{folder}: {sorted(kinds)} numbers of a person, expected always {' or '.join(map(str, PEOPLE))}"
        )
    (width,) = kinds
    table = np.array([np.zeros(width) if frame is None else frame for frame in frames], np.float64)
    return _checked(folder, PEOPLE[width], table.reshape(len(frames), -1, 3))


def _person(file: Path) -> Any:
    try:
        people = json.loads(file.read_text(encoding="utf-8"))["people"]
        numbers = [np.asarray(person["pose_keypoints_2d"], np.float64) for person in people]
    except (ValueError, KeyError, TypeError, RecursionError) as error:
        raise ValueError(f"{file} is no file of OpenPose: {type(error).__name__} {error}") from None
    if len(numbers) > 1:
        raise ValueError(f"{file} has {len(numbers)} people, expected one at most (--number_people_max 1)")
    return numbers[0] if numbers else None
