"""Touch in the original's form: three numbers per sensor, and sensors' positions and forces by body."""

from __future__ import annotations

from typing import Any, Dict, List, Mapping, Tuple

import numpy as np
from numpy.typing import NDArray

from ..constants import Kind
from ..layout import Observation
from ..world import World

ByBody = Dict[int, NDArray[Any]]


def force_field(fields: Mapping[str, Any]) -> str:
    """The name of the field of forces, or None without skin."""
    return "touch/force" if "touch/force" in fields else ""


class Touch:
    """The member `touch` of the original's environments: `sensor_positions` and `sensor_outputs` by number of body."""

    touch_size = 3  # numbers of a sensor

    def __init__(self, world: World, field: str) -> None:
        receptors = world.layout.receptors(field)
        self._bodies = receptors.bodies
        self._normals = receptors.frame[:, 0, :].astype(np.float32)
        self._alone = world.layout.fields[field].shape[-1] == 1  # normal force only
        self._field = field
        self._felt = np.zeros((len(receptors.bodies), 3), np.float32)
        numbers = np.unique(receptors.bodies)
        self._rows = {int(body): np.flatnonzero(receptors.bodies == body) for body in numbers}
        self._names = {int(body): world.name(Kind.BODY, int(body)) for body in numbers}
        self.sensor_positions: ByBody = {body: receptors.position[rows] for body, rows in self._rows.items()}

    def row(self, views: Observation, lead: Tuple[int, ...] = ()) -> NDArray[np.float32]:
        """All sensors' forces, flattened (after the first axes `lead`); also kept for sensor_outputs."""
        force = views[self._field]
        # A normal force points into the skin. The original gives three numbers here as well.
        felt: NDArray[np.float32] = -force * self._normals if self._alone else np.array(force, np.float32)
        self._felt = felt
        return felt.reshape((*lead, -1)).copy()

    def belongs_to(self, env: Any) -> None:
        """Takes the environment that `get_touch_obs` observes."""
        self.env, self.touch_params = env, env.touch_params
        self._in_python: Any = None

    def get_touch_obs(self) -> NDArray[np.float32]:
        """The forces of all sensors in the current state: N x 3, N; of bodies in the order of their numbers."""
        self.row(self.env.seen())
        return self._felt.reshape(-1, self.touch_size).copy()

    @property
    def sensor_outputs(self) -> ByBody:
        """Forces of the last observation by number of body: N x 3, N."""
        return {body: self._felt[..., rows, :] for body, rows in self._rows.items()}

    @property
    def body_names(self) -> Dict[int, str]:
        """Names of the bodies with skin."""
        return dict(self._names)

    def get_total_sensor_count(self) -> int:
        """The number of sensors."""
        return len(self._bodies)

    def get_sensor_count(self, body_id: int) -> int:
        """The number of sensors on a body."""
        return len(self.sensor_positions[int(body_id)])

    def has_sensors(self, body_id: int) -> bool:
        """Whether a body has sensors."""
        return int(body_id) in self.sensor_positions

    @property
    def sensing_bodies(self) -> List[int]:
        """Numbers of the bodies with sensors."""
        return list(self.sensor_positions)

    def __getattr__(self, name: str) -> Any:
        """Members of the original's class that this one lacks: contacts, forces, meshes."""
        if name.startswith("_") or name == "env":
            raise AttributeError(name)
        if self._in_python is None:
            from .touch import TrimeshTouch

            self._in_python = TrimeshTouch(self.env, self.touch_params)
        return getattr(self._in_python, name)
