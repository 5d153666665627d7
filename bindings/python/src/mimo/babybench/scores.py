"""Scores of logs: as the competition computes them, and corrected.

Self-touch: the competition counts palms only, a touch of both palms for the right hand, as a share of 68 geoms, of
which 60 can be reached. Corrected: fingers and both hands count, as a share of the geoms outside of each hand.

Hand regard: the competition takes 15 degrees about the eye's -z axis, which points down the face. Corrected: about the
camera's axis.

A behaviour that a scene's document describes: the share of episodes in which it was reached.

The competition counts the last 10000 episodes, without the first one if there are no more. Corrected: all with steps.
"""

from __future__ import annotations

from typing import Any, Callable, Iterable, List, Mapping, NamedTuple, Optional, Sequence

from .counts import EYES, HANDS, regard_key, touch_key

Entries = Sequence[Mapping[str, Any]]
WINDOW = 10000
COMPETITION_GEOMS = 68
OUTSIDE = 32  # geoms of the mitten body outside of one hand and its fingers: 36 - 4


class Scores(NamedTuple):
    """Scores of one behaviour, 0 to 1; None if unknown.

    Of one that a scene describes: the share of the competition's window, and of all episodes, in which it was reached,
    and the mean share of the time for which it has to hold.
    """

    behavior: str
    episodes: int  # with steps
    competition: Optional[float]
    right: Optional[float]  # None for logs without the data, such as the competition's
    right_mean: Optional[float]  # the mean of single episodes, independent of their number


def scores_of(entries: Entries) -> Scores:
    """The scores of a log."""
    behavior = behavior_of(entries)
    played = [entry for entry in entries if entry["steps"] > 0]
    if behavior == "none" or not played:
        return Scores(behavior, len(played), None, None, None)
    if behavior not in SCORES:
        held = [share_held(entry) for entry in played]
        return Scores(behavior, len(played), reached(window(entries)), reached(played), sum(held) / len(held))
    competition, right = SCORES[behavior]
    if not _complete(played, behavior):
        return Scores(behavior, len(played), competition(window(entries)), None, None)
    single = [right([entry]) for entry in played]
    return Scores(behavior, len(played), competition(window(entries)), right(played), sum(single) / len(single))


def behavior_of(entries: Entries) -> str:
    """The behaviour of a log, by its entries."""
    for behavior, key in (("self_touch", touch_key(HANDS[0])), ("hand_regard", regard_key(EYES[0], HANDS[0]))):
        if any(key in entry for entry in entries):
            return behavior
    return next((str(entry["behavior"]) for entry in entries if "reached" in entry), "none")


def window(entries: Entries) -> Entries:
    """The entries that the competition counts: the last 10000, and never the first."""
    return entries[len(entries) - min(WINDOW, len(entries) - 1) :] if entries else entries


def self_touch(entries: Entries) -> float:
    """The competition's score: geoms that palms touched in any of the episodes, of 68."""
    return _touched(entries, False) / COMPETITION_GEOMS


def self_touch_right(entries: Entries) -> float:
    """Geoms that hands and fingers touched in any of the episodes, of those outside of each hand."""
    return _touched(entries, True) / (2 * OUTSIDE)


def hand_regard(entries: Entries) -> Optional[float]:
    """The competition's score: the share of steps, over both eyes and both hands."""
    return _regarded(entries, False)


def hand_regard_right(entries: Entries) -> Optional[float]:
    """The same along the axes of the eyes' cameras."""
    return _regarded(entries, True)


def reached(entries: Entries) -> float:
    """The share of episodes with steps in which a described behaviour was reached; 0 if there are none."""
    played = [entry for entry in entries if entry["steps"] > 0]
    return sum(bool(entry.get("reached")) for entry in played) / max(len(played), 1)


def share_held(entry: Mapping[str, Any]) -> float:
    """Of the time for which a described behaviour has to hold, the longest for which it held; 1 once it was reached."""
    if entry.get("reached") or not entry.get("hold_seconds"):
        return float(bool(entry.get("reached")))
    return min(1.0, float(entry["held_seconds"] / entry["hold_seconds"]))


Score = Callable[[Entries], Any]
SCORES: Mapping[str, "tuple[Score, Score]"] = {
    "self_touch": (self_touch, self_touch_right),
    "hand_regard": (hand_regard, hand_regard_right),
}


def _touched(entries: Entries, fingers: bool) -> int:
    found = [_union(entry.get(touch_key(hand, fingers), ()) for entry in entries) for hand in HANDS]
    return sum(len(geoms) for geoms in found)


def _union(lists: Iterable[Iterable[int]]) -> "set[int]":
    return {int(geom) for geoms in lists for geom in geoms}


def _regarded(entries: Entries, in_view: bool) -> Optional[float]:
    steps = sum(entry["steps"] for entry in entries)
    keys = [regard_key(eye, hand, in_view) for eye in EYES for hand in HANDS]
    looked = sum(entry.get(key, 0) for entry in entries for key in keys)
    return looked / (len(keys) * steps) if steps else None


def _complete(entries: List[Mapping[str, Any]], behavior: str) -> bool:
    """Whether the entries have the data for the corrected score."""
    key = touch_key(HANDS[0], True) if behavior == "self_touch" else regard_key(EYES[0], HANDS[0], True)
    return all(key in entry for entry in entries)
