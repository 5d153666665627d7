"""The handle in the scene that pulls a body."""

from __future__ import annotations

from typing import Any, Callable

import numpy as np

from ..world import World
from .camera import ROOT
from .pull import Pull

NOTHING = "nothing"
Ask = Callable[[Callable[[], None]], None]


class PullHandle:
    """Three axes at a body that pull it by a spring; dragging the body with Ctrl does the same."""

    def __init__(self, server: Any, world: World, pull: Pull, ask: Ask) -> None:
        self._pull, self._ask, self._dragged = pull, ask, False
        gui = server.gui
        bodies = [name for name in world.bodies().names[1:] if name]
        self._choice = gui.add_dropdown(
            "pull at", [NOTHING, *bodies], initial_value=NOTHING, hint="or Ctrl and drag it"
        )
        self._hold = gui.add_checkbox("hold on", False, hint="keeps pulling when the handle is released")
        self._stiffness = gui.add_slider("spring (N/m)", min=20.0, max=2000.0, step=10.0, initial_value=pull.stiffness)
        self._axes = server.scene.add_transform_controls(f"{ROOT}/pull", 0.2, disable_rotations=True, visible=False)
        self._choice.on_update(self._chosen)
        self._hold.on_update(lambda event: ask(self._let_go))
        self._stiffness.on_update(lambda event: setattr(pull, "stiffness", float(event.target.value)))
        self._axes.on_update(self._moved)

    def _chosen(self, event: Any) -> None:
        if event.client is not None:
            self._ask(lambda: self._choose(event.target.value))

    def _choose(self, body: str) -> None:
        self._pull.choose(None if body == NOTHING else body)
        self._axes.visible = body != NOTHING
        self._choice.value = body

    def _let_go(self) -> None:
        if not self._hold.value and not self._dragged:
            self._pull.release()

    async def _moved(self, event: Any) -> None:  # async: handled in order
        place, ended = np.array(event.target.position), event.phase == "end"
        self._ask(lambda: self._drag(place, ended))

    def _drag(self, place: Any, ended: bool) -> None:
        self._dragged = not ended
        self._pull.to(place)
        if ended:
            self._let_go()

    def body_dragged(self, body: str, event: Any) -> None:
        """Handles dragging of a body."""
        offset, ended = np.subtract(event.end_position, event.start_position), event.phase == "end"
        self._ask(lambda: self._drag_body(body, offset, ended))

    def _drag_body(self, body: str, offset: Any, ended: bool) -> None:
        if self._pull.body != body:
            self._choose(body)
        self._drag(self._pull.position + offset, ended)

    def update(self) -> None:
        """Follows the body unless it is dragged."""
        if self._pull.body is not None and self._pull.target is None:
            self._axes.position = self._pull.position
