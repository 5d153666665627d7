"""Objects that own a handle of the library."""

from __future__ import annotations

import ctypes
import sys
from typing import Any, Callable, Optional, TypeVar

from ._strict import Strict
from .errors import ClosedError

NAMES = ("_handle", "_names_handle")  # attributes of an open object
Self = TypeVar("Self", bound="Closing")


class Closing:
    """Closes at the end of a with block."""

    def close(self) -> None:
        """Frees what the object holds."""
        raise NotImplementedError

    def __enter__(self: Self) -> Self:
        return self

    def __exit__(self, *error: object) -> None:
        self.close()


def _in_main_interpreter() -> bool:
    python = ctypes.pythonapi
    python.PyInterpreterState_Get.restype = python.PyInterpreterState_Main.restype = ctypes.c_void_p
    return bool(python.PyInterpreterState_Get() == python.PyInterpreterState_Main())


IN_MAIN = _in_main_interpreter()


class Native(ctypes.c_void_p):
    """A handle of the library and the objects that must outlive it; destroyed with its last reference.

    Python keeps a call's arguments alive while the call runs. So no handle is destroyed during a call, even if another
    thread closes its owner or Python ends while daemon threads are inside the library.
    """

    def __init__(self, handle: Optional[int], destroy: Any = None) -> None:
        super().__init__(handle)
        self._destroy = destroy
        self._destroy_at_end = destroy if IN_MAIN or destroy is None else _keeping_the_lock(destroy)
        self.keeps: Any = ()  # memory that the library writes to, or the object that owns this handle

    def __del__(self, ends: Callable[[], bool] = sys.is_finalizing) -> None:
        if self._destroy is not None and self.value is not None:
            (self._destroy_at_end if ends() else self._destroy)(self)


def _keeping_the_lock(destroy: Any) -> Any:
    """The same function, called without releasing Python's lock.

    Up to Python 3.11, a thread that takes the lock for a subinterpreter while the process ends is terminated. Here that
    would be the only thread, and the process would hang.
    """
    address: Any = ctypes.cast(destroy, ctypes.c_void_p).value
    return ctypes.PYFUNCTYPE(destroy.restype, *destroy.argtypes)(address)


class Handle(Strict, Closing):
    """Closes by close(), at the end of a with block, or with its last reference.

    Later calls raise mimo.ClosedError.
    """

    _handle: Native

    def _own(self, handle: Optional[int], destroy: Any = None) -> None:
        self._handle = Native(handle, destroy)

    def close(self) -> None:
        """Frees the library's objects, after the calls that run in other threads have ended.

        Arrays that it returned stay valid. Closing twice does nothing.
        """
        for name in NAMES:
            self.__dict__.pop(name, None)

    @property
    def closed(self) -> bool:
        """Whether it is closed."""
        return "_handle" not in self.__dict__

    def __getattr__(self, name: str) -> Any:
        if name in NAMES:  # Python calls this only for missing attributes
            raise ClosedError(f"this {type(self).__name__} is closed")
        raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}")
