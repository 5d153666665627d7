"""Rust's structs for the arrays that a stage is made of."""

from __future__ import annotations

from targets._prose import described
from targets._rust_words import NOTICE, comment, identifier, pascal, prose, rust_type
from targets._stage_parts import PARTS, arrays, lengths, scalars

HEAD = """//! The arrays that a stage is made of: slices whose lengths are checked against each other.
use crate::error::Result;
use crate::structs::{array, common_length, sized};
use crate::sys;
"""

PART = """{doc}#[derive(Clone, Copy, Debug, Default)]
pub struct {name}<'a> {{
{members}}}

impl {name}<'_> {{
    pub(crate) fn raw(&self) -> Result<sys::{struct}> {{
        let mut raw: sys::{struct} = sized();
{filled}        Ok(raw)
    }}
}}
"""


def text(api) -> str:
    told = prose(api)
    return "\n".join([NOTICE + HEAD, *(part(told, api.struct(name)) for name in PARTS)])


def part(told, struct) -> str:
    members, filled = "", ""
    for one in scalars(struct):
        members += f"{comment(told(described(one)), '    ')}    pub {identifier(one.name)}: {rust_type(one.type)},\n"
        filled += f"        raw.{one.name} = self.{one.name};\n"
    for one, _, _ in arrays(struct):
        number = rust_type(one.type).removeprefix("*const ")
        doc = told(described(one)).replace("NULL", "empty")
        members += f"{comment(doc, '    ')}    pub {identifier(one.name)}: &'a [{number}],\n"
        filled += f"        raw.{one.name} = array(self.{one.name});\n"
    for length, of in lengths(struct).items():
        filled += f"        raw.{length} = common_length(&[\n"
        filled += "".join(f'            (self.{one.name}.len(), {width}, "{one.name}"),\n' for one, width in of)
        filled += "        ])?;\n"
    return PART.format(
        doc=comment(told(described(struct))),
        name=pascal(struct.name),
        struct=struct.name,
        members=members,
        filled=filled,
    )
