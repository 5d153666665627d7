"""Writes a recording as a Neurodata Without Borders file (NWB). Needs the extra [nwb].

    mimo.nwb.write("run.h5", "run.nwb")

Each field is a series in `acquisition`. In `processing["behavior"]`, the table `columns` has name, unit and frame of
each number of a series, `receptors` the place of each sensor of the skin. With ndx-pose the bodies are a
PoseEstimation, otherwise SpatialSeries; with ndx-sound ears are AcousticWaveformSeries, otherwise TimeSeries.
"""

from __future__ import annotations

import os
from datetime import datetime, timezone
from typing import Any, Dict, Iterator, List, Optional, Sequence, Union

import numpy as np
from numpy.typing import NDArray

from ._files import new_file, require_writable
from ._library import version
from .errors import UnsupportedError
from .kept import PICTURE, SOUND, Kept, Table

Path = Union[str, "os.PathLike[str]"]
DAYS_A_MONTH = 30.4375
WORLD = "world: right-handed, z up; its origin is that of the scene"
DEEPEST = 4  # dimensions of a series, with time
TIMES = "s after the end of the step"
COMPRESSION = {"compression": "gzip", "compression_opts": 4, "shuffle": True}


def write(
    recording: Path,
    file: Path,
    fields: Optional[Sequence[str]] = None,
    infant: int = 0,
    start: Optional[datetime] = None,
    own_senses: Sequence[str] = (),
) -> List[str]:
    """Writes a recording with one infant as the subject; returns the names of the series.

    A recording does not know when it was made: the session begins at `start`, by default when the recording's file was
    last written.
    """
    require_writable(file)
    if start is not None and start.tzinfo is None:
        raise ValueError(f"start is {start.isoformat()}, expected a time with its time zone, as in ...T12:00:00+00:00")
    pynwb = _need()
    begun = start or datetime.fromtimestamp(os.stat(recording).st_mtime, timezone.utc)
    with Kept(recording, fields, own_senses) as kept:
        if not 0 <= infant < max(1, len(kept.infants)):
            raise ValueError(f"infant is {infant}, expected 0 to {max(1, len(kept.infants)) - 1}")
        writer = _Writer(pynwb, kept, infant, begun)
        with new_file(file) as beside, pynwb.NWBHDF5IO(str(beside), "w") as io:
            io.write(writer.file)
    return writer.names


def _need() -> Any:
    try:
        import pynwb
        from pynwb.event import EventsTable  # noqa: F401
    except ImportError:
        raise UnsupportedError("NWB files need PyNWB 4 or later: pip install 'mimo[nwb]'") from None
    return pynwb


def _extension(name: str) -> Any:
    try:
        return __import__(name)
    except ImportError:
        return None


class _Writer:
    def __init__(self, pynwb: Any, kept: Kept, infant: int, begun: datetime) -> None:
        self._pynwb, self._kept, self._infant = pynwb, kept, infant
        self.names: List[str] = []
        recording = kept.recording
        name = os.path.splitext(os.path.basename(recording.path))[0]
        self.file = pynwb.NWBFile(
            session_description=f"A simulated infant, MIMo, task {kept.task}.",
            identifier=f"{name}, {recording.build}, seed {recording.seed}",
            session_start_time=begun,
            session_id=name,
            experiment_description="A simulation. All numbers are those of the recording.",
            keywords=["simulation", "infant", "MIMo"],
            source_script=f"libmimo {version()}, mimo.nwb",
            source_script_file_name=os.path.basename(recording.path),
            subject=self._subject(),
        )
        self._module = self.file.create_processing_module("behavior", "names, units and frames of all series; poses")
        self._columns: List[Dict[str, Any]] = []
        self._sensors: Dict[Any, str] = {}
        for table in kept.tables:
            self._add(table)
        self._add_columns()
        self._add_poses()
        self._add_events()

    def _subject(self) -> Any:
        if not self._kept.infants:
            return None
        it = self._kept.infants[self._infant]
        days = None if it.age is None else f"P{round(it.age * DAYS_A_MONTH)}D"
        return self._pynwb.file.Subject(
            subject_id=it.name or "infant",
            description=f"A simulated infant (MIMo), {it.height:.3f} m long. It is no living being.",
            species="Homo sapiens",
            age=days,
            sex=it.sex,
            weight=f"{it.mass:.3f} kg",
        )

    def _time(self, late: float) -> Dict[str, Any]:
        kept = self._kept
        if kept.rate is None:
            return {"timestamps": kept.times + late}
        return {"starting_time": float(kept.times[0] + late), "rate": kept.rate}

    def _add(self, table: Table) -> None:
        own = self._kept.of_infant(table, self._infant)
        if not own:
            return
        name = table.name.replace("/", "_")
        said = f"{table.name}, {table.late:g} {TIMES}. " + (f"Frame: {table.frame}." if table.frame else "No frame.")
        common = {"name": name, "description": said}
        if table.kind == PICTURE:
            series = self._pictures(table, common)
        elif table.kind == SOUND:
            series = self._sound(table, common)
        else:
            whole = len(own) == len(table.columns)
            deep = whole and len(table.shape) < DEEPEST
            data = self._rows(table, None if deep else own, table.shape if deep else (len(own),))
            common["comments"] = f"What each number is: processing/behavior/columns, where series is {name}."
            series = self._pynwb.TimeSeries(
                **common, data=data, unit=table.unit or "dimensionless", **self._time(table.late)
            )
        self.file.add_acquisition(series)
        self.names.append(name)
        for place, number in enumerate(own):
            column = table.columns[number]
            self._columns.append(
                {"series": name, "column": place, "label": column.name, "unit": column.unit, "frame": column.frame}
            )
        if table.receptors:
            self._add_receptors(table, name)

    def _rows(self, table: Table, own: Optional[List[int]], shape: Any) -> Any:
        from hdmf.backends.hdf5 import H5DataIO
        from hdmf.data_utils import DataChunkIterator

        def rows() -> Iterator[NDArray[Any]]:
            for chunk in self._kept.chunks(table):
                yield from chunk if own is None else chunk.reshape(len(chunk), -1)[:, own]

        steps = self._kept.recording.steps
        buffered = max(1, min(steps, 256))
        data = DataChunkIterator(
            data=rows(), maxshape=(steps, *shape), dtype=np.dtype(table.dtype), buffer_size=buffered
        )
        return H5DataIO(data, **COMPRESSION)

    def _pictures(self, table: Table, common: Dict[str, str]) -> Any:
        return self._pynwb.image.ImageSeries(
            **common,
            data=self._rows(table, None, table.shape),
            unit=table.unit or "n.a.",
            format="raw",
            comments="Each row: height x width x channels, the top line first.",
            **self._time(table.late),
        )

    def _sound(self, table: Table, common: Dict[str, str]) -> Any:
        """All samples one after the other; each step's last sample ends with it."""
        from hdmf.backends.hdf5 import H5DataIO

        begin = float(self._kept.times[0] + table.late - table.shape[0] / table.sample_rate)
        samples = H5DataIO(self._kept.read(table).ravel(), **COMPRESSION)
        place = {"data": samples, "rate": table.sample_rate, "starting_time": begin, "unit": table.unit}
        common["comments"] = "Sound pressure, Pa."  # AcousticWaveformSeries have no unit
        ndx = _extension("ndx_sound")
        return (ndx.AcousticWaveformSeries if ndx else self._pynwb.TimeSeries)(**common, **place)

    def _table(self, name: str, description: str, rows: Dict[str, Any], meanings: Dict[str, str]) -> Any:
        from hdmf.common import DynamicTable, VectorData

        columns = [VectorData(name=key, description=meanings[key], data=data) for key, data in rows.items()]
        return DynamicTable(name=name, description=description, columns=columns)

    def _add_columns(self) -> None:
        meanings = {
            "series": "name of the series in acquisition",
            "column": "number in a flattened row of the series; of pictures and sound there is one line for all",
            "label": "what it is the number of",
            "unit": "empty for none",
            "frame": "frame of reference, empty for none",
        }
        rows = {key: [line[key] for line in self._columns] for key in meanings}
        self._module.add(self._table("columns", "Name, unit and frame of each number.", rows, meanings))

    def _add_receptors(self, table: Table, series: str) -> None:
        """Fields of the same skin share a table."""
        if table.receptors in self._sensors:
            return
        name = f"receptors_{series}" if self._sensors else "receptors"
        self._sensors[table.receptors] = name
        places = np.array([place for _, place in table.receptors])
        meanings = {"body": "the body that it is on"}
        rows: Dict[str, Any] = {"body": [body for body, _ in table.receptors]}
        for number, axis in enumerate("xyz"):
            rows[axis], meanings[axis] = places[:, number], "place in the body's frame, m"
        told = f"Sensors of the skin, in the order of {series} and all series with as many sensors."
        self._module.add(self._table(name, told, rows, meanings))

    def _add_poses(self) -> None:
        """Places of all bodies but the world."""
        names, parents, poses = self._kept.poses()
        shown = [number for number in range(1, len(names)) if names[number] and self._is_own(names[number])]
        series = [(names[number].replace("/", "_"), poses[:, number, :3]) for number in shown]
        ndx = _extension("ndx_pose")
        if ndx is None:
            from pynwb.behavior import Position, SpatialSeries

            places = [
                SpatialSeries(name=name, data=data, unit="meters", reference_frame=WORLD, **self._time(0.0))
                for name, data in series
            ]
            self._module.add(Position(name="bodies", spatial_series=places))
            return
        index = {number: place for place, number in enumerate(shown)}
        edges = [[index[parents[number]], index[number]] for number in shown if parents[number] in index]
        skeleton = ndx.Skeleton(
            name="bodies", nodes=[name for name, _ in series], edges=np.array(edges, np.uint8).reshape(-1, 2)
        )
        self._module.add(ndx.Skeletons(skeletons=[skeleton]))
        places = [
            ndx.PoseEstimationSeries(
                name=name,
                description=f"Origin of the frame of the body {name}.",
                data=data,
                unit="meters",
                reference_frame=WORLD,
                confidence=np.ones(len(data), np.float32),
                confidence_definition="1: known, not estimated",
                **self._time(0.0),
            )
            for name, data in series
        ]
        self._module.add(
            ndx.PoseEstimation(
                name="bodies_over_time",
                pose_estimation_series=places,
                description="Where all bodies are after each step, as the recorded joints place them.",
                source_software="libmimo",
                source_software_version=self._kept.recording.library,
                skeleton=skeleton,
            )
        )

    def _is_own(self, name: str) -> bool:
        return not any(
            name.startswith(prefix) for number, prefix in enumerate(self._kept.prefixes) if number != self._infant
        )

    def _add_events(self) -> None:
        from pynwb.event import EventsTable

        events = [it for it in self._kept.events() if it.infant in (None, self._infant)]
        if not events:
            return
        table = EventsTable(
            name="episodes", description="Ends of episodes, and changes of the world by something other than a step."
        )
        table.add_column(name="event", description="terminated, truncated, or changed")
        table.add_column(name="outcome", description="success, failure or n/a")
        for event in events:
            table.add_event(timestamp=event.time, event=event.name, outcome=event.outcome)
        self.file.add_events_table(table)
