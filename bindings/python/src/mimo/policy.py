"""Learned policies in files that the program, the browser and other languages read: docs/guide/policies.md."""

from __future__ import annotations

import base64
import json
import os
from typing import TYPE_CHECKING, Any, Dict, List, Mapping, Optional, Sequence, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

if TYPE_CHECKING:
    from .world import World

FORMAT, VERSION = "mimo-policy", 1
CLIP = 10.0  # scaled observations go no further, by default
Layer = Tuple[NDArray[np.float32], NDArray[np.float32]]


class Policy:
    """A small network that gives actions: tanh between its layers, and the last one clipped to the actions' bounds.

    `fields` are names and counts of the observation's fields, one after the other; `mean` and `deviation` scale them.
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
        what: str = "",
        how: Optional[Mapping[str, Any]] = None,
    ) -> None:
        self.fields = [(str(name), int(count)) for name, count in fields]
        self.actions = [str(name) for name in actions]
        self.layers: List[Layer] = [(_finite("weights", w), _finite("bias", b)) for w, b in layers]
        self.mean, self.deviation = _finite("mean", mean), _finite("deviation", deviation)
        self.scene, self.step_seconds, self.clip = scene, float(step_seconds), float(clip)
        self.what, self.how = what, dict(how or {})
        self._check()

    def _check(self) -> None:
        width = sum(count for _, count in self.fields)
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
        with open(path, encoding="utf-8") as file:
            content: Dict[str, Any] = json.load(file)
        if content.get("format") != FORMAT or content.get("version") != VERSION:
            raise ValueError(f"{os.fspath(path)} is no {FORMAT} of version {VERSION}")
        layers = []
        for layer in content["layers"]:
            weights = _unpacked(layer["weights"])
            layers.append((weights.reshape(layer["rows"], -1), _unpacked(layer["bias"])))
        return cls(
            [(name, count) for name, count in content["fields"]],
            content["actions"],
            layers,
            _unpacked(content["mean"]),
            _unpacked(content["deviation"]),
            scene=content.get("scene", ""),
            step_seconds=content.get("step_seconds", 0.0),
            clip=content.get("clip", CLIP),
            what=content.get("what", ""),
            how=content.get("how"),
        )

    def save(self, path: "Union[str, os.PathLike[str]]") -> None:
        """Into a file."""
        content = {
            "format": FORMAT,
            "version": VERSION,
            "what": self.what,
            "scene": self.scene,
            "step_seconds": self.step_seconds,
            "clip": self.clip,
            "how": self.how,
            "fields": [list(field) for field in self.fields],
            "actions": self.actions,
            "mean": _packed(self.mean),
            "deviation": _packed(self.deviation),
            "layers": [
                {"rows": len(bias), "weights": _packed(weights), "bias": _packed(bias)} for weights, bias in self.layers
            ],
        }
        with open(path, "w", encoding="utf-8") as file:
            file.write(json.dumps(content, indent=1) + "\n")

    def attach(self, world: "World") -> None:
        """Refuses a world whose observation, actions or step are others than those that it was learned with."""
        step = world.timestep * world.frame_skip
        if self.step_seconds > 0 and abs(step - self.step_seconds) > 1e-9:
            raise ValueError(
                f"the policy was learned with steps of {self.step_seconds:g} s, the world's last {step:g} s"
            )
        for name, count in self.fields:
            field = world.layout.fields.get(name)
            if field is None:
                raise ValueError(f"the world has no field {name!r}")
            if int(np.prod(field.shape)) != count:
                raise ValueError(
                    f"field {name!r} has {int(np.prod(field.shape))} numbers in this world, {count} in the policy"
                )
        if list(world.action_names) != self.actions:
            raise ValueError(f"the world's actions are {list(world.action_names)}, the policy's {self.actions}")

    def act(self, observation: Mapping[str, ArrayLike], low: ArrayLike, high: ArrayLike) -> NDArray[np.float32]:
        """The action, given an observation by field name and the bounds of actions (world.action_low, action_high)."""
        seen = np.concatenate([np.ravel(np.asarray(observation[name], np.float32)) for name, _ in self.fields])
        row = np.clip((seen - self.mean) / self.deviation, -self.clip, self.clip)
        for weights, bias in self.layers[:-1]:
            row = np.tanh(weights @ row + bias)
        weights, bias = self.layers[-1]
        share = (np.clip(weights @ row + bias, -1, 1) + 1) / 2
        least, most = np.asarray(low, np.float32), np.asarray(high, np.float32)
        return np.asarray(least + (most - least) * share, np.float32)


def _finite(name: str, values: ArrayLike) -> NDArray[np.float32]:
    array = np.array(values, np.float32)
    if not np.isfinite(array).all():
        raise ValueError(f"{name} holds what is no finite number")
    return array


def _packed(values: NDArray[np.float32]) -> str:
    return base64.b64encode(values.astype("<f4").tobytes()).decode()


def _unpacked(text: str) -> NDArray[np.float32]:
    return np.frombuffer(base64.b64decode(text, validate=True), "<f4").astype(np.float32)
