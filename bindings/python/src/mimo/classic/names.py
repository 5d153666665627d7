"""The original's modules and the competition's, and where their names are here."""

from __future__ import annotations

import os
import sys
from typing import Any, Dict, Iterable, List, Mapping, Tuple

CLASSIC = ("mimo.classic",)
UTILS = ("mimo.classic.utils",)
ACTUATION = ("mimo.classic.actuation",)
TOUCH = ("mimo.classic.touch",)
SENSORS = ("mimo.classic.sensors",)
GROWTH = ("mimo.classic.growth",)
KIT = ("mimo.babybench",)

_ENVS = ("reach", "standup", "selfbody", "catch", "dummy", "roll_over", "mimo_muscle_env")
# The names of original modules, each with the modules of this package that have its names.
MODULES: Dict[str, Tuple[str, ...]] = {
    "mimoEnv": CLASSIC,
    "mimoEnv.envs": CLASSIC,
    "mimoEnv.envs.mimo_env": (*CLASSIC, *SENSORS, *TOUCH),
    **{f"mimoEnv.envs.{name}": CLASSIC for name in _ENVS},
    "mimoEnv.utils": UTILS,
    "mimoEnv.babybench": KIT,
    "mimoEnv.babybench.base": KIT,
    "mimoEnv.babybench.selftouch": KIT,
    "mimoEnv.babybench.handregard": KIT,
    "mimoActuation": (),
    "mimoActuation.actuation": ACTUATION,
    "mimoActuation.muscle": ACTUATION,
    "mimoTouch": (),
    "mimoTouch.touch": TOUCH,
    "mimoVision": (),
    "mimoVision.vision": SENSORS,
    "mimoVestibular": (),
    "mimoVestibular.vestibular": SENSORS,
    "mimoProprioception": (),
    "mimoProprioception.proprio": SENSORS,
    "mimoGrowth": GROWTH,
    "mimoGrowth.growth": GROWTH,
    "mimo_infant": (*CLASSIC, *GROWTH),
    "mimo_infant.growth": GROWTH,
    "mimo_infant.growth.growth": GROWTH,
    "mimo_infant.growth.scene": GROWTH,
    "mimo_infant.simulation": CLASSIC,
    "mimo_infant.simulation.registration": CLASSIC,
    "mimo_infant.simulation.envs": CLASSIC,
    "mimo_infant.simulation.envs.mimo_env": (*CLASSIC, *SENSORS, *TOUCH),
    **{f"mimo_infant.simulation.envs.{name}": CLASSIC for name in _ENVS},
    "mimo_infant.simulation.utils": UTILS,
    "mimo_infant.actuation": (),
    "mimo_infant.actuation.actuation": ACTUATION,
    "mimo_infant.actuation.muscle": ACTUATION,
    "mimo_infant.touch": (),
    "mimo_infant.touch.touch": TOUCH,
    "mimo_infant.vision": (),
    "mimo_infant.vision.vision": SENSORS,
    "mimo_infant.vestibular": (),
    "mimo_infant.vestibular.vestibular": SENSORS,
    "mimo_infant.proprioception": (),
    "mimo_infant.proprioception.proprio": SENSORS,
    "babybench": KIT,
    "babybench.utils": ("mimo.babybench.utils",),
    "babybench.eval": ("mimo.babybench.evaluation",),
}
ROOTS = tuple(sorted({name.partition(".")[0] for name in MODULES}))
VERSIONS: Mapping[str, str] = {"mimo_infant": "3.0.0"}
UTILS_NAME = "mimoEnv.utils"
RENAMED: Mapping[str, str] = {"mimo_utils": "utils"}  # names of modules that are modules here under another name
EARLIER: Mapping[str, str] = {  # names of earlier releases, and of the kit's environments
    "MIMoV2DemoEnv": "MIMoV2DummyEnv",
    "BabyBenchSelfTouchEnv": "BabyBenchEnv",
    "BabyBenchHandRegardEnv": "BabyBenchEnv",
}
KIT_ENVIRONMENTS = "mimoEnv.babybench"  # a checkout with files of these runs its own, on our MIMoEnv
ENGINE = "mujoco"  # its functions take our models, too
VIEWER = "mujoco.viewer"
OLD_GYM = "gym"


def is_ours(name: str) -> bool:
    """Whether a module is, or lies in, one of these packages."""
    return name.partition(".")[0] in ROOTS


def folders(name: str, path: Iterable[str] = ()) -> List[str]:
    """Folders of a checkout with this package's own files: of a package in `path`, of others on sys.path."""
    last = name.rpartition(".")[2]
    places = list(path) if "." in name else sys.path
    found = [os.path.join(place or ".", last) for place in places]
    return [os.path.abspath(folder) for folder in found if os.path.isdir(folder)]


def file_of(name: str, path: Iterable[str]) -> str:
    """The file of a module in a checkout, "" if there is none."""
    last = name.rpartition(".")[2]
    places = [os.path.join(place or ".", last) for place in path]
    files = [file for place in places for file in (f"{place}.py", os.path.join(place, "__init__.py"))]
    return next((os.path.abspath(file) for file in files if os.path.isfile(file)), "")


def public(name: str) -> List[str]:
    """The names that `from this_module import *` takes."""
    import importlib

    modules = [importlib.import_module(module) for module in MODULES[name]]
    listed = [getattr(module, "__all__", [it for it in vars(module) if not it.startswith("_")]) for module in modules]
    return list(dict.fromkeys(it for names in listed for it in names))


def ours(name: str, member: str) -> Any:
    """A member of one of these modules; AttributeError if it has none."""
    import importlib

    member = EARLIER.get(member, member)
    for module in MODULES[name]:
        found = importlib.import_module(module)
        if hasattr(found, member):
            return getattr(found, member)
    if member in RENAMED:
        return importlib.import_module(f"mimo.classic.{RENAMED[member]}")
    raise AttributeError(member)
