"""Python's tables of the arrays that a stage is made of."""

from __future__ import annotations

from targets._stage_parts import PARTS, arrays, pointers

NUMBERS = {"int32_t": "np.int32", "uint8_t": "np.uint8", "float": "np.float32", "double": "np.float64"}
HEAD = '''from __future__ import annotations

from typing import Any, Dict, Mapping, NamedTuple, Tuple, Type

import numpy as np

from . import _abi


class Column(NamedTuple):
    """An array of a part: the type and the count of the numbers of each element, and the member that counts these."""

    kind: Any
    width: int
    by: str = "count"'''


def table_name(struct_name):
    return struct_name.removeprefix("mimo_stage_").upper()


def columns(struct):
    rows = ""
    for member, length, width in arrays(struct):
        by = "" if length == "count" else f', "{length}"'
        rows += f'    "{member.name}": Column({NUMBERS[member.type.split()[1]]}, {width}{by}),\n'
    return f"{table_name(struct.name)}: Mapping[str, Column] = {{\n{rows}}}"


def parts(api):
    """The parts of a stage's config, by their names: "geoms" and "sites" are both shapes."""
    rows = ""
    for member, kind in pointers(api):
        if kind in PARTS:
            pascal = "".join(word.capitalize() for word in kind.removeprefix("mimo_").split("_"))
            rows += f'    "{member.name}": (_abi.{pascal}, {table_name(kind)}),\n'
    return f"PARTS: Dict[str, Tuple[Type[_abi.Struct], Mapping[str, Column]]] = {{\n{rows}}}"


def stage_columns(api):
    """The pieces of the module."""
    return [HEAD, "\n".join(columns(api.struct(name)) for name in PARTS), parts(api)]
