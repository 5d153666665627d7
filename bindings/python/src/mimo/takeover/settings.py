"""How others draw with rays, and what their pictures have in common."""

from __future__ import annotations

from typing import Any, Dict, NamedTuple, Tuple

import numpy as np
from numpy.typing import NDArray

from ..renderer import Renderer

RGB, DEPTH, SEGMENTATION = "rgb", "depth", "segmentation"


class Settings(NamedTuple):
    """Settings of the renderers that are made."""

    samples: int = 1
    threads: int = 1

    def renderer(self, model: Any, height: int, width: int) -> Renderer:
        """A renderer with these."""
        return Renderer(model, height, width, samples=self.samples, threads=self.threads)


_classes: Dict[Tuple[Any, Any], Any] = {}


def with_rays(drawing: Any, kind: Any) -> Any:
    """A class of another package, or one that somebody derived from it, whose instances draw as the first one says.

    An instance becomes one of it while it is made. So it stays what it is when OpenGL is given back.
    """
    made = _classes.get((drawing, kind))
    if made is None:
        made = _classes[drawing, kind] = type(kind.__name__, (drawing, kind), {"__module__": kind.__module__})
    return made


def draw(renderer: Renderer, kind: str) -> NDArray[Any]:
    """A picture of the updated scene."""
    renderer.disable_depth_rendering()
    renderer.disable_segmentation_rendering()
    if kind == DEPTH:
        renderer.enable_depth_rendering()
    elif kind == SEGMENTATION:
        renderer.enable_segmentation_rendering()
    return renderer.render()


def window_depth(model: Any, metres: NDArray[np.float32]) -> NDArray[np.float32]:
    """Depth as OpenGL keeps it: 0 at the near plane, 1 at the far plane, hyperbolic between."""
    near, far = (float(plane) * model.stat.extent for plane in (model.vis.map.znear, model.vis.map.zfar))
    depth: Any = far / (far - near) * (1 - near / np.maximum(metres.astype(np.float64), near))
    window: NDArray[np.float32] = np.clip(depth, 0, 1).astype(np.float32)
    return window


def aim(mujoco: Any, camera: Any, camera_id: Any) -> None:
    """Lets a mujoco.MjvCamera be the model's of this number, or for -1 the free one."""
    if camera_id is not None:
        kinds = mujoco.mjtCamera
        camera.type = int(kinds.mjCAMERA_FREE if camera_id == -1 else kinds.mjCAMERA_FIXED)
        camera.fixedcamid = camera_id
