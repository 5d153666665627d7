#!/usr/bin/env python3
"""Writes the table and the drawing of rooms in docs/architecture.md, out of the CMake lists of src/.

With --check nothing is written: fails where the page differs, and where a room names another one whose headers none of
its files sees, or sees one that it does not name, or calls MuJoCo's functions without being the engine or a renderer.
Also fails where the page names something of C++ that does not exist, or its table "Where something new goes" a path.
"""

import re
import sys
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs/architecture.md"
CALL = re.compile(r"mimo_room\(\s*(\w+)\s+(OUTSIDE\s+)?ABOUT\s+\"([^\"]*)\"([^)]*)\)")
CALLERS_OF_MUJOCO = ("compat", "solver", "engine", "render", "rays", "opengl", "geometry")
NAMES_STAND_IN = ("src", "include", "interface/targets", "docs/site", "tests/python")
SUFFIXES = (".h", ".cpp", ".hpp", ".py", ".txt")
MUJOCO_CALL = re.compile(r"\bmj[uvr]?_\w+\s*\(")
INCLUDE = re.compile(r'^\s*#\s*include "((\w+)/[^"]+)"', re.MULTILINE)


class Room(NamedTuple):
    about: str
    sees: list  # rooms that it names
    outside: bool  # a part of programs, which see the public headers and no room of the library


def named_after(keyword, rest):
    """The words behind a keyword of the call, up to the next one."""
    words = rest.split()
    if keyword not in words:
        return []
    following = words[words.index(keyword) + 1 :]
    ends = [i for i, word in enumerate(following) if word.isupper()]
    return following[: ends[0]] if ends else following


def read_rooms():
    rooms = {}
    for path in sorted(ROOT.glob("src/*/CMakeLists.txt")):
        for name, outside, about, rest in CALL.findall(path.read_text()):
            rooms[name] = Room(about, named_after("DEPENDS", rest), bool(outside))
    return rooms


def floors(rooms):
    """Rooms by how many lie below them, the highest floor first. Programs lie above the library."""
    height = {}

    def floor(name):
        if name not in height:
            below = [*rooms[name].sees, *(["capi"] if rooms[name].outside else [])]
            height[name] = 1 + max((floor(other) for other in below), default=-1)
        return height[name]

    for name in rooms:
        floor(name)
    return [sorted(n for n in rooms if height[n] == level) for level in range(max(height.values()), -1, -1)]


def drawn(rooms):
    levels = floors(rooms)
    table = ["| room | what it does | rooms that it sees |", "|---|---|---|"]
    for level in levels:
        for name in level:
            room = rooms[name]
            sees = [*room.sees, *(["the public headers"] if room.outside else [])]
            table.append(f"| `{name}` | {room.about} | {', '.join(sees)} |")
    drawing = [f"    floor {len(levels) - 1 - i:2}   {'   '.join(level)}" for i, level in enumerate(levels)]
    return {"table": "\n".join(table), "drawing": "\n".join(drawing)}


def with_drawn(text, parts):
    for name, content in parts.items():
        pattern = rf"(<!-- {name} of rooms, by docs/make_rooms.py -->\n).*?(<!-- end -->)"
        text, count = re.subn(pattern, lambda m, c=content: f"{m[1]}\n{c}\n\n{m[2]}", text, flags=re.DOTALL)
        if count != 1:
            sys.exit(f"{PAGE}: no place for the {name} of rooms")
    return text


def seen(name, rooms):
    """Rooms whose headers the files of a room include, also by way of other headers."""
    waiting = [p for p in (ROOT / "src" / name).rglob("*") if p.suffix in (".h", ".cpp")]
    known, found = set(waiting), set()
    while waiting:
        for path, room in INCLUDE.findall(waiting.pop().read_text()):
            header = ROOT / "src" / path
            if room not in rooms or header in known or not header.exists():
                continue
            known.add(header)
            waiting.append(header)
            found.add(room)
    return found - {name}


def wrong_arrows(rooms):
    for name, room in rooms.items():
        named, includes = room.sees, seen(name, rooms)
        for other in sorted(set(named) - includes):
            yield f"src/{name} names {other}, but includes nothing of it"
        for other in sorted(includes - set(named)):
            yield f"src/{name} includes headers of {other}, but does not name it"


def forbidden_calls():
    """MuJoCo's functions fail by a jump, so only the engine, which guards them, and renderers call them."""
    for path in sorted(p for p in (ROOT / "src").rglob("*") if p.suffix in (".h", ".cpp")):
        if path.relative_to(ROOT / "src").parts[0] in CALLERS_OF_MUJOCO:
            continue
        for number, line in enumerate(path.read_text().splitlines(), 1):
            if MUJOCO_CALL.search(line.split("//")[0]):
                yield f"{path.relative_to(ROOT)}:{number} calls MuJoCo, which only {', '.join(CALLERS_OF_MUJOCO)} may"


def is_path(quoted):
    return quoted.startswith(tuple(f"{folder}/" for folder in NAMES_STAND_IN))


def lost_names(text):
    """Names of C++ and paths on the page that the tree does not have."""
    table = text.split("## Where something new goes", 1)[1].split("\n## ", 1)[0]
    folders = [ROOT / folder for folder in NAMES_STAND_IN]
    code = "\n".join(p.read_text() for f in folders for p in f.rglob("*") if p.suffix in SUFFIXES)
    known = set(re.findall(r"\w+", code))
    elsewhere = [quoted for quoted in re.findall(r"`([^`\n]+)`", text) if "::" in quoted or is_path(quoted)]
    for quoted in sorted({*re.findall(r"`([^`]+)`", table), *elsewhere}):
        if "/" in quoted and " " not in quoted:
            if not (ROOT / quoted).exists():
                yield f"docs/architecture.md sends its readers to {quoted}, which does not exist"
        elif re.fullmatch(r"[\w:]+(\(\w*\))?", quoted):
            for name in re.findall(r"\w+", quoted):
                if name not in known:
                    yield f"docs/architecture.md sends its readers to {name}, which no file has"


def main():
    rooms = read_rooms()
    text = PAGE.read_text()
    made = with_drawn(text, drawn(rooms))
    if "--check" not in sys.argv[1:]:
        PAGE.write_text(made)
        return
    complaints = [*wrong_arrows(rooms), *forbidden_calls(), *lost_names(text)]
    if made != text:
        complaints.append("docs/architecture.md differs from the CMake lists; run docs/make_rooms.py")
    sys.exit("\n".join(complaints) or None)


if __name__ == "__main__":
    main()
