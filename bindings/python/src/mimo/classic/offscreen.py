"""`mujoco.Renderer` on our models."""

from __future__ import annotations

from typing import Any, Dict, Optional

from .._handle import Closing
from ..constants import Kind
from .model import ModelView


def renderer_for(theirs: Optional[Any]) -> Any:
    """Makes a renderer of a model: ours, or MuJoCo's own."""

    def make(model: Any, *arguments: Any, **named: Any) -> Any:
        if isinstance(model, ModelView):
            return Renderer(model, *arguments, **named)
        if theirs is None:
            raise TypeError("mujoco.Renderer: expected env.model; the package mujoco is not installed")
        return theirs(model, *arguments, **named)

    return make


class Renderer(Closing):
    """Pictures of the world of a model."""

    def __init__(self, model: ModelView, height: int = 240, width: int = 320, max_geom: int = 10000) -> None:
        self.model, self.height, self.width = model, height, width
        self._view: Dict[str, Any] = {}
        self._kind = "rgb"

    def update_scene(self, data: Any, camera: Any = -1, scene_option: Any = None) -> None:
        """Chooses the camera: its name, its number, or an MjvCamera."""
        if isinstance(camera, str):
            self._view = {"camera": camera}
        elif isinstance(camera, int) or getattr(camera, "type", 0) == 2:
            number = camera if isinstance(camera, int) else camera.fixedcamid
            self._view = {"camera": self.model._world.name(Kind.CAMERA, number)} if number >= 0 else {}
        else:
            names = {"lookat": "look_at", "distance": "distance", "azimuth": "azimuth", "elevation": "elevation"}
            self._view = {ours: getattr(camera, theirs) for theirs, ours in names.items()}

    def render(self, *, out: Any = None) -> Any:
        """The picture: height x width x 3, or depths in m."""
        size = {"height": self.height, "width": self.width}
        world = self.model._world
        if self._kind == "segmentation":
            picture = world.draw(**size, **self._view).segmentation
        else:
            picture = (world.depth if self._kind == "depth" else world.render)(**size, **self._view)
        if out is None:
            return picture
        out[...] = picture
        return out

    def enable_depth_rendering(self) -> None:
        """Pictures are depths from now on."""
        self._kind = "depth"

    def disable_depth_rendering(self) -> None:
        """Pictures are colours again."""
        self._kind = "rgb"

    def enable_segmentation_rendering(self) -> None:
        """Pictures are numbers of geoms from now on."""
        self._kind = "segmentation"

    def disable_segmentation_rendering(self) -> None:
        """Pictures are colours again."""
        self._kind = "rgb"

    def close(self) -> None:
        """Does nothing."""
