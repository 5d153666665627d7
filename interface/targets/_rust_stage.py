"""Rust's structs for the arrays that a stage is made of."""

from __future__ import annotations

from targets._prose import described
from targets._rust_words import NOTICE, comment, identifier, pascal, prose, rust_type
from targets._stage_parts import PARTS, arrays, lengths, pointers, scalars

HEAD = """//! The arrays that a stage is made of: slices whose lengths are checked against each other.
use crate::configs::StageAir;
use crate::error::Result;
use crate::structs::{array, common_length, sized};
use crate::sys;
use std::ptr::null;
"""

CONFIG = """/// What a stage is made of. Parts that are None are empty, or stay as they are
/// ([`Stage::update`](crate::Stage::update)).
#[derive(Clone, Copy, Debug, Default)]
pub struct StageParts<'a> {{
{members}}}

impl StageParts<'_> {{
    pub(crate) fn with_raw<R>(&self, use_it: impl FnOnce(&mut sys::mimo_stage_config) -> Result<R>) -> Result<R> {{
{made}        let mut raw: sys::mimo_stage_config = sized();
{filled}        use_it(&mut raw)
    }}
}}

fn pointer<T>(part: &Option<T>) -> *const T {{
    part.as_ref().map_or(null(), |part| part)
}}
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
    return "\n".join([NOTICE + HEAD, config(api, told), *(part(told, api.struct(name)) for name in PARTS)])


def config(api, told) -> str:
    members, made, filled = "", "", ""
    for one, kind in pointers(api):
        borrowed = kind in PARTS  # the air has no arrays, and is copied
        members += f"{comment(told(one.doc), '    ')}    pub {one.name}: "
        members += f"Option<&'a {pascal(kind)}<'a>>,\n" if borrowed else f"Option<{pascal(kind)}>,\n"
        made += f"        let {one.name} = self.{one.name}.map(|part| part.raw()).transpose()?;\n" if borrowed else ""
        place = f"pointer(&{one.name})" if borrowed else f"{pascal(kind)}::pointer(&self.{one.name})"
        filled += f"        raw.{one.name} = {place};\n"
    return CONFIG.format(members=members, made=made, filled=filled)


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
