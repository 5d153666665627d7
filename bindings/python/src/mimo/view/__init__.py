"""A viewer in the browser. Needs the extra [view].

    viewer = mimo.view.open("benchmark")      # a world of its own, which moves; in a notebook the page is shown
    viewer = mimo.view.open(env)              # yours: step it, and call viewer.show() after each step

On the command line: python -m mimo.view --scene benchmark --port 8080
"""

from __future__ import annotations

from typing import Any, Union

from ..env import Env
from ..scene import Scene
from ..world import World
from .source import Followed, Live, Source
from .viewer import LOCAL, Viewer

__all__ = ["Followed", "Live", "Source", "Viewer", "open"]


def open(
    what: Union[str, Scene, World, Env, Source] = "benchmark", *, port: int = 0, host: str = LOCAL, **options: Any
) -> Viewer:
    """Opens a page at viewer.url, on a free port unless one is given.

    A scene gets a world that runs in a thread of its own until viewer.close(); options are those of mimo.World, and
    `seed`. A world or an environment stays yours.
    """
    if isinstance(what, (World, Env)):
        if options:
            raise TypeError(f"{', '.join(options)}: a world that is there takes no options")
        return Viewer(Followed(what if isinstance(what, World) else what.world), host, port)
    seed, task = options.pop("seed", 1), options.pop("task", "")
    viewer = Viewer(what if isinstance(what, Source) else Live(what, task, **options), host, port, seed, task)
    viewer.run_beside()
    return viewer
