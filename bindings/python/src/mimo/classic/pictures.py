"""Pictures of the original's environments: `render()`, and the member `mujoco_renderer`."""

from __future__ import annotations

from typing import Any, Mapping, Optional

from ..arguments import number_of
from ..constants import Kind, Quantity
from ..pictures import ARRAYS
from ..world import World

MODES = (*ARRAYS, "human")
TRACKING = ("trackbodyid", "fixedcamid", "type")  # the first is the body that the camera looks at, without a lookat
CONFIG = {"lookat": "look_at", "distance": "distance", "azimuth": "azimuth", "elevation": "elevation"}


class Renderer:
    """Draws the world, from a camera or by `default_camera_config` (m and degrees)."""

    def __init__(
        self,
        world: World,
        width: int,
        height: int,
        camera: Optional[str],
        config: Optional[Mapping[str, Any]],
        camera_id: Optional[int] = None,
    ) -> None:
        if camera is None and camera_id is not None and camera_id >= 0:
            camera = world.name(Kind.CAMERA, camera_id)
        self._world, self._camera = world, camera
        self._window: Any = None
        self.width, self.height = number_of("width", width), number_of("height", height)
        self.default_cam_config: Mapping[str, Any] = dict(config or {})
        unknown = set(self.default_cam_config) - {*CONFIG, *TRACKING}
        if unknown:
            raise ValueError(f"default_camera_config has {min(unknown)!r}, expected {', '.join((*CONFIG, *TRACKING))}")

    def render(
        self, render_mode: str = "rgb_array", camera_id: Optional[int] = None, camera_name: Optional[str] = None
    ) -> Any:
        """A picture of colours or depths; None with "human", which opens a window."""
        if render_mode not in MODES:
            raise ValueError(f"render_mode is {render_mode!r}, expected {', '.join(map(repr, MODES))}")
        picture: Any = {"width": self.width, "height": self.height, **self._seen_from(camera_id, camera_name)}
        if render_mode == "depth_array":
            return self._world.depth(**picture)
        drawn = self._world.render(**picture)
        if render_mode == "rgb_array":
            return drawn
        self._shown(drawn)
        return None

    def close(self) -> None:
        """Closes the window."""
        if self._window is not None:
            self._window.close()
            self._window = None

    def _seen_from(self, camera_id: Optional[int], camera_name: Optional[str]) -> Mapping[str, Any]:
        name = camera_name or self._camera
        if camera_id is not None and camera_id >= 0:
            name = self._world.name(Kind.CAMERA, camera_id)
        return self._view() if name is None else {"camera": name}

    def _view(self) -> Mapping[str, Any]:
        view = {CONFIG[name]: value for name, value in self.default_cam_config.items() if name in CONFIG}
        body = self.default_cam_config.get("trackbodyid", -1)
        if "look_at" not in view and body is not None and int(body) >= 0:
            view["look_at"] = self._world.get(Quantity.BODY_POSITION, [int(body)], now=True).ravel()
        return view

    def _shown(self, picture: Any) -> None:
        if self._window is None:
            from ..plot import Window  # only windows and plots need matplotlib

            self._window = Window("MIMo")
        self._window.show(picture)

    def __getstate__(self) -> Mapping[str, Any]:
        return {**self.__dict__, "_window": None}
