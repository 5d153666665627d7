"""Named access: joints, bodies, ... of one world, or of all worlds of a batch at once.

    hands = world.bodies("left_hand", "right_hand")     # looked up once
    hands.position                                      # (2, 3); of a batch (worlds, 2, 3)
    world.joints("robot:left_elbow").position = -0.5

Quantities of one number (an angle, a mass) have no axis of their own: (n,), or (worlds, n). The values of joints of
different kinds follow one another. docs/guide/time-and-frames.md explains times and frames.
"""

from __future__ import annotations

import ctypes
from typing import Any, List, Optional, Sequence, Tuple, Type, TypeVar, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._handle import Handle, Native
from ._library import LIB, result, text, utf8
from ._strict import reading
from .arguments import index_in, number_of, whole_number
from .constants import Kind, Quantity
from .layout import Fields, Layout, Observation
from .results import Last, Numbers, Results, StepResult
from .selection import Mask, Selection, kind_of
from .selections import Actuators, Bodies, Cameras, Geoms, Joints, Lights, Sensors, Sites

Which = Union[None, str, Sequence[Union[str, int]]]  # names or numbers of some; None: all of a kind
S = TypeVar("S", bound="Selection")


class Access(Handle):
    """Base of worlds and batches: reads and writes by name."""

    world_count: int = 1
    agents: List[Any]  # of each infant: name, actions, mass, height
    action_names: List[str]
    action_low: NDArray[np.float32]
    action_high: NDArray[np.float32]
    layout: Layout
    reward: Numbers  # of the last step, (infants,); of a batch (worlds, infants), as are the next ones
    terminated: NDArray[np.bool_]
    truncated: NDArray[np.bool_]
    outcome: NDArray[np.int32]  # of mimo.Outcome
    terms: Numbers  # parts of the rewards, in the order of layout.terms
    _scene: Any
    _last: Last
    _result: StepResult
    _names_handle: Native  # the environment that looks names up
    _lead: Tuple[int, ...] = ()  # (worlds,) for a batch

    def _take(self, layout: Layout, agents: List[Any]) -> None:
        """Sets the attributes that describe it."""
        self._have(
            layout=layout,
            agents=agents,
            action_names=[action.name for action in layout.actions],
            action_low=reading(np.array([action.low for action in layout.actions], np.float32)),
            action_high=reading(np.array([action.high for action in layout.actions], np.float32)),
        )

    def _show(self, results: Results, views: Observation) -> None:
        """Exposes the results of steps as attributes."""
        self._result, self._last = results.shown(views), Last(views)
        self._have(**results.__dict__)

    @property
    def observation(self) -> Observation:
        """The latest observation of a step, reset or observe, in any block; zeros before the first."""
        sensed = self._last.sensed
        if not isinstance(sensed, Fields):
            named = self.layout.views(sensed) if isinstance(sensed, np.ndarray) else Fields(sensed)
            sensed = self._last.sensed = named
        return sensed

    @property
    def action(self) -> Optional[NDArray[np.float32]]:
        """The actions of the last step, within their bounds: (actions,), of a batch (worlds, actions).

        None if the step was given none, and after a reset of all worlds.
        """
        given = self._last.actions
        return None if given is None else reading(np.clip(given, self.action_low, self.action_high))

    def bodies(self, *names: str) -> Bodies:
        """Rigid bodies by name; without names, all of them."""
        return self._select(Bodies, names)

    def joints(self, *names: str) -> Joints:
        """Joints by name; without names, all of them."""
        return self._select(Joints, names)

    def geoms(self, *names: str) -> Geoms:
        """Shapes of bodies by name; without names, all of them."""
        return self._select(Geoms, names)

    def sites(self, *names: str) -> Sites:
        """Marked places on bodies by name; without names, all of them."""
        return self._select(Sites, names)

    def cameras(self, *names: str) -> Cameras:
        """Cameras by name; without names, all of them."""
        return self._select(Cameras, names)

    def actuators(self, *names: str) -> Actuators:
        """Motors by name; without names, all of them."""
        return self._select(Actuators, names)

    def sensors(self, *names: str) -> Sensors:
        """MuJoCo's sensors by name; without names, all of them."""
        return self._select(Sensors, names)

    def lights(self, *names: str) -> Lights:
        """Lights by name; without names, all of them."""
        return self._select(Lights, names)

    def get(self, quantity: Quantity, which: Which = None, now: bool = False, dtype: Any = np.float64) -> Numbers:
        """Reads a quantity of elements, by names or numbers, or of all of its kind; in a batch of all worlds.

        Poses and velocities belong to the start of the last physics step, with `now` to the current positions.
        `dtype` is float64 or float32.
        """
        what = Quantity(whole_number("quantity", quantity, Quantity))
        return self._some(what, which)._get(what, now, dtype)

    def set(self, quantity: Quantity, values: ArrayLike, which: Which = None, mask: Mask = None) -> None:
        """Writes a quantity of elements, by names or numbers, or of all of its kind.

        In a batch `values` has a row for each world, or is the same for all; `mask` selects worlds.
        """
        what = Quantity(whole_number("quantity", quantity, Quantity))
        self._some(what, which)._set(what, values, mask)

    def find(self, kind: Kind, name: str) -> int:
        """The number of an element, by its name."""
        number = whole_number("kind", kind, Kind)
        return int(result(ctypes.c_int32, LIB.mimo_env_find, self._names_handle, number, utf8(name)))

    def name(self, kind: Kind, number: int) -> str:
        """The name of an element, "" if it has none."""
        which = (whole_number("kind", kind, Kind), number_of("number", number, 31))
        return text(result(ctypes.c_char_p, LIB.mimo_env_name, self._names_handle, *which))

    def count(self, kind: Kind) -> int:
        """The number of elements of a kind."""
        number = whole_number("kind", kind, Kind)
        return int(result(ctypes.c_size_t, LIB.mimo_env_count, self._names_handle, number))

    def random(self, count: int, mask: Mask = None) -> Numbers:
        """Random numbers from 0 to 1: (count,); of a batch (worlds, count), 0 where mask is False."""
        raise NotImplementedError

    def __repr__(self) -> str:
        worlds = f"{self.world_count} x " if self._lead else ""
        counts = f"{len(self.agents)} infants, {len(self.action_names)} actions"
        fields = [f"{field.name} {field.shape}" for field in self.layout.fields.values()]
        return f"<mimo.{type(self).__name__} {worlds}{self._scene.source}: {counts}; {', '.join(fields)}>"

    def world(self, index: int) -> Any:
        """One of the worlds, 0 to world_count - 1, as a mimo.World; a world is its own number 0."""
        raise NotImplementedError

    def contacts(self, world: int) -> Any:
        """The contacts in one of the worlds, 0 to world_count - 1."""
        raise NotImplementedError

    def _agent(self, agent: int) -> int:
        return 0 if agent == 0 else index_in("agent", agent, len(self.agents))  # the usual case, in every step

    def _select(self, kind: Type[S], names: Tuple[str, ...]) -> S:
        ids = [self.find(kind.kind, name) for name in names] or range(self.count(kind.kind))
        return kind(self, np.array(ids, np.int32))

    def _some(self, quantity: Quantity, which: Which) -> Selection:
        """Selects elements of the quantity's kind."""
        kind = kind_of(quantity)
        if which is None:
            ids: Any = range(self.count(kind))
        else:
            some = [which] if isinstance(which, str) else which
            ids = [self.find(kind, one) if isinstance(one, str) else number_of("which", one, 31) for one in some]
        return Selection(self, np.array(ids, np.int32), kind)

    def _read(self, quantity: int, ids: NDArray[np.int32], values: Numbers) -> None:
        raise NotImplementedError

    def _write(self, quantity: int, ids: NDArray[np.int32], values: Numbers, mask: Mask) -> None:
        raise NotImplementedError
