"""Scores of logs: python -m mimo.babybench.evaluate LOGS.

LOGS is a file, or a folder with training.pkl and evaluation_0.pkl, ..., or the folder of a run (its `save_dir`). Logs
of the competition's kit can be read; they lack the data for corrected scores.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path
from typing import Optional, Sequence

from .reports import report, scores_in


def main(arguments: Optional[Sequence[str]] = None) -> int:
    """Runs the command line."""
    parser = argparse.ArgumentParser(prog="python -m mimo.babybench.evaluate", description="Scores of BabyBench's logs")
    parser.add_argument("logs", metavar="LOGS", type=Path, help="a log, or a folder of logs")
    try:
        found = scores_in(parser.parse_args(arguments).logs)
    except (OSError, ValueError) as error:
        print(error, file=sys.stderr)
        return 1
    for name, scores in found.items():
        print(report(name, scores))
    return 0


if __name__ == "__main__":
    sys.exit(main())
