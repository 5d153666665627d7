"""Pictures of MuJoCo's models drawn with rays: mimo.Renderer, in the place of mujoco.Renderer."""

from __future__ import annotations

import logging
import os
from typing import Any, List, Mapping, Optional, Sequence, Set, Tuple, Union

import numpy as np
from numpy.typing import NDArray

from . import _abi
from ._handle import Closing
from .arguments import described, number_of
from .constants import Render
from .model_arrays import Snapshot, mujoco_of
from .model_stage import ModelStage
from .sight import Sight
from .stage import pixels, point_to

_logger = logging.getLogger("mimo")
EFFECTS = {
    "SHADOW": Render.SHADOWS,
    "REFLECTION": Render.REFLECTIONS,
    "SKYBOX": Render.SKY,
    "HAZE": Render.HAZE,
    "FOG": Render.FOG,
}
USUAL = int(Render.SHADOWS | Render.REFLECTIONS | Render.SKY | Render.HAZE)
OTHERS = {
    "WIREFRAME": False,
    "ADDITIVE": False,
    "CULL_FACE": True,
}  # flags of a scene that pictures do not follow, as they are
SAMPLES = (1, 4, 16, 64)
MOST_GEOMS = 10000
Camera = Any  # the id or name of a camera, -1 for the free one, or a mujoco.MjvCamera


def usable_cores() -> int:
    """As many threads as this process may run at the same time."""
    affinity: Any = getattr(os, "sched_getaffinity", None)
    return min(256, len(affinity(0)) if affinity is not None else os.cpu_count() or 1)


class Renderer(Closing):
    """Draws a mujoco.MjModel as mujoco.Renderer does, with rays on the CPU: no OpenGL, no display, no graphics card.

    It has the same methods, arrays and errors: `mimo.Renderer` can stand where `mujoco.Renderer` stood. It works with
    the models of MuJoCo 2.3 to 4. Pictures may be larger than MuJoCo's frame buffer. It tells the logger "mimo" once
    what it does not draw, by name.

    `samples` rays per pixel (1, 4, 16 or 64) smooth the edges of colour pictures, for which MuJoCo has the model's
    `offsamples`. `threads` draw, 1 by default; 0 stands for as many as this process may run at the same time.
    """

    def __init__(
        self,
        model: Any,
        height: int = 240,
        width: int = 320,
        max_geom: Optional[int] = MOST_GEOMS,
        font_scale: Any = None,
        *,
        samples: int = 1,
        threads: int = 1,
    ) -> None:
        self._stage: Optional[ModelStage] = None
        self._mujoco = mujoco_of(model)
        self._height, self._width = pixels("height", height), pixels("width", width)
        self._max_geom = MOST_GEOMS if max_geom is None else number_of("max_geom", max_geom)
        if samples not in SAMPLES:
            raise ValueError(f"samples is {samples!r}, expected {', '.join(map(str, SAMPLES))}")
        self._samples = samples
        self._model = model
        self._told: Set[str] = set()
        self._stage = ModelStage(self._mujoco, model, number_of("threads", threads) or usable_cores(), self._tell)
        self._arrays = self._stage.arrays
        self._sights: List[Sight] = []
        self._snapshots: List[Snapshot] = []
        self._usual = self._mujoco.MjvOption()
        flags = self._mujoco.mjtRndFlag
        self._flags = {name: int(getattr(flags, f"mjRND_{name}")) for name in (*EFFECTS, *OTHERS)}
        self._scene: Any = None
        self._listed = 0
        self._updated: Any = None
        self._depth_rendering = self._segmentation_rendering = False

    @property
    def model(self) -> Any:
        """The model that it draws."""
        return self._model

    @property
    def height(self) -> int:
        """Height of the pictures, pixels."""
        return self._height

    @property
    def width(self) -> int:
        """Width of the pictures, pixels."""
        return self._width

    @property
    def scene(self) -> Any:
        """A mujoco.MjvScene: pictures follow its flags, and show the geoms that are added to it.

        As soon as a program has asked for it, update_scene fills it as mujoco.Renderer's does. Other changes of it have
        no effect.
        """
        if self._scene is None:
            self._scene = self._mujoco.MjvScene(self._model, self._max_geom)
            if self._updated is not None:
                self._fill_scene(*self._updated)
        return self._scene

    def enable_depth_rendering(self) -> None:
        """Lets render() give depth, m."""
        self._depth_rendering, self._segmentation_rendering = True, False

    def disable_depth_rendering(self) -> None:
        """Lets render() give colours again."""
        self._depth_rendering = False

    def enable_segmentation_rendering(self) -> None:
        """Lets render() give the id and type of the object in each pixel."""
        self._depth_rendering, self._segmentation_rendering = False, True

    def disable_segmentation_rendering(self) -> None:
        """Lets render() give colours again."""
        self._segmentation_rendering = False

    def update_scene(self, data: Any, camera: Camera = -1, scene_option: Any = None) -> None:
        """Takes over where everything is, and what changed in the model; render() draws that.

        `camera` is an id, a name, -1 (the free camera) or a mujoco.MjvCamera; `scene_option` is a mujoco.MjvOption.
        """
        stage, option = self._open("update_scene"), self._option(scene_option)
        sight, snapshot = self._sight(0), self._snapshot(0)
        sight.look(data, camera)
        stage.follow(option)
        self._frame(sight, option)
        self._take(snapshot, data, option, sight.camera)
        self._updated = (data, option, sight.camera)
        if self._scene is not None:
            self._fill_scene(*self._updated)

    def render(self, *, out: Optional[NDArray[Any]] = None) -> NDArray[Any]:
        """The picture, in `out` where that is given.

        Colours are height x width x 3 (uint8), depth is height x width (float32, m), and segmentation is
        height x width x 2 (int32: id and type of the object, -1 where there is none).
        """
        stage = self._open("render")
        if self._updated is None:
            raise RuntimeError("render cannot be called before update_scene.")
        sight, snapshot = self._sight(0), self._snapshot(0)
        if self._scene is not None:
            self._follow_scene()
        shape, kind = self._form()
        if out is not None and out.shape != shape:
            raise ValueError(
                f"Expected `out.shape == {shape}`. Got `out.shape={out.shape}` instead: (height, width) for depth, "
                "(height, width, 2) for segmentation, (height, width, 3) for colours."
            )
        fits = out is not None and out.dtype == kind and out.flags.c_contiguous and out.flags.writeable
        picture: NDArray[Any] = out if out is not None and fits else np.empty(shape, kind)
        self._aim(sight.struct, picture)
        stage.draw([snapshot.struct], [sight.struct])
        if out is None or out is picture:
            return picture
        np.copyto(out, picture, casting="unsafe")
        return out

    def render_batch(
        self,
        data: Sequence[Any],
        cameras: Union[Camera, Sequence[Camera]] = -1,
        scene_option: Any = None,
        out: Optional[NDArray[Any]] = None,
    ) -> NDArray[Any]:
        """Pictures of many mujoco.MjData of the model, from several cameras, at once on all of the renderer's threads.

        The array is len(data) x cameras x height x width x 3, or has the depth or segmentation of render() at its end.
        It needs no update_scene.
        """
        stage, option = self._open("render_batch"), self._option(scene_option)
        eyes = list(cameras) if isinstance(cameras, (list, tuple, range)) else [cameras]
        (size, kind), count = self._form(), len(data)
        shape = (count, len(eyes), *size)
        if out is None:
            out = np.empty(shape, kind)
        elif out.shape != shape or out.dtype != kind or not out.flags.c_contiguous:
            given = f"{out.dtype} of the shape {out.shape}"
            raise ValueError(f"out is {given}, expected {np.dtype(kind)} of the shape {shape}, without gaps")
        stage.follow(option)
        views: List[_abi.StageView] = []
        for i, one in enumerate(data):
            for j, camera in enumerate(eyes):
                sight = self._sight(1 + len(views))
                sight.look(one, camera)
                self._frame(sight, option)
                sight.struct.pose = i
                self._aim(sight.struct, out[i, j])
                views.append(sight.struct)
                if j == 0:
                    self._take(self._snapshot(1 + i), one, option, sight.camera)
        if views:
            stage.draw([self._snapshot(1 + i).struct for i in range(count)], views)
        return out

    def reload(self) -> None:
        """Takes over textures, meshes and skins that were changed in the model, as mjr_uploadTexture does for OpenGL.

        Each update_scene takes over colours, sizes, materials, lights and height fields by itself.
        """
        self._open("reload").reload()

    def close(self) -> None:
        """Frees the library's objects."""
        if self._stage is not None:
            self._stage.close()
            self._stage = None

    def _resize(self, height: int, width: int) -> None:
        """Draws pictures of another size from now on; the camera of the last update_scene stays."""
        height, width = pixels("height", height), pixels("width", width)
        if (height, width) != (self._height, self._width):
            self._height, self._width = height, width
            for sight in self._sights:
                sight.resize(height, width)

    def _open(self, name: str) -> ModelStage:
        if self._stage is None:
            raise RuntimeError(f"{name} cannot be called after close.")
        return self._stage

    def _tell(self, what: str) -> None:
        if what not in self._told:
            self._told.add(what)
            _logger.warning("mimo.Renderer does not draw %s", what)

    def _option(self, option: Any) -> Any:
        if option is None:
            return self._usual
        if not isinstance(option, self._mujoco.MjvOption):
            raise TypeError(f"scene_option is {described(option)}, expected a mujoco.MjvOption")
        return option

    def _sight(self, number: int) -> Sight:
        while len(self._sights) <= number:
            self._sights.append(Sight(self._mujoco, self._model, self._height, self._width, self._samples))
        return self._sights[number]

    def _snapshot(self, number: int) -> Snapshot:
        while len(self._snapshots) <= number:
            self._snapshots.append(Snapshot(self._mujoco, self._model, self._arrays, self._tell))
        return self._snapshots[number]

    def _form(self) -> Tuple[Tuple[int, ...], Any]:
        size = (self._height, self._width)
        if self._depth_rendering:
            return size, np.float32
        return ((*size, 2), np.int32) if self._segmentation_rendering else ((*size, 3), np.uint8)

    def _aim(self, view: _abi.StageView, picture: NDArray[Any]) -> None:
        if self._depth_rendering:
            point_to(view, None, picture)
        elif self._segmentation_rendering:
            point_to(view, None, None, picture)
        else:
            point_to(view, picture)

    def _frame(self, sight: Sight, option: Any) -> None:
        """What of everything a view shows."""
        view, hanging = sight.struct, self._decorations.hanging
        view.geom_groups, view.site_groups = bits(option.geomgroup), bits(option.sitegroup)
        tendons = self._decorations.flag(option, "TENDON") and not hanging
        view.tendon_groups = bits(option.tendongroup) if tendons else 0
        view.render = USUAL if self._model.vis.quality.shadowsize > 0 else USUAL & ~int(Render.SHADOWS)

    @property
    def _decorations(self) -> Any:
        return self._open("update_scene").decorations

    def _take(self, snapshot: Snapshot, data: Any, option: Any, camera: Any) -> None:
        snapshot.take(data)
        decorations = self._decorations
        snapshot.extras.show(decorations.list(data, option, camera) if decorations.wanted(option) else ())

    def _fill_scene(self, data: Any, option: Any, camera: Any) -> None:
        every = int(self._mujoco.mjtCatBit.mjCAT_ALL)
        self._mujoco.mjv_updateScene(self._model, data, option, None, camera, every, self._scene)
        self._listed = self._scene.ngeom

    def _follow_scene(self) -> None:
        """Takes over the scene's flags, and the geoms that were added to it."""
        flags = self._scene.flags.tolist()
        self._override({name: flags[number] for name, number in self._flags.items()})
        self._add(self._scene.geoms[self._listed : self._scene.ngeom])

    def _add(self, geoms: Sequence[Any]) -> None:
        """Shows geoms of an MjvScene besides those of the model."""
        self._snapshot(0).extras.add(geoms)

    def _override(self, flags: Mapping[str, Any]) -> None:
        """Follows flags of a scene, by their names in mjtRndFlag without mjRND_."""
        view, shadows = self._sight(0).struct, self._model.vis.quality.shadowsize > 0
        for name, on in flags.items():
            if name in EFFECTS and (name != "SHADOW" or shadows):
                view.render = view.render | EFFECTS[name] if on else view.render & ~int(EFFECTS[name])
            elif name in OTHERS and bool(on) != OTHERS[name]:
                self._tell(f"scenes with the flag {name.lower()} {'on' if on else 'off'}")


def bits(groups: Any) -> int:
    """Groups that are shown, as bits."""
    return sum(1 << i for i, shown in enumerate(groups.tolist()) if shown)
