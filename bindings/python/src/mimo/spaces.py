"""Gymnasium's spaces of the library's fields and actions, and of a task's fields."""

from __future__ import annotations

from typing import Any, Dict, Iterable, Mapping, Sequence

import numpy as np
from gymnasium import spaces
from gymnasium.vector.utils import batch_space
from numpy.typing import NDArray

from .layout import Field, Observation
from .tasks import GOALS

NONE: Mapping[str, Any] = {}


class View:
    """Observations of an environment: a dict by field name, or with `flatten` one row of numbers.

    With goals, the row is named "observation" beside them, as in Gymnasium's GoalEnv.
    """

    def __init__(
        self, fields: Mapping[str, Field], own: Mapping[str, spaces.Box] = NONE, flatten: bool = False
    ) -> None:
        boxes: Dict[str, spaces.Space[Any]] = {**{name: field_box(field) for name, field in fields.items()}, **own}
        self._flatten = flatten
        self._goals = [name for name in GOALS if name in boxes]
        self.space: spaces.Space[Any] = spaces.Dict(boxes)
        if flatten:
            row = flat_box([box for name, box in boxes.items() if name not in self._goals])
            goals = {name: boxes[name] for name in self._goals}
            self.space = spaces.Dict({"observation": row, **goals}) if goals else row

    def show(self, views: Observation, own: Mapping[str, NDArray[Any]] = NONE, worlds: int = 0) -> Any:
        """The observation; `worlds` is the length of the arrays' first axis."""
        if own:
            views = {**views, **own}
        if not self._flatten:
            return views
        row = flat({name: it for name, it in views.items() if name not in self._goals}, worlds)
        return {"observation": row, **{name: views[name] for name in self._goals}} if self._goals else row


def field_box(field: Field) -> spaces.Box:
    """The space of one field."""
    return spaces.Box(field.low, field.high, field.shape, field.dtype.type)


def flat_box(boxes: Sequence[Any]) -> spaces.Box:
    """The space of several arrays as one row of numbers."""
    low, high = (np.concatenate([getattr(box, end).ravel() for box in boxes]) for end in ("low", "high"))
    return spaces.Box(low.astype(np.float32), high.astype(np.float32), dtype=np.float32)


def action_box(low: NDArray[np.float32], high: NDArray[np.float32]) -> spaces.Box:
    """The space of actions."""
    return spaces.Box(low, high, dtype=np.float32)


def of_worlds(space: spaces.Space[Any], worlds: int) -> spaces.Space[Any]:
    """Gymnasium's space of so many worlds, whose bounds are views of the bounds of one, not a copy for each."""
    if isinstance(space, spaces.Dict):
        return spaces.Dict({name: of_worlds(one, worlds) for name, one in space.items()})
    batch = batch_space(space, worlds)
    if isinstance(space, spaces.Box):
        for name in ("low", "high", "bounded_below", "bounded_above"):
            setattr(batch, name, np.broadcast_to(getattr(space, name), (worlds, *space.shape)))
    return batch


def flat(observation: Observation, worlds: int = 0) -> NDArray[np.float32]:
    """All fields as one row of numbers, in the order of the fields; one row per world."""
    lead = (worlds,) if worlds else ()
    parts = [field.reshape((*lead, -1)) for field in observation.values()]
    return np.concatenate(parts, axis=-1, dtype=np.float32)


def split(fields: Mapping[str, Field], names: Iterable[str]) -> Dict[str, Dict[str, Field]]:
    """The fields of each agent, without the prefix of its name."""
    return {
        agent: {name[len(agent) + 1 :]: field for name, field in fields.items() if name.startswith(agent + "/")}
        for agent in names
    }
