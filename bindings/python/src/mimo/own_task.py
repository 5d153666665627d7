"""Tasks that run inside the library's reset and step, as in C; their fields are part of the layout.

For many worlds a mimo.Task is faster, because it judges all of them at once.
"""

from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Any, Callable, Dict, Mapping, Optional, Sequence
from weakref import WeakValueDictionary

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _abi
from ._library import LIB, check, defaults, utf8
from ._strict import Strict
from .arguments import number_of
from .constants import Outcome, Status
from .errors import Error
from .layout import Observation
from .tasks import Judgement, missing

if TYPE_CHECKING:
    from gymnasium import spaces

    from .world import World


class Moment(Strict):
    """The infant that a task judges, and its step. All arrays are copies that stay valid.

    The values of `memory` and `fields` when the method returns are kept, as part of the world's state. Both are 0 at
    the start of an episode.
    """

    world: int  # number of the world in its batch; 0 for a single world
    agent: int  # number of the infant
    step: int  # steps since the reset, including this one; 0 in a reset
    action: Optional[NDArray[np.float32]]  # the infant's actions, within their bounds; None if the step was given none

    def __init__(self, task: "Bound", told: Any, views: Callable[[NDArray[np.uint8]], Observation]) -> None:
        action = _copy(told.action, told.action_count, np.float32) if told.action else None
        self._have(world=told.world, agent=told.agent, step=told.step, action=action)
        self._memory = _copy(told.memory, task.memory, np.float64)
        self._fields = task.split(_copy(told.fields, task.values, np.float32))
        self._block, self._views = (told.block, told.block_bytes), views

    @property
    def memory(self) -> NDArray[np.float64]:
        """WorldTask.memory numbers; writable."""
        return self._memory

    @memory.setter
    def memory(self, numbers: ArrayLike) -> None:
        self._memory = np.asarray(numbers, np.float64)

    @property
    def fields(self) -> Dict[str, NDArray[np.float32]]:
        """WorldTask.fields by name; writable."""
        return self._fields

    @fields.setter
    def fields(self, fields: Dict[str, NDArray[np.float32]]) -> None:
        self._fields = fields

    @property
    def observation(self) -> Optional[Observation]:
        """The observation of this step, by field name; None in a step without senses, in a reset, and afterwards.

        Fields of tasks still have the values of the previous step.
        """
        address, size = self._block
        return self._views(_copy(address, size, np.uint8)) if address else None

    def _end(self, task: "Bound", told: Any) -> None:
        self._block = (None, 0)
        _write(told.memory, np.asarray(self.memory, np.float64), task.memory, "memory")
        if self.fields.keys() != task.shapes.keys():
            raise ValueError(f"moment.fields has {sorted(self.fields)}, expected {sorted(task.shapes)}")
        rows = [np.asarray(self.fields[name], np.float32).reshape(-1) for name in task.shapes]
        _write(told.fields, np.concatenate(rows) if rows else np.empty(0, np.float32), task.values, "fields")


class WorldTask:
    """Derive from it, and give an instance to Scene.set_task. Copies of the scene share it.

    Its methods are called for one infant of one world at a time; in a batch on the library's threads, one after the
    other. If they raise, the step or reset fails with a mimo.TaskError that quotes the exception.
    """

    terms: Sequence[str] = ()  # names of the reward's terms; empty: the reward is one number
    fields: Mapping[
        str, spaces.Box
    ] = {}  # additional fields of the observation: float32, with equal bounds for all elements
    units: Mapping[str, str] = {}  # units of fields: {"goal": "m"}
    frames: Mapping[str, str] = {}  # frames of fields: {"goal": "world"}
    memory: int = 0  # how many numbers the task keeps per world and infant

    def reset(self, world: "World", moment: Moment) -> None:
        """Prepares an episode: moves things, draws numbers from world.random.

        The world accepts all calls except resets, steps and loading a state.
        """

    def evaluate(self, world: "World", moment: Moment) -> Judgement:
        """Judges a step. Positions of bodies belong to the start of its last physics step.

        Its changes to the world, such as a new goal, count from the next step on. Infants are judged in their order.

        With success or failure, `terminated` says whether the episode ends; `info` is not supported.
        """
        raise missing(self, "evaluate(self, world, moment)")

    def __deepcopy__(self, memo: Dict[int, Any]) -> "WorldTask":
        return self


class Bound:
    """A task as the library knows it."""

    def __init__(self, task: WorldTask) -> None:
        if isinstance(task, type):
            raise TypeError(f"task is the class {task.__name__}, expected an object of it: {task.__name__}(...)")
        if not isinstance(task, WorldTask):
            raise TypeError(f"task is {task!r}, expected a mimo.WorldTask; make and make_vec take a mimo.Task")
        self.task, self.name = task, type(task).__name__
        self.memory = number_of("memory", task.memory)
        self.terms = list(task.terms)
        self.shapes = {name: box.shape for name, box in task.fields.items() if self._checked(name, box)}
        self._sizes = {name: (ctypes.c_size_t * len(shape))(*shape) for name, shape in self.shapes.items()}
        self.values = sum(int(np.prod(shape)) for shape in self.shapes.values())
        self.worlds: WeakValueDictionary[int, World] = WeakValueDictionary()  # by their handles
        _bounds[id(self)] = self

    def tell(self, scene: Any) -> None:
        """Sets it as the scene's task."""
        config = defaults(_abi.Task)
        config.user = id(self)
        config.memory_bytes = self.memory * ctypes.sizeof(ctypes.c_double)
        config.reset, config.evaluate = _reset, _evaluate
        names = (ctypes.c_char_p * len(self.terms))(*[utf8(name, "terms") for name in self.terms])
        config.terms, config.term_count = ctypes.cast(names, ctypes.POINTER(ctypes.c_char_p)), len(self.terms)
        described = [self._described(name) for name in self.shapes]
        fields = (_abi.TaskField * len(described))(*described)
        config.fields, config.field_count = ctypes.cast(fields, ctypes.POINTER(_abi.TaskField)), len(described)
        check(LIB.mimo_scene_set_task(scene, config))

    def split(self, values: NDArray[np.float32]) -> Dict[str, NDArray[np.float32]]:
        """The fields by name, as views of their values."""
        parts, start = {}, 0
        for name, shape in self.shapes.items():
            count = int(np.prod(shape))
            parts[name] = values[start : start + count].reshape(shape)
            start += count
        return parts

    def reset(self, env: int, told: Any) -> None:
        """Lets the task begin an episode."""
        world = self.worlds[env]
        moment = Moment(self, told, world.layout.views)
        self.task.reset(world, moment)
        moment._end(self, told)

    def evaluate(self, env: int, told: Any, verdict: Any) -> None:
        """Lets the task judge a step, and passes its judgement on."""
        world = self.worlds[env]
        moment = Moment(self, told, world.layout.views)
        judged = self.task.evaluate(world, moment)
        moment._end(self, told)
        self._say(judged, verdict)

    def _say(self, judged: Judgement, verdict: Any) -> None:
        if not isinstance(judged, Judgement):
            raise TypeError(f"evaluate returned {judged!r}, expected a mimo.Judgement")
        if judged.info or (judged.terminated and not (judged.success or judged.failure)):
            what = "info" if judged.info else "terminated without success or failure"
            raise ValueError(f"evaluate returned {what}, which a WorldTask cannot")
        if list(judged.terms) != self.terms and set(judged.terms) != set(self.terms):
            raise ValueError(f"evaluate returned the terms {sorted(judged.terms)}, expected {sorted(self.terms)}")
        if self.terms:
            row = np.array([judged.terms[name] for name in self.terms], np.float64)
            _write(verdict.terms, row, len(self.terms), "terms")
        verdict.reward = 0 if judged.reward is None else judged.reward
        verdict.outcome = _outcome(judged)
        verdict.goes_on, verdict.truncated = not judged.terminated, bool(judged.truncated)

    def _checked(self, name: str, box: Any) -> bool:
        from gymnasium.spaces import Box

        if not isinstance(box, Box) or box.dtype != np.float32:
            raise TypeError(f"{self.name}: the space of {name!r} is {box!r}, expected a gymnasium Box of float32")
        if np.unique(box.low).size != 1 or np.unique(box.high).size != 1:
            raise ValueError(f"{self.name}: the bounds of {name!r} differ, expected one low and one high for all")
        return True

    def _described(self, name: str) -> _abi.TaskField:
        field, box = defaults(_abi.TaskField), self.task.fields[name]
        field.shape, field.ndim = ctypes.addressof(self._sizes[name]), len(box.shape)
        field.name, field.unit = utf8(name), utf8(self.task.units.get(name))
        field.frame = utf8(self.task.frames.get(name))
        field.low, field.high = float(box.low.flat[0]), float(box.high.flat[0])
        return field


def _outcome(judged: Judgement) -> Outcome:
    return Outcome.SUCCESS if judged.success else Outcome.FAILURE if judged.failure else Outcome.NONE


_bounds: WeakValueDictionary[int, Bound] = WeakValueDictionary()


def _copy(address: Optional[int], count: int, kind: Any) -> NDArray[Any]:
    if not count or not address:
        return np.empty(0, kind)
    size = count * np.dtype(kind).itemsize
    return np.frombuffer(ctypes.string_at(address, size), kind).copy()


def _write(address: Optional[int], row: NDArray[Any], count: int, name: str) -> None:
    if row.shape != (count,):
        raise ValueError(f"moment.{name} has the shape {row.shape}, expected {(count,)}")
    if count and address:
        ctypes.memmove(address, np.ascontiguousarray(row).ctypes.data, row.nbytes)


def status_of(work: Callable[[], None]) -> int:
    """Turns exceptions into statuses: they must not pass through the library's frames."""
    try:
        work()
        return 0
    except Error as error:
        return _fail(error.status or Status.TASK, str(error))
    except BaseException as error:
        return _fail(Status.TASK, f"{type(error).__name__}: {error}")


def _fail(status: int, message: str) -> int:
    result: int = LIB.mimo_fail(status, message.replace("\0", "?").encode(errors="replace"))
    return result


@_abi.TaskResetFn  # type: ignore[untyped-decorator]
def _reset(user: int, env: int, told: Any) -> int:
    return status_of(lambda: _bounds[user].reset(env, told.contents))


@_abi.TaskEvaluateFn  # type: ignore[untyped-decorator]
def _evaluate(user: int, env: int, told: Any, verdict: Any) -> int:
    return status_of(lambda: _bounds[user].evaluate(env, told.contents, verdict.contents))
