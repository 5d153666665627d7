"""The page's left side: eyes, motors or muscles, and fields that no sense of the library has."""

from __future__ import annotations

from html import escape
from typing import Any, Dict, List, Tuple

import numpy as np

from ..drawing import prefixes
from ..option_types import SENSES
from ..world import World

EYES = ("left", "right")
WIDTH = 290  # pixels
GAP = 4  # pixels between the two eyes' pictures
ACTIVITY = ("proprioception/activation", "proprioception/control")  # of muscles, or of motors
FEW = 6  # numbers that are shown one by one


class SensesPanel:
    """Pictures of both eyes of each infant, bars for motors or muscles, and numbers of all other fields."""

    def __init__(self, server: Any, world: World) -> None:
        self._world = world
        self._panel = server.gui.add_panel()
        self._pictures: Dict[str, Any] = {}
        self._bars: List[Tuple[str, str, Any]] = []
        with self._panel.add_tab("Senses"):
            for name in prefixes(world):
                self._add_eyes(server, name)
        with self._panel.add_tab("Muscles"):
            for name in prefixes(world):
                self._add_bars(server, name)
        self._others = others(world)
        if self._others:
            with self._panel.add_tab("Fields"):
                self._numbers = server.gui.add_html("")
        self._panel.dock_left()
        self._panel.set_width(WIDTH)

    def _add_eyes(self, server: Any, prefix: str) -> None:
        fields = self._world.layout.fields
        if all(f"{prefix}vision/eye_{side}" in fields for side in EYES):
            label = f"{prefix.rstrip('/')} left and right eye".strip()
            self._pictures[prefix] = server.gui.add_image(self._both(prefix), label=label, jpeg_quality=85)

    def _add_bars(self, server: Any, prefix: str) -> None:
        for field in ACTIVITY:
            if self._world.layout.fields.get(prefix + field) is not None:
                self._bars.append((prefix.rstrip("/"), prefix + field, server.gui.add_html("")))
                return

    def _both(self, prefix: str) -> Any:
        left, right = (self._world.observation[f"{prefix}vision/eye_{side}"] for side in EYES)
        return np.hstack([left, np.full((len(left), GAP, 3), 255, np.uint8), right])

    def update_pictures(self) -> None:
        """Shows the eyes' pictures."""
        for prefix, picture in self._pictures.items():
            picture.image = self._both(prefix)

    def update_bars(self) -> None:
        """Shows the muscles' activity."""
        for infant, name, html in self._bars:
            field = self._world.layout.fields[name]
            html.content = bars(infant, field.labels, self._world.observation[name].ravel())
        if self._others:
            observation, fields = self._world.observation, self._world.layout.fields
            self._numbers.content = "".join(line(name, fields[name].unit, observation[name]) for name in self._others)

    def remove(self) -> None:
        """Removes it from the page."""
        self._panel.remove()


def others(world: World) -> List[str]:
    """Fields that no sense of the library has: of senses of one's own, of tasks, on request."""
    infants = [prefix for prefix in prefixes(world) if prefix]
    own = {
        name: next((name[len(one) :] for one in infants if name.startswith(one)), name) for name in world.layout.fields
    }
    return [name for name, path in own.items() if path.split("/")[0] not in SENSES]


def line(name: str, unit: str, values: Any) -> str:
    """A field with its numbers; of many the range and the mean."""
    numbers = np.asarray(values, np.float64).ravel()
    few = " ".join(f"{number:.3g}" for number in numbers[:FEW])
    many = f"{numbers.min():.3g} to {numbers.max():.3g}, mean {numbers.mean():.3g} ({numbers.size})"
    text = f"{few if numbers.size <= FEW else many} {unit}"
    return f'<div style="font:11px sans-serif;padding:2px 8px"><b>{escape(name)}</b> {escape(text)}</div>'


def bars(infant: str, names: Any, values: Any) -> str:
    """A table of bars with the infant's name; negative values go to the left of the middle."""
    title = f'<div style="font-weight:bold;padding:4px 0">{escape(infant)}</div>' if infant else ""
    rows = "".join(_row(short(name), float(np.clip(value, -1, 1))) for name, value in zip(names, values))
    return f'<div style="font:11px sans-serif;padding:0 8px">{title}{rows}</div>'


def _row(name: str, value: float) -> str:
    left, width = 50 + 50 * min(value, 0), 50 * abs(value)
    bar = f'<div style="position:absolute;height:8px;left:{left:.0f}%;width:{width:.0f}%;background:#c8483c"></div>'
    scale = f'<div style="position:relative;flex:1;height:8px;background:#8883">{bar}</div>'
    label = f'<div style="width:150px;overflow:hidden;white-space:nowrap">{escape(name)}</div>'
    return f'<div style="display:flex;align-items:center;height:14px">{label}{scale}</div>'


def short(name: str) -> str:
    """A motor's or joint's name without its prefix: "left_elbow" of "robot:left_elbow"."""
    return name.split(":")[-1]
