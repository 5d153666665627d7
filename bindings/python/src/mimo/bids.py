"""Writes a recording as a data set of the Brain Imaging Data Structure (BIDS), data type "motion".

    mimo.bids.write("run.h5", "dataset")

Each infant is a subject. Its channels are the places and rotations of its bodies, its joints, and what senses it kept
as numbers with names. Pictures, sounds and the skin's sensors are no channels of motion and stay out.
"""

from __future__ import annotations

import json
import os
import re
from pathlib import Path
from typing import Any, Dict, Iterator, List, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np
from numpy.typing import NDArray

from ._files import new_folder
from ._library import version
from .kept import AXES, NUMBERS, Column, Kept, Table, as_texts

BIDS_VERSION = "1.10.0"
SYSTEM = "mimo"
QUATERNION = ("quat_w", "quat_x", "quat_y", "quat_z")
UNITLESS = "n/a"
FRAMES = {
    "world": "Right-handed, z up; the origin is that of the scene.",
    "parent": "The frame of the parent of the tracked body.",
    "body": "The frame of the tracked body: x forwards, y left, z up when the infant stands.",
    "head": "The frame of the head: x forwards, y left, z up.",
    "joint": "Along or around the axis of the joint, from its zero.",
    "site": "The frame of the tracked place on the body.",
    "actuator": "Along the pull of the tracked motor or muscle.",
    "skin": "Normal and tangents of the skin.",
}
COLUMNS = {
    "placement": "Body or joint that the tracked point is on.",
    "description": "Table and column of the recording.",
}


class Channel(NamedTuple):
    """A column of the file, and a line of its list of channels."""

    name: str
    component: str
    type: str
    tracked_point: str
    units: str
    placement: str
    reference_frame: str
    description: str
    sampling_frequency: str = UNITLESS


def write(
    recording: "Union[str, os.PathLike[str]]",
    folder: "Union[str, os.PathLike[str]]",
    fields: Optional[Sequence[str]] = None,
    own_senses: Sequence[str] = (),
) -> List[str]:
    """Writes a data set into a folder, which must be new or empty; returns what has no place in it, as text."""
    with Kept(recording, fields, own_senses) as kept:
        if not kept.infants:
            raise ValueError(f"{os.fspath(recording)} has no infant, and a data set needs subjects")
        if kept.rate is None:
            raise ValueError(f"{os.fspath(recording)} has steps of unequal length; channels of motion need one rate")
        with new_folder(folder) as made:
            _write(kept, made)
        return [_left_out(table) for table in kept.tables if not _is_motion(table)]


def _left_out(table: Table) -> str:
    why = f"{len(table.receptors)} sensors" if table.receptors else table.kind
    return f"{table.dataset[len('fields/') :]} ({why})"


def _is_motion(table: Table) -> bool:
    return table.kind == NUMBERS and not table.receptors


def _label(text: str, otherwise: str) -> str:
    """Letters and digits, as BIDS wants them in names."""
    return re.sub(r"[^A-Za-z0-9]", "", text) or otherwise


def _write(kept: Kept, folder: Path) -> None:
    task = _label(kept.task, "free")
    subjects = [f"sub-{_label(it.name, '01')}" for it in kept.infants]
    names, _, poses = kept.poses()
    _json(folder / "dataset_description.json", _description(kept))
    (folder / "README").write_text(_readme(kept))
    _participants(kept, folder, subjects)
    for infant, subject in enumerate(subjects):
        place = folder / subject / "motion"
        place.mkdir(parents=True)
        stem = f"{subject}_task-{task}"
        channels, sources = _channels(kept, infant, names)
        _motion(kept, place / f"{stem}_tracksys-{SYSTEM}_motion.tsv", sources, poses)
        _json(place / f"{stem}_tracksys-{SYSTEM}_motion.json", _sidecar(kept, task, channels))
        _tsv(place / f"{stem}_tracksys-{SYSTEM}_channels.tsv", list(Channel._fields), channels)
        _json(place / f"{stem}_tracksys-{SYSTEM}_channels.json", _channels_json(channels))
        _events(kept, infant, place / f"{stem}_events")


def _description(kept: Kept) -> Dict[str, Any]:
    recording = kept.recording
    return {
        "Name": f"A simulated infant (MIMo), task {kept.task}",
        "BIDSVersion": BIDS_VERSION,
        "DatasetType": "raw",
        "GeneratedBy": [{"Name": "libmimo", "Version": version()}],
        "SourceDatasets": [{"URL": os.path.basename(recording.path), "Version": recording.build}],
    }


def _readme(kept: Kept) -> str:
    recording = kept.recording
    return (
        f"Movements of a simulated infant, MIMo, in the task {kept.task}: {recording.steps} steps of "
        f"{recording.step_seconds:g} s, seed {recording.seed}.\n\n"
        f"Recorded by {recording.build}, converted by libmimo {version()} from {os.path.basename(recording.path)}. "
        "The times of channels that a sense has before the end of a step are in the description of the channel.\n"
    )


def _participants(kept: Kept, folder: Path, subjects: List[str]) -> None:
    header = ["participant_id", "species", "age", "sex", "weight", "height"]
    lines = [
        (
            subject,
            "homo sapiens",
            UNITLESS if it.age is None else f"{it.age / 12:.4f}",
            {"U": UNITLESS}.get(it.sex, it.sex),
            f"{it.mass:.3f}",
            f"{100 * it.height:.1f}",
        )
        for subject, it in zip(subjects, kept.infants)
    ]
    _tsv(folder / "participants.tsv", header, lines)
    meanings = {
        "species": {"Description": "Species that the simulation is of. No subject is a living being."},
        "age": {"Description": "Age of the body", "Units": "year"},
        "sex": {
            "Description": "Whose growth the body follows; n/a: the mean of both",
            "Levels": {"F": "girls", "M": "boys"},
        },
        "weight": {"Description": "Mass of the body", "Units": "kg"},
        "height": {"Description": "Length of the body", "Units": "cm"},
    }
    _json(folder / "participants.json", meanings)


Source = Tuple[Optional[Table], NDArray[np.intp]]  # columns of a table, or of the poses of all bodies


def _channels(kept: Kept, infant: int, names: List[str]) -> Tuple[List[Channel], List[Source]]:
    """The channels of an infant, and where their numbers are, in order."""
    channels: List[Channel] = []
    others = [prefix for number, prefix in enumerate(kept.prefixes) if number != infant]
    shown = [i for i in range(1, len(names)) if names[i] and not any(names[i].startswith(it) for it in others)]
    for body in shown:
        channels += _of_body(names[body])
    sources: List[Source] = [(None, np.array([7 * body + part for body in shown for part in range(7)], np.intp))]
    for table in filter(_is_motion, kept.tables):
        own = kept.of_infant(table, infant)
        channels += [_of_column(table, table.columns[number]) for number in own]
        sources.append((table, np.array(own, np.intp)))
    return channels, sources


def _of_body(name: str) -> Iterator[Channel]:
    told = "pose of the body after each step"
    for axis in AXES:
        yield Channel(f"{name}_pos_{axis}", axis, "POS", name, "m", name, "world", told)
    for part in QUATERNION:
        yield Channel(f"{name}_{part}", part, "ORNT", name, UNITLESS, name, "world", told)


def _of_column(table: Table, column: Column) -> Channel:
    point, _, part = column.name.rpartition("/")
    kind, component = "MISC", UNITLESS
    if table.name == "joints/position":
        if column.unit == "rad":
            kind = "JNTANG"
        elif part in AXES or column.unit == "m":
            kind, component = "POS", part if part in AXES else UNITLESS
        elif f"quat_{part[1:]}" in QUATERNION:
            kind, component = "ORNT", f"quat_{part[1:]}"
    elif table.name == "joints/velocity" and column.unit == "m/s":
        kind, component = "VEL", part if part in AXES else UNITLESS
    elif table.name.startswith("vestibular/") and column.name in AXES:
        kind = {"m/s^2": "ACCEL", "rad/s": "GYRO"}.get(column.unit, "MISC")
        point, component = "head", column.name
    late = f", {table.late:g} s after the end of the step" if table.late else ""
    where = point if component != UNITLESS and point else column.name
    return Channel(
        f"{table.name}/{column.name}",
        component,
        kind,
        where,
        column.unit or UNITLESS,
        where,
        column.frame or UNITLESS,
        f"{table.name}, {column.name}{late}",
    )


def _channels_json(channels: List[Channel]) -> Dict[str, Any]:
    used = sorted({it.reference_frame for it in channels} - {UNITLESS})
    levels = {frame: {"Description": FRAMES.get(frame, frame)} for frame in used}
    for frame, told in levels.items():
        if frame in ("world", "head", "body"):
            told.update(SpatialAxes="ALS", RotationRule="right-hand", RotationOrder="n/a")
    return {
        "reference_frame": {"Description": "Frame in which the numbers are.", "Levels": levels},
        **{name: {"Description": told} for name, told in COLUMNS.items()},
    }


def _sidecar(kept: Kept, task: str, channels: List[Channel]) -> Dict[str, Any]:
    counts = {f"{kind}ChannelCount": 0 for kind in ("ACCEL", "GYRO", "JNTANG", "MISC", "ORNT", "POS", "VEL")}
    for channel in channels:
        counts[f"{channel.type}ChannelCount"] += 1
    recording = kept.recording
    return {
        "TaskName": task,
        "TaskDescription": f"The task {kept.task} of libmimo, played by a simulated infant.",
        "SamplingFrequency": kept.rate,
        "SamplingFrequencyEffective": kept.rate,
        "TrackingSystemName": "MIMo, a simulated infant",
        "Manufacturer": "libmimo",
        "ManufacturersModelName": f"MuJoCo {recording.mujoco}",
        "SoftwareVersions": recording.build,
        "MotionChannelCount": len(channels),
        "TrackedPointsCount": len({it.tracked_point for it in channels if it.type == "POS"}),
        "RecordingDuration": recording.steps * recording.step_seconds,
        "RecordingType": "continuous",
        "MissingValues": "n/a",
        **counts,
    }


def _motion(kept: Kept, file: Path, sources: List[Source], poses: NDArray[np.float32]) -> None:
    """Rows of numbers without a header, as BIDS wants them."""
    chunk, steps = 1000, len(poses)
    with open(file, "w", encoding="utf-8", newline="\n") as out:
        for first in range(0, steps, chunk):
            many = min(chunk, steps - first)
            parts = []
            for table, columns in sources:
                if table is None:
                    rows: Any = poses[first : first + many]
                else:
                    rows = kept.recording.read(table.dataset, table.dtype, first, many)
                parts.append(as_texts(rows.reshape(many, -1)[:, columns]))
            for texts in zip(*parts):
                out.write("\t".join(_finite(text) for row in texts for text in row) + "\n")


def _finite(text: str) -> str:
    return text if text not in ("nan", "inf", "-inf") else UNITLESS


def _events(kept: Kept, infant: int, stem: Path) -> None:
    events = [it for it in kept.events() if it.infant in (None, infant)]
    if not events:
        return
    lines = [(f"{it.time:.6f}", "0", it.name, it.outcome) for it in events]
    _tsv(stem.with_name(f"{stem.name}.tsv"), ["onset", "duration", "trial_type", "outcome"], lines)
    meanings = {
        "trial_type": {
            "Description": "What happened",
            "Levels": {
                "terminated": "the task ended the episode",
                "truncated": "the episode was cut off",
                "changed": "something other than a step changed the world, as a reset",
            },
        },
        "outcome": {
            "Description": "How the episode ended",
            "Levels": {"success": "its goal was reached", "failure": "its goal was missed", "n/a": "neither"},
        },
    }
    _json(stem.with_name(f"{stem.name}.json"), meanings)


def _tsv(file: Path, header: List[str], lines: Sequence[Tuple[str, ...]]) -> None:
    text = ["\t".join(header), *("\t".join(line) for line in lines)]
    file.write_text("\n".join(text) + "\n", encoding="utf-8", newline="\n")


def _json(file: Path, content: Dict[str, Any]) -> None:
    file.write_text(json.dumps(content, indent=2) + "\n", encoding="utf-8")
