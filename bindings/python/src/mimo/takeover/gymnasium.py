"""Gymnasium's OffScreenViewer."""

from __future__ import annotations

from typing import Any, Optional, Tuple

import numpy as np

from .settings import DEPTH, RGB, SEGMENTATION, Settings, aim, draw, window_depth, with_rays


class Drawing:
    """The methods of a viewer that need OpenGL."""

    _rays: Any
    model: Any

    @property
    def scn(self) -> Any:
        """The scene, to which markers are added."""
        return self._rays.scene

    def render(self: Any, render_mode: Optional[str], camera_id: Any = None, segmentation: bool = False) -> Any:
        """A picture, or a picture and its depth."""
        aim(self._mujoco, self.cam, camera_id)
        self._rays.update_scene(self.data, self.cam, self.vopt)
        for marker in self._markers:
            self._add_marker_to_scene(marker)
        self._markers.clear()
        if self._overlays:
            self._rays._tell("text over pictures")
        depth = None if render_mode == "rgb_array" else window_depth(self.model, draw(self._rays, DEPTH))
        if render_mode == "depth_array":
            return depth
        colors = draw(self._rays, SEGMENTATION)[..., ::-1] if segmentation else draw(self._rays, RGB)
        return colors if render_mode == "rgb_array" else (colors, depth)

    def make_context_current(self) -> None:
        """Rays have no context."""

    def free(self) -> None:
        """Frees what draws."""
        self._rays.close()

    close = free

    def __del__(self) -> None:
        """Nothing of OpenGL is to be freed."""


def takeover(module: Any, settings: Settings) -> Tuple[Any, Any]:
    """The viewer's __init__."""
    mujoco = module.mujoco

    def __init__(
        self: Any,
        model: Any,
        data: Any,
        width: Optional[int] = None,
        height: Optional[int] = None,
        max_geom: int = 1000,
        visual_options: Any = None,
    ) -> None:
        self.__class__ = with_rays(Drawing, type(self))
        self._mujoco, self.model, self.data = mujoco, model, data
        width = model.vis.global_.offwidth if width is None else width
        height = model.vis.global_.offheight if height is None else height
        self.viewport = mujoco.MjrRect(0, 0, width, height)
        self._markers, self._overlays = [], {}
        self.cam, self.vopt, self.pert = mujoco.MjvCamera(), mujoco.MjvOption(), mujoco.MjvPerturb()
        for flag, value in (visual_options or {}).items():
            self.vopt.flags[flag] = value
        self._rays = settings.renderer(model, height, width)
        aim(mujoco, self.cam, -1)
        self.cam.lookat[:] = np.median(data.geom_xpos, axis=0)
        self.cam.distance = model.stat.extent

    return module.OffScreenViewer, __init__
