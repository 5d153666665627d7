"""Fits an infant to key points of a video (2-D, with its camera) or markers (3-D), as `mimo replay --motion` does.

    found = mimo.motion.fit("film", rate=30, camera=camera)    # a file or folder that `mimo replay --motion` reads
    found = mimo.motion.fit(points, camera, age=6)              # or mimo.motion.KeyPoints
    found.errors                                                # m or pixels: a row per frame, a column per point
    found.write("motion.csv")                                   # for mimo replay --motion, and so for senses

    python -m mimo.motion video.csv --camera camera.json --out motion.csv

The program fits: each frame by least squares over all joints that move the points, within their limits, from the frame
before; and the infant's age, where none is given.
"""

from __future__ import annotations

import argparse
import csv
import json
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any, Dict, List, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np

from ._files import require_writable
from ._library import library_path
from .key_points import Camera, KeyPoints, write_table
from .results import Numbers

__all__ = ["Camera", "Found", "KeyPoints", "fit"]

Place = Tuple[str, Sequence[float]]
File = Union[str, "os.PathLike[str]"]


class Found(NamedTuple):
    """The result of a fit: times (n,), columns of a table for `mimo replay --motion`, their values and the errors."""

    times: Numbers
    columns: List[str]  # joints
    positions: Numbers  # (n, columns), rad and m
    points: List[str]
    errors: Numbers  # (n, points): distance from the observed point, m or pixels; NaN for unseen points
    rms: float  # of all errors
    age: Optional[float]  # months, where it was fitted
    notes: List[str]  # how the points were read

    def write(self, path: str) -> None:
        """A table for `mimo replay --motion`."""
        write_table(path, ["time", *self.columns], np.column_stack([self.times, self.positions]))

    def write_errors(self, path: str) -> None:
        """A row per frame, a column per point."""
        write_table(path, ["time", *self.points], np.column_stack([self.times, self.errors]))


def fit(
    points: Union[KeyPoints, File],
    camera: Union[Camera, File, None] = None,
    *,
    rate: Optional[float] = None,
    scene: str = "free",
    age: Optional[float] = None,
    sex: Optional[str] = None,
    scale: Optional[float] = None,
    up: Optional[str] = None,
    places: Optional[Dict[str, Place]] = None,
    robust: bool = False,
    cutoff: Optional[float] = None,
) -> Found:
    """Fits joint angles, the pose of the body and, without `age`, its age.

    `rate` is the frames a second of files without times; `scale` and `up` are those of markers. `scene` has the first
    pose, near which what no point determines stays. `places` names what points are: {"sock": ("left_foot", (0.03, 0,
    0))}, m, in the body's frame, or {"m1": ("left_elbow", ())}; other points are then left out. `robust` gives points
    that are far off less weight; `cutoff`, Hz, filters the movement. The wrong line of a file is a ValueError.
    """
    with tempfile.TemporaryDirectory() as folder:
        made = Path(folder)
        options: Dict[str, Any] = {"rate": rate, "age": age, "sex": sex, "scale": scale, "up": up, "cutoff": cutoff}
        options.update(camera=_camera_file(camera, made), map=_map_file(places, made))
        if isinstance(points, KeyPoints):
            file = str(made / "points.csv")
            points.write(file)
        else:
            file = os.fspath(points)
        command = [_program(), "replay", "--motion", file, "--scene", scene, "--touch", "off", "--json"]
        for name, value in options.items():
            command += [] if value is None else [f"--{name}", str(value)]
        command += ["--robust"] if robust else []
        command += ["--joints", str(made / "joints.csv"), "--errors", str(made / "errors.csv")]
        done = subprocess.run(command, capture_output=True, text=True, encoding="utf-8")
        if done.returncode != 0:
            raise ValueError(_complaint(done.stderr))
        report = json.loads(done.stdout)
        times, columns, positions = _table(made / "joints.csv")
        _, names, errors = _table(made / "errors.csv")
    return Found(times, columns, positions, names, errors, report["points_rms"], report["fitted_age"], report["notes"])


def _camera_file(camera: Union[Camera, File, None], folder: Path) -> Optional[str]:
    if not isinstance(camera, Camera):
        return None if camera is None else os.fspath(camera)
    camera.write(str(folder / "camera.json"))
    return str(folder / "camera.json")


def _map_file(places: Optional[Dict[str, Place]], folder: Path) -> Optional[str]:
    if places is None:
        return None
    with (folder / "map.csv").open("w", newline="", encoding="utf-8") as file:
        csv.writer(file).writerows([name, body, *offset] for name, (body, offset) in places.items())
    return str(folder / "map.csv")


def _table(path: Path) -> Tuple[Numbers, List[str], Numbers]:
    with path.open(newline="", encoding="utf-8") as file:
        (_, *names), *rows = csv.reader(file)
    numbers = np.array([[float(cell) if cell else np.nan for cell in row] for row in rows])
    return numbers[:, 0], names, numbers[:, 1:]


def _complaint(text: str) -> str:
    """The program's last line, without its name."""
    lines = text.strip().splitlines() or ["mimo replay fails"]
    return next((line for line in lines if line.startswith("mimo replay:")), lines[-1]).replace("mimo replay: ", "", 1)


def _program() -> str:
    """The program beside the library, in a package or in a build; MIMO_PROGRAM overrides it."""
    name, library = "mimo.exe" if sys.platform == "win32" else "mimo", library_path()
    own = os.environ.get("MIMO_PROGRAM")
    places = [Path(own)] if own else [library.with_name(name), library.parent.parent / "bin" / name]
    found = next((str(it) for it in places if it.is_file()), shutil.which("mimo"))
    if found is None:
        raise FileNotFoundError(f"there is no program mimo beside {library}; set MIMO_PROGRAM")
    return found


def main(arguments: Optional[Sequence[str]] = None) -> int:
    parser = argparse.ArgumentParser(prog="python -m mimo.motion", description=(__doc__ or "").splitlines()[0])
    parser.add_argument("points", help="a file or a folder of markers or key points, as of mimo replay --motion")
    parser.add_argument("--rate", type=float, help="frames a second, of DeepLabCut, OpenPose and MINI-RGBD")
    parser.add_argument("--out", required=True, help="joints, a table for mimo replay --motion")
    parser.add_argument("--errors", help="how far each point is from where it was seen, a table")
    parser.add_argument("--camera", help="JSON: matrix, or fovy, width, height, position and look_at")
    parser.add_argument("--scene", default="free", help="a built-in scene with the infant's first pose (free)")
    parser.add_argument("--age", type=float, help="months; default: the age that fits best")
    parser.add_argument("--cutoff", type=float, help="Hz: filter the joints over time; 6 is usual")
    parser.add_argument("--robust", action="store_true", help="give less weight to points that are far off")
    options = vars(parser.parse_args(arguments))
    points, out, errors = options.pop("points"), options.pop("out"), options.pop("errors")
    try:
        for path in filter(None, (out, errors)):
            require_writable(path)  # before the work, not after it
        found = fit(points, **options)
        found.write(out)
        if errors:
            found.write_errors(errors)
    except (ValueError, OSError) as error:
        print(f"mimo.motion: {error}", file=sys.stderr)
        return 1
    print(f"{len(found.times)} rows\n{'point':24} {'median':>10} {'largest':>10}  m or pixels")
    for name, known in ((name, it[np.isfinite(it)]) for name, it in zip(found.points, found.errors.T)):
        print(f"{name:24} {np.median(known):10.3g} {known.max():10.3g}" if len(known) else f"{name:24} never seen")
    print("\n".join(found.notes))
    return 0


if __name__ == "__main__":
    sys.exit(main())
