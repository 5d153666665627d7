"""Counts of the library's tasks in an episode, by their names in `info` and logs.

Each exists twice: as the competition counts it, for comparable results, and corrected.
"""

from __future__ import annotations

from typing import Any, Dict, List, Mapping

import numpy as np
from numpy.typing import NDArray

from ..classic.model import ModelView
from ..classic.utils import get_child_bodies, get_geoms_for_body

Info = Dict[str, Any]
Numbers = NDArray[np.float64]
HANDS = ("right_hand", "left_hand")
EYES = ("right_eye", "left_eye")
WITH_FINGERS = "_or_finger"
IN_VIEW = "_in_view"


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

    task = "selftouch"
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


COUNTS: Mapping[str, Any] = {"none": Nothing, "self_touch": Touches, "hand_regard": Regard}


def geoms_below(model: ModelView, body: str) -> List[int]:
    """Numbers of the geoms of a body and of all below it."""
    bodies = get_child_bodies(model, model.body(body).id)
    return sorted(geom for one in bodies for geom in get_geoms_for_body(model, one))
