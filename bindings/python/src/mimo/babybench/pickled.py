"""Reads the plain part of pickle's format: numbers, strings, lists, dicts and arrays of numbers and strings.

It calls and imports nothing that a file names, so a file cannot execute anything.
"""

from __future__ import annotations

import math
import pickletools
import re
import sys
from typing import Any, Callable, Dict, List, Optional, Tuple

import numpy as np
from numpy.typing import NDArray

EXPECTED = "expected numbers, texts, lists, dicts and arrays"
LONGEST = 8  # bytes of a whole number
PLAIN = re.compile(r"\?|[biufcSU]\d{1,6}")  # types of arrays' elements


class Refused(ValueError):
    """Unsupported content."""


class _Kind:
    """The type of an array's elements, which a file gives in two steps."""

    def __init__(self, name: Any, *_: Any) -> None:
        if not isinstance(name, str) or not PLAIN.fullmatch(name):
            raise Refused(f"it holds an array of {name!r:.40}, {EXPECTED}")
        self.dtype = np.dtype(name)

    def build(self, state: Any) -> None:
        """Takes the byte order; further state belongs to structured types."""
        _, order, *parts = state
        if order not in ("<", ">", "|", "=") or parts[:3] != [None] * 3 or parts[5:] not in ([0], [8]):
            raise Refused(f"it holds an array of structures, {EXPECTED}")
        self.dtype = self.dtype.newbyteorder(order)


class _Named:
    """The names that a file may use, and their replacements."""

    def __init__(self, call: Optional[Callable[..., Any]] = None) -> None:
        self.call = call


class _Part(tuple):  # type: ignore[type-arg]
    """A tuple for an array, which may not be in a list or dict."""


def _bytes(raw: Any) -> bytes:
    """Bytes, which old files store as strings."""
    return raw.encode("latin1") if isinstance(raw, str) else bytes(memoryview(raw))


def _values(raw: Any, kind: Any, shape: Any, order: Any) -> NDArray[Any]:
    values, sizes = _bytes(raw), [shape] if isinstance(shape, int) else list(shape)
    if not isinstance(kind, _Kind) or not all(isinstance(size, int) and size >= 0 for size in sizes):
        raise Refused("it holds an array without type and shape")
    if math.prod(sizes) * kind.dtype.itemsize != len(values):
        raise Refused(f"it holds an array of the shape {tuple(sizes)} that has {len(values)} bytes")
    if kind.dtype.kind == "U":  # numpy accepts any four bytes as a character, and Python then fails
        letters = np.frombuffer(values, np.dtype(np.uint32).newbyteorder(kind.dtype.byteorder))
        if letters.max(initial=0) > sys.maxunicode:
            raise Refused("it holds texts of what are no letters")
    return np.frombuffer(values, kind.dtype).reshape(sizes, order="F" if order == "F" else "C").copy("K")


def _empty(*_: Any) -> NDArray[Any]:
    return np.empty(0)  # filled when it is built


def _scalar(kind: Any, raw: Any) -> Any:
    return _values(raw, kind, (), "C")[()]


def _encoded(text: str, encoding: str) -> bytes:
    if encoding != "latin1":
        raise Refused(f"it holds bytes in {encoding!r:.40}, expected latin1")
    return text.encode(encoding)


# Functions that pickle arrays, in all versions of numpy.
NAMES: Dict[Tuple[Any, Any], _Named] = {
    ("numpy", "ndarray"): _Named(),
    ("numpy", "dtype"): _Named(_Kind),
    ("_codecs", "encode"): _Named(_encoded),
    ("__builtin__", "bytes"): _Named(lambda: b""),  # missing in old files
}
for _core in ("core", "_core"):
    NAMES[f"numpy.{_core}.multiarray", "_reconstruct"] = _Named(_empty)
    NAMES[f"numpy.{_core}.multiarray", "scalar"] = _Named(_scalar)
    NAMES[f"numpy.{_core}.numeric", "_frombuffer"] = _Named(_values)


class _Stack:
    """The stack of the file's instructions. Missing values raise IndexError, KeyError or TypeError."""

    def __init__(self) -> None:
        self.items: List[Any] = []
        self.marks: List[List[Any]] = []
        self.memo: Dict[int, Any] = {}

    def push(self, value: Any) -> None:
        """Pushes a value."""
        self.items.append(value)

    def number(self, value: int) -> None:
        """Pushes a number."""
        if value.bit_length() > 8 * LONGEST:
            raise Refused(f"it holds a whole number of {value.bit_length()} bits, expected at most {8 * LONGEST}")
        self.push(value)

    def mark(self, _: Any = None) -> None:
        """Pushes a mark."""
        self.marks.append(self.items)
        self.items = []

    def part(self) -> List[Any]:
        """Pops the values above the last mark."""
        part, self.items = self.items, self.marks.pop()
        return part

    def tuple(self, values: List[Any]) -> None:
        """Pushes a tuple."""
        raw = any(isinstance(value, (_Kind, _Named, _Part)) for value in values)
        self.push(_Part(values) if raw else tuple(values))

    def last(self, count: int) -> List[Any]:
        """Pops `count` values."""
        return [self.items.pop() for _ in range(count)][::-1]

    def extend(self, values: List[Any]) -> None:
        """Appends to the list on top."""
        target = self.items[-1]
        if not isinstance(target, list):
            raise Refused("it appends to what is no list")
        target.extend(map(whole, values))

    def update(self, pairs: List[Any]) -> None:
        """Fills the dict on top."""
        target = self.items[-1]
        if not isinstance(target, dict) or len(pairs) % 2:
            raise Refused("it fills what is no dict")
        target.update(zip(map(whole, pairs[::2]), map(whole, pairs[1::2])))

    def dict(self, _: Any = None) -> None:
        """Makes a dict of the values above the mark."""
        pairs = self.part()
        self.push({})
        self.update(pairs)

    def name(self, module: Any, name: Any) -> None:
        """Pushes a permitted name."""
        if (module, name) not in NAMES:
            raise Refused(f"it holds {f'{module}.{name}':.80}, {EXPECTED}")
        self.push(NAMES[module, name])

    def call(self, _: Any = None) -> None:
        """Replaces a call."""
        named, arguments = self.last(2)
        if not isinstance(named, _Named) or named.call is None or not isinstance(arguments, tuple):
            raise Refused("it calls what is no array")
        self.push(named.call(*arguments))

    def build(self, _: Any = None) -> None:
        """Sets the state of the top value."""
        target, state = self.last(2)
        if not isinstance(state, tuple):
            raise Refused(f"it holds an object, {EXPECTED}")
        if isinstance(target, _Kind):
            target.build(state)
        elif isinstance(target, np.ndarray):
            *_, shape, kind, fortran, raw = state
            values = _values(raw, kind, shape, "F" if fortran else "C")
            whole_state: Any = (1, values.shape, values.dtype, bool(fortran), values.tobytes("A"))
            target.__setstate__(whole_state)
        else:
            raise Refused(f"it holds an object, {EXPECTED}")
        self.push(target)


def whole(value: Any) -> Any:
    """A value, unless it is an unfinished array."""
    if isinstance(value, (_Kind, _Named, _Part)):
        raise Refused(f"it holds the type of an array, {EXPECTED}")
    return value


Work = Callable[[_Stack, Any], Any]
_WORK: Dict[str, Work] = {
    "MARK": _Stack.mark,
    "POP": lambda stack, _: stack.last(1),
    "POP_MARK": lambda stack, _: stack.part(),
    "DUP": lambda stack, _: stack.push(stack.items[-1]),
    "NONE": lambda stack, _: stack.push(None),
    "NEWTRUE": lambda stack, _: stack.push(True),
    "NEWFALSE": lambda stack, _: stack.push(False),
    "EMPTY_LIST": lambda stack, _: stack.push([]),
    "EMPTY_DICT": lambda stack, _: stack.push({}),
    "EMPTY_TUPLE": lambda stack, _: stack.push(()),
    "LIST": lambda stack, _: stack.push([whole(value) for value in stack.part()]),
    "DICT": _Stack.dict,
    "TUPLE": lambda stack, _: stack.tuple(stack.part()),
    "TUPLE1": lambda stack, _: stack.tuple(stack.last(1)),
    "TUPLE2": lambda stack, _: stack.tuple(stack.last(2)),
    "TUPLE3": lambda stack, _: stack.tuple(stack.last(3)),
    "APPEND": lambda stack, _: stack.extend(stack.last(1)),
    "APPENDS": lambda stack, _: stack.extend(stack.part()),
    "SETITEM": lambda stack, _: stack.update(stack.last(2)),
    "SETITEMS": lambda stack, _: stack.update(stack.part()),
    "MEMOIZE": lambda stack, _: stack.memo.update({len(stack.memo): stack.items[-1]}),
    "GLOBAL": lambda stack, names: stack.name(*names.split(" ", 1)),
    "STACK_GLOBAL": lambda stack, _: stack.name(*stack.last(2)),
    "REDUCE": _Stack.call,
    "BUILD": _Stack.build,
    **dict.fromkeys(("PROTO", "FRAME"), lambda stack, _: None),
    **dict.fromkeys(("INT", "BININT", "BININT1", "BININT2", "LONG", "LONG1", "LONG4"), _Stack.number),
    **dict.fromkeys(("FLOAT", "BINFLOAT", "STRING", "BINSTRING", "SHORT_BINSTRING"), _Stack.push),
    **dict.fromkeys(("UNICODE", "BINUNICODE", "SHORT_BINUNICODE", "BINUNICODE8"), _Stack.push),
    **dict.fromkeys(("BINBYTES", "SHORT_BINBYTES", "BINBYTES8", "BYTEARRAY8"), _Stack.push),
    **dict.fromkeys(("PUT", "BINPUT", "LONG_BINPUT"), lambda stack, place: stack.memo.update({place: stack.items[-1]})),
    **dict.fromkeys(("GET", "BINGET", "LONG_BINGET"), lambda stack, place: stack.push(stack.memo[place])),
}


def loads(data: bytes) -> Any:
    """The content of a pickle; a ValueError if it is not one or has other content."""
    stack = _Stack()
    try:
        for opcode, argument, _ in pickletools.genops(data):
            if opcode.name == "STOP":
                return whole(stack.items.pop())
            if opcode.name not in _WORK:
                raise Refused(f"it holds an object, {EXPECTED}")
            _WORK[opcode.name](stack, argument)
    except (IndexError, KeyError, TypeError, AttributeError, OverflowError, RecursionError) as error:
        raise ValueError(f"its parts do not fit together ({type(error).__name__})") from None
    raise ValueError("it has no end")
