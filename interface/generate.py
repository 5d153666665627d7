#!/usr/bin/env python3
"""generate.py [--check] [TARGET...]: renews interface.json and all files that are made of it, or only some targets'.

A target is a module of targets/ with a function files(api), which gives the text of each of its files. With --check
nothing is written: says which files are not what they should be, and fails if there are any.
"""

from __future__ import annotations

import argparse
import importlib
import json
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent
sys.path.insert(0, str(HERE))

import api  # noqa: E402
import describe  # noqa: E402

LAST = "bindings_page"  # reads what the others made


def targets():
    return sorted(path.stem for path in (HERE / "targets").glob("*.py") if not path.stem.startswith("_"))


def made(names):
    """The text of interface.json and of all files of the targets, by their paths, and what targets complain of."""
    text = describe.text()
    files, complaints = {"interface/interface.json": text}, []
    interface = api.from_data(json.loads(text))
    interface.made = files
    for name in sorted(names, key=LAST.__eq__):
        try:
            files |= importlib.import_module(f"targets.{name}").files(interface)
        except describe.Undescribable as error:
            complaints.append(f"{name}: {error}")
    return files, complaints


def main():
    parser = argparse.ArgumentParser(description=__doc__.split(":")[1].split(".")[0].strip())
    parser.add_argument("--check", action="store_true", help="write nothing; fail where files differ")
    parser.add_argument("targets", nargs="*", metavar="TARGET", help=f"one of {', '.join(targets())}; none: all")
    arguments = parser.parse_args()
    for name in arguments.targets:
        if name not in targets():
            parser.error(f"there is no target {name}, only {', '.join(targets())}")
    try:
        files, complaints = made(arguments.targets or targets())
    except describe.Undescribable as error:
        sys.exit(f"interface: {error}")
    for name, text in files.items():
        path = ROOT / name
        if path.exists() and path.read_text(encoding="utf-8") == text:
            continue
        if arguments.check:
            complaints.append(f"{name} is not what interface/generate.py makes; run ./dev interface")
        else:
            path.write_text(text, encoding="utf-8")
            print(f"renewed {name}")
    sys.exit("\n".join(complaints) or None)


main()
