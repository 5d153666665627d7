"""C#: enumerations, structs and functions of the header; the classes on top of them are _csharp_classes.py's."""

from __future__ import annotations

import re

from targets._csharp_classes import configs, records
from targets._csharp_stage import parts
from targets._csharp_words import (
    ADDED,
    HEAD,
    NUMBERS,
    Words,
    documented,
    in_namespace,
    indent,
    keyworded,
    lines_of,
    pascal,
    pointed,
    raw_name,
    raw_type,
    wrapped,
)

SOURCES = "bindings/csharp/src"
TESTS = "bindings/csharp/tests"

# Parameters that the rules of `parameter` do not know.
PARAMETERS = {
    ("mimo_scene_set_maturity", "maturity"): "IntPtr",  # may be null
    ("mimo_scene_set_task", "task"): "IntPtr",  # may be null
    ("mimo_batch_send", "actions"): "IntPtr",  # used after the call
    ("mimo_batch_send", "blocks"): "IntPtr",  # used after the call
    ("mimo_recording_read", "values"): "IntPtr",  # of any type
    ("mimo_stage_draw", "poses"): "IntPtr[]",
    ("mimo_stage_draw", "views"): "IntPtr[]",
    ("mimo_scene_direct_source", "place"): "ref Vector3d",
    ("mimo_scene_direct_source", "axis"): "ref Vector3d",
    ("mimo_env_look_angles", "point"): "ref Vector3d",
    ("mimo_env_look_angles", "errors"): "double[]",
    ("mimo_env_look_at", "point"): "ref Vector3d",
    ("mimo_env_look_at", "errors"): "double[]",
    ("mimo_env_project", "points"): "Vector3d[]",
    ("mimo_env_project", "pixels"): "[Out] Vector3d[]",
}

# Functions that return a handle to keep. All others lend one.
MAKERS = ("_create", "_make", "_clone", "_open", "_attach", "_recording_env")

# Functions that are also called while a handle is released, with the bare pointer.
RELEASING = {"mimo_recorder_close"}


# ---- Enumerations -------------------------------------------------------------------------------------------


def enumeration(words, enum):
    flags = enum.kind == "flags"
    constants = sorted((words.api.constant(name) for name in words.constants(enum)), key=lambda one: abs(one.value))
    rows = [(words.constant(one.name), one.value, words.text(one.doc, enum=enum)) for one in constants]
    if flags and "None" not in [name for name, _, _ in rows]:
        rows.insert(0, ("None", 0, "None of them."))
    hexadecimal = flags or max(value for _, value, _ in rows) > 0xFF
    body = []
    for name, value, text in rows:
        number = f"0x{value:X}" if hexadecimal and value > 0 else value
        body += [*documented(text), f"{name} = {number},"]
    body[-1] = body[-1].rstrip(",")
    base = " : uint" if enum.c_type == "uint32_t" else ""
    head = documented(words.text(enum.doc)) + ["[Flags]"] * flags
    return [*head, f"public enum {words.enum(enum)}{base}", "{", *indent(body), "}"]


def enumerations(words):
    return in_namespace(["System"], [enumeration(words, enum) for enum in words.api.enums])


# ---- Structs ------------------------------------------------------------------------------------------------

NEW = """
internal const uint Bytes = {struct.size};

internal static {name} New()
{{
    return new {name} {{ struct_size = Bytes }};
}}
"""

NEW_BY_FUNCTION = """
internal const uint Bytes = {struct.size};

internal static {name} New()
{{
    {name} made;
    MimoException.Check(Native.{struct.init}(out made, (UIntPtr)Bytes));
    return made;
}}
"""


def raw_struct(struct):
    """A struct of C, and how a new one is made."""
    name = raw_name(struct.name)
    members = [f"internal {raw_type(member)} {keyworded(member.name)};" for member in struct.members]
    new = (NEW_BY_FUNCTION if struct.init else NEW).format(struct=struct, name=name)
    head = ["[StructLayout(LayoutKind.Sequential)]", f"internal partial struct {name}"]
    return [*head, "{", *indent([*members, *lines_of(new)]), "}"]


def structs(api):
    return in_namespace(["System", "System.Runtime.InteropServices"], [raw_struct(struct) for struct in api.structs])


LAYOUTS = """{head}using System;
using System.Collections.Generic;
using Mimo;

internal static partial class Tests
{{
    /// <summary>Size of each struct, and name, offset and size of its members.</summary>
    private static readonly Dictionary<Type, string> Layouts = new Dictionary<Type, string>
    {{
{rows}
    }};
}}
"""


def layouts(api):
    """The layout that a test compares the structs with."""
    rows = []
    for struct in api.structs:
        members = ", ".join(f"{member.name} {member.offset} {member.size}" for member in struct.members)
        strings = " +\n    ".join(f'"{line}"' for line in [f"{struct.size}: ", *wrapped(members, 104)])
        rows += f"{{ typeof({raw_name(struct.name)}), {strings} }},".splitlines()
    rows[-1] = rows[-1].rstrip(",")
    return LAYOUTS.format(head=HEAD, rows="\n".join(indent(rows, 8)))


# ---- Functions ----------------------------------------------------------------------------------------------

FUNCTION = """
internal static {returns} {name}({parameters})
{{
    try {{ {result}Entry.{name}({arguments}); }}
    catch (EntryPointNotFoundException) {{ throw Library.Lacks("{name}"); }}
}}
"""

NATIVE = """
/// <summary>The functions of mimo.h. Arrays are pinned for the length of a call, not copied. A function that the
/// loaded library lacks is a MimoException.</summary>
internal static class Native
{{
    // libmimo.so on Linux; .NET and Mono complete the name.
    private const string File = "mimo";
{body}

    private static class Entry
    {{
{entries}
    }}
}}
"""


def followed_by_length(parameters, index):
    """Whether a pointer is an array: a length comes behind it, or behind further arrays."""
    for other in parameters[index + 1 :]:
        if other.type == "size_t":
            return True
        if pointed(other.type) not in NUMBERS:
            return False
    return False


def parameter(api, function, index):
    """The type of a parameter, with `ref` or `out`."""
    parameters = function.parameters
    one = parameters[index]
    if (function.name, one.name) in PARAMETERS:
        return PARAMETERS[function.name, one.name]
    if one.type in NUMBERS:
        return NUMBERS[one.type]
    base, twice = pointed(one.type), one.type.endswith("**")
    if api.is_a("handles", base):
        name = pascal(base) + "Handle"
        if twice:
            return "out " + (name if function.name.endswith(MAKERS) else "IntPtr")
        frees = function.returns == "void" and len(parameters) == 1  # called while its handle is released
        return "IntPtr" if frees else name
    if api.is_a("structs", base):
        fills = not one.type.startswith("const") and "size" in [other.name for other in parameters[index + 1 :]]
        return ("out " if fills else "ref ") + raw_name(base)
    if base == "char":
        return "out IntPtr" if twice else "byte[]"
    if base == "void":
        return "byte[]" if followed_by_length(parameters, index) else "IntPtr"
    is_array = one.type.startswith("const") or followed_by_length(parameters, index)
    return NUMBERS[base] + "[]" if is_array else "out " + NUMBERS[base]


def returned(function):
    return "void" if function.returns == "void" else NUMBERS.get(function.returns, "IntPtr")


def listed(types, parameters):
    return ", ".join(f"{kind} {keyworded(one.name)}" for kind, one in zip(types, parameters, strict=True))


def native(function, types):
    """A function, and its entry in the library."""
    names = [keyworded(one.name) for one in function.parameters]
    modes = [re.match(r"(?:ref |out )?", kind)[0] for kind in types]
    declared, returns = listed(types, function.parameters), returned(function)
    outer = FUNCTION.format(
        name=function.name,
        returns=returns,
        parameters=declared.replace("[Out] ", ""),
        result="" if returns == "void" else "return ",
        arguments=", ".join(mode + name for mode, name in zip(modes, names, strict=True)),
    )
    return lines_of(outer), f"[DllImport(File)] internal static extern {returns} {function.name}({declared});"


def delegate(api, callback):
    bases = [pointed(one.type) for one in callback.parameters]
    types = ["ref " + raw_name(base) if api.is_a("structs", base) else "IntPtr" for base in bases]
    name = pascal(callback.name.removesuffix("_fn")) + "Function"
    signature = f"internal delegate {returned(callback)} {name}({listed(types, callback.parameters)});"
    return ["", "[UnmanagedFunctionPointer(CallingConvention.Cdecl)]", signature]


def constants(api):
    """Numbers and texts that belong to no enumeration."""
    added = {name for names in ADDED.values() for name in names}
    lines = []
    for one in api.constants:
        if one.group is None and one.name not in added:
            kind, value = ("string", f'"{one.value}"') if isinstance(one.value, str) else ("int", one.value)
            lines.append(f"internal const {kind} {pascal(one.name)} = {value};")
    doc = documented("Constants of mimo.h that belong to no enumeration.")
    return [*doc, "internal static class Constants", "{", *indent(lines), "}"]


def natives(api):
    body, entries = [], []
    for callback in api.callbacks:
        body += delegate(api, callback)
    for function in api.functions:
        overloads = [[parameter(api, function, index) for index in range(len(function.parameters))]]
        for types in overloads + [["IntPtr"]] * (function.name in RELEASING):
            lines, entry = native(function, types)
            body += lines
            entries.append(entry)
    text = NATIVE.format(body="\n".join(indent(body)), entries="\n".join(indent(entries, 8)))
    return in_namespace(["System", "System.Runtime.InteropServices"], [lines_of(text)[1:], constants(api)])


def files(api):
    """All generated files of the C# binding, by their paths."""
    words = Words(api)
    return {
        f"{SOURCES}/Enumerations.cs": enumerations(words),
        f"{SOURCES}/Structs.cs": structs(api),
        f"{SOURCES}/Native.cs": natives(api),
        f"{SOURCES}/Configs.cs": configs(words),
        f"{SOURCES}/Records.cs": records(words),
        f"{SOURCES}/StageParts.cs": parts(words),
        f"{TESTS}/Layouts.cs": layouts(api),
    }
