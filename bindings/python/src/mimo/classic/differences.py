"""Differences from the original's numbers, by environment; docs/differences.md explains them."""

from __future__ import annotations

from typing import Any, Dict, List, Tuple

ALL = (
    "touch: sensors are where they belong, forces of any direction are felt; at scale 1 there are 5685 sensors on the "
    "mitten body (5725 there), 5299 on the other (as there)",
    "touch_function 'normal_force': the force along the contact's normal; three numbers per sensor, against the skin",
    "everything random follows reset(seed=...)",
)
BY_NAME: Dict[str, Tuple[str, ...]] = {
    "MIMoReachEnv": (
        "reward: success is a touch of the ball, worth 100; parameters={'reach/original_rules': 1} gives the "
        "original's: a ball that was moved by 1 cm, and the distance is subtracted",
        "gaze: all six joints of the eyes follow the ball",
    ),
    "MIMoSelfBodyEnv": (
        "desired_goal: drawn from 12 bodies, not from 11 of which some were wrong",
        "reward: the distance is that to the target, counts when the fingers feel any force, and the target's success "
        "is any force on it",
        "touch: 600 sensors (612 there)",
    ),
    "MIMoCatchEnv": (
        "start: the hand is open and the ball's place is random",
        "touch: 1998 sensors (1976 there)",
        "muscles: activation goes on once a physics step, not once more with each action",
    ),
    "MIMoMuscleDummyEnv": ("muscles: activation goes on once a physics step, not once more with each action",),
}


class DifferenceWarning(UserWarning):
    """One difference from the original."""


def differences_of(kind: Any) -> List[str]:
    """The differences of an environment's class, one line each."""
    own = [line for base in kind.__mro__ for line in BY_NAME.get(base.__name__, ())]
    return [*own, *ALL]
