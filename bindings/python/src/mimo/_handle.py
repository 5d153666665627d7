"""Objects of the library that somebody has to destroy."""

from __future__ import annotations

import weakref
from types import TracebackType
from typing import Any, Optional, Type, TypeVar

Self = TypeVar("Self", bound="Handle")


class Handle:
    """Closes with close(), at the end of a with block, or when nobody refers to it any more.

    What is called afterwards raises mimo.ClosedError: the library recognises destroyed handles.
    """

    _handle: int

    def _own(self, handle: int, destroy: Any) -> None:
        self._handle = handle
        self._finalizer = weakref.finalize(self, destroy, handle)

    def _borrow(self, handle: int) -> None:
        self._handle = handle
        self._finalizer = None

    _finalizer: Optional[weakref.finalize[Any, Any]]

    def close(self) -> None:
        """Frees what the library holds. Arrays that were handed out stay valid. Closing twice does nothing."""
        if self._finalizer is not None:
            self._finalizer()

    @property
    def closed(self) -> bool:
        """Whether it was closed."""
        return self._finalizer is not None and not self._finalizer.alive

    def __enter__(self: Self) -> Self:
        return self

    def __exit__(
        self, kind: Optional[Type[BaseException]], error: Optional[BaseException], trace: Optional[TracebackType]
    ) -> None:
        self.close()
