"""JavaScript: structs as they lie in WebAssembly's memory, constants, types of options, methods of handles."""

from __future__ import annotations

from targets import _javascript_methods, _wasm32
from targets._javascript_methods import unreached
from targets._javascript_words import NOTICE, NUMBERS, Words, base, camel, comment, is_switch, listed, number, pascal
from targets._stage_parts import PARTS, arrays

FOLDER = "bindings/javascript/src/generated"
# Switches that programs do not see: they are on where the other member is given.
IMPLIED = {
    ("mimo_growth", "matures_apart"): "physiological_age",
    ("mimo_reset_config", "seeded"): "seed",
    ("mimo_camera_config", "placed"): "look_at",
}


def files(api) -> dict[str, str]:
    words = Words(api)
    return {
        f"{FOLDER}/structs.js": structs(api),
        f"{FOLDER}/constants.js": constants(words),
        f"{FOLDER}/types.js": types(words),
        **{f"{FOLDER}/{name}.js": text for name, text in _javascript_methods.files(words).items()},
    }


def used(api) -> list:
    """The structs that the functions take and give which JavaScript reaches, and the structs in these."""
    reached = [one for one in api.functions if not unreached(one.name)]
    own = [one for one in reached if not one.name.endswith("_init")]
    types = {base(parameter.type) for function in own for parameter in function.parameters}
    for callback in api.callbacks:
        if not callback.name.startswith("mimo_sense_"):
            types |= {base(parameter.type) for parameter in callback.parameters}
    for struct in api.structs:
        if struct.name in types:
            types |= {base(member.type) for member in struct.members}
    return [one for one in api.structs if one.name in types]


# ---- structs.js ----------------------------------------------------------------------------------------------


STRUCTS = """
/**
 * Where the members of each struct lie: [kind, offset]; of an array in the struct, how many numbers it has; of the
 * address of one, how many numbers an element has, and the member with the number of elements.
 * @type {{Record<string, import("../structs.js").Layout>}}
 */
export const structs = {{
{rows}
}};
"""


def kind_of(api, member) -> str:
    if member.array or "*" not in member.type:
        if member.enum and api.enum(member.enum).kind == "flags":
            return "flags"  # or-ed bits are negative in JavaScript where the highest one is set
        return "switch" if is_switch(member) else number(api, member.type) or "pointer"
    if member.type == "const char *":
        return "text"
    if api.is_a("structs", base(member.type)) and member.type.count("*") == 1:
        return base(member.type)
    return "pointer"


def columns(struct) -> dict:
    """The arrays that a stage's part points to: numbers of an element, and the member with the number of elements."""
    return {one.name: (width, length) for one, length, width in arrays(struct)} if struct.name in PARTS else {}


def row_of(api, struct, member, offset) -> str:
    shared = columns(struct)
    if member.name in shared:
        width, length = shared[member.name]
        return f'["{number(api, base(member.type))}", {offset}, {width}, "{camel(length)}"]'
    if any(member.name == length for _, length in shared.values()):
        return f'["length", {offset}]'
    array = f", {member.array}" if member.array else ""
    return f'["{kind_of(api, member)}", {offset}{array}]'


def structs(api) -> str:
    rows = []
    for struct in used(api):
        size, offsets = _wasm32.layout(api, struct)
        members = []
        for member, offset in zip(struct.members, offsets, strict=True):
            if member in listed(struct):
                members.append(f"      {camel(member.name)}: {row_of(api, struct, member, offset)},")
        init = f'init: "{struct.init}"' if struct.init else 'init: ""'
        rows += [f"  {struct.name}: {{", f"    size: {size},", f"    {init},"]
        rows += ["    members: {", *members, "    },"]
        implied = [(own, of) for (name, own), of in IMPLIED.items() if name == struct.name]
        rows += [f'    implied: {{ {camel(of)}: "{camel(own)}" }},' for own, of in implied] + ["  },"]
    return NOTICE + STRUCTS.format(rows="\n".join(rows))


# ---- constants.js --------------------------------------------------------------------------------------------


def constants(words) -> str:
    parts = [NOTICE]
    for enum in words.api.enums:
        rows = []
        for name in enum.constants:
            constant = words.api.constant(name)
            value = hex(constant.value) if enum.kind == "flags" else constant.value
            rows.append(f"{comment(words.text(described(constant), enum.name), '  ')}  {enum.word(name)}: {value},\n")
        doc = comment(words.of_thing(enum) if hasattr(enum, "stability") else words.text(enum.doc))
        parts.append(f"{doc}export const {enum.name} = Object.freeze({{\n{''.join(rows)}}});\n")
    for constant in words.api.constants:
        if constant.group is None:
            value = f'"{constant.value}"' if isinstance(constant.value, str) else constant.value
            name = constant.name.removeprefix("MIMO_")
            parts.append(f"{comment(words.text(described(constant)))}export const {name} = {value};\n")
    return "\n".join(parts)


def described(constant) -> str:
    return f"{constant.doc} Experimental." if constant.stability == "experimental" else constant.doc


# ---- types.js ------------------------------------------------------------------------------------------------


def type_of(words, struct, member) -> str | None:
    """The type of a member in TypeScript; None for what methods take and give in another way."""
    shared = columns(struct)
    if member.name in shared:
        return "ArrayLike<number> | null"
    if any(member.name == length for _, length in shared.values()):
        return None
    kind = kind_of(words.api, member)
    if kind in ("pointer",):
        return None
    if kind == "switch":
        return "boolean"
    if kind == "text":
        return "string"
    if kind == "flags":
        return "number"
    if kind not in NUMBERS.values():
        return pascal(kind)
    return "ArrayLike<number>" if member.array else "number | bigint" if kind == "u64" else "number"


def types(words) -> str:
    parts = [NOTICE]
    for struct in used(words.api):
        rows = []
        for member in listed(struct):
            kind = type_of(words, struct, member)
            if kind is None or (struct.name, member.name) in IMPLIED:
                continue
            doc = " ".join(words.of_member(member).split())
            rows.append(f"@property {{{kind}}} [{camel(member.name)}] {doc}")
        if rows:
            tags = [f"@typedef {{object}} {pascal(struct.name)}", *rows]
            parts.append(comment(words.of_thing(struct), tags=tags))
    parts.append("export {};\n")
    return "\n".join(parts)
