"""A viewer in the browser. Needs the extra [view].

    viewer = mimo.view.open("benchmark")      # a new world, which runs; a notebook shows the page
    viewer = mimo.view.open("run.h5")         # a recording
    viewer = mimo.view.open(env)              # your world: call viewer.show() after each step

On the command line: python -m mimo.view --scene benchmark --port 8080
"""

from __future__ import annotations

import os
import webbrowser
from typing import TYPE_CHECKING, Any, Union

from ..display import has_display
from ..recorded_world import inner_world
from ..scene import Scene
from ..world import World
from .recorded import Recorded
from .source import Followed, Live, Source
from .viewer import LOCAL, Viewer

if TYPE_CHECKING:
    from ..env import Env  # used to open viewers

__all__ = ["Followed", "Live", "Recorded", "Source", "Viewer", "open"]

RECORDINGS = (".h5", ".hdf5")


def open(
    what: "Union[str, os.PathLike[str], Scene, World, Env, Source]" = "benchmark",
    *,
    port: int = 0,
    host: str = LOCAL,
    **options: Any,
) -> Viewer:
    """Opens a page at viewer.url; the default is a free port.

    A file that ends with .h5 or .hdf5 is a recording; its options are `eyes`, their pixels, and `own_senses`. A scene
    gets a new world, which runs in a thread until viewer.close(); options are those of mimo.World, `seed`, and
    `own_senses`: shared libraries with senses of your own, whose code runs. A world or an environment takes no options:
    step it, and call viewer.show().
    """
    if isinstance(what, (str, os.PathLike)) and os.fspath(what).endswith(RECORDINGS):
        viewer = Viewer(Recorded(what, **options), host, port)
    elif isinstance(what, (str, Scene)):
        seed, task = options.pop("seed", 1), options.pop("task", "")
        viewer = Viewer(Live(what, task, **options), host, port, seed, task)
    elif options:
        raise TypeError(f"{', '.join(options)}: an existing world takes no options")
    elif isinstance(what, Source):
        viewer = Viewer(what, host, port)
    else:
        return Viewer(Followed(inner_world(what)), host, port)
    viewer.run_beside()
    return viewer


def opened_for_people(env: "Env") -> Viewer:
    """Opens the page of render_mode="human", in the browser if there is a display, and prints its address."""
    viewer = open(env)
    print(f"The infant is at {viewer.url}")
    if has_display():
        webbrowser.open(viewer.url)
    return viewer
