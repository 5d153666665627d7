"""Exports recordings and scenes to other programs.

python -m mimo.export --nwb run.nwb run.h5            # Neurodata Without Borders
python -m mimo.export --bids-motion dataset run.h5    # BIDS, data type motion
python -m mimo.export --csv tables run.h5             # also --wav, --mp4: a folder with a file for each field
python -m mimo.export --html run.html run.h5          # a page that plays it, which the program mimo writes
python -m mimo.export --usd infant.usdc --scene showroom
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
from datetime import datetime
from typing import Any, Callable, Dict, List, Optional

from . import bids, by_field, nwb, usd
from ._hdf5 import with_hdf5
from ._library import native_file
from .errors import Error, UnsupportedError
from .recordings import add_sense_option
from .scene import scenes
from .world import World

OF_SCENES = ("scene", "seed", "age", "face", "segments")
OF_RECORDINGS = ("fields", "infant", "start", "sense")


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="python -m mimo.export", description="Writes a recording or a scene as a file for other programs."
    )
    parser.add_argument("recording", nargs="?", metavar="FILE.h5", help="the recording")
    kinds = parser.add_argument_group("one of").add_mutually_exclusive_group(required=True)
    kinds.add_argument("--nwb", metavar="FILE.nwb", help="a recording: Neurodata Without Borders")
    kinds.add_argument("--bids-motion", metavar="FOLDER", help="a recording: a BIDS data set with motion")
    kinds.add_argument("--csv", metavar="FOLDER", help="a recording: a table for each field")
    kinds.add_argument("--wav", metavar="FOLDER", help="a recording: a sound for each ear that it keeps")
    kinds.add_argument("--mp4", metavar="FOLDER", help="a recording: a film for each picture field that it keeps")
    kinds.add_argument("--html", metavar="FILE.html", help="a recording: a page that plays it in a browser")
    kinds.add_argument("--usd", metavar="FILE", help="a scene: .usdc, .usda, or .usdz")
    recordings = parser.add_argument_group("of recordings")
    recordings.add_argument("--fields", metavar="LIST", help="senses and names of fields, as touch,vision/eye_left")
    recordings.add_argument("--infant", type=int, help="the subject of --nwb (0)")
    recordings.add_argument(
        "--start", metavar="TIME", help="of --nwb, as 2026-05-01T12:00:00+00:00; default: the file's"
    )
    add_sense_option(recordings)
    of_scenes = parser.add_argument_group("of scenes")
    of_scenes.add_argument("--scene", help=f"one of {', '.join(scenes())} (benchmark)")
    of_scenes.add_argument("--seed", type=int, help="of the start (0)")
    of_scenes.add_argument("--age", type=float, help="of the infants, months")
    of_scenes.add_argument("--face", help="of the infants")
    of_scenes.add_argument("--segments", type=int, help="pieces of a circle (24)")
    return parser


def _refuse(asked: argparse.Namespace, names: Any, kind: str) -> None:
    for name in names:
        if getattr(asked, name) not in (None, []):
            raise ValueError(f"--{name} has no effect on {kind}")


def _usd(asked: argparse.Namespace) -> str:
    if asked.recording is not None:
        raise ValueError(f"--usd writes a scene, not the recording {asked.recording}")
    _refuse(asked, OF_RECORDINGS, "--usd")
    options = {name: getattr(asked, name) for name in ("age", "face") if getattr(asked, name) is not None}
    with World(asked.scene or "benchmark", vision=False, touch=False, **options) as world:
        world.reset(seed=asked.seed or 0)
        written = usd.write(world, asked.usd, segments=24 if asked.segments is None else asked.segments)
    return f"wrote {_listed(list(map(str, written)))}"


def _listed(names: List[str]) -> str:
    return ", ".join(names[:2]) + (" ..." if len(names) > 2 else "")


def _start(text: Optional[str]) -> Optional[datetime]:
    if text is None:
        return None
    try:
        return datetime.fromisoformat(text)
    except ValueError:
        raise ValueError(f"--start is {text!r}, expected a time as 2026-05-01T12:00:00+00:00") from None


def _page(asked: argparse.Namespace) -> str:
    _refuse(asked, ("fields", "sense"), "--html, which writes a recording as it is")
    program = native_file("mimo.exe" if sys.platform == "win32" else "mimo")
    command = [str(program), "export", "--html", asked.html, asked.recording]

    def write(hdf5: Optional[bytes]) -> None:
        env = dict(os.environ, **({} if hdf5 is None else {"MIMO_HDF5": os.fsdecode(hdf5)}))
        done = subprocess.run(command, capture_output=True, text=True, env=env)
        if done.returncode != 0:
            told = done.stderr.strip().partition(": ")[2]
            raise UnsupportedError(told) if "libhdf5" in told else ValueError(told)
        sys.stderr.write(done.stderr)  # warnings

    with_hdf5(write, None)
    return f"wrote {asked.html}"


def _of_recording(asked: argparse.Namespace) -> str:
    if asked.recording is None:
        raise ValueError("a recording is missing: give its file, as run.h5")
    _refuse(asked, OF_SCENES, "recordings")
    fields = None if asked.fields is None else [name for name in asked.fields.split(",") if name]
    if asked.nwb is not None:
        written = nwb.write(asked.recording, asked.nwb, fields, asked.infant or 0, _start(asked.start), asked.sense)
        return f"wrote {asked.nwb}: {len(written)} series"
    _refuse(asked, ("infant", "start"), "any but --nwb")
    if asked.html is not None:
        return _page(asked)
    if asked.bids_motion is not None:
        left_out = bids.write(asked.recording, asked.bids_motion, fields, asked.sense)
        return f"wrote {asked.bids_motion}" + (f"; no channels of motion: {', '.join(left_out)}" if left_out else "")
    writers: Dict[str, Callable[..., List[str]]] = {
        "csv": by_field.write_csv,
        "wav": by_field.write_wav,
        "mp4": by_field.write_mp4,
    }
    (kind,) = [name for name in writers if getattr(asked, name) is not None]
    folder = getattr(asked, kind)
    return f"wrote {folder}: {_listed(writers[kind](asked.recording, folder, fields, asked.sense))}"


def main(given: Optional[List[str]] = None) -> int:
    """Writes what the arguments of the command line ask for."""
    asked = _parser().parse_args(given)
    try:
        said = _usd(asked) if asked.usd is not None else _of_recording(asked)
    except (Error, OSError, ValueError) as error:
        print(f"python -m mimo.export: {error}", file=sys.stderr)
        return 1
    print(said)
    return 0


if __name__ == "__main__":
    sys.exit(main())
