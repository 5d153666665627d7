"""Files that are written beside their place and renamed when they are whole, as the program `mimo` writes its own."""

from __future__ import annotations

import os
import secrets
import stat
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Iterator, Union

from .errors import Error

MARK = ".mimo-"  # how names of what is not whole begin
Name = Union[str, "os.PathLike[str]"]


def require_writable(name: Name) -> None:
    """That a file can be written there: to be asked before the work, not after it."""
    path = Path(name)
    if not path.parent.is_dir():
        raise FileNotFoundError(f"cannot write {path}: there is no folder {path.parent}")
    if path.is_dir():
        raise IsADirectoryError(f"cannot write {path}: it is a folder")
    if path.is_fifo() and not _is_open_pipe(path):
        raise OSError(f"cannot write {path}: it is a pipe with a name")
    if path.exists() and not path.is_file() and not _is_stream(path):
        raise OSError(f"cannot write {path}: it is no plain file")
    if not os.access(path if path.exists() else path.parent, os.W_OK):
        raise PermissionError(f"cannot write {path}: it may not be written to")


@contextmanager
def new_file(name: Name) -> Iterator[Path]:
    """The name of a file beside another one, with its ending, which is to be written in the block.

    Afterwards it takes the other one's place: what a link leads to, with the rights that were there. Where the block
    fails, nothing is left of it.
    """
    require_writable(name)
    if _is_stream(Path(name)):
        yield Path(name)
        return
    beside = _beside(Path(name))
    try:
        with failures_named(name):
            yield beside
        put(beside, name)
    finally:
        with suppress(FileNotFoundError):
            beside.unlink()


def put(made: Path, name: Name) -> None:
    """Moves a whole file to its place, in the same file system."""
    place = Path(os.path.realpath(name))
    with failures_named(name):
        if place.exists():
            made.chmod(stat.S_IMODE(place.stat().st_mode))
        made.replace(place)


@contextmanager
def failures_named(name: Name) -> Iterator[None]:
    """What the system refuses in the block is told of the file that was asked for, not of those beside it."""
    try:
        yield
    except OSError as error:
        of_others = error.filename is not None and MARK not in str(error.filename)
        if error.errno is None or of_others or isinstance(error, Error):
            raise
        kind = type(OSError(error.errno, ""))  # the class that belongs to the number
        failure = kind(f"cannot write {os.fspath(name)}: {error.strerror or error}")
        failure.errno = error.errno
        raise failure from None


def _beside(path: Path) -> Path:
    """A name that nobody has thought of, in the folder of what a link leads to."""
    return Path(os.path.realpath(path)).with_name(f"{MARK}{secrets.token_hex(8)}{path.suffix}")


def _is_stream(path: Path) -> bool:
    """What has no content of its own to keep, and needs no name."""
    return path.is_char_device() or (path.is_fifo() and _is_open_pipe(path))


def _is_open_pipe(path: Path) -> bool:
    """Whether a pipe has both ends, as bash's >(...) has; one with a name waits for the other."""
    return not os.path.exists(os.path.realpath(path))
