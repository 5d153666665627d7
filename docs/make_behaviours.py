#!/usr/bin/env python3
"""Writes the table of behaviours in docs/tasks.md out of what their scenes' documents say.

make_behaviours.py PROGRAM writes it, from `PROGRAM info --tasks --json`; with --check behind that nothing is written:
fails where the page differs.
"""

import json
import re
import subprocess
import sys
from pathlib import Path

PAGE = Path(__file__).resolve().parent / "tasks.md"
BEGIN, END = "<!-- table of behaviours, by docs/make_behaviours.py -->\n", "<!-- end -->"
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


def main():
    arguments = sys.argv[1:]
    check = arguments[1:] == ["--check"]
    if not arguments or (arguments[1:] and not check):
        sys.exit(__doc__)
    said = subprocess.run(
        [arguments[0], "info", "--tasks", "--json"], check=True, capture_output=True, text=True
    ).stdout
    behaviours = [it for it in json.loads(said) if it["measure"] is not None]
    page = PAGE.read_text(encoding="utf-8")
    text = BEGIN + "\n" + table(behaviours) + "\n" + END
    renewed, count = re.subn(re.escape(BEGIN) + ".*?" + re.escape(END), lambda _: text, page, flags=re.DOTALL)
    if count != 1:
        sys.exit(f"{PAGE} has {count} places for the table, expected one")
    if check and renewed != page:
        sys.exit(f"{PAGE} differs from what the scenes say; run docs/make_behaviours.py")
    if not check:
        PAGE.write_text(renewed, encoding="utf-8")


if __name__ == "__main__":
    main()
