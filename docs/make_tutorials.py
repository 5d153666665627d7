#!/usr/bin/env python3
"""make_tutorials.py [PAGE...]: runs the programs of docs/tutorials/*.md, and renews what the pages show.

    python docs/make_tutorials.py hand               # docs/tutorials/hand.md
    python docs/make_tutorials.py --notebooks FOLDER # all pages as notebooks

The programs of a page are one program, in an empty folder. What a piece prints stands behind it, as text; the pictures
that it saves are in docs/images/tutorials. tests/python/test_tutorials.py compares both with what is there.
"""

import contextlib
import io
import json
import os
import re
import shutil
import sys
import tempfile
from pathlib import Path

DOCS = Path(__file__).resolve().parent
TUTORIALS, IMAGES = DOCS / "tutorials", DOCS / "images/tutorials"
CELL = re.compile(r"^```python\n(?P<code>.*?)^```\n(?:\n```text\n(?P<said>.*?)^```\n)?", re.DOTALL | re.MULTILINE)
PICTURE = re.compile(r"\(\.\./images/tutorials/([\w-]+\.png)\)")


def programs(page):
    """The pieces of a page's program, each with what it prints."""
    return [(cell["code"], cell["said"] or "") for cell in CELL.finditer(page.read_text(encoding="utf-8"))]


def run(page, folder):
    """What the pieces of a page print, in their order; their pictures are then in the folder."""
    names, printed, before = {"__name__": "__main__"}, [], Path.cwd()
    os.chdir(folder)
    try:
        for number, (code, _) in enumerate(programs(page), 1):
            said = io.StringIO()
            with contextlib.redirect_stdout(said):
                exec(compile(code, f"{page.name}, program {number}", "exec"), names)  # as in a notebook
            printed.append(said.getvalue())
    finally:
        os.chdir(before)
    return printed


def renew(page):
    with tempfile.TemporaryDirectory() as folder:
        printed = iter(run(page, folder))
        text = page.read_text(encoding="utf-8")
        for name in PICTURE.findall(text):
            IMAGES.mkdir(exist_ok=True)
            if (Path(folder) / name).is_file():
                shutil.copy(Path(folder) / name, IMAGES / name)
    page.write_text(CELL.sub(lambda cell: shown(cell["code"], next(printed)), text), encoding="utf-8")


def shown(code, said):
    return f"```python\n{code}```\n" + (f"\n```text\n{said}```\n" if said else "")


def notebook(page):
    """A page as a notebook: programs are cells that can be run, without what they printed."""

    def cell(kind, source):
        more = {"execution_count": None, "outputs": []} if kind == "code" else {}
        return {"cell_type": kind, "metadata": {}, "source": source.strip(), **more}

    text = PICTURE.sub(r"(\1)", page.read_text(encoding="utf-8"))  # beside the notebook, where its programs save them
    cells, end = [], 0
    for found in CELL.finditer(text):
        cells += [cell("markdown", text[end : found.start()]), cell("code", found["code"])]
        end = found.end()
    cells.append(cell("markdown", text[end:]))
    return {"cells": [one for one in cells if one["source"]], "metadata": {}, "nbformat": 4, "nbformat_minor": 4}


def main(arguments):
    os.environ.setdefault("MPLBACKEND", "Agg")
    if arguments[:1] == ["--notebooks"]:
        for page in TUTORIALS.glob("*.md"):
            (Path(arguments[1]) / f"{page.stem}.ipynb").write_text(
                json.dumps(notebook(page), indent=1), encoding="utf-8"
            )
        return
    for name in arguments or sorted(page.stem for page in TUTORIALS.glob("*.md")):
        renew(TUTORIALS / f"{name}.md")
        print(f"{name}: renewed")


if __name__ == "__main__":
    main(sys.argv[1:])
