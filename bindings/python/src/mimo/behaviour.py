"""Behaviours: what a scene's document measures of its infant, and when infants are known to show it."""

from __future__ import annotations

from typing import NamedTuple, Optional, Tuple

from . import _abi
from ._library import text


class Norm(NamedTuple):
    """At which age infants show a behaviour, months; None where it is not known."""

    early: Optional[float]  # the first infants
    age: Optional[float]  # the middle infant
    late: Optional[float]  # all but the last infants
    about: str  # which statistics these are
    source: str  # who published them, or "not found" and what was looked for


class Behaviour(NamedTuple):
    """What the infant of a scene is to do whose task is "behaviour"."""

    about: str  # "sits without support"
    measure: str  # what is measured: "tilt upper_body z"
    unit: str  # of the measure and its threshold; "" for a share
    at_most: bool  # the measure reaches its threshold from above
    threshold: float  # lengths are those of the body of 18 months, and are scaled with the infant's stature
    conditions: Tuple[str, ...]  # what else has to hold
    hold_seconds: float  # how long everything has to hold
    episode_seconds: float
    norm: Norm


def behaviour_of(raw: _abi.Behaviour) -> Behaviour:
    """From the struct of the library."""
    conditions = text(raw.conditions)
    return Behaviour(
        about=text(raw.about),
        measure=text(raw.measure),
        unit=text(raw.unit),
        at_most=bool(raw.at_most),
        threshold=raw.threshold,
        conditions=tuple(conditions.split("; ")) if conditions else (),
        hold_seconds=raw.hold_seconds,
        episode_seconds=raw.episode_seconds,
        norm=Norm(
            early=raw.norm_early or None,
            age=raw.norm_age or None,
            late=raw.norm_late or None,
            about=text(raw.norm),
            source=text(raw.norm_source),
        ),
    )
