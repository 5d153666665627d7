"""Lets environments of MuJoCo draw with rays instead of OpenGL: those of Gymnasium, dm_control and robosuite.

import mimo.gymnasium

mimo.gymnasium.use_rays()
env = gymnasium.make("Humanoid-v5", render_mode="rgb_array")
"""

from __future__ import annotations

import sys
from types import TracebackType
from typing import Any, Callable, List, Optional, Tuple, Type

from .importing import wait_no_longer, when_imported
from .takeover import MODULES
from .takeover.settings import Settings

_active: List[Rays] = []


class Rays:
    """What use_rays() changed. `undo()`, or the end of a with block, gives OpenGL back."""

    def __init__(self, settings: Settings) -> None:
        self._before: List[Tuple[Any, Any]] = []
        self._actions = {module: self._action(module, made, settings) for module, made in MODULES.items()}

    def _action(self, module: str, made: Any, settings: Settings) -> Callable[[], None]:
        def take_over() -> None:
            kind, begin = made(sys.modules[module], settings)
            self._before.append((kind, kind.__init__))
            kind.__init__ = begin

        return take_over

    def _begin(self) -> None:
        for module, action in self._actions.items():
            when_imported(module, action)

    def undo(self) -> None:
        """Lets environments that are made from now on draw with OpenGL again. Undoing twice does nothing."""
        for module, action in self._actions.items():
            wait_no_longer(module, action)
        while self._before:
            kind, begin = self._before.pop()
            kind.__init__ = begin
        if self in _active:
            _active.remove(self)

    def __enter__(self) -> Rays:
        return self

    def __exit__(
        self, kind: Optional[Type[BaseException]], error: Optional[BaseException], trace: Optional[TracebackType]
    ) -> None:
        self.undo()


def use_rays(*, samples: int = 1, threads: int = 1) -> Rays:
    """Draws by mimo.Renderer from now on, whatever was imported before and will be imported later.

    That concerns render_mode "rgb_array", "depth_array" and "rgbd_tuple" of Gymnasium's MuJoCo environments and of all
    that use their renderer (gymnasium_robotics, metaworld), `physics.render` of dm_control, and the cameras and the
    offscreen pictures of robosuite. What draws already goes on as it began. A second call takes the place of the first.
    `samples` and `threads` are those of mimo.Renderer.
    """
    settings = Settings(samples, threads)
    while _active:
        _active[-1].undo()
    rays = Rays(settings)
    _active.append(rays)
    rays._begin()
    return rays


def use_opengl() -> None:
    """Undoes use_rays()."""
    while _active:
        _active[-1].undo()
