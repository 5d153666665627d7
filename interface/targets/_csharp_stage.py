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
from targets._stage_parts import PARTS, arrays, lengths, scalars

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
    return in_namespace([], [part(words, words.api.struct(name)) for name in PARTS])
