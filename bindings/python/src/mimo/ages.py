"""Ages and growth of infants as C structs."""

from __future__ import annotations

import ctypes
from typing import Any, Dict, List, Mapping, Optional, Sequence, Tuple, Union

from . import _abi
from ._library import defaults
from .arguments import whole_number
from .constants import GrowthModel
from .options import GrowthOptions, fill

# Months, or options of growth: {"age": 6, "sex": "female"}. None: unchanged.
Age = Union[float, Mapping[str, Any], None]


def growth_from(options: Mapping[str, Any]) -> _abi.Growth:
    """The C struct of one infant's growth."""
    growth = defaults(_abi.Growth)
    members = dict(options)
    growth.model = whole_number("growth", members.pop("growth", growth.model), GrowthModel)
    growth.matures_apart = "physiological_age" in members
    fill(growth, members, GrowthOptions)
    return growth


def growths(ages: Sequence[Age]) -> Tuple[Any, int]:
    """An array of pointers for a config and its length."""
    pointers: Any = ctypes.POINTER(_abi.Growth) * len(ages)
    return pointers(*map(_pointer, ages)), len(ages)


def _pointer(age: Age) -> Optional[Any]:
    if age is None:
        return None
    return ctypes.pointer(growth_from(age if isinstance(age, Mapping) else {"age": age}))


def changed(growth: Mapping[str, Any], age: Age) -> Dict[str, Any]:
    """A growth with another age or other options; the rest stays, for example the sex."""
    if age is None:
        return dict(growth)
    return {**growth, **(age if isinstance(age, Mapping) else {"age": age})}


def of_agents(growths: Sequence[Mapping[str, Any]], age: Any) -> List[Dict[str, Any]]:
    """The new growth of each infant, by one age for all or a list with one for each."""
    ages = list(age) if isinstance(age, (list, tuple)) else [age] * len(growths)
    if len(ages) != len(growths):
        raise ValueError(f"there are {len(ages)} ages, expected {len(growths)}, one for each infant")
    return [changed(growth, one) for growth, one in zip(growths, ages)]


def listed(name: str, ages: Any) -> Sequence[Age]:
    """Checks a list of ages."""
    if isinstance(ages, (str, Mapping)) or not hasattr(ages, "__len__"):
        raise TypeError(f"{name} is {ages!r}, expected ages: months, or options of growth")
    return list(ages)
