"""`mujoco.viewer` on our models: a window that shows the world."""

from __future__ import annotations

from contextlib import contextmanager
from types import ModuleType
from typing import Any, Iterator, Optional

from .._handle import Closing
from .live import PAGE
from .mathematics import MjvCamera, MjvOption
from .model import DataView, ModelView

SIZE = {"width": 640, "height": 480}


class Viewer(Closing):
    """A window as launch_passive returns it: sync() shows the current state."""

    def __init__(self, model: ModelView, data: DataView) -> None:
        from ..plot import Window  # only windows need matplotlib

        self._world: Any = data._world
        self._window: Any = Window("MIMo")
        self.cam, self.opt = MjvCamera(), MjvOption()
        self._standard = vars(MjvCamera()).copy()

    def sync(self) -> None:
        """Shows the current state."""
        self._window.show(self._world.render(**SIZE, **self._view()))

    def _view(self) -> Any:
        now = vars(self.cam)
        if all(
            (now[name] == value) if name != "lookat" else not now[name].any() for name, value in self._standard.items()
        ):
            return {}
        names = {"lookat": "look_at", "distance": "distance", "azimuth": "azimuth", "elevation": "elevation"}
        return {ours: now[theirs] for theirs, ours in names.items()}

    def is_running(self) -> bool:
        """Whether the window is open."""
        return bool(self._window.is_open)

    def close(self) -> None:
        """Closes the window."""
        self._window.close()

    @contextmanager
    def lock(self) -> Iterator[None]:
        """Does nothing: nobody else draws."""
        yield


def viewer_module(real: Optional[ModuleType]) -> ModuleType:
    """The module `mujoco.viewer`: ours for our models, MuJoCo's own for its own."""
    module = ModuleType("mujoco.viewer", "Windows for models of mimo.classic.")

    def launch_passive(model: Any, data: Any, *arguments: Any, **options: Any) -> Any:
        if isinstance(model, ModelView):
            return Viewer(model, data)
        return _theirs(real, "launch_passive")(model, data, *arguments, **options)

    def launch(model: Any = None, data: Any = None, **options: Any) -> Any:
        if not isinstance(model, ModelView):
            return _theirs(real, "launch")(model, data, **options)
        raise NotImplementedError(
            f"mujoco.viewer.launch is not there: mimo.view.open(env.world) opens a viewer; {PAGE}"
        )

    module.__dict__.update(launch_passive=launch_passive, launch=launch)
    return module


def _theirs(real: Optional[ModuleType], name: str) -> Any:
    if real is None:
        raise TypeError(f"mujoco.viewer.{name}: expected env.model; the package mujoco is not installed")
    return getattr(real, name)
