"""The Rust bindings: the declarations of the crate mimo-sys; enumerations, configs and records of the crate mimo."""

from __future__ import annotations

import textwrap

from targets import _rust_stage
from targets._prose import described
from targets._rust_structs import Configs, Records
from targets._rust_words import NOTICE, comment, identifier, integer, member_type, prose, rust_type


def files(api) -> dict[str, str]:
    return {
        "bindings/rust/mimo-sys/src/bindings.rs": Declarations(api).text(),
        "bindings/rust/mimo-sys/tests/structs.in": structs(api),
        "bindings/rust/mimo/src/constants.rs": constants(api),
        "bindings/rust/mimo/src/configs.rs": Configs(api).text(),
        "bindings/rust/mimo/src/records.rs": Records(api).text(),
        "bindings/rust/mimo/src/stage_parts.rs": _rust_stage.text(api),
    }


# ---- mimo-sys -----------------------------------------------------------------------------------------------


HANDLE = """#[repr(C)]
#[derive(Debug)]
pub struct {name} {{
    opaque: [u8; 0],
}}
"""


class Declarations:
    """The C interface as it is."""

    def __init__(self, api):
        self.api = api
        self.types = {name: integer(enum, api) for enum in api.enums for name in enum.constants}

    def text(self) -> str:
        api = self.api
        parts = [NOTICE, "use std::os::raw::{c_char, c_void};\n"]
        parts += [self.constant(constant) for constant in api.constants]
        parts += [f"{comment(one.doc)}pub type {one.name} = {rust_type(one.c_type)};\n" for one in api.typedefs]
        parts += [self.handle(handle) for handle in api.handles]
        parts += [self.callback(callback) for callback in api.callbacks]
        parts += [self.struct(struct) for struct in api.structs]
        parts.append('extern "C" {\n' + "\n".join(self.function(function) for function in api.functions) + "}\n")
        return "\n".join(parts)

    def constant(self, constant) -> str:
        value = constant.value
        if isinstance(value, str):
            return (
                f'{comment(described(constant))}pub const {constant.name}: &[u8; {len(value) + 1}] = b"{value}\\0";\n'
            )
        number = self.types.get(constant.name, "u32" if value >= 0 else "i32")
        return f"{comment(described(constant))}pub const {constant.name}: {number} = {value};\n"

    def handle(self, handle) -> str:
        return f"{comment(handle.doc)}{HANDLE.format(name=handle.name)}"

    def callback(self, callback) -> str:
        signature = self.signature(callback)
        return f'{comment(callback.doc)}pub type {callback.name} = Option<unsafe extern "C" fn{signature}>;\n'

    def signature(self, function) -> str:
        parameters = ", ".join(f"{identifier(one.name)}: {rust_type(one.type)}" for one in function.parameters)
        returns = "" if function.returns == "void" else f" -> {rust_type(function.returns)}"
        return f"({parameters}){returns}"

    def struct(self, struct) -> str:
        members = "".join(
            f"{comment(described(member), '    ')}    pub {identifier(member.name)}: {member_type(member)},\n"
            for member in struct.members
        )
        head = f"{comment(described(struct))}#[repr(C)]\n#[derive(Clone, Copy, Debug)]\n"
        return f"{head}pub struct {struct.name} {{\n{members}}}\n"

    def function(self, function) -> str:
        told = "".join(f"\n\n* `{one.name}`: {one.doc}" for one in function.parameters if one.doc)
        return f"{comment(described(function) + told, '    ')}    pub fn {function.name}{self.signature(function)};\n"


def structs(api) -> str:
    """What tests/layout.rs compares the structs with: of each its size, then offset and size of its members."""
    lines = [NOTICE + "{"]
    for struct in api.structs:
        members = " ".join(f"{identifier(one.name)} {one.offset} {one.size}," for one in struct.members)
        lines.append(f"compare!(wrong, {struct.name} {struct.size} {{ {members} }});")
    return "\n".join(lines) + "\n}\n"


# ---- mimo ---------------------------------------------------------------------------------------------------


def constants(api) -> str:
    told = prose(api)
    parts = [NOTICE + "//! Enumerations of the library, and their constants.\nuse crate::sys;\n"]
    parts += [enumeration(enum, api, told) for enum in api.enums]
    return "\n".join(parts)


def enumeration(enum, api, told) -> str:
    docs = {constant.name: described(constant) for constant in api.constants}
    entries = "".join(
        f"{comment(told(docs[name], enum.name), '    ')}    {enum.word(name)} = {name},\n" for name in enum.constants
    )
    about = comment(told(enum.doc))
    return f"{enum.kind}! {{\n{textwrap.indent(about, '    ')}    {enum.name}: {integer(enum, api)}\n{entries}}}\n"
