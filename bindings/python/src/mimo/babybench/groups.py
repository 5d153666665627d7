"""The parts of the body that a configuration switches, with their joints, motors and skin."""

from __future__ import annotations

import re
from typing import Dict, Iterable, List, Tuple

GROUPS = ("body", "head", "eyes", "arms", "hands", "fingers", "legs", "feet")  # in the order of the action

# Starts of names after "robot:", "act:" and the side. All others belong to the fingers.
_STARTS: Tuple[Tuple[str, str], ...] = (
    ("eyes", r"eye"),
    ("arms", r"shoulder|elbow|upper_arm|lower_arm"),
    ("hands", r"hand|wrist"),
    ("legs", r"hip|knee|upper_leg|lower_leg"),
    ("feet", r"foot|toes|big_toe"),
)


def group_of(name: str) -> str:
    """The group of a joint, motor or body by its name."""
    side, part = re.fullmatch(r"(?:robot:|act:)?(left_|right_)?(.*)", name).groups()  # type: ignore[union-attr]
    if side is None:
        return "head" if part.startswith("head") else "body"
    for group, start in _STARTS:
        if re.match(start, part):
            return group
    return "fingers"


def of_groups(names: Iterable[str], groups: Iterable[str]) -> List[str]:
    """The names that belong to some groups, in their order."""
    wanted = set(groups)
    return [name for name in names if group_of(name) in wanted]


def in_order(names: Iterable[str]) -> List[str]:
    """Names by group, in the order of actions; a foot's big toe is last in its group."""
    ordered = sorted(names, key=lambda name: GROUPS.index(group_of(name)))
    for place, (name, following) in enumerate(zip(ordered, ordered[1:])):
        if name.endswith("_big_toe") and following == name.replace("_big_toe", "_toes"):
            ordered[place : place + 2] = [following, name]
    return ordered


def flags(prefix: str) -> Dict[str, str]:
    """The switches of all groups: {"act_hands": "hands", ...}."""
    return {f"{prefix}_{group}": group for group in GROUPS}
