"""Recorders, which write a world's steps into a file."""

from __future__ import annotations

import ctypes
import os
from typing import TYPE_CHECKING, Any, Optional, Union

from . import _abi
from ._handle import Handle
from ._hdf5 import with_hdf5
from ._library import LIB, check, defaults, utf8
from .option_types import RecorderOptions
from .options import fill
from .recorded_world import inner_world

if TYPE_CHECKING:
    from typing_extensions import Unpack


class Recorder(Handle):
    """Records all steps of a world or an environment until it is closed.

        with mimo.Recorder(env, "run.h5", keep="touch,vision/eye_left"):
            ...

    Other changes of the world between two steps are noticed, and a state is kept for replays. A full disk does not fail
    steps; flush and close raise the error. An existing recording is kept and raises FileError unless `replace` is true.

    The file holds the world too, except a custom task, so that Recording.world can make it again.
    """

    def __init__(self, world: Any, path: "Union[str, os.PathLike[str]]", **options: Unpack[RecorderOptions]) -> None:
        inner, config = inner_world(world), defaults(_abi.RecorderConfig)
        fill(config, options, RecorderOptions)
        handle = ctypes.c_void_p()

        def record(library: Optional[bytes]) -> None:
            config.hdf5 = library
            check(LIB.mimo_recorder_open(inner._handle, utf8(os.fspath(path), "path"), config, handle))

        with_hdf5(record, config.hdf5)
        self._own(handle.value, LIB.mimo_recorder_close)

    def flush(self) -> None:
        """Flushes everything to the disk."""
        check(LIB.mimo_recorder_flush(self._handle))

    def close(self) -> None:
        """Keeps the last state and closes the file; raises errors of writing. Closing twice does nothing."""
        if not self.closed:
            check(LIB.mimo_recorder_close(self._handle))
            super().close()
