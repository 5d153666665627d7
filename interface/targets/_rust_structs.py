"""Structs of C as Rust's: builders of configs, and records."""

from __future__ import annotations

from targets._prose import described, switch
from targets._rust_words import NOTICE, RECORDS, comment, configs, identifier, member_type, pascal, prose, told

# Configs whose constructors take arguments; a hand-written module has them.
CONSTRUCTED_BY_HAND = (
    "mimo_batch_config",
    "mimo_camera_config",
    "mimo_field_config",
    "mimo_growth",
    "mimo_model_config",
    "mimo_object_config",
    "mimo_picture_config",
    "mimo_scene_config",
    "mimo_senses_config",
)
# Members of records that say what is asked for.
ASKED = ("mimo_light.axes",)
# Members that only the hand-written part of a config sets.
SET_BY_HAND = (
    "mimo_camera_config.name",
    "mimo_camera_config.placed",
    "mimo_camera_config.position",
    "mimo_camera_config.look_at",
    "mimo_field_config.name",
    "mimo_field_config.quantity",
    "mimo_field_config.elements",
    "mimo_growth.age",
    "mimo_growth.matures_apart",
    "mimo_growth.physiological_age",
    "mimo_model_config.name",
    "mimo_model_config.file",
    "mimo_model_config.xml",
    "mimo_object_config.name",
    "mimo_picture_config.width",
    "mimo_picture_config.height",
    "mimo_scene_config.name",
    "mimo_scene_config.file",
    "mimo_scene_config.xml",
    "mimo_senses_config.mujoco_version",
)

CONFIGS_HEAD = """//! Configs of the library: a method for each of their members.
use crate::constants::*;
use crate::error::{c_string, Result};
use crate::log::{self, Log, LogRecord};
use crate::structs::{defaults, given, pointer};
use crate::sys;
use std::ffi::CString;
use std::ptr::null;
"""

# A config that points to what it is given: strings, growths, a closure.
POINTING = """{doc}#[derive(Clone, Debug)]
pub struct {name} {{
    pub(crate) raw: sys::{struct},
{kept}}}

// The pointers inside are set for the length of a call only.
unsafe impl Send for {name} {{}}
unsafe impl Sync for {name} {{}}

impl {name} {{
    /// With the library's defaults.
    {maker}() -> Result<{name}> {{
        {name}::of(defaults(sys::{init})?)
    }}

    pub(crate) fn of(raw: sys::{struct}) -> Result<{name}> {{
        Ok({name} {{ raw{copies} }})
    }}

    pub(crate) fn with_raw<R>(&self, use_it: impl FnOnce(&sys::{struct}) -> R) -> R {{
        let mut raw = self.raw;
{pointers}        use_it(&raw)
    }}
{setters}}}
"""

# A config of numbers alone.
PLAIN = """{doc}#[derive(Clone, Copy, Debug)]
pub struct {name} {{
    pub(crate) raw: sys::{struct},
}}

impl {name} {{
    /// With the library's defaults.
    {maker}() -> Result<{name}> {{
        Ok({name} {{ raw: defaults(sys::{init})? }})
    }}

    pub(crate) fn pointer(one: &Option<{name}>) -> *const sys::{struct} {{
        one.as_ref().map_or(null(), |one| &one.raw as *const _)
    }}
{setters}}}
"""

SETTER = """
{doc}    pub fn {name}(&mut self, {name}: {argument}) -> {returns} {{
        {assignment};
        {result}
    }}
"""

# How a config keeps what the struct of C only points to, by the type of the member.
KEPT = {
    "const char *": "Option<CString>",
    "const char *const *": "Vec<CString>",
    "const mimo_growth *": "Option<Growth>",
    "const mimo_growth *const *": "Vec<Option<Growth>>",
    "mimo_log_fn": "Option<Log>",
}


class Configs:
    """A builder for each config: a method for each of its members."""

    def __init__(self, api):
        self.api = api
        self.prose = prose(api)
        self.kinds = {enum.name: enum.kind for enum in api.enums}

    def text(self) -> str:
        parts = [NOTICE + CONFIGS_HEAD]
        parts += [self.config(struct) for struct in configs(self.api)]
        return "\n".join(parts)

    def config(self, struct) -> str:
        members = [member for member in struct.members if self.is_set(member, struct)]
        kept = [member for member in members if member.type in KEPT]
        lines = [line for member in kept for line in self.point(struct, member)]
        return (POINTING if kept else PLAIN).format(
            doc=comment(self.prose(described(struct))),
            name=pascal(struct.name),
            struct=struct.name,
            init=struct.init,
            maker="pub(crate) fn init" if struct.name in CONSTRUCTED_BY_HAND else "pub fn new",
            kept="".join(f"    pub(crate) {member.name}: {KEPT[member.type]},\n" for member in kept),
            copies="".join(f", {member.name}: {self.copy(member)}" for member in kept),
            pointers="".join(f"        {line}\n" for line in lines),
            setters="".join(
                self.setter(member) for member in members if f"{struct.name}.{member.name}" not in SET_BY_HAND
            ),
        )

    def is_set(self, member, struct) -> bool:
        """Whether a member is the caller's to set: sizes, counts of arrays and what is reserved are not."""
        if member.name in ("struct_size", "log_user") or "reserved" in member.name:
            return False
        return not any(member.name == self.count(struct, one) for one in struct.members if "*const *" in one.type)

    def count(self, struct, array) -> str:
        """The member that holds an array's length: element_count of elements, cohort_count of cohort."""
        counts = [one.name for one in struct.members if one.name.endswith("_count")]
        return next(name for name in counts if array.name.startswith(name.removesuffix("_count")))

    def copy(self, member) -> str:
        if member.type == "const char *":
            return f"given(raw.{member.name})?"
        return "None" if KEPT[member.type].startswith("Option") else "Vec::new()"

    def point(self, struct, member) -> list[str]:
        """How the struct gets to point to what is kept."""
        name = member.name
        if member.type == "const char *":
            return [f"raw.{name} = pointer(&self.{name});"]
        if member.type == "const mimo_growth *":
            return [f"raw.{name} = Growth::pointer(&self.{name});"]
        if member.type == "mimo_log_fn":
            return ["(raw.log, raw.log_user) = log::raw(&self.log);"]
        each = "|text| text.as_ptr()" if member.type == "const char *const *" else "Growth::pointer"
        return [
            f"let {name}: Vec<_> = self.{name}.iter().map({each}).collect();",
            f"raw.{name} = if {name}.is_empty() {{ null() }} else {{ {name}.as_ptr() }};",
            f"raw.{self.count(struct, member)} = {name}.len();",
        ]

    def setter(self, member) -> str:
        argument, assignment = self.assignment(member)
        fails = argument == "&str"
        return SETTER.format(
            doc=told(member, self.prose, self.kinds),
            name=identifier(member.name),
            argument=argument,
            returns="Result<&mut Self>" if fails else "&mut Self",
            assignment=assignment,
            result="Ok(self)" if fails else "self",
        )

    def assignment(self, member) -> tuple[str, str]:
        """The type of a setter's argument, and what the setter does."""
        name = identifier(member.name)
        if member.type == "const char *":
            return "&str", f"self.{name} = Some(c_string({name})?)"
        if member.type == "const mimo_growth *":
            return "Growth", f"self.{name} = Some({name})"
        if member.type == "const mimo_growth *const *":
            return "&[Option<Growth>]", f"self.{name} = {name}.to_vec()"
        if member.type == "mimo_log_fn":
            return "impl Fn(&LogRecord) + Send + Sync + 'static", f"self.{name} = Some(Log::new({name}))"
        if member.enum:
            return member.enum, f"self.raw.{name} = {name}.raw()"
        if switch(member):
            return "bool", f"self.raw.{name} = {name}.into()"
        if "*" in member.type:
            raise ValueError(f"_rust_structs.py knows no setter for {member.name}, a {member.type}")
        return member_type(member), f"self.raw.{name} = {name}"


RECORDS_HEAD = """//! Records: plain values that the library returns, or takes.
use crate::error::{text, Result};
use crate::structs::defaults;
use crate::sys;
use std::time::Duration;
"""

RECORD = """{doc}#[derive(Clone, {copy}Debug, PartialEq)]
{open}pub struct {name} {{
{members}}}

impl {name} {{
    pub(crate) fn of(raw: &sys::{struct}) -> {name} {{
        {name} {{ {values} }}
    }}
{settable}}}
"""

# A record that the library takes, too.
SETTABLE = """
    /// With the library's defaults.
    pub fn new() -> Result<{name}> {{
        Ok({name}::of(&defaults(sys::{init})?))
    }}

    pub(crate) fn raw(&self) -> Result<sys::{struct}> {{
        Ok(sys::{struct} {{ {values}, ..defaults(sys::{init})? }})
    }}
"""


class Records:
    """Plain structs with the members of C's."""

    def __init__(self, api):
        self.api = api
        self.prose = prose(api)
        self.kinds = {enum.name: enum.kind for enum in api.enums}

    def text(self) -> str:
        parts = [NOTICE + RECORDS_HEAD]
        parts += [self.record(struct) for struct in self.api.structs if struct.name in RECORDS]
        return "\n".join(parts)

    def record(self, struct) -> str:
        members = [
            (member, *self.conversion(struct, member))
            for member in struct.members
            if member.name != "struct_size"
            and "reserved" not in member.name
            and f"{struct.name}.{member.name}" not in ASKED
        ]
        name = pascal(struct.name)
        settable = ", ".join(f"{one.name}: {self.raw(one)}" for one, _, _ in members)
        return RECORD.format(
            doc=comment(self.prose(described(struct))),
            copy="" if any(kind == "String" for _, kind, _ in members) else "Copy, ",
            open="" if struct.init else "#[non_exhaustive]\n",
            name=name,
            struct=struct.name,
            members="".join(
                f"{told(one, self.prose, self.kinds)}    pub {one.name}: {kind},\n" for one, kind, _ in members
            ),
            values=", ".join(f"{one.name}: {value}" for one, _, value in members),
            settable=SETTABLE.format(name=name, struct=struct.name, init=struct.init, values=settable)
            if struct.init
            else "",
        )

    def conversion(self, struct, member) -> tuple[str, str]:
        """The type of a member, and how its value comes out of the struct of C."""
        raw = f"raw.{member.name}"
        if struct.name == "mimo_timing" and member.type == "double":
            return "Duration", f"Duration::from_secs_f64({raw})"
        if member.name == "texture":
            return "Option<i32>", f"({raw} >= 0).then_some({raw})"
        if member.type == "const char *":
            return "String", f"text({raw})"
        if switch(member):
            return "bool", f"{raw} == 1"
        return member_type(member), raw

    def raw(self, member) -> str:
        return f"self.{member.name}.into()" if switch(member) else f"self.{member.name}"
