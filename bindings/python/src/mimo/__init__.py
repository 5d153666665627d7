"""MIMo, the multimodal infant model.

    env = mimo.make("reach")                        # a Gymnasium environment
    envs = mimo.make_vec("reach", num_envs=64)      # many worlds at once
    world = mimo.World("benchmark")                 # names, contacts, pictures, states

The library's messages go to the logger "mimo".
"""

from __future__ import annotations

import importlib.util
from typing import TYPE_CHECKING, Any, Union

from . import constants, conversions
from ._library import abi_version, api_version, library_path, mujoco_version, supports, version
from .access import Access
from .arguments import meant
from .batch import Batch
from .constants import *  # noqa: F403
from .conversions import *  # noqa: F403
from .errors import (
    ArgumentError,
    BusyError,
    ClosedError,
    EndError,
    Error,
    FileError,
    ForkedError,
    InternalError,
    MismatchError,
    ModelError,
    NotFoundError,
    OutOfMemoryError,
    RenderError,
    SimulationError,
    TaskError,
    UnsupportedError,
)
from .layout import Action, Field, Layout, Observation, Receptors, Term
from .maturity import Maturity
from .own_sense import Sense
from .own_task import Moment, WorldTask
from .policy import Policy
from .recorder import Recorder
from .recordings import Recording, ReplayReport
from .registration import register_when_imported
from .renderer import Renderer
from .results import StepResult
from .scene import Scene, faces, materials, rooms, scenes, tasks
from .selection import Selection
from .senses import Senses
from .stage import Stage, StagePicture, StageView
from .states import LoadReport
from .tasks import GoalTask, Judgement, Task
from .world import World

if TYPE_CHECKING:
    from .env import Env
    from .vector import VectorEnv, make_vec

__version__ = version()
# Imported on demand, because they need Gymnasium or PettingZoo.
_MODULES = {"Env": "env", "VectorEnv": "vector", "make_vec": "vector", "ParallelEnv": "parallel"}


def make(scene: Union[str, Scene] = "benchmark", **options: Any) -> Env:
    """One world of a scene as a gymnasium.Env; see mimo.Env for the options."""
    from .env import Env

    return Env(scene, **options)


def __getattr__(name: str) -> Any:
    if name in _MODULES:
        return getattr(importlib.import_module(f"mimo.{_MODULES[name]}"), name)
    # Modules are imported on demand, because some need extras.
    if not name.startswith("_") and importlib.util.find_spec(f"mimo.{name}") is not None:
        return importlib.import_module(f"mimo.{name}")
    raise AttributeError(f"module 'mimo' has no attribute {name!r}{meant(name, __all__)}")


register_when_imported()

__all__ = [
    *constants.__all__,
    *conversions.__all__,
    "Access",
    "Action",
    "ArgumentError",
    "Batch",
    "BusyError",
    "EndError",
    "MismatchError",
    "ClosedError",
    "Env",
    "Error",
    "Field",
    "FileError",
    "ForkedError",
    "GoalTask",
    "InternalError",
    "Judgement",
    "Layout",
    "LoadReport",
    "Maturity",
    "ModelError",
    "Moment",
    "NotFoundError",
    "Observation",
    "OutOfMemoryError",
    "Policy",
    "Recorder",
    "Recording",
    "ReplayReport",
    "Receptors",
    "RenderError",
    "Renderer",
    "Scene",
    "Sense",
    "Senses",
    "Selection",
    "SimulationError",
    "Stage",
    "StagePicture",
    "StageView",
    "StepResult",
    "Task",
    "TaskError",
    "Term",
    "UnsupportedError",
    "VectorEnv",
    "World",
    "WorldTask",
    "abi_version",
    "api_version",
    "faces",
    "materials",
    "library_path",
    "make",
    "make_vec",
    "mujoco_version",
    "rooms",
    "scenes",
    "supports",
    "tasks",
    "version",
]
