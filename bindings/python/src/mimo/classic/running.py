"""Runs a script for the original: with this package's modules under the original's names."""

from __future__ import annotations

import os
import runpy
import sys
from typing import List

from .._library import version
from . import old_gym
from .checking import Findings, examine
from .children import children_too
from .modules import install


def source_of(script: str) -> str:
    """The text of a script, which must be Python."""
    if not os.path.isfile(script):
        raise FileNotFoundError(f"there is no script {script}")
    with open(script, encoding="utf-8") as file:
        source = file.read()
    compile(source, script, "exec")
    return source


def check(script: str, source: str) -> int:
    """Prints what a script uses and what is missing; 1 if anything is."""
    found = examine(source, script)
    print("\n".join(found.report()))
    return 1 if found.missing else 0


def run(script: str, arguments: List[str], source: str) -> int:
    """Runs a script as `python script.py` would."""
    found = examine(source, script)
    old_gym.FOUR_RESULTS = not found.five_results
    install()
    children_too()
    print(line_of(script, found), file=sys.stderr, flush=True)
    sys.argv = [script, *arguments]
    sys.path[0] = os.path.dirname(os.path.abspath(script))
    runpy.run_path(script, run_name="__main__")
    return 0


def line_of(script: str, found: Findings) -> str:
    """What runs on what, and what is not there, in one line."""
    import gymnasium

    on = f"{', '.join(found.modules) or 'no module of the original'} on libmimo {version()}"
    missing = "; ".join(f"line {line}: {name}" for line, name in found.missing)
    lacks = f"not there: {missing}" if missing else "nothing is missing that can be seen without running it"
    return f"mimo.classic: {os.path.basename(script)}: {on}, Gymnasium {gymnasium.__version__}; {lacks}"
