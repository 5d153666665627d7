"""What a program does with a world, written into a recording by the library."""

from __future__ import annotations

import ctypes
import os
from typing import Any, Optional, TypedDict, Union

from typing_extensions import Unpack

from . import _abi
from ._handle import Handle
from ._hdf5 import with_hdf5
from ._library import LIB, check, defaults, utf8
from .options import fill
from .recorded_world import configuration_of, inner_world


class RecorderOptions(TypedDict, total=False):
    """What is recorded, and how: see mimo_recorder_config. `hdf5` is the path of the HDF5 library.

    Without `configuration` it is how the world was made, from which Recording.world makes it anew; "" for worlds with
    tasks of their own.
    """

    keep: str
    state_seconds: float
    flush_seconds: float
    compression: int
    configuration: str
    seed: int
    hdf5: str
    replace: bool


class Recorder(Handle):
    """Records all steps of a world, or of an environment's, until it is closed.

        with mimo.Recorder(env, "run.h5", keep="touch,vision/eye_left"):
            ...

    Whatever else changes the world between two steps is found, and a state is kept from which a replay goes on there.
    A full disk fails no step; flush and close raise it. A recording that is there stays, and is a FileError, unless
    `replace` is true.
    """

    def __init__(self, world: Any, path: "Union[str, os.PathLike[str]]", **options: Unpack[RecorderOptions]) -> None:
        inner, config = inner_world(world), defaults(_abi.RecorderConfig)
        options.setdefault("configuration", configuration_of(inner))
        fill(config, options, RecorderOptions)
        handle = ctypes.c_void_p()

        def record(library: Optional[bytes]) -> None:
            config.hdf5 = library
            check(LIB.mimo_recorder_open(inner._handle, utf8(os.fspath(path), "path"), config, handle))

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
