"""What the behaviours are measured by: which parts of the body hands touch, and whether eyes look at hands.

Each measure is taken twice: as the competition takes it, so that results compare, and right.
"""

from __future__ import annotations

from typing import Any, Dict, List, Mapping, Set, Tuple

import numpy as np
from numpy.typing import NDArray

from ..classic.utils import get_child_bodies, get_geoms_for_body, matrix
from ..world import World

Info = Dict[str, Any]
HANDS = ("right_hand", "left_hand")
EYES = ("right_eye", "left_eye")
CONE = np.radians(15)  # half of the 30 degrees within which a hand is looked at
WITH_FINGERS = "_or_finger"
IN_VIEW = "_in_view"


def touch_key(hand: str, fingers: bool = False) -> str:
    """The name of a list of touched geoms in `info`."""
    return f"{hand}{WITH_FINGERS if fingers else ''}_touches"


def regard_key(eye: str, hand: str, in_view: bool = False) -> str:
    """The name of a counter of steps in `info`."""
    return f"{eye}_{hand}{IN_VIEW if in_view else ''}"


class Nothing:
    """The measure of no behaviour."""

    def begin(self) -> None:
        """Starts an episode."""

    def take(self) -> None:
        """Takes in the step that was made last."""

    def told(self) -> Info:
        """What the episode has come to."""
        return {}


class Touches(Nothing):
    """Geoms of the body that each hand has touched in the episode, in order: the palm alone, or with fingers, too."""

    def __init__(self, env: Any) -> None:
        self._world: World = env.world
        model = env.model
        self.body = _geoms_below(model, "hip")
        self.palms = {hand: set(get_geoms_for_body(model, model.body(hand).id)) for hand in HANDS}
        self.hands = {hand: _geoms_below(model, hand) for hand in HANDS}
        self.begin()

    def begin(self) -> None:
        """Starts an episode."""
        keys = [touch_key(hand, fingers) for fingers in (False, True) for hand in HANDS]
        self._touched: Dict[str, List[int]] = {key: [] for key in keys}

    def take(self) -> None:
        """Takes in the contacts of the last physics step."""
        for pair in self._world.contacts().geoms.tolist():
            hand, geom = self._credited(pair)
            if hand:
                self._add(touch_key(hand), geom)
            for hand, geom in self._touching(pair):
                self._add(touch_key(hand, True), geom)

    def told(self) -> Info:
        """Lists of their own, so that what a step told stays as it was."""
        return {key: list(geoms) for key, geoms in self._touched.items()}

    def _credited(self, pair: List[int]) -> Tuple[str, int]:
        """As the competition has it: palms alone, the right one first; two palms that touch each other count once."""
        for hand in HANDS:
            for one, other in (pair, pair[::-1]):
                if one in self.palms[hand]:
                    return (hand, other) if other in self.body else ("", -1)
        return "", -1

    def _touching(self, pair: List[int]) -> List[Tuple[str, int]]:
        """Fingers count, and both hands; what belongs to the hand itself does not."""
        return [
            (hand, other)
            for hand in HANDS
            for one, other in (pair, pair[::-1])
            if one in self.hands[hand] and other in self.body - self.hands[hand]
        ]

    def _add(self, key: str, geom: int) -> None:
        if geom not in self._touched[key]:
            self._touched[key].append(geom)


class Regard(Nothing):
    """Steps of the episode in which each eye was turned to each hand.

    The competition measures from the axis that points down the face (-z of the eye); right is the camera's (+x).
    """

    def __init__(self, env: Any) -> None:
        self._eyes, self._hands = env.world.bodies(*EYES), env.world.bodies(*HANDS)
        self.begin()

    def begin(self) -> None:
        """Starts an episode."""
        pairs = [(eye, hand) for eye in EYES for hand in HANDS]
        self._steps = {regard_key(*pair, in_view): 0 for in_view in (False, True) for pair in pairs}

    def take(self) -> None:
        """Takes in poses at the start of the last physics step."""
        hands = self._hands.position
        for eye, place, turn in zip(EYES, self._eyes.position, self._eyes.orientation):
            axes = matrix(turn)
            for hand, there in zip(HANDS, hands):
                self._steps[regard_key(eye, hand)] += within(there - place, -axes[:, 2])
                self._steps[regard_key(eye, hand, True)] += within(there - place, axes[:, 0])

    def told(self) -> Info:
        """The counters."""
        return dict(self._steps)


MEASURES: Mapping[str, Any] = {"none": lambda env: Nothing(), "self_touch": Touches, "hand_regard": Regard}


def within(offset: NDArray[np.float64], axis: NDArray[np.float64]) -> bool:
    """Whether a place is less than 15 degrees beside an axis of length 1; never one that is where the axis begins."""
    distance = float(np.linalg.norm(offset))
    return distance > 0 and bool(np.arccos(np.clip(offset @ axis / distance, -1, 1)) < CONE)


def _geoms_below(model: Any, body: str) -> Set[int]:
    return {geom for one in get_child_bodies(model, model.body(body).id) for geom in get_geoms_for_body(model, one)}
