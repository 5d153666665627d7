#!/usr/bin/env python3
"""describe.py [FOLDER]: prints interface.json, made out of the public headers (or those of FOLDER) and notes.toml.

Doxygen reads the headers; this program takes what it found and refuses everything that bindings could not use: types
that differ between platforms, structs by value, unions, enumerations, bit-fields, padding, and whatever has no comment.
Layouts are those of 64-bit platforms; tests/abi/layout.c asks every compiler whether it agrees.
"""

from __future__ import annotations

import json
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as xml
from pathlib import Path

import tomllib

ROOT = Path(__file__).resolve().parent.parent
HEADERS = ROOT / "include/mimo"
NOTES = ROOT / "interface/notes.toml"
FROZEN = ROOT / "interface/frozen"  # the interface of each released version, kept by ./dev freeze

FORMAT = 1
NUMBERS = {"char": 1, "int8_t": 1, "uint8_t": 1, "int32_t": 4, "uint32_t": 4, "float": 4}
NUMBERS |= {"int64_t": 8, "uint64_t": 8, "size_t": 8, "double": 8}
POINTER = 8

DOXYFILE = """
INPUT = "{headers}"
OUTPUT_DIRECTORY = "{out}"
GENERATE_HTML = NO
GENERATE_LATEX = NO
GENERATE_XML = YES
XML_PROGRAMLISTING = NO
OPTIMIZE_OUTPUT_FOR_C = YES
EXTRACT_ALL = YES
MARKDOWN_SUPPORT = NO
AUTOLINK_SUPPORT = NO
SORT_MEMBER_DOCS = NO
MACRO_EXPANSION = YES
EXPAND_ONLY_PREDEF = YES
PREDEFINED = MIMO_API= MIMO_NOEXCEPT=
QUIET = YES
WARN_IF_INCOMPLETE_DOC = NO
WARN_IF_UNDOCUMENTED = NO
"""


class Undescribable(Exception):
    """A declaration that bindings cannot use, or a note that fits nothing."""


# ---- Comments ----------------------------------------------------------------------------------------------


def prepare(text):
    """A header as Doxygen should see it: what follows the last parameter is a paragraph of its own, and # is text."""
    lines, in_command = [], False
    text = re.sub(r"/\*\*.*?\*/", lambda one: re.sub(r"(?<!/\*\*)#(?=\w)", r"\\\g<0>", one[0]), text, flags=re.DOTALL)
    for line in text.splitlines():
        if re.match(r" \* @(param|return)", line):
            in_command = True
        elif re.match(r" \* Errors:", line) or (in_command and re.match(r" \* \S", line)):
            lines.append(" *")
            in_command = False
        elif re.match(r" \*(/|$)", line):
            in_command = False
        lines.append(line)
    return "\n".join(lines) + "\n"


def words(element):
    return " ".join("".join(element.itertext()).split())


def paragraphs(element):
    """The paragraphs of a comment, without what it says of parameters."""
    found, line = [], []

    def end():
        text = " ".join("".join(line).split())
        if text:
            found.append(text)
        line.clear()

    def walk(node):
        line.append(node.text or "")
        for child in node:
            if child.tag == "parameterlist":
                end()
            elif child.tag == "simplesect":
                end()
                found.append(f"{child.get('kind').capitalize()}s: {words(child)}")
            elif child.tag in ("itemizedlist", "orderedlist"):
                end()
                found.append("\n".join(f"- {words(item)}" for item in child))
            elif child.tag in ("verbatim", "preformatted"):
                end()
                found.append("\n".join("    " + code for code in "".join(child.itertext()).strip("\n").splitlines()))
            elif child.tag == "para":
                end()
                walk(child)
                end()
            else:
                walk(child)
            line.append(child.tail or "")

    walk(element)
    end()
    return found


def comment(node, where):
    text = "\n\n".join(paragraphs(node.find("briefdescription")) + paragraphs(node.find("detaileddescription")))
    if not text:
        raise Undescribable(f"{where}: it has no comment")
    return text


def parameter_comments(node):
    told = {}
    for item in node.iterfind("detaileddescription//parameteritem"):
        text = "\n\n".join(paragraphs(item.find("parameterdescription")))
        for name in re.split(
            r"[,\s]+", " ".join(words(name) for name in item.iterfind("parameternamelist/parametername"))
        ):
            told[name] = text
    return told


# ---- Declarations ------------------------------------------------------------------------------------------


def spelling(text):
    """A type in the one way in which interface.json writes it: "const char *const *"."""
    text = " ".join(text.split())
    text = re.sub(r"\s*\*\s*", "*", text)
    return re.sub(r"(?<=\w)\*", " *", text)


class Reader:
    """Collects what Doxygen found, header after header."""

    def __init__(self, folder):
        self.folder = folder
        self.data = {
            key: [] for key in ("headers", "handles", "typedefs", "callbacks", "constants", "structs", "functions")
        }
        self.sizes = dict(NUMBERS)
        self.names = {key: set() for key in ("handles", "structs", "callbacks")}
        self.values = {}

    def parse(self, name):
        return xml.parse(self.folder / f"{name}.xml").getroot().find("compounddef")

    def header(self, chapter):
        node = self.parse(chapter.replace("_", "__").replace(".", "_8"))
        self.data["headers"].append({"name": chapter, "doc": comment(node, chapter)})
        structs = {words(inner): inner.get("refid") for inner in node.iterfind("innerclass")}
        for member in sorted(
            node.iterfind("sectiondef/memberdef"), key=lambda one: int(one.find("location").get("line"))
        ):
            where = f"{chapter}: {words(member.find('name'))}"
            kind = member.get("kind")
            if kind == "define":
                self.constant(member, chapter, where)
            elif kind == "function":
                self.function(member, chapter, where)
            elif kind == "typedef":
                self.typedef(member, chapter, where, structs)
            else:
                raise Undescribable(
                    f"{where}: a {kind} cannot be described; there are constants, structs and functions"
                )
        if structs:
            raise Undescribable(f"{chapter}: {', '.join(structs)}: a struct without a typedef of the same name")

    def constant(self, node, chapter, where):
        name, value = words(node.find("name")), node.find("initializer")
        if value is None and name.endswith("_H"):
            return  # the header's guard
        self.values[name] = self.value("" if value is None else words(value), where)
        self.data["constants"].append(
            {"name": name, "value": self.values[name], "doc": comment(node, where), "header": chapter}
        )

    def value(self, text, where):
        """The number or the string that a constant stands for, which may be made of constants before it."""
        if string := re.fullmatch(r'"([^"\\]*)"', text):
            return string[1]
        number = re.sub(r"\bMIMO_\w+", lambda name: repr(self.values.get(name[0], name[0])), text)
        number = re.sub(r"\b(0[xX][0-9a-fA-F]+|\d+)[uU]\b", r"\1", number)
        if not re.fullmatch(r"[-+*|()\s]*(?:(0[xX][0-9a-fA-F]+|\d+(\.\d+)?(e[-+]?\d+)?)[-+*|()\s]*)+", number):
            raise Undescribable(f'{where}: the value "{text}" is no number and no string')
        return eval(number, {"__builtins__": {}})  # nothing but numbers and operators, as was just seen

    def typedef(self, node, chapter, where, structs):
        name, kind = words(node.find("name")), spelling(words(node.find("type")))
        doc = comment(node, where)
        if kind == f"struct {name}":
            if name in structs:
                self.struct(self.parse(structs.pop(name)), name, doc, chapter)
            else:
                self.names["handles"].add(name)
                self.data["handles"].append({"name": name, "doc": doc, "header": chapter})
        elif function := re.fullmatch(r"(\w+) ?\(\*", kind):
            arguments = re.fullmatch(r"\)\((.*)\)", words(node.find("argsstring")))[1]
            split = [re.fullmatch(r"(.*?)(\w+)", argument.strip()) for argument in arguments.split(",")]
            parameters = [(spelling(one[1]), one[2]) for one in split]
            self.names["callbacks"].add(name)
            self.sizes[name] = POINTER
            self.data["callbacks"].append(
                {
                    "name": name,
                    "returns": self.returned(function[1], where),
                    "parameters": self.parameters(parameters, node, where),
                    "doc": doc,
                    "header": chapter,
                }
            )
        elif kind in NUMBERS:
            self.sizes[name] = NUMBERS[kind]
            self.data["typedefs"].append({"name": name, "c_type": kind, "doc": doc, "header": chapter})
        else:
            raise Undescribable(f'{where}: a typedef of "{kind}" cannot be described')

    def known(self, kind, where):
        """A type that all bindings have: a number, a pointer to numbers, structs or handles, a callback."""
        base = re.sub(r"\bconst\b|\*", " ", kind).split()
        pointers = kind.count("*")
        named = self.names["handles"] | self.names["structs"]
        plain = len(base) == 1 and (base[0] in self.sizes or (pointers and base[0] in named | {"void"}))
        if not plain or pointers > 2:
            raise Undescribable(f'{where}: the type "{kind}" cannot be described')
        return kind

    def returned(self, kind, where):
        return kind if kind == "void" else self.known(kind, f"{where}: its result")

    def parameters(self, declared, node, where):
        told = parameter_comments(node)
        if strangers := told.keys() - {name for _, name in declared}:
            raise Undescribable(
                f"{where}: its comment speaks of {', '.join(sorted(strangers))}, which it does not have"
            )
        return [
            {
                "name": name,
                "type": self.known(kind, f"{where}: parameter {name}"),
                "doc": told.get(name, ""),
            }
            for kind, name in declared
        ]

    def function(self, node, chapter, where):
        declared = []
        for parameter in node.iterfind("param"):
            kind = spelling(words(parameter.find("type")))
            if kind == "void":
                continue
            name = parameter.find("declname")
            if name is None or parameter.find("array") is not None:
                raise Undescribable(f'{where}: a parameter "{kind}" without a name, or an array, cannot be described')
            declared.append((kind, words(name)))
        self.data["functions"].append(
            {
                "name": words(node.find("name")),
                "returns": self.returned(spelling(words(node.find("type"))), where),
                "parameters": self.parameters(declared, node, where),
                "doc": comment(node, where),
                "header": chapter,
            }
        )

    def struct(self, node, name, doc, chapter):
        if node.get("kind") != "struct" or node.find("innerclass") is not None:
            raise Undescribable(f"{chapter}: {name}: unions and structs within structs cannot be described")
        members, offset, widest = [], 0, 1
        for member in node.iterfind("sectiondef/memberdef"):
            field = words(member.find("name"))
            where = f"{chapter}: {name}.{field}"
            if member.find("bitfield") is not None:
                raise Undescribable(f"{where}: a bit-field cannot be described")
            kind = self.known(spelling(words(member.find("type"))), where)
            extent = words(member.find("argsstring"))
            array = re.fullmatch(r"(?:\[(\d+)\])?", extent)
            if array is None:
                raise Undescribable(f'{where}: the array "{extent}" cannot be described')
            each = POINTER if "*" in kind else self.sizes[kind]
            if offset % each:
                raise Undescribable(f"{where}: there is padding before it, at offset {offset}")
            entry = {"name": field, "type": kind, "offset": offset, "size": each * int(array[1] or 1)}
            entry |= {"doc": comment(member, where), "array": int(array[1] or 0)}
            members.append(entry)
            offset, widest = offset + entry["size"], max(widest, each)
        if offset % widest or not members:
            raise Undescribable(f"{chapter}: {name}: it ends with padding, at offset {offset}, or has no members")
        self.names["structs"].add(name)
        sized = members[0]["name"] == "struct_size"
        self.data["structs"].append(
            {"name": name, "doc": doc, "header": chapter, "sized": sized, "size": offset, "members": members}
        )


def chapters(headers):
    """The headers in the order in which they are read."""
    return re.findall(r'^#include "(\w+\.h)"', (headers / "mimo.h").read_text(), flags=re.MULTILINE)


def read_headers(headers, folder):
    """What Doxygen finds in the headers, as XML."""
    copies = Path(folder) / "mimo"
    copies.mkdir()
    for header in headers.glob("*.h"):
        (copies / header.name).write_text(prepare(header.read_text(encoding="utf-8")), encoding="utf-8")
    settings = DOXYFILE.format(headers=copies, out=folder)
    subprocess.run(["doxygen", "-"], input=settings, text=True, check=True)
    return Path(folder) / "xml"


# ---- Notes -------------------------------------------------------------------------------------------------


def group(data, notes):
    """The enumerations of the notes. Every constant belongs to one of them, or stands alone by the notes."""
    constants = {one["name"]: one for one in data["constants"]}
    alone = set(notes["constants"]["alone"])
    claimed = {name for enum in notes["enum"] for name in enum.get("constants", [])}
    enums = []
    for enum in notes["enum"]:
        listed = set(enum.get("constants", enum.get("also", [])))
        members = [
            name
            for name, one in constants.items()
            if name in listed
            or (
                "constants" not in enum
                and name.startswith(enum["prefix"])
                and name not in claimed | alone
                and enum.get("header", one["header"]) == one["header"]
                and "group" not in one
            )
        ]
        if lacking := listed - constants.keys():
            raise Undescribable(
                f"notes.toml: {enum['name']} has {', '.join(sorted(lacking))}, which no header declares"
            )
        for name in members:
            constants[name]["group"] = enum["name"]
        check_values(enum, [constants[name] for name in members])
        enums.append(
            {
                "name": enum["name"],
                "kind": enum["kind"],
                "c_type": enum.get("type", "uint32_t" if enum["kind"] == "flags" else "int32_t"),
                "prefix": enum["prefix"],
                "doc": enum["doc"],
                "constants": members,
            }
        )
    for name, constant in constants.items():
        if "group" not in constant and name not in alone:
            raise Undescribable(
                f"{constant['header']}: {name} belongs to no enumeration of notes.toml, and is not in constants.alone"
            )
        constant.setdefault("group", None)
    return enums


def check_values(enum, constants):
    values = [one["value"] for one in constants]
    if not values or not all(isinstance(value, int) for value in values) or len(set(values)) != len(values):
        raise Undescribable(f"notes.toml: {enum['name']}: its constants are not different whole numbers: {values}")
    if enum["kind"] == "flags" and any(value <= 0 or value & (value - 1) for value in values):
        raise Undescribable(f"notes.toml: {enum['name']}: its flags are not single bits: {values}")


def enum_of(kind, doc, enums, typedefs):
    """The enumeration whose constants an integer takes: by its type, else by the first constant that its text names."""
    if kind not in ("int32_t", "uint32_t"):
        return next((one["name"] for one in enums if one["c_type"] == kind and kind in typedefs), None)
    for name in re.findall(r"\bMIMO_[A-Z0-9_]+", doc):
        for enum in enums:
            if name in enum["constants"] or (name == enum["prefix"] and name != "MIMO_"):
                return enum["name"]
    return None


class History:
    """In which version of the interface a name came, and how large a struct was then."""

    def __init__(self, now):
        self.now, self.came, self.first_sizes = now, {}, {}
        for path in sorted(FROZEN.glob("*.json"), key=lambda one: [int(part) for part in one.stem.split(".")]):
            released = json.loads(path.read_text(encoding="utf-8"))
            for one in released["constants"] + released["functions"] + released["structs"]:
                self.came.setdefault(one["name"], path.stem)
            for struct in released["structs"]:
                self.first_sizes.setdefault(struct["name"], struct["size"])
                for member in struct["members"]:
                    self.came.setdefault(f"{struct['name']}.{member['name']}", path.stem)

    def since(self, name):
        return self.came.get(name, self.now)


def annotate(data, notes, history):
    """Adds what the notes say (enumerations, units, ranges, owners, what is experimental), and since when."""
    enums = data["enums"]
    typedefs = {one["name"] for one in data["typedefs"]}
    known = {one["name"] for one in enums}
    young = notes["experimental"]
    used = set()

    def status(name, header):
        experimental = header in young["headers"] or any(re.fullmatch(pattern, name) for pattern in young["names"])
        if name in young["stable"]:
            used.add(name)
            experimental = False
        return {"since": history.since(name), "stability": "experimental" if experimental else "stable"}

    def enum_note(name, found):
        if name not in notes["enums_of"]:
            return found
        used.add(name)
        chosen = notes["enums_of"][name] or None
        if chosen is not None and chosen not in known:
            raise Undescribable(f"notes.toml: enums_of.{name}: there is no enumeration {chosen}")
        return chosen

    functions = {one["name"] for one in data["functions"]}
    for constant in data["constants"]:
        constant |= status(constant["name"], constant["header"])
    for struct in data["structs"]:
        name = struct["name"]
        init = f"{name}_init" if f"{name}_init" in functions else None
        struct |= {"first_size": history.first_sizes.get(name, struct["size"]), "init": init}
        struct |= status(name, struct["header"])
        for member in struct["members"]:
            path = f"{name}.{member['name']}"
            found = None if member["name"] == "struct_size" else enum_of(member["type"], member["doc"], enums, typedefs)
            member["enum"] = enum_note(path, found)
            member |= check_note(notes["members"].get(path, {}), member, path)
            used.add(path)
            told = status(path, "")
            if told["since"] != struct["since"]:
                member["since"] = told["since"]
            if told["stability"] == "experimental" and struct["stability"] == "stable":
                member["stability"] = "experimental"
    for function in data["functions"] + data["callbacks"]:
        for parameter in function["parameters"]:
            path = f"{function['name']}.{parameter['name']}"
            found = enum_note(parameter["name"], enum_of(parameter["type"], parameter["doc"], enums, typedefs))
            integer = parameter["type"] in ("int32_t", "uint32_t") or parameter["type"] in typedefs
            parameter["enum"] = enum_note(path, found if integer else None)
        if function in data["functions"]:
            function |= status(function["name"], function["header"])
    given = set(notes["enums_of"]) | set(notes["members"]) | set(young["stable"])
    if unused := given - used:
        raise Undescribable(f"notes.toml: there is no {', '.join(sorted(unused))}")


def check_note(note, member, path):
    """A member's note. Numbers and units that the header's comment does not have are refused: it is the one source."""
    text = " ".join(member["doc"].split())
    if "range" in note:
        low, high = ("infinity" if abs(number) == float("inf") else f"{number:g}" for number in note["range"])
        if low not in text or high not in text:
            raise Undescribable(f"notes.toml: {path}: its comment does not have the range {low} to {high}")
    return note


def describe(headers=HEADERS):
    notes = tomllib.loads(NOTES.read_text(encoding="utf-8"))
    with tempfile.TemporaryDirectory() as folder:
        reader = Reader(read_headers(headers, folder))
        for chapter in chapters(headers):
            reader.header(chapter)
    data, values = reader.data, reader.values
    version = ".".join(str(values[f"MIMO_VERSION_{part}"]) for part in ("MAJOR", "MINOR", "PATCH"))
    data = {
        "format": FORMAT,
        "version": version + values["MIMO_VERSION_LABEL"],
        "abi": values["MIMO_ABI_VERSION"],
    } | data
    data["enums"] = group(data, notes)
    annotate(data, notes, History("{MIMO_API_MAJOR}.{MIMO_API_MINOR}".format(**values)))
    return data


def text(headers=HEADERS):
    """The text of interface.json."""
    return json.dumps(describe(headers), indent=1, ensure_ascii=False) + "\n"


if __name__ == "__main__":
    try:
        sys.stdout.write(text(*map(Path, sys.argv[1:])))
    except Undescribable as error:
        sys.exit(f"describe.py: {error}")
