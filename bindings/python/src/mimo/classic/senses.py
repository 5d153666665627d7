"""The original's dictionary of observations, made of the library's fields."""

from __future__ import annotations

from typing import Any, Dict, List, Optional, Sequence, Tuple

import numpy as np
from gymnasium import spaces
from numpy.typing import NDArray

from ..layout import Observation
from ..world import World
from .params import PARTS, Senses
from .skin import Touch, force_field

Picked = Optional[NDArray[np.intp]]


class Observer:
    """Combines fields as the original does: `observation` in its order, `touch`, `vestibular`, one key per camera.

    `torque_sensors` are the sensors with torques, if the original's scene has fewer than the body; None: all. `extra`
    names additional fields at the end of `observation`.
    """

    def __init__(
        self,
        world: World,
        senses: Senses,
        torque_sensors: Optional[Sequence[str]] = None,
        extra: Sequence[str] = (),
    ) -> None:
        fields = world.layout.fields
        self._parts = [f"proprioception/{name}" for part in senses.parts for name in PARTS[part]]
        self._parts = [*(name for name in self._parts if name in fields), *extra]
        self._torques = _picked(fields, torque_sensors)
        self._vestibular = [f"vestibular/{name}" for name in senses.vestibular]
        self._cameras = list(senses.cameras)
        self.touch = Touch(world, force_field(fields)) if force_field(fields) else None
        block = world.layout.new_block()
        block[...] = 0
        self.boxes = self._boxes(world.layout.views(block))

    def see(self, views: Observation, worlds: int = 0) -> Dict[str, NDArray[Any]]:
        """The dictionary, with new arrays; `worlds` is the length of their first axis."""
        lead = (worlds,) if worlds else ()
        seen: Dict[str, NDArray[Any]] = {"observation": self._row(views, lead)}
        if self.touch is not None:
            seen["touch"] = self.touch.row(views, lead)
        for name in self._cameras:
            seen[name] = views[f"vision/{name}"].copy()
        if self._vestibular:
            parts = [views[name] for name in self._vestibular]
            seen["vestibular"] = np.concatenate(parts, axis=-1, dtype=np.float64)
        return seen

    def _row(self, views: Observation, lead: Tuple[int, ...]) -> NDArray[np.float64]:
        rows: List[NDArray[Any]] = []
        for name in self._parts:
            values = views[name].reshape((*lead, -1))
            picks = self._torques if name == "proprioception/torque" else None
            rows.append(values if picks is None else values[..., picks])
        return np.concatenate(rows, axis=-1, dtype=np.float64)

    def _boxes(self, views: Observation) -> Dict[str, spaces.Box]:
        """Unbounded spaces, as in the original; pictures are 0 to 255."""
        boxes = {}
        for name, array in self.see(views).items():
            low, high = (0.0, 255.0) if array.dtype == np.uint8 else (-np.inf, np.inf)
            boxes[name] = spaces.Box(low, high, array.shape, array.dtype.type)
        return boxes


def _picked(fields: Any, sensors: Optional[Sequence[str]]) -> Picked:
    """Indices of the components of torque sensors in the flattened field."""
    field = fields.get("proprioception/torque")
    if sensors is None or field is None:
        return None
    places = {label: place for place, label in enumerate(field.labels)}
    return np.array([places[f"{sensor}/{axis}"] for sensor in sensors for axis in "xyz"], np.intp)
