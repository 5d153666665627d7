"""The classes of other packages that draw with OpenGL, and what draws with rays in their place."""

from __future__ import annotations

from typing import Any, Callable, Dict, Tuple

from . import dm_control, gymnasium, robosuite
from .settings import Settings

Takeover = Tuple[Any, Any]  # a class, and the __init__ that makes its instances draw with rays

# By the module that has the class.
MODULES: Dict[str, Callable[[Any, Settings], Takeover]] = {
    "gymnasium.envs.mujoco.mujoco_rendering": gymnasium.takeover,
    "dm_control.mujoco.engine": dm_control.takeover,
    "robosuite.utils.binding_utils": robosuite.takeover,
}
