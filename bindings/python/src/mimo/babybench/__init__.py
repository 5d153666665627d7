"""BabyBench: infants that explore their body, in three scenes; scores of self-touch and hand regard.

    env = mimo.babybench.make("config.yml")     # or a dict, or "selftouch", "handregard", "test_installation"
    envs = mimo.babybench.make_vec("selftouch", 64)
    python -m mimo.babybench.evaluate LOGS      # scores of logs

docs/guide/babybench.md explains the configuration, the scores, and differences from the competition's platform.
"""

from . import utils
from .baselines import (
    IntrinsicReward,
    Saliency,
    TouchCount,
    TouchedSensors,
    saliency,
    saliency_of_eyes,
    touch_count,
    touched_sensors,
)
from .config import load, shipped
from .env import BabyBenchEnv
from .evaluation import EVALS, Evaluation
from .making import make, register
from .scores import Scores, scores_of
from .vector import BabyBenchVectorEnv, make_vec

register()

__all__ = [
    "BabyBenchEnv",
    "BabyBenchVectorEnv",
    "EVALS",
    "Evaluation",
    "IntrinsicReward",
    "Saliency",
    "Scores",
    "TouchCount",
    "TouchedSensors",
    "load",
    "make",
    "make_vec",
    "register",
    "saliency",
    "saliency_of_eyes",
    "scores_of",
    "shipped",
    "touch_count",
    "touched_sensors",
    "utils",
]
