"""The original's environments under their names, for existing scripts.

    import mimo.classic                             # was: import mimoEnv
    env = gymnasium.make("MIMoReach-v0")            # or mimo.classic.make("MIMoReach-v0")

docs/guide/classic.md explains how to adapt scripts.
"""

from . import utils
from .actuation import ActuationModel, MuscleModel, PositionalModel, SpringDamperModel
from .differences import DifferenceWarning
from .env import DEFAULT_SIZE, EMOTES, MIMoEnv
from .envs import (
    BENCHMARK_XML,
    BENCHMARK_XML_V2,
    CATCH_XML,
    DEMO_XML,
    REACH_XML,
    ROLL_OVER_XML,
    SELFBODY_XML,
    SHOWROOM_XML,
    STANDUP_XML,
    MIMoCatchEnv,
    MIMoDummyEnv,
    MIMoMuscleDummyEnv,
    MIMoReachEnv,
    MIMoRollOverEnv,
    MIMoSelfBodyEnv,
    MIMoShowroomEnv,
    MIMoStandupEnv,
    MIMoV2DummyEnv,
)
from .params import (
    DEFAULT_PROPRIOCEPTION_PARAMS,
    DEFAULT_TOUCH_PARAMS,
    DEFAULT_TOUCH_PARAMS_V2,
    DEFAULT_VESTIBULAR_PARAMS,
    DEFAULT_VISION_PARAMS,
)
from .registry import ENVIRONMENTS, differences, make, register
from .scenes import scene_directory

SCENE_DIRECTORY = scene_directory("mimoEnv")

register()

__all__ = [
    "ActuationModel",
    "BENCHMARK_XML",
    "BENCHMARK_XML_V2",
    "CATCH_XML",
    "DEMO_XML",
    "EMOTES",
    "DEFAULT_PROPRIOCEPTION_PARAMS",
    "DEFAULT_SIZE",
    "DEFAULT_TOUCH_PARAMS",
    "DEFAULT_TOUCH_PARAMS_V2",
    "DEFAULT_VESTIBULAR_PARAMS",
    "DEFAULT_VISION_PARAMS",
    "DifferenceWarning",
    "ENVIRONMENTS",
    "MIMoCatchEnv",
    "MIMoDummyEnv",
    "MIMoEnv",
    "MIMoMuscleDummyEnv",
    "MIMoReachEnv",
    "MIMoRollOverEnv",
    "MIMoSelfBodyEnv",
    "MIMoShowroomEnv",
    "MIMoStandupEnv",
    "MIMoV2DummyEnv",
    "MuscleModel",
    "PositionalModel",
    "REACH_XML",
    "ROLL_OVER_XML",
    "SCENE_DIRECTORY",
    "SELFBODY_XML",
    "SHOWROOM_XML",
    "STANDUP_XML",
    "SpringDamperModel",
    "differences",
    "make",
    "register",
    "utils",
]
