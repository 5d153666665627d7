"""BabyBench: an infant that is to find out about its body, in three scenes; scores of self-touch and hand regard.

    env = mimo.babybench.make("config.yml")     # or a dict, or "selftouch", "handregard", "test_installation"
    python -m mimo.babybench.evaluate LOGS      # scores of logs

docs/guide/babybench.md has the configuration, the scores, and what differs from the competition's own platform.
"""

from . import utils
from .baselines import IntrinsicReward, Saliency, TouchCount, TouchedSensors, saliency
from .config import load, shipped
from .env import BabyBenchEnv
from .evaluation import EVALS, Evaluation
from .making import make, register
from .scores import Scores, scores_of

register()

__all__ = [
    "BabyBenchEnv",
    "EVALS",
    "Evaluation",
    "IntrinsicReward",
    "Saliency",
    "Scores",
    "TouchCount",
    "TouchedSensors",
    "load",
    "make",
    "register",
    "saliency",
    "scores_of",
    "shipped",
    "utils",
]
