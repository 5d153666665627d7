"""The page's lamps: the world's light is in its colours already (shapes.lit)."""

from __future__ import annotations

from typing import Any

WHITE = (255, 255, 255)
FROM = (1.0, -0.6, 2.0)  # where the lamp is, seen from what it lights
AROUND, LAMP = 1.5, 2.3  # a little more than pi together: white things are white, also a little aslant


def add_lights(server: Any) -> None:
    """Even light from all around, and a lamp that casts shadows; no surroundings that would be mirrored."""
    scene = server.scene
    scene.configure_environment_map(None)
    scene.configure_default_lights(False)
    scene.add_light_ambient("/lights/around", color=WHITE, intensity=AROUND)
    scene.add_light_directional("/lights/lamp", color=WHITE, intensity=LAMP, cast_shadow=True, position=FROM)
