"""What a failed call raises. Each carries the library's message: the argument, its value and what was expected."""

from __future__ import annotations

from typing import Dict, Type


class Error(Exception):
    """Whatever libmimo complains about; `status` is the C API's number."""

    status = 0


class ArgumentError(Error, ValueError):
    """An argument is out of range, of the wrong size or not finite. Nothing was changed."""


class ClosedError(Error, ValueError):
    """The scene, world or batch was closed."""

    status = -2


class NotFoundError(Error, LookupError):
    """No scene, body, joint, file... of that name; the message lists names that are there."""


class ModelError(Error, ValueError):
    """A model does not compile; the message is MuJoCo's, or names file and line."""


class SimulationError(Error, RuntimeError):
    """The simulation failed or diverged. A reset makes the world usable again."""


class RenderError(Error, RuntimeError):
    """A picture could not be drawn."""


class UnsupportedError(Error, RuntimeError):
    """Not possible on this machine, for example because OSMesa or a display is missing."""


class OutOfMemoryError(Error, MemoryError):
    """An allocation failed; the call had no effect."""


class ForkedError(Error, RuntimeError):
    """The object was made before fork(), in the parent process. Make a new one in the child."""


class FileError(Error, OSError):
    """A file cannot be written, or is not what it should be."""


class TaskError(Error, RuntimeError):
    """A mimo.WorldTask raised something, or said what cannot be meant."""


class BusyError(Error, RuntimeError):
    """Not now, and nothing was changed: another thread is using this object, or another call has to come first."""


class InternalError(Error, RuntimeError):
    """A defect in libmimo; please report the message."""


BY_STATUS: Dict[int, Type[Error]] = {
    -1: ArgumentError,
    -2: ClosedError,
    -3: ArgumentError,
    -4: InternalError,  # the structs of this package always have the library's size
    -5: NotFoundError,
    -6: ModelError,
    -7: SimulationError,
    -8: RenderError,
    -9: UnsupportedError,
    -10: OutOfMemoryError,
    -11: ForkedError,
    -12: InternalError,
    -13: FileError,
    -14: TaskError,
    -15: BusyError,
}


def make_error(status: int, message: str) -> Error:
    """The exception for a status."""
    error = BY_STATUS.get(status, InternalError)(message)
    error.status = status
    return error
