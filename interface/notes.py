"""Adds to a description of the headers what notes.toml says, and since when each thing is there."""

from __future__ import annotations

import json
import re
from pathlib import Path

import facts
import tomllib

HERE = Path(__file__).resolve().parent
NOTES = HERE / "notes.toml"
FROZEN = HERE / "frozen"  # the interface of each released version, kept by ./dev freeze


class Undescribable(Exception):
    """A declaration that bindings cannot use, or a note that fits nothing."""


def read():
    return tomllib.loads(NOTES.read_text(encoding="utf-8"))


def add(data, now, label):
    """Adds the enumerations, and to everything what is noted of it. `now` is the interface's version, "1.0"."""
    notes = read()
    data["enums"] = group(data, notes)
    Annotator(data, notes, History(now, label)).annotate()


def group(data, notes):
    """The enumerations of the notes. Every constant belongs to one of them, or stands alone by the notes."""
    constants = {one["name"]: one for one in data["constants"]}
    alone = set(notes["constants"]["alone"])
    claimed = {name for enum in notes["enum"] for name in enum.get("constants", [])}
    enums = []
    for enum in notes["enum"]:
        listed = {*enum.get("constants", []), *enum.get("also", [])}
        prefixes = [] if "constants" in enum else [enum["prefix"]]
        if "of" in enum:
            prefixes = [f"{name}_" for one in enums if one["name"] == enum["of"] for name in one["constants"]]
        free = constants.keys() - claimed - alone - set(enum.get("except", []))
        members = [
            name
            for name, one in constants.items()
            if name in listed or (name in free and "group" not in one and name.startswith(tuple(prefixes)))
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
                "sense": enum.get("sense"),
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


class History:
    """In which version of the interface a name came, how large a struct was then, and the node of what is promised."""

    def __init__(self, now, label):
        self.now, self.newest = now, now + label.replace("-", "_")
        self.came, self.first_sizes, self.nodes = {}, {}, {}
        for path in sorted(FROZEN.glob("*.json"), key=lambda one: [int(part) for part in one.stem.split(".")]):
            released = json.loads(path.read_text(encoding="utf-8"))
            for one in released["constants"] + released["functions"] + released["structs"]:
                self.came.setdefault(one["name"], path.stem)
            for struct in released["structs"]:
                self.first_sizes.setdefault(struct["name"], struct["size"])
                for member in struct["members"]:
                    self.came.setdefault(f"{struct['name']}.{member['name']}", path.stem)
            if path.stem != now:
                for function in released["functions"]:
                    if function["stability"] == "stable":
                        self.nodes.setdefault(function["name"], function["node"])

    def since(self, name):
        return self.came.get(name, self.now)

    def node(self, name, stability):
        """A function's symbol version: the one with which it was promised, or else one that each version changes."""
        if stability == "experimental":
            return f"LIBMIMO_EXPERIMENTAL_{self.newest}"
        return self.nodes.get(name, f"LIBMIMO_{self.newest}")


class Annotator:
    """Adds to everything what the notes say of it, and remembers which notes fitted something."""

    def __init__(self, data, notes, history):
        self.data, self.notes, self.history = data, notes, history
        self.young = notes["experimental"]["members"]
        self.typedefs = {one["name"] for one in data["typedefs"]}
        self.used = set()

    def annotate(self):
        for constant in self.data["constants"]:
            constant |= self.status(constant["name"], constant["header"])
        for struct in self.data["structs"]:
            self.struct(struct)
        self.senses()
        for function in self.data["functions"]:
            function |= self.status(function["name"], function["header"])
            function["node"] = self.history.node(function["name"], function["stability"])
        for function in self.data["functions"] + self.data["callbacks"]:
            self.parameters(function)
        given = {*self.notes["enums_of"], *self.notes["members"], *self.notes["owners"], *self.young}
        if unused := given - self.used:
            raise Undescribable(f"notes.toml: nothing is called {', '.join(sorted(unused))}")

    def status(self, name, header=""):
        """Since when it is there, and whether it may still change: what experimental/ declares, and some members."""
        young = header.startswith("experimental/") or any(re.fullmatch(one, name) for one in self.young)
        self.used.update(one for one in self.young if re.fullmatch(one, name))
        return {"since": self.history.since(name), "stability": "experimental" if young else "stable"}

    def enum(self, name, found):
        """An enumeration by its note, else the one that was found."""
        if name not in self.notes["enums_of"]:
            return found
        self.used.add(name)
        return self.notes["enums_of"][name] or None

    def struct(self, struct):
        name, functions = struct["name"], {one["name"] for one in self.data["functions"]}
        struct["first_size"] = self.history.first_sizes.get(name, struct["size"])
        struct["init"] = f"{name}_init" if f"{name}_init" in functions else None
        struct |= self.status(name, struct["header"])
        for member in struct["members"]:
            self.member(struct, member)

    def member(self, struct, member):
        path = f"{struct['name']}.{member['name']}"
        found = None if member["name"] == "struct_size" else self.enum_of(member)
        member["enum"] = self.enum(path, found)
        told = {"unit": facts.unit_of(member), "range": facts.range_of(member)}
        if "*" in member["type"] and struct["name"] in self.notes["owners"]:
            self.used.add(struct["name"])
            told["owner"] = self.notes["owners"][struct["name"]]
        told |= self.notes["members"].get(path, {})
        self.used.add(path)
        status = self.status(path)
        if status["since"] != struct["since"]:
            told["since"] = status["since"]
        if status["stability"] != struct["stability"] == "stable":
            told["stability"] = status["stability"]
        member |= {key: value for key, value in told.items() if value not in (None, "", [])}

    def senses(self):
        """Which member of an agent's config belongs to which sense; every sense has one that switches it on."""
        config = next(one for one in self.data["structs"] if one["name"] == "mimo_agent_config")
        named = [one["sense"] for one in self.data["enums"] if one["sense"]]
        for member in config["members"]:
            if found := [one for one in named if f"{member['name']}_".startswith(f"{one}_")]:
                member["sense"] = found[0]
        if lacking := set(named) - {one["name"] for one in config["members"]}:
            raise Undescribable(f"mimo_agent_config lacks {', '.join(sorted(lacking))}, a sense by notes.toml")
        if strangers := {one["sense"] for one in config["members"] if "sense" in one} - set(named):
            raise Undescribable(f"notes.toml: no enumeration is of the sense {', '.join(sorted(strangers))}")

    def parameters(self, function):
        for parameter in function["parameters"]:
            integer = parameter["type"] in ("int32_t", "uint32_t") or parameter["type"] in self.typedefs
            found = self.enum(parameter["name"], self.enum_of(parameter)) if integer else None
            parameter["enum"] = self.enum(f"{function['name']}.{parameter['name']}", found)

    def enum_of(self, integer):
        """The enumeration of an integer: by its type, else by the first of its constants that the comment names."""
        kind, enums = integer["type"], self.data["enums"]
        if kind not in ("int32_t", "uint32_t"):
            return next((one["name"] for one in enums if one["c_type"] == kind and kind in self.typedefs), None)
        for name in re.findall(r"\bMIMO_[A-Z0-9_]+", integer["doc"]):
            for enum in enums:
                if name in enum["constants"] or (name == enum["prefix"] and name != "MIMO_"):
                    return enum["name"]
        return None
