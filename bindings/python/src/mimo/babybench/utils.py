"""Functions that scripts import from the competition's module of this name."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from .baselines import to_grayscale
from .making import make as make_env

__all__ = ["make_env", "render", "to_grayscale", "view_binocular"]


def render(env: Any, camera: str = "corner") -> NDArray[np.uint8]:
    """A picture from one of the scene's cameras: corner, top, side1, side2, closeup, eye_left, eye_right."""
    picture: NDArray[np.uint8] = env.unwrapped.mujoco_renderer.render("rgb_array", camera_name=camera)
    return picture


def view_binocular(env: Any) -> NDArray[np.uint8]:
    """Both eyes' pictures in one: brightness of the left in red, of the right in green and blue."""
    left, right = (to_grayscale(render(env, f"eye_{side}")).astype(np.uint8) for side in ("left", "right"))
    return np.stack([left, right, right], axis=-1)
