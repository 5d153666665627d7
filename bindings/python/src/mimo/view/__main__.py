"""The viewer on the command line: python -m mimo.view --scene S --port P."""

from __future__ import annotations

import argparse
import signal
import sys
from typing import Any, List, Optional

from ..drawing import EYES
from ..errors import Error
from ..recordings import add_sense_option
from ..scene import scenes, tasks
from .recorded import Recorded
from .source import Live
from .viewer import LOCAL, Viewer


def arguments(given: Optional[List[str]] = None) -> argparse.Namespace:
    """The arguments of the command line."""
    parser = argparse.ArgumentParser(prog="python -m mimo.view", description="Shows an infant in the browser.")
    parser.add_argument("--scene", help=f"one of {', '.join(scenes())} (benchmark)")
    parser.add_argument(
        "--recording",
        metavar="FILE.h5",
        help="plays this recording, with its scene, task, age and actions",
    )
    parser.add_argument("--task", default="", help=f"one of {', '.join(tasks())}")
    parser.add_argument("--seed", type=int, default=1, help="seed of the first episode (1)")
    parser.add_argument("--age", type=float, help="of the infants, months")
    add_sense_option(parser)
    parser.add_argument("--eyes", type=int, default=EYES, help=f"pixels of each eye, across and down ({EYES}); 0: none")
    parser.add_argument("--port", type=int, default=8080, help="port of the page (8080); 0: a free one")
    parser.add_argument("--host", default=LOCAL, help=f"address to listen at ({LOCAL}: from this machine only)")
    parser.add_argument("--paused", action="store_true", help="starts paused")
    return parser.parse_args(given)


def made(asked: argparse.Namespace) -> Viewer:
    """The requested viewer."""
    if asked.recording is not None:
        viewer = Viewer(Recorded(asked.recording, asked.eyes, asked.scene, asked.sense), asked.host, asked.port)
        viewer.clock.paused = asked.paused
        return viewer
    source = Live.asked(asked.scene, asked.eyes, asked.age, asked.task, asked.sense)
    viewer = Viewer(source, asked.host, asked.port, asked.seed, asked.task)
    viewer.clock.paused = asked.paused
    return viewer


def _stop(*_: Any) -> None:
    raise KeyboardInterrupt


def main() -> int:
    """Serves the page until it is interrupted."""
    asked = arguments()
    signal.signal(signal.SIGTERM, _stop)
    try:
        viewer = made(asked)
    except (Error, OSError, ValueError) as error:
        print(f"python -m mimo.view: {error}", file=sys.stderr)
        return 1
    print(f"The infant is at {viewer.url}; Ctrl-C ends it", flush=True)
    try:
        viewer.run()
    except KeyboardInterrupt:
        pass
    finally:
        viewer.close()
    return 0


if __name__ == "__main__":
    sys.exit(main())
