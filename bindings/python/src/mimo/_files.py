"""Writes files under a temporary name and renames them when they are complete, as the program `mimo` does."""

from __future__ import annotations

import os
import secrets
import shutil
import stat
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Iterator, Union

from .errors import Error

MARK = ".mimo-"  # prefix of temporary names
Name = Union[str, "os.PathLike[str]"]


def require_writable(name: Name) -> None:
    """Raises unless a file can be written there; call it before the work, not after it."""
    path = Path(name)
    if not path.parent.is_dir():
        raise FileNotFoundError(f"cannot write {path}: there is no folder {path.parent}")
    if path.is_dir():
        raise IsADirectoryError(f"cannot write {path}: it is a folder")
    if path.is_fifo() and not _is_open_pipe(path):
        raise OSError(f"cannot write {path}: it is a named pipe")
    if path.exists() and not path.is_file() and not _is_stream(path):
        raise OSError(f"cannot write {path}: it is not a plain file")
    if not os.access(path if path.exists() else path.parent, os.W_OK):
        raise PermissionError(f"cannot write {path}: it may not be written to")


@contextmanager
def new_file(name: Name) -> Iterator[Path]:
    """Yields a temporary name in the same folder, with the same suffix; the block writes that file.

    Afterwards the file replaces `name` (or the target of a link) and keeps its permissions. If the block fails, the
    temporary file is removed.
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
    """Moves a complete file to its place, in the same file system."""
    place = Path(os.path.realpath(name))
    with failures_named(name):
        if place.exists():
            made.chmod(stat.S_IMODE(place.stat().st_mode))
        made.replace(place)


@contextmanager
def failures_named(name: Name) -> Iterator[None]:
    """Makes errors of the system in the block name the requested file, not the temporary one."""
    try:
        yield
    except OSError as error:
        of_others = error.filename is not None and MARK not in str(error.filename)
        if error.errno is None or of_others or isinstance(error, Error):
            raise
        kind = type(OSError(error.errno, ""))  # the subclass for that errno
        failure = kind(f"cannot write {os.fspath(name)}: {error.strerror or error}")
        failure.errno = error.errno
        raise failure from None


def _beside(path: Path) -> Path:
    """An unused name in the folder of the file, or of a link's target."""
    return Path(os.path.realpath(path)).with_name(f"{MARK}{secrets.token_hex(8)}{path.suffix}")


def _is_stream(path: Path) -> bool:
    """Whether it is a device or an open pipe: such a file keeps no content and is written directly."""
    return path.is_char_device() or (path.is_fifo() and _is_open_pipe(path))


def _is_open_pipe(path: Path) -> bool:
    """Whether a pipe has both ends, like bash's >(...); a named pipe waits for its reader."""
    return not os.path.exists(os.path.realpath(path))


@contextmanager
def new_folder(name: Name) -> Iterator[Path]:
    """Yields a temporary folder beside `name`, which takes that name when the block is done; `name` is new or empty."""
    place = Path(os.path.realpath(name))
    if not place.parent.is_dir():
        raise FileNotFoundError(f"cannot write {name}: there is no folder {place.parent}")
    if place.exists() and not place.is_dir():
        raise NotADirectoryError(f"cannot write {name}: it is a file, expected a folder")
    if place.is_dir() and any(place.iterdir()):
        raise FileExistsError(f"cannot write {name}: the folder is not empty")
    if not os.access(place.parent, os.W_OK):
        raise PermissionError(f"cannot write {name}: {place.parent} may not be written to")
    beside = place.with_name(f"{MARK}{secrets.token_hex(8)}")
    with failures_named(name):
        beside.mkdir()
        try:
            yield beside
            if place.is_dir():
                place.rmdir()
            beside.replace(place)
        finally:
            shutil.rmtree(beside, ignore_errors=True)
