"""Reads and replays recordings, the HDF5 files of mimo.Recorder and `mimo record`."""

from __future__ import annotations

import argparse
import ctypes
import os
from typing import Any, List, NamedTuple, Optional, Type, Union

import numpy as np
from numpy.typing import NDArray

from . import _abi
from ._handle import Handle
from ._hdf5 import with_hdf5
from ._library import LIB, check, from_struct, text, utf8
from .arguments import whole_number
from .constants import Replay
from .drawing import EYES
from .own_sense import BoundSense, Sense
from .recorded_world import inner_world, recorded_world, world_of_scene
from .results import StepResult
from .world import World


class ReplayReport(NamedTuple):
    """The result of a replay so far."""

    identical: bool  # whether all compared numbers were equal, bit for bit
    next: int  # the next step
    steps: int  # played steps
    first_difference: int  # the first step that differed
    largest_difference: float  # of all numbers
    differs_most_in: str  # its dataset, "" if all were equal


def add_sense_option(parser: argparse._ActionsContainer) -> None:
    """The option of programs that load senses of a user's own."""
    told = "shared library with a sense of your own, whose code runs; may be given several times"
    parser.add_argument("--sense", metavar="FILE", action="append", default=[], help=told)


class Recording(Handle):
    """A recording, which can be replayed in a world like the recorded one.

        with mimo.Recording("run.h5") as recording, recording.world() as world:
            print(recording.play(world))

    `read` reads its numbers, as do h5py, MATLAB, R and others from the file.
    """

    path: str
    format_version: int
    steps: int
    states: int
    bodies: int  # different ages of its infants
    step_seconds: float
    same_build: bool  # whether this build of the library wrote it
    build: str
    this_build: str
    configuration: str
    seed: int
    library: str  # its version; "" in recordings of format version 1 and 2
    mujoco: str  # likewise

    def __init__(self, path: "Union[str, os.PathLike[str]]", hdf5: Optional[str] = None) -> None:
        self._have(path=os.fspath(path))
        self._own_senses: List[BoundSense] = []
        handle = ctypes.c_void_p()

        def read(library: Optional[bytes]) -> None:
            check(LIB.mimo_recording_open(utf8(self.path, "path"), library, handle))

        with_hdf5(read, utf8(hdf5, "hdf5"))
        self._own(handle.value, LIB.mimo_recording_close)
        info = _abi.RecordingInfo()
        check(LIB.mimo_recording_describe(self._handle, info))
        self._have(
            format_version=int(info.format_version),
            steps=int(info.steps),
            states=int(info.states),
            bodies=int(info.bodies),
            step_seconds=float(info.step_seconds),
            same_build=bool(info.same_build),
            build=text(info.build),
            this_build=text(info.this_build),
            configuration=text(info.configuration),
            seed=int(info.seed),
            library=text(info.library),
            mujoco=text(info.mujoco),
        )

    def read(self, dataset: str, dtype: Type[np.generic], first: int = 0, rows: Optional[int] = None) -> NDArray[Any]:
        """Rows of a dataset, by default all; actions and most fields are float32, joints and rewards float64."""
        there, row_bytes = ctypes.c_size_t(), ctypes.c_size_t()
        name = utf8(dataset, "dataset")
        check(LIB.mimo_recording_size(self._handle, name, there, row_bytes))
        wanted = there.value - first if rows is None else rows
        if row_bytes.value % np.dtype(dtype).itemsize != 0:
            raise ValueError(f"dtype is {np.dtype(dtype)}, but a row of {dataset} has {row_bytes.value} bytes")
        values = np.empty((max(wanted, 0), row_bytes.value // np.dtype(dtype).itemsize), dtype)
        check(LIB.mimo_recording_read(self._handle, name, first, max(wanted, 0), values.ctypes.data, values.nbytes))
        return values

    def load_sense(self, path: "Union[str, os.PathLike[str]]") -> None:
        """Brings along a shared library with a sense that the recorded world had; a file loads no code by itself."""
        check(LIB.mimo_recording_load_sense(self._handle, utf8(os.path.abspath(path), "path")))

    def add_sense(self, sense: Sense) -> None:
        """Brings along a sense in Python that the recorded world had. Its fields stay 0, as in the recording."""
        self._own_senses.append(BoundSense(sense))
        check(LIB.mimo_recording_add_sense(self._handle, self._own_senses[-1].table()))

    def world(self, eyes: int = EYES, scene: Optional[str] = None) -> World:
        """Makes the recorded world from the file, with touch, and eyes of `eyes` x `eyes` pixels; 0: no eyes.

        A custom task is not in the file: the world gets one that does nothing, and a replay returns the recorded
        rewards. Recordings of format version 1 and 2 hold no world and need the name or the file of their `scene`.
        """
        if self.library == "" and scene is not None:
            return world_of_scene(scene, eyes)
        if scene is not None:
            raise ValueError(f"scene is {scene!r}, but {self.path} holds its world itself")
        return recorded_world(self, self.path, eyes)

    def seek(self, world: Any, step: int = 0, compare_fields: bool = True, joints: bool = False) -> int:
        """Loads the last kept state that is not later than a step; returns that state's step.

        Infants get their recorded age. With `compare_fields=False` the world's senses may differ from the recording.
        With `joints=True` no state is loaded, and steps set the recorded joints, which works with any version.
        """
        inner, at = inner_world(world), ctypes.c_size_t()
        number = whole_number("step", step)
        how = (Replay.FIELDS if compare_fields else 0) | (Replay.JOINTS if joints else 0)
        check(LIB.mimo_recording_seek(self._handle, inner._handle, number, how, at))
        self._look(inner)
        return int(at.value)

    def step(self, world: Any, senses: bool = True) -> StepResult:
        """Plays the next step and compares it with the recording; without senses the observation stays."""
        inner = inner_world(world)
        inner.step_with(lambda *to: LIB.mimo_recording_step(self._handle, *to), senses)
        self._look(inner)
        return inner._result

    def move_to(self, world: Any, step: int) -> None:
        """Brings a world, whose senses may differ, to its recorded state after `step` steps."""
        for _ in range(self.seek(world, step, compare_fields=False), step):
            self.step(world, senses=False)
        inner_world(world).observe()

    def play(self, world: Any, step: int = 0, steps: Optional[int] = None, compare_fields: bool = True) -> ReplayReport:
        """Plays from the last state that is not later than `step` to the end, or until `step + steps`."""
        end = self.steps if steps is None else min(self.steps, step + steps)
        for _ in range(self.seek(world, step, compare_fields), end):
            self.step(world)
        return self.report()

    def report(self) -> ReplayReport:
        """The comparison since the last seek."""
        report = _abi.ReplayReport()
        check(LIB.mimo_recording_report(self._handle, report))
        return from_struct(ReplayReport, report)

    def _look(self, world: World) -> None:
        if self.bodies > 1:
            world.renew()
