"""The page's lamps; colours already contain the world's light (shapes.lit)."""

from __future__ import annotations

from typing import Any

WHITE = (255, 255, 255)
FROM = (1.0, -0.6, 2.0)  # direction from things to the lamp
AROUND, LAMP = 1.5, 2.3  # a little more than pi together, so that slanted white things are white, too


def add_lights(server: Any) -> None:
    """Adds ambient light and a lamp that casts shadows; no environment to reflect."""
    scene = server.scene
    scene.configure_environment_map(None)
    scene.configure_default_lights(False)
    scene.add_light_ambient("/lights/around", color=WHITE, intensity=AROUND)
    scene.add_light_directional("/lights/lamp", color=WHITE, intensity=LAMP, cast_shadow=True, position=FROM)
