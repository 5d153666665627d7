"""What a step gives beside the observation: arrays that are made once and that every step writes to."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Dict, NamedTuple, Optional, Union

import numpy as np
from numpy.typing import NDArray

from . import _abi
from .layout import Layout, Observation

Numbers = NDArray[np.float64]


@dataclass(frozen=True)
class StepResult:
    """What a step gave; of a batch with its worlds in front.

    The arrays belong to the world or batch and change with its next step.
    """

    observation: Observation
    reward: Numbers  # one an infant
    terminated: NDArray[np.bool_]
    truncated: NDArray[np.bool_]
    outcome: NDArray[np.int32]  # one an infant, of mimo.Outcome, also where that does not end the episode
    terms: Numbers  # what the rewards are the sums of, in the order of layout.terms


class Followed(NamedTuple):
    """What a step of a known movement gave."""

    observation: Observation
    forces: Numbers  # physics steps x degrees of freedom: what the movement takes, N or Nm


class Last:
    """What was done and sensed last: the one place of it, which everything that shows a world looks at."""

    __slots__ = ("actions", "seen", "sensed", "times")

    def __init__(self, sensed: Observation) -> None:
        self.actions: Optional[NDArray[np.float32]] = None  # as they were given
        self.sensed: Union[Observation, NDArray[np.uint8]] = sensed  # or a block, until somebody asks for its fields
        self.times = 0  # how often something was sensed
        self.seen = 0  # of a world in a batch: how often the batch had sensed then


class Results:
    """The arrays of a world, or of a batch with its worlds in front."""

    def __init__(self, layout: Layout, *lead: int) -> None:
        each = (*lead, layout.agents)
        self.reward = np.zeros(each)
        self.terminated = np.zeros(each, np.bool_)
        self.truncated = np.zeros(each, np.bool_)
        self.outcome = np.zeros(each, np.int32)
        self.terms = np.zeros((*lead, len(layout.terms)))

    def of_world(self, index: int) -> "Results":
        """The rows of one world of a batch."""
        rows = Results.__new__(Results)
        rows.__dict__.update({name: array[index] for name, array in self.__dict__.items()})
        return rows

    def shown(self, observation: Observation) -> StepResult:
        """As steps return them."""
        return StepResult(observation, **self.__dict__)

    def places(self) -> Dict[str, Any]:
        """Where they are: members of the library's structs."""
        places = {name: array.ctypes.data for name, array in self.__dict__.items()}
        return {**places, "agent_count": self.reward.size, "term_count": self.terms.size}

    def for_world(self) -> _abi.EnvResults:
        """As the library's struct, for a world."""
        return _abi.EnvResults(**self.places())
