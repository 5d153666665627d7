"""Exceptions of failed calls. The library's message names the argument, its value and the expected one."""

from __future__ import annotations

from typing import Dict, Type

from .constants import Status


class Error(Exception):
    """Base of all exceptions for failed calls, itself raised for a status that only a newer library has.

    `status` is the status that the call returned.
    """

    status: int = Status.OK


class ArgumentError(Error, ValueError):
    """An argument is out of range, of the wrong size or not finite. Nothing was changed."""


class ClosedError(Error, ValueError):
    """The scene, world or batch was closed."""

    status = Status.BAD_HANDLE


class NotFoundError(Error, LookupError):
    """No scene, body, joint, file... of that name; the message lists existing names."""


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
    """A file cannot be written, or a file or state is damaged or something else."""


class TaskError(Error, RuntimeError):
    """A mimo.WorldTask raised an exception or returned an invalid judgement."""


class BusyError(Error, RuntimeError):
    """Another thread is using this object, or another call has to come first; nothing was changed."""


class MismatchError(Error, ValueError):
    """A state or recording is of another model, age, task or kind of agents."""


class EndError(Error, EOFError):
    """A recording has no further step."""


class InternalError(Error, RuntimeError):
    """A defect in libmimo; please report the message."""


BY_STATUS: Dict[int, Type[Error]] = {
    Status.INVALID_ARGUMENT: ArgumentError,
    Status.BAD_HANDLE: ClosedError,
    Status.BUFFER_TOO_SMALL: ArgumentError,
    Status.STRUCT_SIZE: InternalError,  # the structs of this package always have the library's size
    Status.NOT_FOUND: NotFoundError,
    Status.MODEL: ModelError,
    Status.SIMULATION: SimulationError,
    Status.RENDER: RenderError,
    Status.UNSUPPORTED: UnsupportedError,
    Status.OUT_OF_MEMORY: OutOfMemoryError,
    Status.FORKED: ForkedError,
    Status.INTERNAL: InternalError,
    Status.FILE: FileError,
    Status.TASK: TaskError,
    Status.BUSY: BusyError,
    Status.MISMATCH: MismatchError,
    Status.END: EndError,
}


def make_error(status: int, message: str) -> Error:
    """The exception for a status."""
    error = BY_STATUS.get(status, Error)(message)
    error.status = Status(status) if status in BY_STATUS else status
    return error
