"""Adds to a description of the headers what notes.toml says, and since when each thing is there."""

from __future__ import annotations

import json
import re
from pathlib import Path

import tomllib

HERE = Path(__file__).resolve().parent
NOTES = HERE / "notes.toml"
FROZEN = HERE / "frozen"  # the interface of each released version, kept by ./dev freeze


class Undescribable(Exception):
    """A declaration that bindings cannot use, or a note that fits nothing."""


def read():
    return tomllib.loads(NOTES.read_text(encoding="utf-8"))


def add(data, now):
    """Adds the enumerations, and to everything else what is noted of it; `now` is the version of the interface."""
    notes = read()
    data["enums"] = group(data, notes)
    annotate(data, notes, History(now))


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
