"""The original's dictionaries of senses, and the library's options for them."""

from __future__ import annotations

from typing import Any, Dict, Iterable, List, Mapping, NamedTuple, Optional, Tuple

import numpy as np

from ..arguments import number_of, real_number
from ..constants import Proprioception, Touch, TouchFrame, TouchResponse, Vestibular

Params = Optional[Mapping[str, Any]]

# The original's parts of `observation`, in its (alphabetical) order, and the fields of each.
# `actuation` has two fields for motors, two others for muscles, and one for position control.
ACTUATION = ("control", "motor_torque", "activation", "muscle_force", "target")
PARTS: Mapping[str, Tuple[str, ...]] = {
    "actuation": ACTUATION,
    "limits": ("limit",),
    "qpos": ("position",),
    "qvel": ("velocity",),
    "torques": ("torque",),
}
COMPONENTS: Mapping[str, Tuple[str, Proprioception]] = {
    "velocity": ("qvel", Proprioception.VELOCITY),
    "torque": ("torques", Proprioception.TORQUE),
    "limits": ("limits", Proprioception.LIMIT),
    "actuation": ("actuation", Proprioception.ACTUATION),
}
ADULT, FOVEATION = 18.0, 10.0  # what acuity=True (months) and foveation=True stand for
VESTIBULAR = {"vestibular_acc": "acceleration", "vestibular_gyro": "angular_velocity"}
FUNCTIONS = {
    "force_vector": (Touch.FORCE, TouchFrame.BODY),
    "force_vector_global": (Touch.FORCE, TouchFrame.WORLD),
    "normal_force": (Touch.NORMAL_FORCE, TouchFrame.BODY),
}
RESPONSES = {"spread_linear": TouchResponse.LINEAR, "nearest": TouchResponse.NEAREST}

_SHARED = {
    "foot": 0.015,
    "lower_leg": 0.038,
    "upper_leg": 0.027,
    "upper_arm": 0.024,
    "lower_arm": 0.024,
    "hand": 0.007,
    "eye": 1.0,
}
_TRUNK = {"hip": 0.025, "lower_body": 0.025, "upper_body": 0.03, "head": 0.013}
_FINGERS = {
    **{f"{finger}distal": 0.002 for finger in ("ff", "mf", "rf", "lf", "th")},
    **{f"{finger}middle": 0.004 for finger in ("ff", "mf", "rf", "lf")},
    **{f"{finger}knuckle": 0.004 for finger in ("ff", "mf", "rf", "lf")},
    **{"thhub": 0.004, "thbase": 0.004, "lfmetacarpal": 0.007},
}


def _sides(spacings: Mapping[str, float]) -> Dict[str, float]:
    return {f"{side}_{part}": metres for side in ("left", "right") for part, metres in spacings.items()}


def _touch(scales: Mapping[str, float]) -> Dict[str, Any]:
    return {"scales": dict(scales), "touch_function": "force_vector", "response_function": "spread_linear"}


DEFAULT_PROPRIOCEPTION_PARAMS: Dict[str, Any] = {"components": list(COMPONENTS), "threshold": 0.035}
DEFAULT_VISION_PARAMS: Dict[str, Any] = {
    "eye_left": {"width": 256, "height": 256},
    "eye_right": {"width": 256, "height": 256},
}
DEFAULT_VESTIBULAR_PARAMS: Dict[str, Any] = {"sensors": list(VESTIBULAR)}
DEFAULT_TOUCH_PARAMS = _touch({**_TRUNK, **_sides({**_SHARED, "toes": 0.01, "fingers": 0.002})})
DEFAULT_TOUCH_PARAMS_V2 = _touch({**_TRUNK, **_sides({**_SHARED, "toes": 0.01, "big_toe": 0.01, **_FINGERS})})


class Eye(NamedTuple):
    """A camera that is observed."""

    width: int
    height: int
    fovy: float  # degrees; 0: the camera's own
    acuity: float  # age whose eyesight it has, months; 0: sharp
    foveation: float  # how much the middle is enlarged; 0: not


class Senses(NamedTuple):
    """The senses of an infant: the library's options, and the order of the original's arrays."""

    options: Dict[str, Any]  # options of the infant
    parts: List[str]  # parts of `observation`, keys of PARTS
    vestibular: List[str]  # fields
    cameras: Dict[str, "Eye"]  # by name
    spacings: Optional[Dict[str, float]]  # spacing in metres by body; None: the scene's


def senses_of(
    proprio: Params, touch: Params, vision: Params, vestibular: Params, age: Optional[float] = None
) -> Senses:
    """The senses of these four dictionaries; None switches a sense off, except proprioception. `age` is in months."""
    parts, options = _proprioception({} if proprio is None else proprio)
    feels, spacings = _skin(touch)
    balance = _balance(vestibular)
    options.update(feels, vision=False, vestibular=bool(balance) and _bits(balance))
    return Senses(options, parts, balance, _cameras(vision, age), spacings)


def _proprioception(params: Mapping[str, Any]) -> Tuple[List[str], Dict[str, Any]]:
    _known("proprio_params", params, DEFAULT_PROPRIOCEPTION_PARAMS)
    given = params.get("components", list(COMPONENTS))
    wanted = [_one_of("proprio_params['components']", name, COMPONENTS) for name in given]
    bits = Proprioception.POSITION
    for _, bit in wanted:
        bits |= bit
    threshold = real_number("proprio_params['threshold']", params.get("threshold", 0.035))
    return sorted({"qpos", *(part for part, _ in wanted)}), {"proprioception": bits, "limit_threshold": threshold}


def _skin(params: Params) -> Tuple[Dict[str, Any], Optional[Dict[str, float]]]:
    if params is None:
        return {"touch": False}, None
    _known("touch_params", params, DEFAULT_TOUCH_PARAMS)
    function = params.get("touch_function", "force_vector")
    output, frame = _one_of("touch_params['touch_function']", function, FUNCTIONS)
    response = _one_of("touch_params['response_function']", params.get("response_function", "spread_linear"), RESPONSES)
    scales = params.get("scales")
    spacings = None if scales is None else {body: real_number(f"scale of {body!r}", it) for body, it in scales.items()}
    return {"touch": output, "touch_frame": frame, "touch_response": response}, spacings


def _balance(params: Params) -> List[str]:
    if params is None:
        return []
    _known("vestibular_params", params, DEFAULT_VESTIBULAR_PARAMS)
    sensors = params.get("sensors", list(VESTIBULAR))
    return [_one_of("vestibular_params['sensors']", name, VESTIBULAR) for name in sensors]


def _bits(fields: Iterable[str]) -> Vestibular:
    bits = Vestibular(0)
    for name in fields:
        bits |= Vestibular[name.upper()]
    return bits


def _cameras(params: Params, age: Optional[float]) -> Dict[str, Eye]:
    cameras = {}
    for name, size in (DEFAULT_VISION_PARAMS if params == {} else params or {}).items():
        if not isinstance(size, Mapping):
            raise TypeError(f"vision_params[{name!r}] is {size!r}, expected {{'width': 256, 'height': 256}}")
        _known(f"vision_params[{name!r}]", size, ("width", "height", "fovy", "acuity", "foveation"))
        width, height = (number_of(f"{side} of {name!r}", size.get(side, 256)) for side in ("width", "height"))
        fovy = real_number(f"fovy of {name!r}", size.get("fovy", 0))
        acuity = _strength(f"acuity of {name!r}", size.get("acuity", False), ADULT if age is None else age)
        foveation = _strength(f"foveation of {name!r}", size.get("foveation", False), FOVEATION)
        cameras[name] = Eye(width, height, fovy, acuity, foveation)
    return cameras


def _strength(name: str, given: Any, standard: float) -> float:
    """A number; True stands for the standard one, False for 0."""
    if given is None or isinstance(given, (bool, np.bool_)):
        return standard if given else 0.0
    return real_number(name, given)


def _known(name: str, params: Any, keys: Iterable[str]) -> None:
    if not isinstance(params, Mapping):
        raise TypeError(f"{name} is {params!r}, expected a dict or None")
    for key in params:
        if key not in keys:
            raise ValueError(f"{name} has {key!r}, expected {', '.join(map(repr, keys))}")


def _one_of(name: str, value: Any, known: Mapping[str, Any]) -> Any:
    if value not in known:
        raise ValueError(f"{name} has {value!r}, expected {', '.join(map(repr, known))}")
    return known[value]
