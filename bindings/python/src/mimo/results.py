"""Results of steps beside the observation: arrays that every step overwrites."""

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
    """The result of a step; in a batch the first axis is the world.

    The arrays belong to the world or batch, and its next step overwrites them.
    """

    observation: Observation
    reward: Numbers  # one per infant
    terminated: NDArray[np.bool_]
    truncated: NDArray[np.bool_]
    outcome: NDArray[np.int32]  # one per infant, of mimo.Outcome, also if the episode continues
    terms: Numbers  # parts of the rewards, in the order of layout.terms


class Followed(NamedTuple):
    """The result of a step of a known movement."""

    observation: Observation
    forces: Numbers  # physics steps x degrees of freedom, N or Nm


class Last:
    """The last actions and observation, which everything that shows a world reads."""

    __slots__ = ("actions", "seen", "sensed", "times")

    def __init__(self, sensed: Observation) -> None:
        self.actions: Optional[NDArray[np.float32]] = None  # unclipped
        self.sensed: Union[Observation, NDArray[np.uint8]] = sensed  # or a block, until its fields are read
        self.times = 0  # number of observations
        self.seen = 0  # of a world in a batch: the batch's `times` at that moment


class Results:
    """The arrays of a world or a batch."""

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
        """The result that steps return."""
        return StepResult(observation, **self.__dict__)

    def places(self) -> Dict[str, Any]:
        """Their addresses, as members of the C structs."""
        places = {name: array.ctypes.data for name, array in self.__dict__.items()}
        return {**places, "agent_count": self.reward.size, "term_count": self.terms.size}

    def for_world(self) -> _abi.EnvResults:
        """The C struct of a world."""
        return _abi.EnvResults(**self.places())
