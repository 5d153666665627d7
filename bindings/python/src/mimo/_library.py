"""Loads libmimo from this package, once, and turns its status codes into exceptions."""

from __future__ import annotations

import contextlib
import ctypes
import importlib.util
import logging
import os
import sys
import threading
from functools import lru_cache
from pathlib import Path
from typing import Any, Iterator, Optional, Tuple, Type, TypeVar, cast, get_origin, get_type_hints

import numpy as np

from . import _abi
from .constants import LogLevel
from .errors import make_error

S = TypeVar("S", bound=_abi.Struct)
T = TypeVar("T")
PACKAGE = Path(__file__).resolve().parent
NATIVE = PACKAGE / "_native"
LIBRARY_NAME = {"win32": "mimo.dll", "darwin": "libmimo.dylib"}.get(sys.platform, "libmimo.so.1")


def native_file(name: str) -> Path:
    """A file of the package's native part; in a clone, from where `pip install -e` takes the package, the built one."""
    clone = PACKAGE / "../../../.."
    if not NATIVE.is_dir() and (clone / "include/mimo/mimo.h").is_file():
        return (clone / "build" / ("lib" if name == LIBRARY_NAME else "bin") / name).resolve()
    return NATIVE / name


_logger = logging.getLogger("mimo")
_levels = {LogLevel.WARNING: logging.WARNING, LogLevel.INFO: logging.INFO}


# Versions of MuJoCo that pip installs, and the packages with the library for them.
FOR_HOSTS = {"4.0.1": "mimo_mujoco4"}


def library_path() -> Path:
    """The library inside this package, or the one for the package mujoco if the program imported that first.

    The environment variable MIMO_LIBRARY overrides both.
    """
    return Path(os.environ.get("MIMO_LIBRARY") or _for_host() or native_file(LIBRARY_NAME)).resolve()


def _for_host() -> Optional[Path]:
    package = FOR_HOSTS.get(getattr(sys.modules.get("mujoco"), "__version__", ""))
    if package is None or importlib.util.find_spec(package) is None:
        return None
    return Path(importlib.import_module(package).LIBRARY)


def advice_for_host(version: str) -> str:
    """Advice for a user whose MuJoCo is not the library's."""
    if version in FOR_HOSTS:
        return "pip install mimo[mujoco] brings the libmimo for it; import mujoco before mimo"
    return f"there is no libmimo for it yet, only for {', '.join([mujoco_version(), *FOR_HOSTS])}"


def _load(path: Path) -> Any:
    if not path.is_file():
        raise ImportError(
            f"there is no {path}; install the package with pip, run ./dev build in a clone, "
            "or set MIMO_LIBRARY to a libmimo"
        )
    # RTLD_LOCAL, the default of ctypes, keeps it apart from another MuJoCo in this process.
    try:
        library = ctypes.CDLL(str(path))
    except OSError as error:
        advice = "the MuJoCo in its folder must be the one that came with it"
        raise ImportError(f"{path} cannot be loaded: {error}; {advice}") from None
    lacking = [name for name in _abi.FUNCTIONS if not hasattr(library, name)]
    if lacking:
        raise ImportError(f"{path} has no {', '.join(lacking)}; it belongs to another version of this package")
    for name, (result, arguments) in _abi.FUNCTIONS.items():
        function = getattr(library, name)
        function.restype, function.argtypes = result, arguments
    version = library.mimo_abi_version()
    if version != _abi.ABI_VERSION:
        raise ImportError(f"{path} has ABI version {version}, this package needs {_abi.ABI_VERSION}")
    return library


LIB = _load(library_path())


def raise_error(status: int) -> None:
    """Raises the error of the last failed call on this thread."""
    raise make_error(status, message_text(LIB.mimo_last_error()))


def check(status: int) -> None:
    """Raises unless the call succeeded."""
    if status != 0:
        raise_error(status)


def defaults(struct: Type[S]) -> S:
    """A config with the library's defaults."""
    config = struct()
    check(getattr(LIB, struct.init)(config, ctypes.sizeof(config)))
    return config


def result(kind: Any, function: Any, *arguments: Any) -> Any:
    """The number or text that a function writes behind its arguments."""
    value = kind()
    check(function(*arguments, value))
    return value.value


def from_struct(kind: Type[T], struct: ctypes.Structure, **others: Any) -> T:
    """A dataclass or named tuple made of the members of a struct that have its attributes' names."""
    hints = _hints(cast(Any, kind))
    values = {name: _converted(getattr(struct, name), hints[name]) for name in hints if name not in others}
    return kind(**values, **others)


@lru_cache(maxsize=None)
def _hints(kind: Any) -> Any:
    return get_type_hints(kind)


def _converted(value: Any, kind: Any) -> Any:
    if kind is str:
        return text(value)
    if isinstance(value, ctypes.Array):
        return tuple(value) if get_origin(kind) is tuple else np.array(value)
    return kind(value) if isinstance(kind, type) else value


def text(value: Optional[bytes]) -> str:
    """A name from the library; bytes that are not UTF-8 survive the way back to it."""
    return (value or b"").decode(errors="surrogateescape")


def message_text(value: Optional[bytes]) -> str:
    """A message from the library, always printable."""
    return (value or b"").decode(errors="replace")


def utf8(value: Optional[str], name: str = "name") -> Optional[bytes]:
    """A string for the library; refuses zero bytes, at which C would stop reading."""
    if value is None:
        return None
    if not isinstance(value, str):
        raise TypeError(f"{name} is {value!r}, expected a string")
    if "\0" in value:
        raise ValueError(f"{value!r} contains a zero byte")
    return value.encode(errors="surrogateescape")


_told = threading.local()


@contextlib.contextmanager
def told_before() -> Iterator[None]:
    """Suppresses log messages while this thread repeats calls that have logged them before."""
    before = getattr(_told, "before", False)
    _told.before = True
    try:
        yield
    finally:
        _told.before = before


@_abi.LogFn  # type: ignore[untyped-decorator]
def log_to_python(_user: Any, told: Any) -> None:
    """Passes the library's messages to the logger "mimo". As a module-level function it outlives all handles."""
    if sys.is_finalizing() or getattr(_told, "before", False):
        return
    record = told.contents
    where = {"world": record.world, "time": record.time} if record.in_world else {"world": None, "time": None}
    level = _levels.get(record.level, logging.INFO)
    _logger.log(level, "%s", message_text(record.text), extra={"code": record.code, **where})


def abi_version() -> int:
    """Version of the library's binary interface."""
    return int(LIB.mimo_abi_version())


def api_version() -> Tuple[int, int]:
    """Version of the library's API: major, minor."""
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
