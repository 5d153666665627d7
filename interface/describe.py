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

import notes
from notes import Undescribable

ROOT = Path(__file__).resolve().parent.parent
HEADERS = ROOT / "include/mimo"

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
RECURSIVE = YES
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
        node = self.parse(Path(chapter).name.replace("_", "__").replace(".", "_8"))
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
    """The headers in the order in which they are read: the promised ones, then those of experimental/."""
    both = "".join((headers / name).read_text(encoding="utf-8") for name in ("mimo.h", "experimental.h"))
    return re.findall(r'^#include "((?:experimental/)?\w+\.h)"', both.replace('#include "mimo.h"', ""), re.MULTILINE)


def read_headers(headers, folder):
    """What Doxygen finds in the headers, as XML."""
    copies = Path(folder) / "mimo"
    for header in headers.rglob("*.h"):
        copy = copies / header.relative_to(headers)
        copy.parent.mkdir(parents=True, exist_ok=True)
        copy.write_text(prepare(header.read_text(encoding="utf-8")), encoding="utf-8")
    settings = DOXYFILE.format(headers=copies, out=folder)
    subprocess.run(["doxygen", "-"], input=settings, text=True, check=True)
    return Path(folder) / "xml"


def describe(headers=HEADERS):
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
    notes.add(data, "{MIMO_API_MAJOR}.{MIMO_API_MINOR}".format(**values), values["MIMO_VERSION_LABEL"])
    return data


def text(headers=HEADERS):
    """The text of interface.json."""
    return json.dumps(describe(headers), indent=1, ensure_ascii=False) + "\n"


if __name__ == "__main__":
    try:
        sys.stdout.write(text(*map(Path, sys.argv[1:])))
    except Undescribable as error:
        sys.exit(f"describe.py: {error}")
