"""Recordings through the library: what a program does with a world is written by itself, and played again."""

from __future__ import annotations

import ctypes
import importlib.util
import os
from pathlib import Path
from typing import Any, NamedTuple, Optional, Type, TypedDict, Union

import numpy as np
from numpy.typing import NDArray
from typing_extensions import Unpack

from . import _abi
from ._handle import Handle
from ._library import LIB, check, text, utf8
from .arguments import whole_number
from .errors import UnsupportedError
from .options import fill
from .results import StepResult
from .world import World


class RecorderOptions(TypedDict, total=False):
    """What is recorded, and how: see mimo_recorder_config. `hdf5` is the path of the HDF5 library."""

    keep: str
    state_seconds: float
    flush_seconds: float
    compression: int
    configuration: str
    seed: int
    hdf5: str


class Recorder(Handle):
    """Records all steps of a world, or of an environment's, until it is closed.

        with mimo.Recorder(env, "run.h5", keep="touch,vision/eye_left"):
            ...

    Whatever else changes the world between two steps is found, and a state is kept from which a replay goes on there.
    A full disk fails no step; flush and close raise it.
    """

    def __init__(self, world: Any, path: "Union[str, os.PathLike[str]]", **options: Unpack[RecorderOptions]) -> None:
        config = _abi.RecorderConfig()
        check(LIB.mimo_recorder_config_init(config, ctypes.sizeof(config)))
        fill(config, options, RecorderOptions)
        handle = ctypes.c_void_p()

        def record(library: Optional[bytes]) -> None:
            config.hdf5 = library
            check(LIB.mimo_recorder_open(_world_of(world)._handle, utf8(os.fspath(path), "path"), config, handle))

        with_hdf5(record, config.hdf5)
        self._own(handle.value, LIB.mimo_recorder_close)

    def flush(self) -> None:
        """Puts everything on its way to the disk now."""
        check(LIB.mimo_recorder_flush(self._handle))

    def close(self) -> None:
        """Keeps the last state and closes the file; raises what could not be written. Closing twice does nothing."""
        if not self.closed:
            check(LIB.mimo_recorder_close(self._handle))
            super().close()


class ReplayReport(NamedTuple):
    """What a replay has shown so far."""

    identical: bool  # all that was compared, to the last bit
    next: int  # the step that comes next
    steps: int  # how many were played
    first_difference: int  # the first step that differed
    largest_difference: float  # of any number
    differs_most_in: str  # the dataset in which that was, "" where all was identical


class Replay(Handle):
    """A recording that is played again in a world like the one that was recorded.

        with mimo.Replay("run.h5") as replay, mimo.World("reach") as world:
            print(replay.play(world))

    Its numbers are read with `read`, or by h5py, MATLAB, R ... from the file.
    """

    def __init__(self, path: "Union[str, os.PathLike[str]]", hdf5: Optional[str] = None) -> None:
        handle = ctypes.c_void_p()

        def read(library: Optional[bytes]) -> None:
            check(LIB.mimo_recording_open(utf8(os.fspath(path), "path"), library, handle))

        with_hdf5(read, utf8(hdf5, "hdf5"))
        self._own(handle.value, LIB.mimo_recording_destroy)
        info = _abi.RecordingInfo()
        check(LIB.mimo_recording_describe(self._handle, info))
        self.format_version = int(info.format_version)
        self.steps, self.states, self.bodies = int(info.steps), int(info.states), int(info.bodies)
        self.step_seconds = float(info.step_seconds)
        self.same_build = bool(info.same_build)
        self.build, self.this_build = text(info.build), text(info.this_build)
        self.configuration, self.seed = text(info.configuration), int(info.seed)

    def read(self, dataset: str, dtype: Type[np.generic], first: int = 0, rows: Optional[int] = None) -> NDArray[Any]:
        """Rows of a dataset, as many as there are; actions and most fields are float32, joints and rewards float64."""
        there, row_bytes = ctypes.c_size_t(), ctypes.c_size_t()
        name = utf8(dataset, "dataset")
        check(LIB.mimo_recording_size(self._handle, name, there, row_bytes))
        wanted = there.value - first if rows is None else rows
        if row_bytes.value % np.dtype(dtype).itemsize != 0:
            raise ValueError(f"dtype is {np.dtype(dtype)}, but a row of {dataset} has {row_bytes.value} bytes")
        values = np.empty((max(wanted, 0), row_bytes.value // np.dtype(dtype).itemsize), dtype)
        check(LIB.mimo_recording_read(self._handle, name, first, max(wanted, 0), values.ctypes.data, values.nbytes))
        return values

    def seek(self, world: Any, step: int = 0, compare_fields: bool = True) -> int:
        """Loads the last kept state that is not later than a step; returns that state's step.

        Infants become as old as they were. Without compare_fields the world may sense otherwise than the recorded one.
        """
        inner, at = _world_of(world), ctypes.c_size_t()
        number = whole_number("step", step)
        check(LIB.mimo_recording_seek(self._handle, inner._handle, number, int(compare_fields), at))
        self._look(inner)
        return int(at.value)

    def step(self, world: Any) -> StepResult:
        """Plays the next step, and compares what comes of it with the recording."""
        inner = _world_of(world)
        inner.step_with(lambda *to: LIB.mimo_recording_step(self._handle, *to))
        self._look(inner)
        return inner._result

    def play(self, world: Any, step: int = 0, steps: Optional[int] = None, compare_fields: bool = True) -> ReplayReport:
        """Plays from the last state that is not later than `step` to the end, or to so many steps behind `step`."""
        end = self.steps if steps is None else min(self.steps, step + steps)
        for _ in range(self.seek(world, step, compare_fields), end):
            self.step(world)
        return self.report()

    def report(self) -> ReplayReport:
        """What was compared since the last seek."""
        report = _abi.ReplayReport()
        check(LIB.mimo_recording_report(self._handle, report))
        return ReplayReport(
            bool(report.identical),
            int(report.next),
            int(report.steps),
            int(report.first_difference),
            float(report.largest_difference),
            text(report.differs_most_in),
        )

    def _look(self, world: World) -> None:
        if self.bodies > 1:
            world.renew()


def with_hdf5(call: Any, library: Optional[bytes]) -> None:
    """Calls with the path of the HDF5 library that is asked for, or where the system has none of the one in h5py."""
    try:
        call(library)
    except UnsupportedError as error:
        own = None if library is not None or os.environ.get("MIMO_HDF5") else _library_of_h5py()
        if own is None or "libhdf5-103-1" not in str(error):
            raise
        call(own)


def _library_of_h5py() -> Optional[bytes]:
    found = importlib.util.find_spec("h5py")
    if found is None or found.origin is None:
        return None
    beside = Path(found.origin).parent.parent / "h5py.libs"
    return next((os.fsencode(path) for path in sorted(beside.glob("libhdf5-*.so*"))), None)


def _world_of(world: Any) -> World:
    inner = world if isinstance(world, World) else getattr(getattr(world, "unwrapped", world), "world", None)
    if not isinstance(inner, World):
        raise TypeError(f"world is {world!r}, expected a mimo.World or an environment")
    return inner
