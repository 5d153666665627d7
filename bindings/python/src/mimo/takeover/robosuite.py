"""robosuite's render contexts."""

from __future__ import annotations

from typing import Any, Tuple

from .settings import DEPTH, RGB, SEGMENTATION, Settings, aim, draw, window_depth, with_rays


class Drawing:
    """The methods of a context that need OpenGL."""

    _rays: Any

    @property
    def scn(self) -> Any:
        """The scene."""
        return self._rays.scene

    def update_offscreen_size(self, width: int, height: int) -> None:
        """Rays have no frame buffer."""

    def render(self: Any, width: int, height: int, camera_id: Any = None, segmentation: bool = False) -> None:
        """Takes over where everything is; read_pixels draws it."""
        aim(self._mujoco, self.cam, camera_id)
        self._rays._resize(height, width)
        self._rays.update_scene(self.data._data, self.cam, self.vopt)

    def read_pixels(self, width: int, height: int, depth: bool = False, segmentation: bool = False) -> Any:
        """The picture as OpenGL gives it: rows from the bottom; of objects the type comes before the id."""
        rays = self._rays
        rays._resize(height, width)
        shown = draw(rays, SEGMENTATION)[::-1, :, ::-1] if segmentation else draw(rays, RGB)[::-1]
        return (shown, window_depth(rays.model, draw(rays, DEPTH))[::-1]) if depth else shown

    def upload_texture(self, tex_id: int) -> None:
        """Takes over textures that were changed."""
        self._rays.reload()

    def __del__(self) -> None:
        """Nothing of OpenGL is to be freed."""


def takeover(module: Any, settings: Settings) -> Tuple[Any, Any]:
    """The context's __init__."""
    mujoco = module.mujoco

    def __init__(
        self: Any, sim: Any, offscreen: bool = True, device_id: int = -1, max_width: int = 640, max_height: int = 480
    ) -> None:
        self.__class__ = with_rays(Drawing, type(self))
        self._mujoco, self.sim, self.offscreen, self.device_id = mujoco, sim, offscreen, device_id
        sim.forward()
        sim.add_render_context(self)
        self.model, self.data = sim.model, sim.data
        self.cam, self.vopt, self.pert = mujoco.MjvCamera(), mujoco.MjvOption(), mujoco.MjvPerturb()
        self.cam.fixedcamid, self.cam.type = 0, int(mujoco.mjtCamera.mjCAMERA_FIXED)
        self._rays = settings.renderer(sim.model._model, max_height, max_width)

    return module.MjRenderContext, __init__
