"""dm_control's Camera, which physics.render makes for each picture."""

from __future__ import annotations

import sys
import weakref
from types import SimpleNamespace
from typing import Any, Optional, Tuple

from ..renderer import Renderer
from .settings import DEPTH, RGB, SEGMENTATION, Settings, draw, with_rays

NO_OPENGL = SimpleNamespace(mujoco=None)


class Drawing:
    """The method of a camera that needs OpenGL."""

    def render(
        self: Any,
        overlays: Any = (),
        depth: bool = False,
        segmentation: bool = False,
        scene_option: Any = None,
        render_flag_overrides: Any = None,
    ) -> Any:
        """A picture."""
        module = sys.modules["dm_control.mujoco.engine"]
        if overlays and (depth or segmentation):
            raise ValueError(module._OVERLAYS_NOT_SUPPORTED_FOR_DEPTH_OR_SEGMENTATION)
        if render_flag_overrides and (depth or segmentation):
            raise ValueError(module._RENDER_FLAG_OVERRIDES_NOT_SUPPORTED_FOR_DEPTH_OR_SEGMENTATION)
        if depth and segmentation:
            raise ValueError(module._BOTH_SEGMENTATION_AND_DEPTH_ENABLED)
        rays = self._rays()
        option = scene_option or self._scene_option
        rays.update_scene(self._physics.data.ptr, self._render_camera.ptr, option.ptr)
        if overlays:
            rays._tell("text over pictures")
        if self._scene_callback:
            self.update(scene_option)
            listed = self._scene.ngeom
            self._scene_callback(self._physics, self._scene)
            rays._add(list(self._scene.ptr.geoms[listed : self._scene.ptr.ngeom]))
        rays._override({flag_name(key): value for key, value in (render_flag_overrides or {}).items()})
        return draw(rays, DEPTH if depth else SEGMENTATION if segmentation else RGB)


def flag_name(key: Any) -> str:
    """The name of a flag, which dm_control takes as a word or as a member of mjtRndFlag."""
    return str(key if isinstance(key, str) else key.name.replace("mjRND_", "")).upper()


def takeover(module: Any, settings: Settings) -> Tuple[Any, Any]:
    """The camera's __init__."""
    begin = module.Camera.__init__
    renderers: Any = weakref.WeakKeyDictionary()  # of each physics, which makes a camera for each picture

    def __init__(self: Any, physics: Any, *arguments: Any, **options: Any) -> None:
        begin(self, SimpleNamespace(model=physics.model, data=physics.data, contexts=NO_OPENGL), *arguments, **options)
        self._physics = physics
        self._rays = lambda: rays_of(physics, self._height, self._width)
        self.__class__ = with_rays(Drawing, type(self))

    def rays_of(physics: Any, height: int, width: int) -> Renderer:
        model = physics.model.ptr
        renderer: Optional[Renderer] = renderers.get(physics)
        if renderer is None or renderer.model is not model:
            renderer = renderers[physics] = settings.renderer(model, height, width)
        renderer._resize(height, width)
        return renderer

    return module.Camera, __init__
