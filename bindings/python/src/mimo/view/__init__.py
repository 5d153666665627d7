"""A viewer in the browser. Needs the extra [view].

    viewer = mimo.view.open("benchmark")      # a world of its own, which moves; in a notebook the page is shown
    viewer = mimo.view.open("run.h5")         # a recording
    viewer = mimo.view.open(env)              # yours: step it, and call viewer.show() after each step

On the command line: python -m mimo.view --scene benchmark --port 8080
"""

from __future__ import annotations

import os
import webbrowser
from typing import TYPE_CHECKING, Any, Union, cast

from ..display import has_display
from ..scene import Scene
from ..world import World
from .recorded import Recorded
from .source import Followed, Live, Source
from .viewer import LOCAL, Viewer

if TYPE_CHECKING:
    from ..env import Env  # which opens viewers

__all__ = ["Followed", "Live", "Recorded", "Source", "Viewer", "open"]

RECORDINGS = (".h5", ".hdf5")


def open(
    what: "Union[str, os.PathLike[str], Scene, World, Env, Source]" = "benchmark",
    *,
    port: int = 0,
    host: str = LOCAL,
    **options: Any,
) -> Viewer:
    """Opens a page at viewer.url, on a free port unless one is given.

    A file that ends with .h5 or .hdf5 is a recording; its option is `eyes`, their pixels. A scene gets a world that
    runs in a thread of its own until viewer.close(); options are those of mimo.World, and
    `seed`. A world or an environment stays yours.
    """
    world = getattr(what, "world", what)  # an environment's
    if isinstance(world, World) and not isinstance(what, Source):
        if options:
            raise TypeError(f"{', '.join(options)}: a world that is there takes no options")
        return Viewer(Followed(world), host, port)
    if isinstance(what, (str, os.PathLike)) and os.fspath(what).endswith(RECORDINGS):
        what = Recorded(what, **options)
    seed, task = options.pop("seed", 1), options.pop("task", "")
    source = what if isinstance(what, Source) else Live(cast("Union[str, Scene]", what), task, **options)
    viewer = Viewer(source, host, port, seed, task)
    viewer.run_beside()
    return viewer


def opened_for_people(env: "Env") -> Viewer:
    """What render_mode="human" opens: in the user's browser where there is a display, and says where it is."""
    viewer = open(env)
    print(f"The infant is at {viewer.url}")
    if has_display():
        webbrowser.open(viewer.url)
    return viewer
