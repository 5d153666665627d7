"""Arrays that follow a world and write to it, as MuJoCo's arrays do."""

from __future__ import annotations

import weakref
from typing import Any, Callable, Optional

import numpy as np
from numpy.typing import NDArray

from .._strict import Copied
from ..world import World

Numbers = NDArray[Any]
Write = Callable[[Numbers, Numbers], None]  # the values, and the values before
PAGE = "docs/guide/classic.md says what to write instead"


class Stage:
    """A world, whether its senses are current, and the arrays of it that a script keeps."""

    def __init__(self, world: World) -> None:
        self.world = world
        self.observed = False  # world.observation is that of the current state
        self.start: Any = None  # positions and velocities with which it was made
        self.contacts: Any = None  # of the current state, once a script has asked for them
        self._kept: Any = weakref.WeakValueDictionary()  # arrays by id

    def moved(self, observed: bool = False) -> None:
        """Tells that the world has changed: kept arrays are read again. `observed`: the senses have seen it."""
        self.observed, self.contacts = observed, None
        if self._kept:
            for array in list(self._kept.values()):
                array.pull()

    def array(self, read: Callable[[], Any], write: Optional[Write] = None, refusal: str = "") -> "Live":
        """An array of this world, which a script may keep."""
        values = np.atleast_1d(np.array(read()))
        made = values.view(Live)
        made.flags.writeable = False
        made.source = Source(self, read, write, refusal, values)
        self._kept[id(made)] = made
        return made

    def __getstate__(self) -> Any:
        return {**self.__dict__, "_kept": None}

    def __setstate__(self, state: Any) -> None:
        self.__dict__.update(state, _kept=weakref.WeakValueDictionary())


class Source:
    """The place of an array's values: how they are read, and written."""

    def __init__(
        self, stage: Stage, read: Callable[[], Any], write: Optional[Write], refusal: str, values: Numbers
    ) -> None:
        self.stage, self.read, self.write, self.refusal, self.values = stage, read, write, refusal, values

    def pull(self) -> None:
        """Reads the values again."""
        now = np.asarray(self.read())
        if now.size == self.values.size:
            self.values[...] = now.reshape(self.values.shape)

    def change(self, edit: Callable[[], Any]) -> Any:
        """Edits the values, and writes them to the world, which may refuse them."""
        if self.write is None:
            raise ValueError(self.refusal)
        self.pull()
        before = self.values.copy()
        made = edit()
        try:
            self.write(self.values, before)
        except Exception:
            self.pull()
            raise
        self.stage.moved()
        return made


class Live(Copied):
    """An array of a world. Assigning to its elements writes to the world, or is refused; copies are ordinary arrays."""

    source: Optional[Source]

    def __array_finalize__(self, parent: Any) -> None:
        self.source = None

    def pull(self) -> None:
        """Reads the values again."""
        if self.source is not None:
            self.source.pull()

    def _same(self, view: Any) -> Any:
        """A view of this array writes to the same place; other arrays are ordinary ones."""
        if not isinstance(view, Live):
            return view
        if not np.may_share_memory(view, self):
            return np.asarray(view)
        view.source = self.source
        return view

    def _edited(self, edit: Callable[[], Any]) -> Any:
        if self.source is None:
            raise ValueError(f"this array is a copy, so writing to it would change nothing; {PAGE}")

        def change() -> Any:
            self.flags.writeable = True
            try:
                return edit()
            finally:
                self.flags.writeable = False

        return self.source.change(change)

    def __getitem__(self, key: Any) -> Any:
        return self._same(super().__getitem__(key))

    def __setitem__(self, key: Any, value: Any) -> None:
        plain = np.asarray(value)
        self._edited(lambda: super(Live, self).__setitem__(key, plain))

    def fill(self, value: Any) -> None:
        """Sets all elements."""
        self[...] = value

    def reshape(self, *shape: Any, **options: Any) -> Any:
        """The array with another shape."""
        return self._same(super().reshape(*shape, **options))

    def ravel(self, *order: Any) -> Any:
        """The array as one row."""
        return self._same(super().ravel(*order))

    def squeeze(self, *axis: Any, **options: Any) -> Any:
        """The array without axes of length 1."""
        return self._same(super().squeeze(*axis, **options))

    @property
    def T(self) -> Any:
        """The transposed array."""
        return self._same(super().transpose())

    def __array_ufunc__(self, ufunc: Any, method: str, *inputs: Any, out: Any = None, **options: Any) -> Any:
        plain = [_plain(it) for it in inputs]
        if method == "at" and isinstance(inputs[0], Live):
            return inputs[0]._edited(lambda: ufunc.at(np.asarray(inputs[0]), *plain[1:], **options))
        if out is None:
            return getattr(ufunc, method)(*plain, **options)
        if len(out) == 1 and isinstance(out[0], Live):
            target = out[0]
            target._edited(lambda: getattr(ufunc, method)(*plain, out=np.asarray(target), **options))
            return target
        return getattr(ufunc, method)(*plain, out=tuple(_plain(it) for it in out), **options)

    def __array_function__(self, function: Any, types: Any, arguments: Any, options: Any) -> Any:
        if function is np.copyto and isinstance(arguments[0], Live):
            arguments[0][...] = np.broadcast_to(arguments[1], arguments[0].shape)
            return None
        return function(*_deep(arguments), **{name: _plain(it) for name, it in options.items()})

    def flatten(self, order: Any = "C") -> Any:
        """A copy as one row."""
        return np.asarray(self).flatten(order)

    def astype(self, *arguments: Any, **options: Any) -> Any:
        """A copy of another type."""
        return np.array(np.asarray(self).astype(*arguments, **options))


def _plain(value: Any) -> Any:
    return np.asarray(value) if isinstance(value, Live) else value


def _deep(value: Any) -> Any:
    """Plain arrays for those in lists, too, as in np.concatenate([a, b])."""
    if isinstance(value, (list, tuple)):
        return type(value)(_deep(it) for it in value) if type(value) in (list, tuple) else value
    return _plain(value)
