"""Counts of the library's tasks in an episode, by their names in `info` and logs.

Each exists twice: as the competition counts it, for comparable results, and corrected.
"""

from __future__ import annotations

from typing import Any, Dict, List, Mapping

import numpy as np
from numpy.typing import NDArray

from ..behaviour import Behaviour
from ..classic.model import ModelView
from ..classic.utils import get_child_bodies, get_geoms_for_body
from ..constants import Quantity
from .described import Described

Info = Dict[str, Any]
Numbers = NDArray[np.float64]
HANDS = ("right_hand", "left_hand")
EYES = ("right_eye", "left_eye")
WITH_FINGERS = "_or_finger"
IN_VIEW = "_in_view"
ROUNDING = 1e-6  # s; of a sum of many time steps


def touch_key(hand: str, fingers: bool = False) -> str:
    """The name of a list of touched geoms in `info`."""
    return f"{hand}{WITH_FINGERS if fingers else ''}_touches"


def regard_key(eye: str, hand: str, in_view: bool = False) -> str:
    """The name of a counter of steps in `info`."""
    return f"{eye}_{hand}{IN_VIEW if in_view else ''}"


# In the order of the tasks' numbers (docs/tasks.md).
TOUCH_KEYS = [touch_key(hand, fingers) for fingers in (False, True) for hand in HANDS]
REGARD_KEYS = [regard_key(eye, hand, in_view) for in_view in (False, True) for eye in EYES for hand in HANDS]


class Nothing:
    """Counts without a behaviour, in episodes of self-touch without its random steps."""

    task, settles = "selftouch", True
    parameters: Mapping[str, float] = {"selftouch/warm_up_steps": 0}

    def __init__(self, model: ModelView) -> None:
        del model

    def told(self, achieved: Numbers) -> Info:
        """The entries of `info`, from the numbers of a task (Quantity.AGENT_ACHIEVED)."""
        del achieved
        return {}

    def told_of_all(self, achieved: Numbers) -> Info:
        """The same for many worlds, as arrays with one row per world."""
        del achieved
        return {}


class Touches(Nothing):
    """Geoms of the body that each hand has touched, in order: with the palm alone, or also with fingers."""

    parameters: Mapping[str, float] = {}

    def __init__(self, model: ModelView) -> None:
        self._geoms = np.array(geoms_below(model, "hip"))

    def told(self, achieved: Numbers) -> Info:
        """Lists of numbers of geoms."""
        return {key: self._in_order(steps) for key, steps in zip(TOUCH_KEYS, achieved.reshape(len(TOUCH_KEYS), -1))}

    def told_of_all(self, achieved: Numbers) -> Info:
        """The touched geoms of the body, for each world."""
        touched = achieved.reshape(len(achieved), len(TOUCH_KEYS), -1) > 0
        return {key: touched[:, place] for place, key in enumerate(TOUCH_KEYS)}

    def _in_order(self, steps: Numbers) -> List[int]:
        """Ordered by the step of the first touch, then by number; 0 means never."""
        touched = np.flatnonzero(steps)
        ordered: List[int] = self._geoms[touched[np.argsort(steps[touched], kind="stable")]].tolist()
        return ordered


class Regard(Nothing):
    """Steps of the episode in which each eye was turned to each hand.

    The competition measures from the axis that points down the face (-z of the eye); right is the camera's (+x).
    """

    task = "handregard"
    parameters: Mapping[str, float] = {}

    def told(self, achieved: Numbers) -> Info:
        """Numbers of steps."""
        return dict(zip(REGARD_KEYS, achieved.astype(int).tolist()))

    def told_of_all(self, achieved: Numbers) -> Info:
        """Numbers of steps, one for each world."""
        return dict(zip(REGARD_KEYS, achieved.astype(int).T))


class Measured:
    """What a behaviour measures that a scene's document describes, with all that a log needs to be read alone."""

    task, settles = "behaviour", False
    parameters: Mapping[str, float] = {"behaviour/episode_seconds": 1e9}  # max_episode_steps says how long

    def __init__(self, behaviour: Behaviour, name: str, goal: Numbers) -> None:
        told = {"behavior": name, "measured": behaviour.measure, "unit": behaviour.unit, "at_most": behaviour.at_most}
        self._told: Info = {**told, "threshold": float(goal[0]), "hold_seconds": float(goal[-1])}

    def told(self, achieved: Numbers) -> Info:
        """The measure now, the longest time for which all has held, and whether that is enough; what these are."""
        return {**{key: values.item() for key, values in self.told_of_all(achieved).items()}, **self._told}

    def told_of_all(self, achieved: Numbers) -> Info:
        """The first three for many worlds, as arrays with one row per world."""
        measure, held = achieved[..., 0], achieved[..., -1]
        reached = (held > 0) & (held >= self._told["hold_seconds"] - ROUNDING)
        return {"measure": measure, "held_seconds": held, "reached": reached}


COUNTS: Mapping[str, Any] = {"none": Nothing, "self_touch": Touches, "hand_regard": Regard}


def kind_of(config: Mapping[str, Any]) -> Any:
    """The class of the counts of a configuration: their task and its parameters."""
    return COUNTS.get(config["behavior"], Measured)


def counts_of(config: Mapping[str, Any], world: Any) -> Any:
    """The counts of a configuration, in its world."""
    if config["behavior"] in COUNTS:
        return COUNTS[config["behavior"]](ModelView(world))
    told = Described(config["behavior"])
    return Measured(told.behaviour, told.name, world.get(Quantity.AGENT_GOAL).ravel())


def geoms_below(model: ModelView, body: str) -> List[int]:
    """Numbers of the geoms of a body and of all below it."""
    bodies = get_child_bodies(model, model.body(body).id)
    return sorted(geom for one in bodies for geom in get_geoms_for_body(model, one))
