"""Sliders for joints and for actions, in a folder for each infant."""

from __future__ import annotations

from collections import defaultdict
from typing import Any, Callable, Dict, List, Tuple

import numpy as np

from ..constants import Quantity
from ..drawing import limited
from ..world import World
from .motors import SLIDERS, Motors
from .senses_panel import short

DIGITS = 2  # decimals of a slider's numbers


def owner(name: str) -> str:
    """The owner of a joint or motor: "anna" of "anna/robot:left_elbow", "" for a single infant."""
    return name.split("/")[0] if "/" in name else ""


def _folders(gui: Any, names: Any, title: str) -> List[Tuple[Any, List[int]]]:
    """A folder for each owner, with the indices of its elements."""
    by_owner: Dict[str, List[int]] = defaultdict(list)
    for index, name in enumerate(names):
        by_owner[owner(name)].append(index)
    return [(gui.add_folder(of or title), indices) for of, indices in by_owner.items()]


def _slider(gui: Any, name: str, low: float, high: float, value: float) -> Any:
    low, high = (round(end, DIGITS) for end in (low, high))
    value = round(float(np.clip(value, low, high)), DIGITS)
    return gui.add_slider(short(name), min=low, max=high, step=10.0**-DIGITS, initial_value=value)


class JointSliders:
    """Show joints' positions, and set them."""

    def __init__(
        self, server: Any, world: World, ask: Callable[[Callable[[], None]], None], fixed: bool = False
    ) -> None:
        self._world, self._joints, self._ask = world, limited(world), ask
        self._sliders: List[Any] = [None] * len(self._joints)
        names, ranges = self._joints.names, self._ranges()
        values = self._joints._get(Quantity.JOINT_POSITION)
        for folder, indices in _folders(server.gui, names, "rad"):
            with folder:
                for i in indices:
                    self._sliders[i] = _slider(server.gui, names[i], ranges[i][0], ranges[i][1], values[i])
                    self._sliders[i].disabled = fixed
                    self._sliders[i].on_update(self._moved(i))

    def _ranges(self) -> Any:
        return self._joints._get(Quantity.JOINT_RANGE).reshape(-1, 2).tolist()

    def _moved(self, index: int) -> Callable[[Any], None]:
        def moved(event: Any) -> None:
            if event.client is not None:  # not by update()
                self._ask(lambda: self._put(index, event.target.value))

        return moved

    def _put(self, index: int, angle: float) -> None:
        which = [int(self._joints.ids[index])]
        low, high = self._ranges()[index]
        self._world.set(Quantity.JOINT_POSITION, min(max(angle, low), high), which)  # a slider's ends are rounded
        self._world.set(Quantity.JOINT_VELOCITY, 0.0, which)
        self._world.update()

    def update(self) -> None:
        """Shows the joints' positions and ranges."""
        ranges, values = self._ranges(), self._joints._get(Quantity.JOINT_POSITION)
        for slider, ends, value in zip(self._sliders, ranges, values.tolist()):
            low, high = (round(end, DIGITS) for end in ends)
            if (slider.min, slider.max) != (low, high):
                slider.min, slider.max = low, high
            rounded = round(min(max(value, low), high), DIGITS)
            if abs(slider.value - rounded) > 0.5 * 10**-DIGITS:
                slider.value = rounded


class ActionSliders:
    """Choose the actions."""

    def __init__(self, server: Any, world: World, motors: Motors, chosen: Callable[[], None]) -> None:
        self._motors, self._chosen = motors, chosen
        for folder, indices in _folders(server.gui, world.action_names, "actions"):
            with folder:
                for i in indices:
                    low, high = float(world.action_low[i]), float(world.action_high[i])
                    slider = _slider(server.gui, world.action_names[i], low, high, float(motors.rest[i]))
                    slider.on_update(self._moved(i))

    def _moved(self, index: int) -> Callable[[Any], None]:
        def moved(event: Any) -> None:
            self._motors.given[index] = np.clip(event.target.value, self._motors.low[index], self._motors.high[index])
            self._motors.choice = SLIDERS
            self._chosen()

        return moved
