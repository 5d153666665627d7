"""Baselines: random actions, and for each behaviour a reward that needs nobody to tell what is good.

env = mimo.babybench.make("selftouch")
learner = PPO("MultiInputPolicy", mimo.babybench.TouchCount(env))
"""

from __future__ import annotations

from typing import Any, Dict, Mapping, Tuple

import gymnasium
import numpy as np
from numpy.typing import ArrayLike, NDArray

Step = Tuple[Any, float, bool, bool, Dict[str, Any]]
FELT = 1e-6  # N
GREY = (0.2989, 0.587, 0.114)  # shares of red, green and blue in brightness


class IntrinsicReward(gymnasium.Wrapper[Any, Any, Any, Any]):
    """Adds a reward that is computed from what is observed; derive `intrinsic`. It is in info["intrinsic_reward"]."""

    def intrinsic(self, observation: Mapping[str, NDArray[Any]]) -> float:
        """The reward of an observation."""
        raise NotImplementedError

    def step(self, action: Any) -> Step:
        """Goes one step on."""
        observation, reward, terminated, truncated, info = self.env.step(action)
        own = self.intrinsic(observation)
        return observation, float(reward) + own, terminated, truncated, {**info, "intrinsic_reward": own}


class TouchCount(IntrinsicReward):
    """For self-touch: the share of the skin's numbers that are above 1e-6, as the competition's baseline has it.

    Of a sensor's three numbers only those above 0 count, and the mattress is felt as well as the own hand.
    """

    def intrinsic(self, observation: Mapping[str, NDArray[Any]]) -> float:
        """The reward of an observation."""
        return float(np.mean(observation["touch"] > FELT))


class TouchedSensors(IntrinsicReward):
    """For self-touch: the share of sensors that feel a force of any direction."""

    def intrinsic(self, observation: Mapping[str, NDArray[Any]]) -> float:
        """The reward of an observation."""
        return float(np.mean(np.linalg.norm(observation["touch"].reshape(-1, 3), axis=1) > FELT))


class Saliency(IntrinsicReward):
    """For hand regard: how many edges both eyes see, as the competition's baseline has it."""

    def intrinsic(self, observation: Mapping[str, NDArray[Any]]) -> float:
        """The reward of an observation."""
        return saliency(observation["eye_left"]) + saliency(observation["eye_right"])


def saliency(picture: ArrayLike) -> float:
    """The norm of the brightness's Laplacian of four neighbours, over the number of pixels."""
    grey = to_grayscale(picture)
    wide = np.pad(grey, 1, mode="symmetric")
    neighbours = wide[:-2, 1:-1] + wide[2:, 1:-1] + wide[1:-1, :-2] + wide[1:-1, 2:]
    return float(np.linalg.norm(4 * grey - neighbours) / grey.size)


def to_grayscale(picture: ArrayLike) -> NDArray[np.float64]:
    """Brightness of a picture, 0 to 255."""
    grey: NDArray[np.float64] = np.asarray(picture, np.float64)[..., :3] @ np.array(GREY)
    return grey
