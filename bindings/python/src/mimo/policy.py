"""Learned policies in files that the program, the browser and other languages read: docs/guide/policies.md."""

from __future__ import annotations

import base64
import binascii
import json
import math
import os
from reprlib import repr as short
from typing import TYPE_CHECKING, Any, Dict, Iterable, List, Mapping, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._files import new_file
from .arguments import meant

if TYPE_CHECKING:
    from .world import World

FORMAT, VERSIONS = "mimo-policy", (1, 2)
CLIP = 10.0  # scaled observations go no further, by default
MOST_ROWS = 4096  # of a layer, and numbers of a field
MOST_NESTED = 15  # lists and objects in each other, of `how`
MOST_PERIODS, LARGEST = 64, float(np.finfo(np.float32).max)
NEW = ("age", "delays", "hold_s", "clock_s", "reflex")  # members of version 2
NEEDED = ("fields", "actions", "mean", "deviation", "layers")
MEMBERS = ("format", "version", "what", "scene", "step_seconds", "clip", "how", *NEEDED, *NEW)
LAYER = ("rows", "weights", "bias")
ANGLES, VELOCITIES = "proprioception/position", "proprioception/velocity"  # what a reflex feels
Numbers = NDArray[np.float32]
Layer = Tuple[Numbers, Numbers]


class StretchReflex(NamedTuple):
    """Pulls each action's joint to a goal: stiffness (goal - angle) - damping velocity, in the action's unit.

    `joints` are labels of proprioception/position, one for each action; goals count from `start`, rad.
    """

    stiffness: float
    damping: float
    joints: Sequence[str]
    start: Sequence[float]


class Policy:
    """A small network that gives actions: tanh between its layers, and the last one clipped to the actions' bounds.

    `fields` are names and counts of the observation's fields, one after the other; `clock_s` are periods whose sine and
    cosine are read after them; `mean` and `deviation` scale all of these. What the network gives holds for `hold_s`, or
    one step. With a `reflex` it gives goals of joints, and the reflex makes an action of them in every step. The
    program and the page show it with an infant of `age` months, unless they are asked for another; with `delays` its
    nerves are as old, too, as they were when it learned.
    """

    def __init__(
        self,
        fields: Sequence[Tuple[str, int]],
        actions: Sequence[str],
        layers: Sequence[Tuple[ArrayLike, ArrayLike]],
        mean: ArrayLike,
        deviation: ArrayLike,
        *,
        scene: str = "",
        step_seconds: float = 0.0,
        clip: float = CLIP,
        age: Optional[float] = None,
        delays: bool = False,
        hold_s: Optional[float] = None,
        clock_s: Sequence[float] = (),
        reflex: Union[StretchReflex, Mapping[str, Any], None] = None,
        what: str = "",
        how: Any = None,
    ) -> None:
        self.fields = [(str(name), int(count)) for name, count in fields]
        self.actions = [str(name) for name in _listed("actions", actions)]
        self.layers: List[Layer] = [(_finite("weights", w), _finite("bias", b)) for w, b in layers]
        self.mean, self.deviation = _finite("mean", mean), _finite("deviation", deviation)
        self.scene, self.clip = scene, _positive("clip", clip)
        self.step_seconds = _positive("step_seconds", step_seconds, or_zero=True)
        self.age, self.delays = None if age is None else _months(age), _flag("delays", delays)
        self.hold_s = None if hold_s is None else _seconds("hold_s", hold_s)
        self.clock_s = [_seconds("clock_s", period) for period in _listed("clock_s", clock_s)]
        self.what, self.how = what, {} if how is None else how
        self._check()
        self.reflex = None if reflex is None else self._checked(reflex)
        self._places: List[int] = []  # of the reflex's joints
        self._step = self.step_seconds
        self._hold, self._given = 1, self.layers[-1][1]
        self._last = -1  # the step of the episode in which it acted last; -1: never
        if self._step > 0:
            self._hold = self._steps_held()

    def _check(self) -> None:
        if len(self.clock_s) > MOST_PERIODS:
            raise ValueError(f"clock_s has {len(self.clock_s)} periods, expected at most {MOST_PERIODS}")
        width = sum(count for _, count in self.fields) + 2 * len(self.clock_s)
        for name, values in (("mean", self.mean), ("deviation", self.deviation)):
            if values.shape != (width,):
                raise ValueError(f"{name} has shape {values.shape}, expected ({width},): the numbers of all fields")
        if not (self.deviation > 0).all():
            raise ValueError("deviation holds a number that is not above 0")
        for number, (weights, bias) in enumerate(self.layers):
            if weights.ndim != 2 or weights.shape[1] != width or bias.shape != (weights.shape[0],):
                raise ValueError(
                    f"layer {number} has weights of shape {weights.shape} and bias of shape {bias.shape}, "
                    f"expected (rows, {width}) and (rows,)"
                )
            width = weights.shape[0]
        if not self.layers or width != len(self.actions):
            raise ValueError(f"the last layer has {width} rows, expected {len(self.actions)}, one for each action")

    def _checked(self, reflex: Union[StretchReflex, Mapping[str, Any]]) -> StretchReflex:
        told = reflex._asdict() if isinstance(reflex, StretchReflex) else reflex
        if not isinstance(told, Mapping):
            raise ValueError(f"reflex is {short(told)}, expected an object")
        _refuse_unknown("reflex", told, StretchReflex._fields)
        for name in StretchReflex._fields:
            if name not in told:
                raise ValueError(f"reflex has no {name}")
        joints, start = (list(_listed(name, told[name])) for name in ("joints", "start"))
        for name, values in (("joints", joints), ("start", start)):
            if len(values) != len(self.actions):
                raise ValueError(
                    f"{name} of reflex has {len(values)} elements, expected {len(self.actions)}, one for each action"
                )
        for joint, angle in zip(joints, start):
            if not isinstance(joint, str):
                raise ValueError(f"joints of reflex holds {short(joint)}, expected names")
            if not _is_number(angle) or not abs(angle) <= LARGEST:
                raise ValueError(f"start of reflex holds {short(angle)}, expected a finite number")
        return StretchReflex(
            _positive("stiffness", told["stiffness"]),
            _positive("damping", told["damping"], or_zero=True),
            joints,
            [float(angle) for angle in start],
        )

    def _steps_held(self) -> int:
        """How many steps an output of the network holds."""
        if self.hold_s is None:
            return 1
        steps = self.hold_s / self._step
        if round(steps) < 1 or abs(steps - round(steps)) > 1e-6 * steps:
            raise ValueError(f"hold_s is {self.hold_s:g}, expected a whole number of steps of {self._step:g} s")
        return round(steps)

    @property
    def version(self) -> int:
        """Of the file that `save` writes: 1 where other readers of version 1 can read it."""
        new = self.age is not None or self.delays or self.hold_s or self.clock_s or self.reflex
        return 1 if self.fields and not new else 2

    @classmethod
    def of(
        cls,
        world: "World",
        layers: Sequence[Tuple[ArrayLike, ArrayLike]],
        mean: ArrayLike,
        deviation: ArrayLike,
        **others: Any,
    ) -> "Policy":
        """A policy that reads the whole observation of a world, as `flatten=True` gives it, and moves all it can."""
        fields = [(name, int(np.prod(field.shape))) for name, field in world.layout.fields.items()]
        step = world.timestep * world.frame_skip
        return cls(fields, list(world.action_names), layers, mean, deviation, step_seconds=step, **others)

    @classmethod
    def load(cls, path: "Union[str, os.PathLike[str]]") -> "Policy":
        """From a file."""
        try:
            with open(path, encoding="utf-8") as file:
                return cls(**_arguments(json.load(file)))
        except RecursionError:
            raise ValueError(f"policy {os.fspath(path)}: its values are nested too deeply") from None
        except json.JSONDecodeError as error:
            raise ValueError(f"policy {os.fspath(path)}: this is no JSON object: {error}") from None
        except ValueError as error:
            raise ValueError(f"policy {os.fspath(path)}: {error}") from None

    def save(self, path: "Union[str, os.PathLike[str]]") -> None:
        """Into a file."""
        content = {
            "format": FORMAT,
            "version": self.version,
            "what": self.what,
            "scene": self.scene,
            "step_seconds": self.step_seconds,
            "clip": self.clip,
            "age": self.age,
            "delays": self.delays or None,
            "hold_s": self.hold_s,
            "clock_s": self.clock_s or None,
            "reflex": self.reflex and self.reflex._asdict(),
            "how": self.how,
            "fields": [list(field) for field in self.fields],
            "actions": self.actions,
            "mean": _packed(self.mean),
            "deviation": _packed(self.deviation),
            "layers": [
                {"rows": len(bias), "weights": _packed(weights), "bias": _packed(bias)} for weights, bias in self.layers
            ],
        }
        told = {name: value for name, value in content.items() if value is not None}
        if _depth(self.how) > MOST_NESTED:
            raise ValueError(f"how is nested more than {MOST_NESTED} deep, which no reader takes")
        try:
            text = json.dumps(told, indent=1, allow_nan=False) + "\n"
        except (TypeError, ValueError) as error:
            raise ValueError(f"how holds what is no JSON: {error}") from None
        with new_file(path) as file:
            file.write_text(text, encoding="utf-8")

    def attach(self, world: "World") -> None:
        """Refuses a world whose observation, actions or step are others than those that it was learned with."""
        step = world.timestep * world.frame_skip
        if self.step_seconds > 0 and abs(step - self.step_seconds) > 1e-9:
            raise ValueError(
                f"the policy was learned with steps of {self.step_seconds:g} s, the world's last {step:g} s"
            )
        for name, count in self.fields:
            field = _field(world, name)
            if int(np.prod(field.shape)) != count:
                raise ValueError(
                    f"field {name!r} has {int(np.prod(field.shape))} numbers in this world, {count} in the policy"
                )
        if list(world.action_names) != self.actions:
            raise ValueError(f"the world's actions are {list(world.action_names)}, the policy's {self.actions}")
        self._step, self._last = step, -1
        self._hold = self._steps_held()
        if self.reflex:
            labels = list(_field(world, ANGLES).labels)
            if list(_field(world, VELOCITIES).labels) != labels:
                raise ValueError(f"the joints of {VELOCITIES!r} are others than those of {ANGLES!r}")
            for joint in self.reflex.joints:
                if joint not in labels:
                    raise ValueError(f"joints of reflex has {joint!r}{meant(joint, labels)}; there are: {labels}")
            self._places = [labels.index(joint) for joint in self.reflex.joints]

    def act(
        self, observation: Mapping[str, ArrayLike], low: ArrayLike, high: ArrayLike, time: Optional[float] = None
    ) -> Numbers:
        """The action, given an observation by field name and the bounds of actions (world.action_low, action_high).

        `time` is the seconds since the episode began (world.time), which a clock and a hold need; an earlier time than
        that of the last call is another episode's. A policy with a hold or a reflex acts in the world that it is
        attached to.
        """
        if time is None and (self.clock_s or self.hold_s):
            raise ValueError("the policy has a clock or a hold: give time=world.time")
        if (self.reflex and not self._places) or (self.hold_s and not self._step):
            raise ValueError("the policy has a reflex or a hold: attach it to the world first")
        least, most = np.asarray(low, np.float32), np.asarray(high, np.float32)
        given = self._held(observation, time or 0.0)
        if not self.reflex:
            return np.asarray(least + (most - least) * (np.clip(given, -1, 1) + 1) / 2, np.float32)
        angles, velocities = (
            np.ravel(np.asarray(observation[name], np.float32))[self._places] for name in (ANGLES, VELOCITIES)
        )
        goals = np.asarray(self.reflex.start, np.float32) + given
        pull = self.reflex.stiffness * (goals - angles) - self.reflex.damping * velocities
        return np.asarray(np.clip(pull, least, most), np.float32)

    def _held(self, observation: Mapping[str, ArrayLike], time: float) -> Numbers:
        """What the network gives, or gave."""
        step = math.floor(time / self._step + 0.5) if self._step else 0  # round() takes halves to even numbers
        if (
            self._last < 0
            or step % self._hold == 0
            or step // self._hold != self._last // self._hold
            or step < self._last
        ):
            self._given = self._thought(observation, time)
        self._last = step
        return self._given

    def _thought(self, observation: Mapping[str, ArrayLike], time: float) -> Numbers:
        turns = [2 * math.pi * time / period for period in self.clock_s]
        clock = np.array([turned(turn) for turn in turns for turned in (math.sin, math.cos)], np.float32)
        seen = np.concatenate(
            [*(np.ravel(np.asarray(observation[name], np.float32)) for name, _ in self.fields), clock]
        )
        with np.errstate(over="ignore", invalid="ignore"):
            row = np.clip((seen - self.mean) / self.deviation, -self.clip, self.clip)
            for weights, bias in self.layers[:-1]:
                row = np.tanh(weights @ row + bias)
            weights, bias = self.layers[-1]
            given = np.asarray(weights @ row + bias, np.float32)
        if not np.isfinite(given).all():
            raise ValueError("the policy's network gives what is no finite number")
        return given


def _field(world: "World", name: str) -> Any:
    field = world.layout.fields.get(name)
    if field is None:
        raise ValueError(f"the world has no field {name!r}")
    return field


def _refuse_unknown(owner: str, told: Mapping[str, Any], known: Iterable[str]) -> None:
    for name in told:
        if name not in known:
            raise ValueError(f"{owner} has no member {short(name)}{meant(name, known)}; expected {', '.join(known)}")


def _arguments(content: Any) -> Dict[str, Any]:
    """What the constructor takes, of the JSON value of a file."""
    if not isinstance(content, dict) or content.get("format") != FORMAT:
        raise ValueError(f"this is no JSON object whose format is {FORMAT!r}")
    version = content.get("version")
    if version not in VERSIONS or isinstance(version, bool):
        raise ValueError(f"its version is {short(version)}, and this library reads versions 1 and 2")
    if version == 1:  # which had members that nobody knew, and they were passed over
        for name in NEW:
            if name in content:
                raise ValueError(f"{name} needs version 2, and its version is 1")
    else:
        _refuse_unknown("a policy", content, MEMBERS)
    told = {name: content[name] for name in MEMBERS[2:] if name in content}
    for name in ("what", "scene"):
        if not isinstance(told.get(name, ""), str):
            if version > 1:
                raise ValueError(f"{name} is {short(told[name])}, expected text")
            del told[name]
    for name in NEEDED:
        if name not in content:
            raise ValueError(f"it has no {name}")
    for name, value in told.items():
        if value is None and name != "how":
            raise ValueError(f"{name} is null, expected a value, or nothing of that name")
    for name in _listed("actions", content["actions"]):
        if not isinstance(name, str):
            raise ValueError(f"actions holds {short(name)}, expected names")
    told["fields"] = [_pair(field) for field in _listed("fields", content["fields"])]
    if version == 1 and not told["fields"]:
        raise ValueError("fields is [], expected names and counts")
    told["layers"] = [_layer(layer, version) for layer in _listed("layers", content["layers"])]
    told["mean"], told["deviation"] = (_unpacked(name, content[name]) for name in ("mean", "deviation"))
    return told


def _pair(field: Any) -> Tuple[str, int]:
    if isinstance(field, list) and len(field) == 2:
        name, count = field
        if isinstance(name, str) and _is_size(count):
            return name, count
    raise ValueError(f"fields holds {short(field)}, expected a name and a count from 1 to {MOST_ROWS}")


def _is_size(value: Any) -> bool:
    return isinstance(value, int) and not isinstance(value, bool) and 1 <= value <= MOST_ROWS


def _layer(layer: Any, version: int) -> Layer:
    if not isinstance(layer, dict) or not set(LAYER) <= set(layer):
        raise ValueError(f"layers holds {short(layer)}, expected objects with {', '.join(LAYER)}")
    if version > 1:
        _refuse_unknown("a layer", layer, LAYER)
    rows, weights, bias = layer["rows"], _unpacked("weights", layer["weights"]), _unpacked("bias", layer["bias"])
    if not _is_size(rows) or len(weights) % rows:
        expected = f"expected 1 to {MOST_ROWS}, a divisor of its {len(weights)} weights"
        raise ValueError(f"rows of a layer is {short(rows)}, {expected}")
    return weights.reshape(rows, len(weights) // rows), bias


def _listed(name: str, value: Any) -> Sequence[Any]:
    if isinstance(value, (str, Mapping)) or not hasattr(value, "__len__"):
        raise ValueError(f"{name} is {short(value)}, expected a list")
    values: Sequence[Any] = value
    return values


def _seconds(name: str, value: Any) -> float:
    """Shorter periods and longer holds are a mistake, and their quotients would end at infinity."""
    if not (_is_number(value) and 1e-3 <= value <= 1e6):
        raise ValueError(f"{name} is {short(value)}, expected seconds from 0.001 to 1e+06")
    return float(value)


def _is_number(value: Any) -> bool:
    return isinstance(value, (int, float, np.number)) and not isinstance(value, bool)


def _positive(name: str, value: Any, or_zero: bool = False) -> float:
    if not (_is_number(value) and value <= LARGEST and (value > 0 or (or_zero and value == 0))):
        raise ValueError(f"{name} is {short(value)}, expected a number {'from 0 on' if or_zero else 'above 0'}")
    return float(value)


def _months(age: Any) -> float:
    if not (_is_number(age) and 0 <= age <= 24):
        raise ValueError(f"age is {short(age)}, expected months from 0 to 24")
    return float(age)


def _flag(name: str, value: Any) -> bool:
    if not isinstance(value, bool):
        raise ValueError(f"{name} is {short(value)}, expected true or false")
    return value


def _finite(name: str, values: ArrayLike) -> Numbers:
    try:
        array = np.array(values, np.float32)
    except (TypeError, ValueError):
        raise ValueError(f"{name} is {short(values)}, expected numbers") from None
    if not np.isfinite(array).all():
        raise ValueError(f"{name} holds what is no finite number")
    return array


def _depth(value: Any) -> int:
    """How many lists and objects lie in each other."""
    depth, layer = 0, [value]
    while layer := [one for one in layer if isinstance(one, (list, tuple, dict))]:
        layer = [inner for one in layer for inner in (one.values() if isinstance(one, dict) else one)]
        depth += 1
        if depth > MOST_NESTED:
            break
    return depth


def _packed(values: Numbers) -> str:
    return base64.b64encode(values.astype("<f4").tobytes()).decode()


def _unpacked(name: str, text: Any) -> Numbers:
    try:
        return np.frombuffer(base64.b64decode(text, validate=True), "<f4").astype(np.float32)
    except (TypeError, ValueError, binascii.Error):
        raise ValueError(f"{name} is {short(text)}, expected 32-bit numbers in base 64") from None
