"""C#'s classes for the arrays that a stage is made of."""

from __future__ import annotations

from targets._csharp_words import (
    NUMBERS,
    documented,
    in_namespace,
    indent,
    keyworded,
    lines_of,
    pascal,
    pointed,
    raw_name,
)
from targets._stage_parts import PARTS, arrays, lengths, pointers, scalars

PART = """
public sealed class {name}
{{
{properties}

    /// <summary>The struct, valid as long as the parts.</summary>
    internal {raw} Raw(PinnedParts parts)
    {{
        var filled = {raw}.New();
{filled}        return filled;
    }}
}}
"""


CONFIG = """
public sealed partial class StageConfig
{{
{properties}

    private StageConfigStruct RawParts(PinnedParts parts)
    {{
        var filled = StageConfigStruct.New();
{filled}        return filled;
    }}
}}
"""


def config(words):
    """The parts of a stage's config."""
    struct, properties, filled = words.api.struct("mimo_stage_config"), [], []
    for member, kind in pointers(words.api):
        name = pascal(member.name)
        doc = documented(words.text(member.doc, struct, member))
        properties += ["", *doc, f"public {pascal(kind)} {name} {{ get; set; }}"]
        filled.append(f"if ({name} != null) filled.{member.name} = parts.Keep(new[] {{ {name}.Raw(parts) }});")
    text = CONFIG.format(
        properties="\n".join(indent(properties[1:])), filled="".join(line + "\n" for line in indent(filled, 8))
    )
    return [
        *documented("What a stage is made of. Parts that are null are empty, or stay as they are (Stage.Update)."),
        *lines_of(text)[1:],
    ]


def part(words, struct):
    name, properties, filled = pascal(struct.name), [], []
    for member in scalars(struct):
        doc = documented(words.text(member.doc, struct, member))
        properties += ["", *doc, f"public {NUMBERS[member.type]} {pascal(member.name)} {{ get; set; }}"]
        filled.append(f"filled.{keyworded(member.name)} = {pascal(member.name)};")
    for member, _, _ in arrays(struct):
        doc = documented(words.text(member.doc, struct, member))
        properties += ["", *doc, f"public {NUMBERS[pointed(member.type)]}[] {pascal(member.name)} {{ get; set; }}"]
        filled.append(f"filled.{keyworded(member.name)} = parts.Keep({pascal(member.name)});")
    for length, members in lengths(struct).items():
        filled.append(f'filled.{length} = new CommonLength("{name}")')
        filled += [f'    .Of({pascal(one.name)}, {width}, "{pascal(one.name)}")' for one, width in members]
        filled.append("    .Count;")
    text = PART.format(
        name=name,
        raw=raw_name(struct.name),
        properties="\n".join(indent(properties[1:])),
        filled="".join(line + "\n" for line in indent(filled, 8)),
    )
    return [*documented(words.text(struct.doc, struct)), *lines_of(text)[1:]]


def parts(words):
    return in_namespace([], [config(words), *(part(words, words.api.struct(name)) for name in PARTS)])
