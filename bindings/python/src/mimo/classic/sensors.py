"""The original's classes of senses, as members of an environment: `env.vision.get_vision_obs()`."""

from __future__ import annotations

from typing import Any, Dict, List, Mapping, Optional

import numpy as np
from numpy.typing import NDArray

from ..constants import Kind
from .params import PARTS

Numbers = NDArray[Any]


class SimpleProprioception:
    """Angles, and what else `proprio_params` names."""

    def __init__(self, env: Any, proprio_params: Optional[Mapping[str, Any]] = None) -> None:
        self.env, self.proprio_params = env, proprio_params
        self.output_components: List[str] = list((proprio_params or {}).get("components", ()))
        self.limit_thresh = (proprio_params or {}).get("threshold", 0.035)

    @property
    def joint_names(self) -> List[str]:
        """The joints that are felt."""
        return [self.env.model.joint(int(number)).name for number in self.env.mimo_joints]

    @property
    def sensor_names(self) -> Dict[str, List[str]]:
        """The names of the numbers of each part."""
        fields = self.env.world.layout.fields
        parts = self.env.observer.fields
        return {part: [label for name in names for label in fields[name].labels] for part, names in parts.items()}

    @property
    def sensor_outputs(self) -> Dict[str, Numbers]:
        """The parts of the observation: qpos, qvel, torques, limits, actuation."""
        seen = self.env.seen()
        return {part: self._part(part, seen) for part in PARTS if part in self.env.observer.fields}

    def get_proprioception_obs(self) -> Numbers:
        """The parts in a row."""
        seen = self.env.seen()
        if not self.env.moves_by_hand:
            whole: Numbers = self.env.observer.row(seen)
            return whole
        parts = [self._part(part, seen) for part in self.env.observer.fields]
        return np.concatenate([*parts, self.env.observer.row(seen, only=self.env.observer.extra)])

    def _part(self, part: str, seen: Any) -> Numbers:
        if part == "actuation" and self.env.moves_by_hand:
            return np.asarray(self.env.actuation_model.observations(), np.float64).ravel()
        row: Numbers = self.env.observer.row(seen, only=self.env.observer.fields[part])
        return row


class SimpleVision:
    """Pictures of cameras."""

    def __init__(self, env: Any, camera_parameters: Optional[Mapping[str, Any]] = None) -> None:
        self.env, self.camera_parameters = env, camera_parameters
        self.sensor_outputs: Dict[str, NDArray[np.uint8]] = {}

    def get_vision_obs(self) -> Dict[str, NDArray[np.uint8]]:
        """One picture a camera."""
        self.sensor_outputs = self.env.observer.pictures(self.env.seen())
        return self.sensor_outputs

    def render_camera(self, width: int, height: int, camera_name: str, depth: bool = False) -> Any:
        """A picture of any camera, and its depths (m)."""
        view = {"width": width, "height": height, "camera": camera_name}
        picture = self.env.world.render(**view)
        return (picture, self.env.world.depth(**view)) if depth else picture

    def save_obs_to_file(self, directory: str, suffix: str = "") -> None:
        """Writes the last pictures as PNG files."""
        import os

        from matplotlib import image

        os.makedirs(directory, exist_ok=True)
        for name, picture in self.sensor_outputs.items():
            image.imsave(os.path.join(directory, f"{name}_{suffix}.png"), picture)


class SimpleVestibular:
    """Acceleration and rotation of the head."""

    def __init__(self, env: Any, vestibular_params: Optional[Mapping[str, Any]] = None) -> None:
        self.env, self.vestibular_params = env, vestibular_params
        self.sensor_addrs: List[int] = []
        for name in (vestibular_params or {}).get("sensors", ()):
            number = env.world.find(Kind.SENSOR, name)
            start = int(env.model.sensor_adr[number])
            self.sensor_addrs += range(start, start + int(env.model.sensor_dim[number]))

    @property
    def sensor_outputs(self) -> Numbers:
        """The numbers of the current state."""
        return self.get_vestibular_obs()

    def get_vestibular_obs(self) -> Numbers:
        """The numbers of the sensors, in their order."""
        balance: Numbers = self.env.observer.balance(self.env.seen())
        return balance


# The original's abstract classes, which scripts name in annotations.
Proprioception, Vision, Vestibular = SimpleProprioception, SimpleVision, SimpleVestibular
