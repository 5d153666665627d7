"""Baselines: random actions, and an intrinsic reward for each behaviour.

env = mimo.babybench.TouchCount(mimo.babybench.make("selftouch"))
envs = mimo.babybench.make_vec("selftouch", 64, reward=mimo.babybench.touch_count)
"""

from __future__ import annotations

from typing import Any, Dict, Mapping, Tuple

import gymnasium
import numpy as np
from numpy.typing import ArrayLike, NDArray

Observation = Mapping[str, NDArray[Any]]
Step = Tuple[Any, float, bool, bool, Dict[str, Any]]
FELT = 1e-6  # N
GREY = (0.2989, 0.587, 0.114)  # shares of red, green and blue in brightness


def touch_count(observation: Observation) -> Any:
    """For self-touch: the share of the skin's numbers above 1e-6, as in the competition's baseline.

    Only positive numbers of a sensor's three count, and the mattress counts like the infant's hand. For many worlds it
    returns an array, like all these functions.
    """
    return np.mean(observation["touch"] > FELT, axis=-1)


def touched_sensors(observation: Observation) -> Any:
    """For self-touch: the share of sensors that feel a force of any direction."""
    touch = observation["touch"]
    forces = touch.reshape((*touch.shape[:-1], -1, 3))
    return np.mean(np.linalg.norm(forces, axis=-1) > FELT, axis=-1)


def saliency_of_eyes(observation: Observation) -> Any:
    """For hand regard: the amount of edges in both eyes' pictures, as in the competition's baseline."""
    return saliency(observation["eye_left"]) + saliency(observation["eye_right"])


def saliency(picture: ArrayLike) -> Any:
    """The norm of the brightness's Laplacian of four neighbours, over the number of pixels."""
    grey = to_grayscale(picture)
    edge = [(0, 0)] * (grey.ndim - 2) + [(1, 1), (1, 1)]
    wide = np.pad(grey, edge, mode="symmetric")
    neighbours = wide[..., :-2, 1:-1] + wide[..., 2:, 1:-1] + wide[..., 1:-1, :-2] + wide[..., 1:-1, 2:]
    pixels = grey.shape[-2] * grey.shape[-1]
    return np.linalg.norm(4 * grey - neighbours, axis=(-2, -1)) / pixels


def to_grayscale(picture: ArrayLike) -> NDArray[np.float64]:
    """Brightness of a picture, 0 to 255."""
    grey: NDArray[np.float64] = np.asarray(picture, np.float64)[..., :3] @ np.array(GREY)
    return grey


class IntrinsicReward(gymnasium.Wrapper[Any, Any, Any, Any]):
    """Adds a reward computed from the observation; override `intrinsic`. It is also in info["intrinsic_reward"]."""

    def intrinsic(self, observation: Observation) -> float:
        """The reward of an observation."""
        raise NotImplementedError

    def step(self, action: Any) -> Step:
        """Makes one step."""
        observation, reward, terminated, truncated, info = self.env.step(action)
        own = self.intrinsic(observation)
        return observation, float(reward) + own, terminated, truncated, {**info, "intrinsic_reward": own}


class TouchCount(IntrinsicReward):
    """Rewards by touch_count."""

    def intrinsic(self, observation: Observation) -> float:
        """The reward of an observation."""
        return float(touch_count(observation))


class TouchedSensors(IntrinsicReward):
    """Rewards by touched_sensors."""

    def intrinsic(self, observation: Observation) -> float:
        """The reward of an observation."""
        return float(touched_sensors(observation))


class Saliency(IntrinsicReward):
    """Rewards by saliency_of_eyes."""

    def intrinsic(self, observation: Observation) -> float:
        """The reward of an observation."""
        return float(saliency_of_eyes(observation))
