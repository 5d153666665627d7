"""Objects of the library that somebody has to destroy."""

from __future__ import annotations

import ctypes
import sys
from types import TracebackType
from typing import Any, Callable, Optional, Type, TypeVar

from ._strict import Strict
from .errors import ClosedError

NAMES = ("_handle", "_names_handle")  # attributes that an open object has
Self = TypeVar("Self", bound="Handle")


def _in_main_interpreter() -> bool:
    python = ctypes.pythonapi
    python.PyInterpreterState_Get.restype = python.PyInterpreterState_Main.restype = ctypes.c_void_p
    return bool(python.PyInterpreterState_Get() == python.PyInterpreterState_Main())


IN_MAIN = _in_main_interpreter()


class Native(ctypes.c_void_p):
    """A handle of the library, and what has to live as long as it; destroyed when nobody refers to it any more.

    Python keeps the arguments of a call while it runs, this one among them. So nothing is destroyed under a call,
    whatever another thread closes meanwhile, and nothing under the calls of daemon threads when Python ends.
    """

    def __init__(self, handle: Optional[int], destroy: Any = None) -> None:
        super().__init__(handle)
        self._destroy = destroy
        self._destroy_at_end = destroy if IN_MAIN or destroy is None else _keeping_the_lock(destroy)
        self.keeps: Any = ()  # memory that the library writes to, or the object that this one is a part of

    def __del__(self, ends: Callable[[], bool] = sys.is_finalizing) -> None:
        if self._destroy is not None and self.value is not None:
            (self._destroy_at_end if ends() else self._destroy)(self)


def _keeping_the_lock(destroy: Any) -> Any:
    """The same function, called without giving Python's lock away.

    When the process ends, up to Python 3.11, a thread that takes the lock for another interpreter than the main one
    is ended: here the only thread, and the process would wait for ever.
    """
    address: Any = ctypes.cast(destroy, ctypes.c_void_p).value
    return ctypes.PYFUNCTYPE(destroy.restype, *destroy.argtypes)(address)


class Handle(Strict):
    """Closes with close(), at the end of a with block, or when nobody refers to it any more.

    What is called afterwards raises mimo.ClosedError.
    """

    _handle: Native

    def _own(self, handle: Optional[int], destroy: Any = None) -> None:
        self._handle = Native(handle, destroy)

    def close(self) -> None:
        """Frees what the library holds, once the calls that run in other threads have ended.

        Arrays that were handed out stay valid. Closing twice does nothing.
        """
        for name in NAMES:
            self.__dict__.pop(name, None)

    @property
    def closed(self) -> bool:
        """Whether it was closed."""
        return "_handle" not in self.__dict__

    def __getattr__(self, name: str) -> Any:
        if name in NAMES:  # Python asks here only for what is not there any more
            raise ClosedError(f"this {type(self).__name__} is closed")
        raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}")

    def __enter__(self: Self) -> Self:
        return self

    def __exit__(
        self, kind: Optional[Type[BaseException]], error: Optional[BaseException], trace: Optional[TracebackType]
    ) -> None:
        self.close()
