"""Runs a script for the original: with this package's modules under the original's names."""

from __future__ import annotations

import os
import runpy
import sys
from pathlib import Path
from typing import List

from .._library import version
from . import old_gym
from .checking import Findings, examine
from .children import children_too
from .live import PAGE
from .modules import install
from .names import ROOTS, folders, is_ours

LEVELS = 4  # folders above a script that may be such a checkout


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
    _look_around(script)
    found = examine(source, script)
    print("\n".join(found.report()))
    return 1 if found.missing else 0


def run(script: str, arguments: List[str], source: str) -> int:
    """Runs a script as `python script.py` would."""
    _look_around(script)
    found = examine(source, script)
    old_gym.FOUR_RESULTS = not found.five_results
    install()
    children_too()
    print(line_of(script, found), file=sys.stderr, flush=True)
    sys.argv = [script, *arguments]
    try:
        runpy.run_path(script, run_name="__main__")
    except ImportError as error:
        if error.name is None or not is_ours(error.name):
            raise
        raise ImportError(f"{error.msg}; {PAGE}", name=error.name, path=error.path) from error
    return 0


def _look_around(script: str) -> None:
    """Lets imports find what `python script.py` would, and the packages of a checkout around it."""
    sys.path[0] = os.path.dirname(os.path.abspath(script))
    sys.path += checkouts(script)


def checkouts(script: str) -> List[str]:
    """Folders around a script with packages of the original, which is installed from such a folder."""
    around = [*list(Path(script).resolve().parents)[:LEVELS], Path.cwd()]
    places = [place for folder in around for place in (folder, folder / "MIMo")]
    found = [str(place) for place in places if any((place / root / "__init__.py").is_file() for root in ROOTS)]
    return [place for place in dict.fromkeys(found) if place not in sys.path]


def line_of(script: str, found: Findings) -> str:
    """What runs on what, and what is not there, in one line."""
    import gymnasium

    places = [place for root in found.modules if root in ROOTS for place in folders(root)]
    instead = f" (in place of {', '.join(places)}, except modules that only these have)" if places else ""
    on = f"{', '.join(found.modules) or 'no module of the original'}{instead} on libmimo {version()}"
    missing = "; ".join(f"line {line}: {name}" for line, name in found.missing)
    lacks = f"not there: {missing}" if missing else "nothing is missing that can be seen without running it"
    return f"mimo.classic: {os.path.basename(script)}: {on}, Gymnasium {gymnasium.__version__}; {lacks}"
