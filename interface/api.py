"""interface.json as Python objects, for the generators in targets/ and for anybody's own."""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from pathlib import Path

FILE = Path(__file__).resolve().with_name("interface.json")
# Structs of plain values that the library fills: each language has a class or struct for them.
FILLED = (
    *("mimo_action", "mimo_appearance", "mimo_behaviour", "mimo_layout_info", "mimo_light", "mimo_parameter"),
    *("mimo_recording_info", "mimo_replay_report", "mimo_term", "mimo_timing"),
)


@dataclass
class Header:
    name: str
    doc: str


@dataclass
class Handle:
    """An opaque struct."""

    name: str
    doc: str
    header: str


@dataclass
class Typedef:
    name: str
    c_type: str
    doc: str
    header: str


@dataclass
class Parameter:
    name: str
    type: str
    doc: str
    enum: str | None = None


@dataclass
class Callback:
    """The type of a function that the caller gives to the library."""

    name: str
    returns: str
    parameters: list[Parameter]
    doc: str
    header: str


@dataclass
class Constant:
    name: str
    value: int | float | str
    doc: str
    header: str
    group: str | None
    since: str
    stability: str


@dataclass
class Enum:
    """Constants that belong together: a set of flags, or the values of one choice."""

    name: str
    kind: str
    c_type: str
    prefix: str
    doc: str
    constants: list[str]
    sense: str | None = None  # of an agent, whose outputs it chooses

    def word(self, constant: str) -> str:
        """A constant's name without the prefix: "FORCE" of MIMO_TOUCH_FORCE; one without the prefix loses MIMO_."""
        return constant.removeprefix(self.prefix if constant.startswith(self.prefix) else "MIMO_")


@dataclass
class Member:
    name: str
    type: str
    offset: int
    size: int
    doc: str
    array: int = 0
    enum: str | None = None
    unit: str | None = None
    range: list[float] | None = None
    owner: str | None = None
    sense: str | None = None  # of an agent, to which it belongs
    since: str = "1.0"
    stability: str = "stable"


@dataclass
class Struct:
    name: str
    doc: str
    header: str
    sized: bool
    size: int
    first_size: int
    init: str | None
    stability: str
    since: str
    members: list[Member]


@dataclass
class Function:
    name: str
    returns: str
    parameters: list[Parameter]
    doc: str
    header: str
    stability: str
    since: str
    node: str = ""  # its symbol version


@dataclass
class Api:
    format: int
    version: str
    abi: int
    headers: list[Header] = field(default_factory=list)
    handles: list[Handle] = field(default_factory=list)
    typedefs: list[Typedef] = field(default_factory=list)
    callbacks: list[Callback] = field(default_factory=list)
    constants: list[Constant] = field(default_factory=list)
    enums: list[Enum] = field(default_factory=list)
    structs: list[Struct] = field(default_factory=list)
    functions: list[Function] = field(default_factory=list)
    made: dict[str, str] = field(default_factory=dict)  # by the targets before: the text of each file

    def constant(self, name: str) -> Constant:
        return next(one for one in self.constants if one.name == name)

    def enum(self, name: str) -> Enum:
        return next(one for one in self.enums if one.name == name)

    def struct(self, name: str) -> Struct:
        return next(one for one in self.structs if one.name == name)

    def function(self, name: str) -> Function:
        return next(one for one in self.functions if one.name == name)

    def configs(self, *more: str) -> list[Struct]:
        """The structs of options in the order of the headers: all named ..._config with an init function, and more."""
        return [one for one in self.structs if (one.init and one.name.endswith("_config")) or one.name in more]

    def senses(self) -> list[Enum]:
        """The enumerations of the senses' outputs, in the order of the times that steps take for them."""
        order = [one.name for one in self.struct("mimo_timing").members]
        found = [one for one in self.enums if one.sense]
        return sorted(found, key=lambda one: order.index(one.sense) if one.sense in order else len(order))

    def is_a(self, kind: str, name: str) -> bool:
        """Whether a name is one of the "handles", "typedefs", "callbacks", "structs", ..."""
        return any(one.name == name for one in getattr(self, kind))


def load(path: Path = FILE) -> Api:
    """The interface that a file describes."""
    return from_data(json.loads(path.read_text(encoding="utf-8")))


def from_data(data: dict) -> Api:
    def many(kind, key, **inner):
        return [
            kind(
                **{
                    name: [inner[name](**part) for part in value] if name in inner else value
                    for name, value in one.items()
                }
            )
            for one in data[key]
        ]

    return Api(
        data["format"],
        data["version"],
        data["abi"],
        many(Header, "headers"),
        many(Handle, "handles"),
        many(Typedef, "typedefs"),
        many(Callback, "callbacks", parameters=Parameter),
        many(Constant, "constants"),
        many(Enum, "enums"),
        many(Struct, "structs", members=Member),
        many(Function, "functions", parameters=Parameter),
    )
