"""Many worlds of one scene, stepped by the library's threads. Their arrays are stacked along the first axis."""

from __future__ import annotations

import atexit
import ctypes
import weakref
from typing import TYPE_CHECKING, Any, Dict, Iterable, List, Optional, Sequence, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _abi
from ._handle import IN_MAIN, Native
from ._library import LIB, check, defaults, message_text, raise_error, result
from .access import Access
from .ages import Age, changed, growths, listed
from .arguments import index_in, known_keywords, number_of, numbers_in, whole_number
from .constants import Autoreset, Kind, Movement, Quantity
from .contacts import contacts_of, step_contacts_of
from .errors import Error, make_error
from .layout import Layout, Observation
from .options import Options, refuse_unknown
from .own_sense import fill_all
from .results import Last, Numbers, Results, StepResult
from .scene import Scene, prepare
from .selection import Mask
from .selections import Contacts, StepContacts
from .states import LoadReport, reported
from .world import World, agents_of, env_config

if TYPE_CHECKING:
    from typing_extensions import Unpack

Seeds = Optional[Union[int, Sequence[Optional[int]]]]


class Row:
    """One world's row of a batch's observations; the world may also observe on its own."""

    def __init__(self, batch: "Batch", index: int) -> None:
        self._batch, self._index = weakref.ref(batch), index

    def look(self, last: Last) -> None:
        """Takes the batch's observation if it is newer than the world's."""
        batch = self._batch()
        if batch is not None and last.seen != batch._last.times:
            last.sensed = {name: field[self._index] for name, field in batch.observation.items()}
            last.seen = batch._last.times

    def sensed_itself(self, last: Last) -> None:
        """Marks the world's observation as newer than the batch's."""
        batch = self._batch()
        if batch is not None:
            last.seen = batch._last.times


_working: "weakref.WeakSet[Batch]" = weakref.WeakSet()  # batches with a step in flight


def _wait_for_sent() -> None:
    """Waits while Python still runs: a task in Python could not return to the batch's threads afterwards."""
    for batch in list(_working):
        if not batch.closed:
            batch.drop_sent()


if IN_MAIN:  # a subinterpreter that waits here would never get Python's lock back
    atexit.register(_wait_for_sent)


class Batch(Access):
    """Many worlds. World i behaves exactly like a single World with the i-th seed and the i-th actions.

    `autoreset` selects what happens when an episode ends, see mimo.Autoreset. A world whose simulation fails is
    truncated and starts a new episode; with `restart_failed=False` the step raises mimo.SimulationError instead. With
    `ages` (months, or options of growth) the infants of world i have the i-th age; a shorter list repeats.
    """

    blocks: NDArray[np.uint8]  # observations of step, reset and receive, one row per world
    final_blocks: NDArray[np.uint8]  # with SAME_STEP: last observations of ended episodes
    was_reset: NDArray[np.bool_]
    status: NDArray[np.int32]  # of mimo.Status, one per world

    def __init__(
        self,
        scene: Union[str, Scene] = "benchmark",
        worlds: int = 1,
        *,
        threads: int = 0,
        autoreset: Union[Autoreset, str] = Autoreset.NONE,
        restart_failed: bool = True,
        ages: Optional[Sequence[Age]] = None,
        **options: Unpack[Options],
    ) -> None:
        refuse_unknown(options, Options, Batch.__init__)
        self._scene, self._options = prepare(scene, options)
        mode = whole_number("autoreset", autoreset, Autoreset)
        self._settings: Dict[str, Any] = {"threads": threads, "autoreset": mode, "restart_failed": restart_failed}
        self._settings["ages"] = None if ages is None else self._merged(listed("ages", ages))
        self._create(worlds)
        self._lead = (self.world_count,)
        # Worlds keep the batch alive, the batch does not keep them.
        self._worlds: "weakref.WeakValueDictionary[int, World]" = weakref.WeakValueDictionary()
        self._names_handle = self._world_handle(0)
        layout = Layout(self._handle, LIB.mimo_batch_layout)
        self._take(layout, agents_of(self._names_handle, layout.agents))
        self._make_arrays()

    def _create(self, worlds: int) -> None:
        config = defaults(_abi.BatchConfig)
        config.worlds = number_of("worlds", worlds)
        self._have(world_count=config.worlds)
        config.threads = number_of("threads", self._settings["threads"])
        config.autoreset, config.restart_failed = self._settings["autoreset"], self._settings["restart_failed"]
        if self._settings["ages"] is not None:
            config.cohort, config.cohort_count = growths(self._settings["ages"])
        handle = ctypes.c_void_p()
        check(LIB.mimo_batch_create(self._scene._handle, env_config(self._options), config, handle))
        self._own(handle.value, LIB.mimo_batch_destroy)

    def _make_arrays(self) -> None:
        worlds = self.world_count
        self._have(
            blocks=self.layout.new_block(worlds),
            final_blocks=self.layout.new_block(worlds),
            was_reset=np.zeros(worlds, np.bool_),
            status=np.zeros(worlds, np.int32),
        )
        self._views = self.layout.views(self.blocks)
        self._results = Results(self.layout, worlds)
        self._show(self._results, self._views)
        places = self._places()
        self._results_place = ctypes.byref(places)
        # A step in flight writes to these arrays, and may outlive this object.
        self._handle.keeps = [places, self.blocks, self.final_blocks, self._result, self.was_reset, self.status]
        self._sent: List[Any] = []  # arrays of the step in flight; the handle keeps them, too
        self._handle.keeps.append(self._sent)
        if self._scene._task is not None:  # the task is called with these worlds during steps
            judged = [World._of_batch(self, index, keeps=False) for index in range(worlds)]
            self._handle.keeps += [self._scene._task, judged]
            self._scene._task.worlds.update((world._handle.value, world) for world in judged)

    def _places(self) -> _abi.BatchResults:
        """The C struct with the addresses of the results."""
        places = _abi.BatchResults(
            **self._results.places(),
            status=self.status.ctypes.data,
            was_reset=self.was_reset.ctypes.data,
            worlds=self.world_count,
        )
        if self._settings["autoreset"] == Autoreset.SAME_STEP:
            places.final_blocks, places.final_bytes = self.final_blocks.ctypes.data, self.final_blocks.nbytes
        return places

    @property
    def threads(self) -> int:
        """The number of threads that step the worlds."""
        return int(result(ctypes.c_size_t, LIB.mimo_batch_size, self._handle, None))

    # ---- Stepping ------------------------------------------------------------------------------------------------

    @known_keywords
    def reset(self, seeds: Seeds = None, mask: Mask = None, ages: Optional[Sequence[Age]] = None) -> Observation:
        """Starts episodes. One seed s means s, s + 1, ...; without seeds, worlds continue their random numbers.

        Of a list of seeds, one per world, None lets that world continue its random numbers. With `ages`, one per
        world, the infants get that age; None leaves them unchanged.
        """
        self.reset_into(self.blocks, seeds, mask, ages)
        return self._views

    @known_keywords
    def reset_into(
        self,
        blocks: Optional[NDArray[np.uint8]],
        seeds: Seeds = None,
        mask: Mask = None,
        ages: Optional[Sequence[Age]] = None,
    ) -> None:
        """As reset, with blocks of your own (layout.new_block(worlds)); None skips the senses."""
        growth = None if ages is None else self._growths(ages)
        if mask is None:
            self._last.actions = None
        for numbers, chosen in self._parts(seeds, self._mask(mask)):
            count = 0 if numbers is None and chosen is None and growth is None else self.world_count
            config = _abi.BatchResetConfig(seeds=_data(numbers), mask=_data(chosen), worlds=count, growth=growth)
            check(LIB.mimo_batch_reset(self._handle, config, *_place(blocks)))
            self._sense(blocks, chosen)
        if ages is not None:
            self._remember(ages, mask)

    def _parts(self, seeds: Seeds, mask: Optional[NDArray[np.uint8]]) -> List[Tuple[Any, Optional[NDArray[np.uint8]]]]:
        """Seeds and masks of the calls that a reset makes: worlds without a seed need a call of their own."""
        if not isinstance(seeds, (list, tuple)) or None not in seeds:
            return [(self._seeds(seeds), mask)]
        seeded = np.array([seed is not None for seed in seeds], np.uint8)
        numbers = self._seeds([0 if seed is None else seed for seed in seeds])
        chosen = np.ones_like(seeded) if mask is None else mask
        parts: List[Tuple[Any, NDArray[np.uint8]]] = [(numbers, chosen & seeded), (None, chosen & (1 - seeded))]
        return [part for part in parts if part[1].any()]

    def _growths(self, ages: Sequence[Age]) -> Any:
        array, count = growths(self._merged(listed("ages", ages)))
        if count != self.world_count:
            raise ValueError(f"there are {count} ages, expected {self.world_count}, one for each world")
        return array

    def _merged(self, ages: Sequence[Age]) -> List[Age]:
        """Ages, completed with the growth of the scene's first infant."""
        usual = self._scene._growths[0] if self._scene._growths else {}
        return [None if age is None else changed(usual, age) for age in ages]

    def _remember(self, ages: Sequence[Age], mask: Mask) -> None:
        before = self._settings["ages"] or [None]
        now = [before[i % len(before)] for i in range(self.world_count)]
        for i, age in enumerate(ages):
            if age is not None and (mask is None or mask[i]):
                now[i] = age
        self._settings["ages"] = now
        for world in self._worlds.values():
            world._have(agents=agents_of(world._handle, self.layout.agents))
        self.layout._renew()

    def step(self, actions: Optional[ArrayLike] = None) -> StepResult:
        """Steps all worlds; actions are worlds x actions, None keeps the motors' commands."""
        self.step_into(self.blocks, actions)
        return self._result

    def step_into(self, blocks: Optional[NDArray[np.uint8]], actions: Optional[ArrayLike] = None) -> None:
        """As step, with blocks of your own; None skips the senses."""
        given = self._actions(actions)
        self._raise(LIB.mimo_batch_step(self._handle, *_place_of(given), *_place(blocks), self._results_place))
        self._sense(blocks)

    def _sense(self, blocks: Optional[NDArray[np.uint8]], mask: Optional[NDArray[np.uint8]] = None) -> None:
        """Remembers the blocks of the latest observation, of all worlds or those of a mask; None: there was none."""
        if blocks is None:
            return
        if self._scene._own_senses:
            self._fill(blocks)
        last = self._last
        for index, world in self._worlds.items() if mask is not None else ():
            if not mask[index] and world._last.seen == last.times:  # type: ignore[index]  # it has observed on its own
                world._last.seen += 1
        last.sensed, last.times = self._views if blocks is self.blocks else blocks, last.times + 1

    def _fill(self, blocks: NDArray[np.uint8]) -> None:
        senses = self._scene._own_senses
        fill_all(senses, self._views if blocks is self.blocks else self.layout.views(blocks), alone=False)
        if self._settings["autoreset"] == Autoreset.SAME_STEP and self.was_reset.any():
            fill_all(senses, self.layout.views(self.final_blocks), alone=False)

    def _row_of(self, index: int) -> Row:
        return Row(self, index)

    def send(self, actions: Optional[ArrayLike] = None, blocks: Optional[NDArray[np.uint8]] = None) -> None:
        """Starts a step and returns; receive() waits for it. By default it writes to the batch's own blocks."""
        given = self._actions(actions)
        given = None if given is None else given.copy()  # the caller may reuse its array
        target = self.blocks if blocks is None else blocks
        place = _place(target)
        # Kept before sending: an interrupt may come at any moment from here on.
        self._sent.append((given, target))
        _working.add(self)
        status = LIB.mimo_batch_send(self._handle, *_place_of(given), *place, self._results_place)
        if status != 0:
            self._sent.pop()
            raise_error(status)

    def drop_sent(self) -> None:
        """Waits for a step that an interrupt may have left in flight, and drops its results."""
        if self._sent:
            LIB.mimo_batch_receive(self._handle)  # fails if the interrupt came before the step was sent
            self._sent.clear()

    def receive(self) -> StepResult:
        """Waits for the step in flight."""
        status = LIB.mimo_batch_receive(self._handle)
        blocks = self._sent[-1][1] if self._sent else None
        self._sent.clear()
        self._raise(status)
        self._sense(blocks)
        return self._result

    def observe_into(self, blocks: NDArray[np.uint8], mask: Mask = None) -> None:
        """Observes the current states without changing trajectories."""
        chosen = self._mask(mask)
        count = 0 if chosen is None else self.world_count
        check(LIB.mimo_batch_observe(self._handle, _data(chosen), count, *_place(blocks)))
        self._sense(blocks, chosen)

    def __len__(self) -> int:
        return self.world_count

    def __getitem__(self, index: Any) -> Any:
        raise TypeError(
            f"a Batch has no [{index!r}]; a world of it is world({index!r}), and arrays have worlds in front"
        )

    def contacts(self, world: int) -> Contacts:
        """The contacts in one world, of its last physics step or its reset."""
        return contacts_of(self._world_handle(world))

    def step_contacts(self, world: int) -> StepContacts:
        """The contacts in one world during its last step; needs the option step_contacts=True."""
        return step_contacts_of(self._world_handle(world))

    def world(self, index: int) -> World:
        """One world, between the batch's own calls: its contacts, pictures, state."""
        index = index_in("world", index, self.world_count)
        world = self._worlds.get(index)
        if world is None:
            world = World._of_batch(self, index, keeps=True)
            self._worlds[index] = world
        return world

    def error(self, index: int) -> Optional[Error]:
        """The error of one world in the last call, or None."""
        status, message = ctypes.c_int32(), ctypes.c_char_p()
        number = index_in("world", index, self.world_count)
        check(LIB.mimo_batch_world_error(self._handle, number, status, message))
        return make_error(status.value, message_text(message.value)) if status.value else None

    def close(self) -> None:
        """Frees the batch and its worlds, after a step in flight and the calls of other threads have ended."""
        for world in list(self._worlds.values()):
            world.close()
        super().close()

    # ---- Named access and states ---------------------------------------------------------------------------------

    def _read(self, quantity: int, ids: NDArray[np.int32], values: Numbers) -> None:
        arguments = (quantity, ids.ctypes.data, len(ids), None, 0, values.ctypes.data, values.size)
        get = LIB.mimo_batch_get if values.dtype == np.float64 else LIB.mimo_batch_get_float
        check(get(self._handle, *arguments))

    def _write(self, quantity: int, ids: NDArray[np.int32], values: Numbers, mask: Mask) -> None:
        chosen = self._mask(mask)
        count = 0 if chosen is None else self.world_count
        arguments = (quantity, ids.ctypes.data, len(ids), _data(chosen), count, values.ctypes.data, values.size)
        check(LIB.mimo_batch_set(self._handle, *arguments))

    def random(self, count: int, mask: Mask = None) -> Numbers:
        """Numbers from 0 to 1, (worlds, count), each world's from its own random stream; 0 where mask is False."""
        values = np.zeros((self.world_count, number_of("count", count)))
        for index in range(self.world_count) if mask is None else np.flatnonzero(mask):
            check(LIB.mimo_env_random(self._world_handle(int(index)), values[index].ctypes.data, values.shape[1]))
        return values

    def spontaneous(self, which: int = Movement.ALL) -> NDArray[np.float32]:
        """What all infants' motors do by themselves: actions for the next step, worlds x actions; see World."""
        actions = np.empty((self.world_count, len(self.action_names)), np.float32)
        kinds = whole_number("which", which, Movement)
        check(LIB.mimo_batch_spontaneous(self._handle, kinds, actions.ctypes.data, actions.size))
        return actions

    def set_face(self, name: str, agent: int = 0, mask: Mask = None) -> None:
        """Sets an infant's face, see mimo.faces()."""
        self.set(Quantity.AGENT_FACE, self.find(Kind.FACE, name), [self._agent(agent)], mask)

    def save(self) -> List[bytes]:
        """The states of all worlds."""
        row = result(ctypes.c_size_t, LIB.mimo_batch_state_size, self._handle)
        states = ctypes.create_string_buffer(row * self.world_count)
        check(LIB.mimo_batch_state_save(self._handle, None, 0, states, len(states)))
        worlds = map(self._world_handle, range(self.world_count))
        sizes = [result(ctypes.c_size_t, LIB.mimo_env_state_size, world) for world in worlds]
        raw = states.raw
        return [raw[i * row : i * row + size] for i, size in enumerate(sizes)]

    def load(self, states: Union[bytes, Sequence[bytes]], mask: Mask = None) -> LoadReport:
        """Loads one state into each world, or a single one into all; if one is refused, no world changes.

        Reports on the world in which most memories started fresh.
        """
        if not isinstance(states, bytes) and len(states) not in (1, self.world_count):
            raise ValueError(f"there are {len(states)} states, expected 1 or {self.world_count}")
        row = 0 if isinstance(states, bytes) else max(map(len, states), default=0)
        joined = states if isinstance(states, bytes) else b"".join(state.ljust(row, b"\0") for state in states)
        chosen = self._mask(mask)
        count = 0 if chosen is None else self.world_count
        return reported(LIB.mimo_batch_state_load, self._handle, _data(chosen), count, joined, len(joined))

    def _world_handle(self, index: int) -> Native:
        handle = ctypes.c_void_p()
        check(LIB.mimo_batch_world(self._handle, index_in("world", index, self.world_count), handle))
        world = Native(handle.value)
        world.keeps = self._handle  # a call on the world keeps the batch
        return world

    def __deepcopy__(self, memo: Dict[int, Any]) -> "Batch":
        return _rebuilt(self._scene, self.world_count, {**self._settings, **self._options}, self.save())

    def __reduce__(self) -> Tuple[Any, ...]:
        return _rebuilt, (self._scene, self.world_count, {**self._settings, **self._options}, self.save())

    # ---- Arguments -----------------------------------------------------------------------------------------------

    def _actions(self, actions: Optional[ArrayLike]) -> Optional[NDArray[np.float32]]:
        self._last.actions = None
        if actions is None:
            return None
        shape = (self.world_count, len(self.action_names))
        self._last.actions = np.ascontiguousarray(
            numbers_in("actions", actions, shape, what="a row for each world, a number for each of action_names")
        )
        return self._last.actions

    def _seeds(self, seeds: Seeds) -> Optional[NDArray[np.uint64]]:
        if seeds is None:
            return None
        if not isinstance(seeds, Iterable):
            first = number_of("seed", seeds, 64)
            seeds = range(first, first + self.world_count)
        numbers = [number_of("seed", number, 64) for number in seeds]
        if len(numbers) != self.world_count:
            raise ValueError(f"{len(numbers)} seeds, expected {self.world_count}, one for each world")
        return np.array(numbers, np.uint64)

    def _mask(self, mask: Mask) -> Optional[NDArray[np.uint8]]:
        if mask is None:
            return None
        chosen = np.ascontiguousarray(mask, np.bool_)
        if chosen.shape != self._lead:
            raise ValueError(f"the mask has the shape {chosen.shape}, expected {self._lead}, one for each world")
        return chosen.view(np.uint8)

    def _raise(self, status: int) -> None:
        if status != 0:
            raise_error(status)


def _rebuilt(scene: Scene, worlds: int, options: Dict[str, Any], states: Sequence[bytes]) -> Batch:
    batch = Batch(scene, worlds, **options)
    batch.load(states)
    return batch


def _data(array: Optional[NDArray[Any]]) -> Optional[int]:
    return None if array is None else array.ctypes.data


def _place(blocks: Optional[NDArray[np.uint8]]) -> Tuple[Optional[int], int]:
    if blocks is None:
        return None, 0
    if blocks.dtype != np.uint8 or not blocks.flags.c_contiguous or not blocks.flags.writeable:
        raise ValueError("blocks: expected a contiguous, writable array of uint8, as layout.new_block(worlds) gives it")
    return blocks.ctypes.data, blocks.nbytes


def _place_of(actions: Optional[NDArray[np.float32]]) -> Tuple[Optional[int], int]:
    return (None, 0) if actions is None else (actions.ctypes.data, actions.size)
