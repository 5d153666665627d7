"""Runs a script for the original, or for the competition's kit, as it is: python -m mimo.classic script.py."""

from __future__ import annotations

import argparse
import sys
from typing import List, Optional


def main(arguments: Optional[List[str]] = None) -> int:
    """Runs or checks a script."""
    given = argparse.ArgumentParser(
        prog="python -m mimo.classic",
        description="Runs a script for the original MIMo (mimoEnv, mimo_infant) or for BabyBench's kit, as it is.",
    )
    given.add_argument("--check", action="store_true", help="do not run it; list the members it uses, and missing ones")
    given.add_argument("script", help="the script")
    given.add_argument("arguments", nargs=argparse.REMAINDER, help="its arguments")
    asked = given.parse_args(arguments)
    from . import running

    try:
        source = running.source_of(asked.script)
    except (OSError, SyntaxError, ValueError) as error:
        print(f"python -m mimo.classic: {error}", file=sys.stderr)
        return 2
    if asked.check:
        return running.check(asked.script, source)
    return running.run(asked.script, asked.arguments, source)


if __name__ == "__main__":
    sys.exit(main())
