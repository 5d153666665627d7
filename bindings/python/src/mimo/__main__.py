"""Runs the program `mimo` inside this package."""

from __future__ import annotations

import os
import subprocess
import sys

from ._library import native_file


def main() -> None:
    """Replaces this process by the program; on Windows it waits for it instead."""
    if sys.platform == "win32":
        sys.exit(subprocess.call([str(native_file("mimo.exe")), *sys.argv[1:]]))
    os.execv(str(native_file("mimo")), ["mimo", *sys.argv[1:]])


if __name__ == "__main__":
    main()
