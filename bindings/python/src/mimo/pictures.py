"""Gymnasium's render modes."""

from __future__ import annotations

from typing import Any, Optional, Sequence, Tuple

from .arguments import number_of
from .world import World

ARRAYS = ("rgb_array", "depth_array")


def without_mode(kind: type) -> None:
    """Warns as Gymnasium's environments do when render() is called without a render mode."""
    from gymnasium import logger

    logger.warn(
        f"render() draws nothing: this {kind.__name__} was made without render_mode; give it render_mode={ARRAYS[0]!r}"
    )


class Painter:
    """Draws worlds: "rgb_array" is height x width x 3, "depth_array" height x width, m along the camera's axis."""

    def __init__(
        self,
        mode: Optional[str],
        size: Tuple[Optional[int], Optional[int]],
        standard: Tuple[int, int],
        camera: Optional[str],
        modes: Sequence[str] = ARRAYS,
    ) -> None:
        if mode is not None and mode not in modes:
            raise ValueError(f"render_mode is {mode!r}, expected {', '.join(map(repr, modes))} or None")
        width, height = (usual if given is None else given for given, usual in zip(size, standard))
        self._mode = mode
        self._picture: Any = {"width": number_of("width", width), "height": number_of("height", height)}
        if camera is not None:
            self._picture["camera"] = camera

    def paint(self, world: World) -> Any:
        """A picture of a world."""
        if self._mode == "depth_array":
            return world.depth(**self._picture)
        return world.render(**self._picture)
