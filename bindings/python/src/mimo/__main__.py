"""The program `mimo`: the one inside this package."""

from __future__ import annotations

import os
import sys

from ._library import NATIVE


def main() -> None:
    """Becomes the program."""
    program = NATIVE / "mimo"
    os.execv(str(program), ["mimo", *sys.argv[1:]])


if __name__ == "__main__":
    main()
