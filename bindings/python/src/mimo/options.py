"""What can be asked for when a scene's infant, a world or an object is made; and how it gets into the C structs.

Whatever is left out is the library's default, or the scene's own. docs/python.md has them in a table.
"""

from __future__ import annotations

import ctypes
import inspect
import os
from enum import IntEnum, IntFlag
from functools import lru_cache
from typing import Any, Dict, Literal, Mapping, Optional, Sequence, TypedDict, Union, get_args, get_type_hints

import numpy as np

from ._library import utf8
from .arguments import real_number, unexpected, vector, whole_number
from .constants import (
    Act,
    Actuation,
    Disable,
    Frame,
    GrowthModel,
    Hearing,
    Jacobian,
    Mature,
    Place,
    Proprioception,
    Quantity,
    Reflex,
    Render,
    Sex,
    Shape,
    Touch,
    TouchResponse,
    Vestibular,
    Vision,
)

Numbers = Sequence[float]
SIZES = 3  # that a shape has at most


class DocumentOptions(TypedDict, total=False):
    """How much an MJCF document may ask for, and whether its files must lie in its own folder."""

    max_file_bytes: int
    max_pixels: int
    max_vertices: int
    max_elements: int
    max_keyframes: int
    max_iterations: int
    max_world_bytes: int
    max_compile_ms: int
    confined: bool


class GrowthOptions(TypedDict, total=False):
    """How old an infant is (months), how large and strong for its age; what of it is as old: "all"."""

    age: float
    physiological_age: float
    sex: Sex
    growth: GrowthModel
    z_length: float
    z_weight: float
    z_head: float
    percentile: float
    strength_exponent: float
    neck_strength: float
    birth_tone: float
    contracture: float
    absolute: bool
    keep_spacing: bool
    maturity: Union[Mature, Sequence[Union[Mature, str]]]


class AgentOptions(GrowthOptions, total=False):
    """One infant: where it is, how old it is, what it senses, what of it acts."""

    name: str
    body: str
    place: Place
    position: Numbers
    orientation: Numbers
    proprioception: Union[Proprioception, bool]
    vestibular: Union[Vestibular, bool]
    hearing: Union[Hearing, bool]
    voice: bool
    limit_threshold: float
    vision: Union[Vision, bool]
    vision_width: int
    vision_height: int
    vision_fovy: float
    vision_foveation: float
    actuation: Actuation
    acts: Act
    normalize_actions: bool
    touch: Union[Touch, bool]
    touch_response: TouchResponse
    touch_frame: Frame
    touch_scale: float
    touch_slip_threshold: float
    reflexes: Union[Reflex, str, Sequence[Union[Reflex, str]]]
    senses: Union[Literal["usual", "all", "hearing"], Sequence[str]]
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
    step_contacts: bool
    render: Render
    samples: int
    render_threads: int


class SensesOptions(TypedDict, total=False):
    """How attached senses look at a simulation; `step`: seconds between two calls of advance."""

    step: float
    renderer: str
    render: Render
    samples: int
    render_threads: int


class EnvOptions(AgentOptions, PhysicsOptions, total=False):
    """What make and make_vec understand beside their own arguments."""

    parameters: Mapping[str, float]


class WorldOptions(PhysicsOptions, total=False):
    """How a world is simulated, and what is rewarded in it."""

    task: str


class Options(EnvOptions, WorldOptions, total=False):
    """What World and Batch understand beside their own arguments."""


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


class FieldOptions(TypedDict, total=False):
    """A quantity that is observed, and in the frame of which body; None: of the world."""

    quantity: Quantity
    relative_to: Optional[str]


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
    foveation: float


@lru_cache(maxsize=None)
def enums(kind: Any) -> Dict[str, Any]:
    """The options that a class above names, each with the enum that it takes, or None."""
    hints = get_type_hints(kind)
    return {name: next((it for it in (hint, *get_args(hint)) if _is_enum(it)), None) for name, hint in hints.items()}


def _is_enum(kind: Any) -> bool:
    return isinstance(kind, type) and issubclass(kind, (IntEnum, IntFlag))


def refuse_unknown(options: Mapping[str, Any], kind: Any, function: Any = None) -> None:
    """Raises for an option that a class above does not name; `function` has keyword arguments of its own, too."""
    for name in options.keys() - enums(kind).keys():
        own = inspect.signature(function).parameters.values() if function else ()
        known = sorted({*enums(kind), *(it.name for it in own if it.kind == it.KEYWORD_ONLY)})
        raise unexpected(name, known)


def fill(
    config: ctypes.Structure,
    options: Mapping[str, Any],
    kind: Any,
    standard: Optional[Mapping[str, Any]] = None,
) -> None:
    """Puts options, of those that `kind` names, into a config; `standard` has what True stands for in sets of bits."""
    refuse_unknown(options, kind)
    types = {entry[0]: entry[1] for entry in config._fields_}
    for name, value in options.items():
        if standard is not None and value is True:
            value = standard.get(name, value)
        setattr(config, name, _converted(name, value, types[name], enums(kind)[name]))


def _converted(name: str, value: Any, kind: Any, choice: Any) -> Any:
    if kind is ctypes.c_char_p:
        return utf8(value, name)
    if issubclass(kind, ctypes.Array):
        numbers = _size(value) if name == "size" else vector(name, value, kind._length_)
        return kind(*numbers)
    if kind is ctypes.c_double:
        return real_number(name, value)
    number = whole_number(name, value, choice)
    if kind(number).value != number:  # ctypes would silently take it modulo 2^32
        raise ValueError(f"{name} is {value!r}, out of range")
    return number


def _size(value: Any) -> Any:
    """One to three numbers, by shape; the rest is ignored."""
    given = np.atleast_1d(vector("size", value, len(value)) if np.ndim(value) else real_number("size", value))
    if not 1 <= len(given) <= SIZES:
        raise ValueError(f"size is {value!r}, expected 1 to {SIZES} numbers")
    return [*given, *[0.0] * (SIZES - len(given))]
