"""Gymnasium's spaces, from the fields and action bounds that the library describes."""

from __future__ import annotations

from typing import Dict, Iterable, Mapping

import numpy as np
from gymnasium import spaces
from numpy.typing import NDArray

from .layout import Field, Layout, Observation


def field_box(field: Field) -> spaces.Box:
    """The space of one field."""
    return spaces.Box(field.low, field.high, field.shape, field.dtype.type)


def dict_space(fields: Mapping[str, Field]) -> spaces.Dict:
    """The space of several fields, by name."""
    return spaces.Dict({name: field_box(field) for name, field in fields.items()})


def flat_box(fields: Iterable[Field]) -> spaces.Box:
    """The space of all fields as one row of numbers."""
    listed = list(fields)
    low = [np.full(int(np.prod(field.shape)), field.low) for field in listed]
    high = [np.full(int(np.prod(field.shape)), field.high) for field in listed]
    return spaces.Box(np.concatenate(low).astype(np.float32), np.concatenate(high).astype(np.float32), dtype=np.float32)


def observation_space(layout: Layout, flatten: bool) -> spaces.Space[object]:
    """The space of a world's observations."""
    return flat_box(layout.fields.values()) if flatten else dict_space(layout.fields)


def action_box(low: NDArray[np.float32], high: NDArray[np.float32]) -> spaces.Box:
    """The space of actions."""
    return spaces.Box(low, high, dtype=np.float32)


def flat(observation: Observation, worlds: int = 0) -> NDArray[np.float32]:
    """All fields as one row of numbers, in the order of the fields; a row a world for several worlds."""
    lead = (worlds,) if worlds else ()
    parts = [field.reshape((*lead, -1)) for field in observation.values()]
    return np.concatenate(parts, axis=-1, dtype=np.float32)


def split(fields: Mapping[str, Field], names: Iterable[str]) -> Dict[str, Dict[str, Field]]:
    """The fields of each of several agents, without the agents' names in front."""
    return {
        agent: {name[len(agent) + 1 :]: field for name, field in fields.items() if name.startswith(agent + "/")}
        for agent in names
    }
