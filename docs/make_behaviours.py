#!/usr/bin/env python3
"""Writes what scenes say of behaviours: the table in docs/tasks.md, the pictures in docs/guide/behaviours.md.

make_behaviours.py PROGRAM writes both, from `PROGRAM info --tasks --json`; with --check behind that nothing is written:
fails where a page differs. docs/images/make_behaviours.py draws the pictures.
"""

import json
import re
import subprocess
import sys
from pathlib import Path

DOCS = Path(__file__).resolve().parent
BLOCK = re.compile(r"(<!-- [a-z]+ of behaviours, by docs/make_behaviours\.py -->\n).*?(<!-- end -->)", re.DOTALL)
HEADS = ("scene", "the infant", "measure", "reached", "and", "months", "which; source")


def number(value):
    return "-" if value is None else f"{value:g}"


def reached(it):
    unit = f" {it['unit']}" if it["unit"] else ""
    held = f" for {it['hold_seconds']:g} s" if it["hold_seconds"] else ""
    return f"{'at most' if it['at_most'] else 'at least'} {it['threshold']:g}{unit}{held}"


def row(it):
    norm = it["norm"]
    months = " / ".join(number(norm[key]) for key in ("early_months", "months", "late_months"))
    known = any(norm[key] is not None for key in ("early_months", "months", "late_months"))
    conditions = "<br>".join(f"`{one}`" for one in it["conditions"].split("; ") if one)
    source = f"{norm['about']}; {it['source']}" if norm["about"] else it["source"]
    return (
        f"`{it['scene']}`",
        it["about"],
        f"`{it['measure']}`",
        reached(it),
        conditions,
        months if known else "",
        source,
    )


def table(behaviours):
    rows = [HEADS, ("---",) * len(HEADS), *map(row, behaviours)]
    return "".join(f"| {' | '.join(cells)} |\n" for cells in rows)


def pictures(behaviours):
    shown = (
        f"`{it['scene']}`: {it['about']}. Reached: `{it['measure']}` {reached(it)}.\n\n"
        f"![{it['scene']}](../images/behaviours/{it['scene']}.png)\n"
        for it in behaviours
    )
    return "\n".join(shown)


def renewed(page, text):
    """The page with the text in the place that it has for it."""
    written = page.read_text(encoding="utf-8")
    found, count = BLOCK.subn(lambda block: f"{block[1]}\n{text}\n{block[2]}", written)
    if count != 1:
        sys.exit(f"{page} has {count} places for behaviours, expected one")
    return found


def main():
    arguments = sys.argv[1:]
    check = arguments[1:] == ["--check"]
    if not arguments or (arguments[1:] and not check):
        sys.exit(__doc__)
    said = subprocess.run(
        [arguments[0], "info", "--tasks", "--json"], check=True, capture_output=True, text=True
    ).stdout
    behaviours = [it for it in json.loads(said) if it["measure"] is not None]
    for page, text in ((DOCS / "tasks.md", table(behaviours)), (DOCS / "guide/behaviours.md", pictures(behaviours))):
        new = renewed(page, text)
        if check and new != page.read_text(encoding="utf-8"):
            sys.exit(f"{page} differs from what the scenes say; run docs/make_behaviours.py")
        if not check:
            page.write_text(new, encoding="utf-8")


if __name__ == "__main__":
    main()
