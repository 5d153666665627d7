"""Loads libmimo from this package, once, and turns its status codes into exceptions."""

from __future__ import annotations

import contextlib
import ctypes
import importlib.util
import logging
import os
import sys
import threading
from pathlib import Path
from typing import Any, Iterator, Optional, Tuple

from . import _abi
from .errors import make_error

NATIVE = Path(__file__).resolve().parent / "_native"
LIBRARY_NAME = {"win32": "mimo.dll", "darwin": "libmimo.dylib"}.get(sys.platform, "libmimo.so.1")

_logger = logging.getLogger("mimo")
_levels = {1: logging.WARNING, 2: logging.INFO}


# Packages with the library for a MuJoCo that pip installs, and which MuJoCo that is.
FOR_HOSTS = {"4.0.1": "mimo_mujoco4"}


def library_path() -> Path:
    """The library inside this package, or the one that fits the package mujoco, if a program has imported that before.

    Developers can name another in MIMO_LIBRARY.
    """
    return Path(os.environ.get("MIMO_LIBRARY") or _for_host() or NATIVE / LIBRARY_NAME).resolve()


def _for_host() -> Optional[Path]:
    package = FOR_HOSTS.get(getattr(sys.modules.get("mujoco"), "__version__", ""))
    if package is None or importlib.util.find_spec(package) is None:
        return None
    return Path(importlib.import_module(package).LIBRARY)


def advice_for_host(version: str) -> str:
    """What the user of another MuJoCo than the library's can do."""
    if version in FOR_HOSTS:
        return "pip install mimo[mujoco] brings the libmimo for it; import mujoco before mimo"
    return f"there is no libmimo for it yet, only for {', '.join([mujoco_version(), *FOR_HOSTS])}"


def _load(path: Path) -> Any:
    if not path.is_file():
        raise ImportError(
            f"there is no {path}; install the package with pip, or set MIMO_LIBRARY to the path of libmimo"
        )
    # Its own scope (ctypes' default): another MuJoCo in this process neither disturbs nor is disturbed.
    try:
        library = ctypes.CDLL(str(path))
    except OSError as error:
        advice = "the MuJoCo in its folder has to be the one that came with it"
        raise ImportError(f"{path} cannot be loaded: {error}; {advice}") from None
    for name, (result, arguments) in _abi.FUNCTIONS.items():
        function = getattr(library, name, None)
        if function is None:
            raise ImportError(f"{path} has no {name}; it belongs to another version of this package")
        function.restype, function.argtypes = result, arguments
    version = library.mimo_abi_version()
    if version != _abi.ABI_VERSION:
        raise ImportError(f"{path} has ABI version {version}, this package needs {_abi.ABI_VERSION}")
    return library


LIB = _load(library_path())


def raise_error(status: int) -> None:
    """Raises what the last failed call on this thread complained about."""
    raise make_error(status, message_text(LIB.mimo_last_error()))


def check(status: int) -> None:
    """Raises unless the call succeeded."""
    if status != 0:
        raise_error(status)


def text(value: Optional[bytes]) -> str:
    """A name of the library's; bytes of a file's path or a model's name that are no UTF-8 find their way back."""
    return (value or b"").decode(errors="surrogateescape")


def message_text(value: Optional[bytes]) -> str:
    """A message of the library's, always printable."""
    return (value or b"").decode(errors="replace")


def utf8(value: Optional[str], name: str = "name") -> Optional[bytes]:
    """A string for the library. Python would pass an embedded zero on, and C would stop reading there."""
    if value is None:
        return None
    if not isinstance(value, str):
        raise TypeError(f"{name} is {value!r}, expected a text")
    if "\0" in value:
        raise ValueError(f"{value!r} contains a zero byte")
    return value.encode(errors="surrogateescape")


_told = threading.local()


@contextlib.contextmanager
def told_before() -> Iterator[None]:
    """While this thread makes once more what it has made: the library's messages were told the first time."""
    before = getattr(_told, "before", False)
    _told.before = True
    try:
        yield
    finally:
        _told.before = before


@_abi.LogFunction  # type: ignore[untyped-decorator]
def log_to_python(_user: Any, told: Any) -> None:
    """Hands the library's messages to the logger "mimo". Lives as long as the process, so no handle can outlive it."""
    if sys.is_finalizing() or getattr(_told, "before", False):
        return
    record = told.contents
    where = {"world": record.world, "time": record.time} if record.in_world else {"world": None, "time": None}
    level = _levels.get(record.level, logging.INFO)
    _logger.log(level, "%s", message_text(record.text), extra={"code": record.code, **where})


def abi_version() -> int:
    """Version of the library's binary interface, which is that of this package."""
    return int(LIB.mimo_abi_version())


def api_version() -> Tuple[int, int]:
    """Version of what the library declares: major, minor."""
    major, minor = divmod(LIB.mimo_api_version(), 1000)
    return major, minor


def supports(name: str) -> bool:
    """Whether the library knows a name of mimo.h: a function, a constant, a struct, or a member ("mimo_field.end")."""
    return bool(LIB.mimo_supports(utf8(name)))


def version() -> str:
    """Version of the library, "major.minor.patch"."""
    return text(LIB.mimo_version())


def mujoco_version() -> str:
    """Version of the MuJoCo that the library runs on."""
    return text(LIB.mimo_mujoco_version())
