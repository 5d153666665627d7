"""Tables in the guides: the members of a struct, and the constants of an enumeration, with the header's comments.

A guide says where: <!-- members of mimo_growth --> or <!-- constants of Axes -->, and <!-- end --> behind the table.
"""

import re
from pathlib import Path

import notes

ROOT = Path(__file__).resolve().parents[2]
PLACE = re.compile(r"<!-- (members|constants) of (\w+) -->\n.*?<!-- end -->", re.DOTALL)


def files(api):
    found = {}
    for path in sorted((ROOT / "docs").rglob("*.md")):
        text = path.read_text(encoding="utf-8")
        if PLACE.search(text):
            found[str(path.relative_to(ROOT))] = PLACE.sub(lambda place: table(api, place[1], place[2]), text)
    return found


def table(api, kind, name):
    known = api.structs if kind == "members" else api.enums
    if not any(one.name == name for one in known):
        raise notes.Undescribable(f"a guide has the {kind} of {name}, which there is not")
    if kind == "members":
        members = (one for one in api.struct(name).members if one.name != "struct_size" and "reserved" not in one.name)
        rows = [(one.name, one.doc) for one in members]
    else:
        rows = [(one, api.constant(one).doc) for one in api.enum(name).constants]
    lines = [f"<!-- {kind} of {name} -->", "", f"| {kind[:-1]} | |", "|---|---|"]
    lines += [f"| `{word}` | {' '.join(doc.split()).replace('|', chr(92) + '|')} |" for word, doc in rows]
    return "\n".join([*lines, "", "<!-- end -->"])
