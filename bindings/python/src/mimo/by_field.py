"""Writes a recording as a folder with a file for each field: CSV, WAV or MP4.

    mimo.by_field.write_csv("run.h5", "tables")
    mimo.by_field.write_wav("run.h5", "sounds")
    mimo.by_field.write_mp4("run.h5", "films")    # needs the extra [video]

`fields.json` beside them has the unit and frame of each column, and how long before the end of a step its moment was.
"""

from __future__ import annotations

import json
import os
import struct
from pathlib import Path
from typing import Any, Callable, Dict, List, Optional, Sequence, Union

import numpy as np
from numpy.typing import NDArray

from . import video
from ._files import new_folder
from .kept import NUMBERS, PICTURE, SOUND, Kept, Table, as_texts

Name = Union[str, "os.PathLike[str]"]
IEEE_FLOAT = 3  # format of samples in WAV files
LARGEST_WAV = 2**32 - 1  # bytes


def write_csv(
    recording: Name, folder: Name, fields: Optional[Sequence[str]] = None, own_senses: Sequence[str] = ()
) -> List[str]:
    """Writes each table of numbers as FIELD.csv: time (s, of the moment of the row) and a column for each number."""
    return _write(recording, folder, fields, own_senses, NUMBERS, ".csv", _csv)


def write_wav(
    recording: Name, folder: Name, fields: Optional[Sequence[str]] = None, own_senses: Sequence[str] = ()
) -> List[str]:
    """Writes each sound as FIELD.wav, 32-bit numbers: 1 is 1 Pa."""
    return _write(recording, folder, fields, own_senses, SOUND, ".wav", _wav)


def write_mp4(
    recording: Name, folder: Name, fields: Optional[Sequence[str]] = None, own_senses: Sequence[str] = ()
) -> List[str]:
    """Writes each kept picture field as FIELD.mp4 (H.264), a picture per step."""
    return _write(recording, folder, fields, own_senses, PICTURE, ".mp4", _mp4)


def _write(
    recording: Name,
    folder: Name,
    fields: Optional[Sequence[str]],
    own_senses: Sequence[str],
    kind: str,
    suffix: str,
    write: Callable[[Kept, Table, Path], None],
) -> List[str]:
    """Writes the tables of a kind; returns the files' names."""
    with Kept(recording, fields, own_senses) as kept:
        chosen = [it for it in kept.tables if it.kind == kind]
        if not chosen:
            keep = {SOUND: "--senses hearing --keep hearing", PICTURE: "--vision 128 --keep vision"}[kind]
            raise ValueError(
                f"{os.fspath(recording)} keeps no {kind}; 'mimo replay {os.fspath(recording)} {keep} --out NEW.h5' does"
            )
        files: Dict[str, Any] = {}
        with new_folder(folder) as made:
            for table in chosen:
                name = _plain(table) + suffix
                write(kept, table, made / name)
                files[name] = _told(table)
            (made / "fields.json").write_text(json.dumps(files, indent=1) + "\n", encoding="utf-8")
    return [*files, "fields.json"]


def _plain(table: Table) -> str:
    """The field's name without slashes, with the prefix of its infant."""
    return table.dataset.replace("fields/", "", 1).replace("/", "_")


def _told(table: Table) -> Dict[str, Any]:
    told: Dict[str, Any] = {"field": table.dataset.replace("fields/", "", 1), "late_seconds": table.late}
    if table.sample_rate > 0:
        told["sample_rate"] = table.sample_rate
    told["columns"] = [column._asdict() for column in table.columns]
    if table.receptors:
        told["receptors"] = [{"body": body, "position": place} for body, place in table.receptors]
    return told


def _csv(kept: Kept, table: Table, file: Path) -> None:
    times, step = kept.times + table.late, 0
    with open(file, "w", encoding="utf-8", newline="\n") as out:
        out.write(",".join(["time", *(_quoted(column.name) for column in table.columns)]) + "\n")
        for chunk in kept.chunks(table):
            for row in as_texts(chunk):
                out.write(f"{times[step]:.9g}," + ",".join(row) + "\n")
                step += 1


def _quoted(name: str) -> str:
    return '"' + name.replace('"', '""') + '"' if any(mark in name for mark in ',"\n') else name


def _wav(kept: Kept, table: Table, file: Path) -> None:
    """RIFF, fmt, fact and data, as the format of WAVE files has them."""
    rate, samples = round(table.sample_rate), kept.recording.steps * table.shape[0]
    size = 4 * samples
    if size + 50 > LARGEST_WAV:
        raise ValueError(f"{table.dataset} has {samples} samples; a WAV file holds {(LARGEST_WAV - 50) // 4}")
    sound = struct.pack("<4sIHHIIHHH", b"fmt ", 18, IEEE_FLOAT, 1, rate, 4 * rate, 4, 32, 0)
    sound += struct.pack("<4sII", b"fact", 4, samples)
    with open(file, "wb") as out:
        out.write(struct.pack("<4sI4s", b"RIFF", 4 + len(sound) + 8 + size, b"WAVE") + sound)
        out.write(struct.pack("<4sI", b"data", size))
        for chunk in kept.chunks(table):
            out.write(np.ascontiguousarray(chunk, "<f4").tobytes())


def _mp4(kept: Kept, table: Table, file: Path) -> None:
    if kept.rate is None or abs(kept.rate - round(kept.rate)) > 1e-6:
        raise ValueError(f"a film needs a whole number of pictures a second, and {kept.recording.path} has {kept.rate}")
    height, width = (2 * (-(-edge // 2)) for edge in table.shape[:2])  # H.264 wants even edges: the last line is twice

    def pictures() -> Any:
        for chunk in kept.chunks(table):
            for picture in chunk:
                yield _color(picture, (height, width), table)

    video.write(str(file), pictures(), round(kept.rate), (width, height))


def _color(picture: NDArray[Any], size: Any, table: Table) -> NDArray[np.uint8]:
    if picture.dtype != np.uint8 or picture.shape[2] not in (1, 3):
        raise ValueError(
            f"{table.dataset} has {picture.shape[2]} x {picture.dtype} in a pixel, and a film has colours; "
            "choose other fields, or write it as NWB"
        )
    shown = np.repeat(picture, 3, axis=2) if picture.shape[2] == 1 else picture
    return np.pad(shown, [(0, size[0] - shown.shape[0]), (0, size[1] - shown.shape[1]), (0, 0)], mode="edge")
