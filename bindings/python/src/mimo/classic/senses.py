"""The original's dictionary of observations, made of the library's fields."""

from __future__ import annotations

from typing import Any, Dict, List, Optional, Sequence, Tuple

import numpy as np
from gymnasium import spaces
from numpy.typing import NDArray

from ..layout import Observation
from ..world import World
from .eyes import Fovea
from .params import ACTUATION, PARTS, Senses
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
        named = {part: [f"proprioception/{name}" for name in PARTS[part]] for part in senses.parts}
        self.fields = {part: [name for name in names if name in fields] for part, names in named.items()}
        self.extra = list(extra)
        self._parts = [*(name for names in self.fields.values() for name in names), *extra]
        self._known = set(fields)
        self._torques = _picked(fields, torque_sensors)
        self._vestibular = [f"vestibular/{name}" for name in senses.vestibular]
        self._cameras = list(senses.cameras)
        eyes = senses.cameras.items()
        self._foveas = {name: Fovea(eye.width, eye.height, eye.foveation) for name, eye in eyes if eye.foveation}
        self.touch = Touch(world, force_field(fields)) if force_field(fields) else None
        block = world.layout.new_block()
        block[...] = 0
        self.boxes = self._boxes(world.layout.views(block))

    @property
    def actuation_fields(self) -> List[str]:
        """The fields of what motors do."""
        return [f"proprioception/{name}" for name in ACTUATION if f"proprioception/{name}" in self._known]

    def see(self, views: Observation, worlds: int = 0) -> Dict[str, NDArray[Any]]:
        """The dictionary, with new arrays; `worlds` is the length of their first axis."""
        lead = (worlds,) if worlds else ()
        seen: Dict[str, NDArray[Any]] = {"observation": self.row(views, lead)}
        if self.touch is not None:
            seen["touch"] = self.touch.row(views, lead)
        seen.update(self.pictures(views))
        if self._vestibular:
            seen["vestibular"] = self.balance(views)
        return seen

    def row(
        self, views: Observation, lead: Tuple[int, ...] = (), only: Optional[Sequence[str]] = None
    ) -> NDArray[np.float64]:
        """`observation`, or some of its fields."""
        rows: List[NDArray[Any]] = []
        for name in self._parts if only is None else only:
            values = views[name].reshape((*lead, -1))
            picks = self._torques if name == "proprioception/torque" else None
            rows.append(values if picks is None else values[..., picks])
        return np.concatenate(rows, axis=-1, dtype=np.float64) if rows else np.zeros((*lead, 0))

    def balance(self, views: Observation) -> NDArray[np.float64]:
        """`vestibular`."""
        return np.concatenate([views[name] for name in self._vestibular], axis=-1, dtype=np.float64)

    def pictures(self, views: Observation) -> Dict[str, NDArray[np.uint8]]:
        """One picture a camera."""
        pictures = {name: views[f"vision/{name}"].copy() for name in self._cameras}
        pictures.update({name: fovea.seen(pictures[name]) for name, fovea in self._foveas.items()})
        return pictures

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
