"""C#'s classes that have a struct's members under C#'s names: configs, which programs fill in, and records, which the
library does.
"""

from __future__ import annotations

from api import FILLED
from targets._csharp_words import (
    camel,
    documented,
    in_namespace,
    indent,
    is_switch,
    keyworded,
    lines_of,
    pascal,
    pointed,
    raw_name,
    raw_type,
)

# A config is a class whose constructor takes the library's defaults. These are not: they are arguments of a method (new
# Batch, MimoScene.AddModel, AddField).
ARGUMENTS = ("mimo_batch_config", "mimo_field_config", "mimo_model_config")

RECORDS = sorted((*FILLED, "mimo_agent_info", "mimo_gaze"))

# Members that an argument of a method, or a member written by hand, stands for.
HIDDEN = {
    "mimo_scene_config": {"name", "file", "xml"},
    "mimo_senses_config": {"mujoco_version"},
    "mimo_picture_config": {"format"},
    "mimo_light": {"axes"},
    "mimo_stage_air": {"fog_color", "haze_color", "ambient", "diffuse", "specular"},
    "mimo_stage_view": {
        *("position", "rotation", "rgb", "rgb_bytes", "rgb_stride", "depth", "depth_count", "depth_stride"),
        *("segmentation", "segmentation_count", "segmentation_stride"),
    },
}

# Numbers of records are those that C# counts with.
COUNTED = {"uint": "int", "UIntPtr": "int", "ulong": "long"}

# What arrays of single precision become in records.
WIDE = {"Floats3": "Vector3d", "Floats4": "Rgba"}

PROPERTY = "public {kind} {name} {{ get {{ return {get}; }} set {{ {set}; }} }}"

CONFIG = """
public sealed partial class {name}
{{
    private {raw} raw;

    /// <summary>The library's defaults.</summary>
    public {name}()
    {{
        Library.Require();
        raw = {raw}.New();
    }}

    internal {name}({raw} raw) {{ this.raw = raw; }}
{properties}

    /// <summary>The struct, valid as long as the parts.</summary>
    internal {raw} Raw(PinnedParts parts)
    {{
        var filled = raw;
{filled}        return filled;
    }}
}}
"""

RECORD = """
public struct {name}
{{
{properties}

    internal {name}({raw} raw)
    {{
{filled}    }}
}}
"""


def shown(struct):
    """The members that a class has: not sizes, spares, and a callback's argument."""
    hidden = {"struct_size", "log_user"} | HIDDEN.get(struct.name, set())
    return [one for one in struct.members if one.name not in hidden and not one.name.endswith("reserved")]


def class_of(template, words, struct, properties, filled):
    text = template.format(
        name=words.struct(struct.name),
        raw=raw_name(struct.name),
        properties="\n".join(indent(properties)),
        filled="".join(line + "\n" for line in indent(filled, 8)),
    )
    return [*documented(words.text(struct.doc, struct)), *lines_of(text)[1:]]


# ---- Configs ------------------------------------------------------------------------------------------------


def text_property(member, name, doc):
    kept, raw = camel(member.name), keyworded(member.name)
    get = f"{kept} ?? Utf8.OrNull(raw.{raw})"
    lines = [f"private string {kept};", *doc, PROPERTY.format(kind="string", name=name, get=get, set=f"{kept} = value")]
    return lines, [f"if ({kept} != null) filled.{raw} = parts.Text({kept});"]


def number_property(words, struct, member, name, doc):
    raw, kind = "raw." + keyworded(member.name), raw_type(member)
    get, value = raw, "value"
    if member.enum:
        named = words.enum_named(member.enum)
        kind, get, value = named, f"({named}){raw}", f"({kind})value"
    elif is_switch(member):
        kind, get, value = "bool", f"{raw} != 0", "value ? 1u : 0u"
    elif kind == "UIntPtr":
        kind, get, value = "ulong", f"(ulong){raw}", "(UIntPtr)value"
    elif kind == "IntPtr":
        raise NotImplementedError(
            f"{struct.name}.{member.name} is a {member.type}: _csharp_classes.py has no such property"
        )
    return [*doc, PROPERTY.format(kind=kind, name=name, get=get, set=f"{raw} = {value}")], []


def property_of(words, struct, member):
    """Lines of a property of a config's class, and the lines that put it into the struct."""
    name, text = pascal(member.name), words.text(member.doc, struct, member)
    if member.type == "mimo_log_fn":
        doc = documented(text + " Exceptions in it are dropped.")
        return [*doc, f"public Action<LogRecord> {name} {{ get; set; }}"], []
    doc = documented(text)
    if member.type == "const char *":
        return text_property(member, name, doc)
    base = pointed(member.type)
    if words.api.is_a("structs", base):
        put = f"if ({name} != null) filled.{member.name} = parts.Keep(new[] {{ {name}.Raw(parts) }});"
        return [*doc, f"public {words.struct(base)} {name} {{ get; set; }}"], [put]
    return number_property(words, struct, member, name, doc)


def config(words, struct):
    properties, filled = [], []
    for member in shown(struct):
        lines, puts = property_of(words, struct, member)
        properties += ["", *lines]
        filled += puts
    return class_of(CONFIG, words, struct, properties, filled)


def configs(words):
    all_of_them = words.api.configs("mimo_growth", "mimo_maturity", "mimo_stage_air", "mimo_stage_view")
    return in_namespace(["System"], [config(words, one) for one in all_of_them if one.name not in ARGUMENTS])


# ---- Records ------------------------------------------------------------------------------------------------


def from_raw(words, member):
    """The type of a record's member, and how it follows from the struct's."""
    raw, kind = "raw." + keyworded(member.name), raw_type(member)
    if member.type == "const char *":
        return "string", f"Utf8.Of({raw})"
    if member.enum:
        named = words.enum_named(member.enum)
        return named, f"({named}){raw}"
    if is_switch(member):
        return "bool", f"{raw} != 0"
    if kind in WIDE:
        return WIDE[kind], f"{raw}.Wide"
    return (COUNTED[kind], f"({COUNTED[kind]}){raw}") if kind in COUNTED else (kind, raw)


def record(words, struct):
    properties, filled = [], []
    for member in shown(struct):
        kind, value = from_raw(words, member)
        name = pascal(member.name)
        doc = documented(words.text(member.doc, struct, member))
        properties += ["", *doc, f"public {kind} {name} {{ get; }}"]
        filled.append(f"{name} = {value};")
    return class_of(RECORD, words, struct, properties[1:], filled)


def records(words):
    return in_namespace([], [record(words, words.api.struct(name)) for name in RECORDS])
