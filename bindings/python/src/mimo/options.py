"""What can be asked for when a scene's infant, a world or an object is made; and how it gets into the C structs.

Whatever is left out is the library's default, or the scene's own. docs/python.md has them in a table.
"""

from __future__ import annotations

import ctypes
import os
from typing import Any, Mapping, Sequence, TypedDict, Union

from ._library import utf8
from .constants import (
    Act,
    Actuation,
    Disable,
    Frame,
    Jacobian,
    Proprioception,
    Render,
    Shape,
    Touch,
    TouchResponse,
    Vision,
)

Numbers = Sequence[float]


class AgentOptions(TypedDict, total=False):
    """One infant: where it is, what it senses, what of it acts."""

    name: str
    body: str
    position: Numbers
    orientation: Numbers
    proprioception: Union[Proprioception, bool]
    vestibular: bool
    limit_threshold: float
    vision: Union[Vision, bool]
    vision_width: int
    vision_height: int
    vision_fovy: float
    actuation: Actuation
    acts: Act
    normalize_actions: bool
    touch: Union[Touch, bool]
    touch_response: TouchResponse
    touch_frame: Frame
    touch_scale: float
    touch_slip_threshold: float
    face: str
    root: str
    vestibular_at: str


class PhysicsOptions(TypedDict, total=False):
    """How a world is simulated."""

    frame_skip: int
    max_steps: int
    renderer: str
    jacobian: Jacobian
    disable: Disable
    timing: bool
    render: Render
    samples: int
    render_threads: int


class EnvOptions(AgentOptions, PhysicsOptions, total=False):
    """What make and make_vec understand beside their own arguments."""

    parameters: Mapping[str, float]


class Options(EnvOptions, total=False):
    """What World and Batch understand beside their own arguments."""

    task: str


class ObjectOptions(TypedDict, total=False):
    """A rigid object."""

    shape: Shape
    size: Union[float, Numbers]
    position: Numbers
    orientation: Numbers
    mass: float
    rgba: Numbers
    fixed: bool


class CameraOptions(TypedDict, total=False):
    """A camera whose pictures are observed; with `look_at` a new one. Metres, in the frame of `body`."""

    outputs: Vision
    width: int
    height: int
    fovy: float
    body: str
    position: Numbers
    look_at: Numbers


class ModelOptions(TypedDict, total=False):
    """An object that an MJCF document describes."""

    file: Union[str, "os.PathLike[str]"]
    xml: str
    position: Numbers
    orientation: Numbers
    fixed: bool


class PictureOptions(TypedDict, total=False):
    """What a picture shows: a camera of the model by name, or a free one that looks at a point (angles in degrees)."""

    width: int
    height: int
    camera: str
    look_at: Numbers
    distance: float
    azimuth: float
    elevation: float
    fovy: float


AGENT_OPTIONS = frozenset(AgentOptions.__annotations__)
WORLD_OPTIONS = frozenset(PhysicsOptions.__annotations__) | {"task"}

# Switches that are sets of bits: True means the default, not bit 0.
_BIT_SETS = frozenset({"proprioception", "vision", "touch"})


def fill(config: ctypes.Structure, options: Mapping[str, Any], standard: Mapping[str, Any]) -> None:
    """Puts options into a config; `standard` has the values of the bit sets that True stands for."""
    kinds = {entry[0]: entry[1] for entry in config._fields_}
    for name, value in options.items():
        if name in _BIT_SETS and value is True:
            value = standard[name]
        setattr(config, name, _converted(name, value, kinds[name]))


def _converted(name: str, value: Any, kind: Any) -> Any:
    try:
        if kind is ctypes.c_char_p:
            return utf8(value)
        if issubclass(kind, ctypes.Array):
            return _array(name, value, kind)
        if kind is ctypes.c_double:
            return float(value)
        number = int(value)
    except (TypeError, AttributeError, ValueError) as error:
        raise TypeError(f"{name} is {value!r}: {error}") from None
    if kind(number).value != number:  # ctypes would silently take it modulo 2^32
        raise ValueError(f"{name} is {value!r}, out of range")
    return number


def _array(name: str, value: Any, kind: Any) -> Any:
    length = kind._length_
    values = [float(value)] if name == "size" and not isinstance(value, Sequence) else [float(v) for v in value]
    if name == "size":
        values += [0.0] * (length - len(values))  # by shape; the rest is ignored
    if len(values) != length:
        raise ValueError(f"expected {length} numbers")
    return kind(*values)
