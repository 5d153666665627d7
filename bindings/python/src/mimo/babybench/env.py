"""The environments of BabyBench."""

from __future__ import annotations

import secrets
from pathlib import Path
from typing import Any, Dict, List, Optional, Tuple

import numpy as np
from numpy.typing import NDArray

from ..classic.actuation import MuscleModel, PositionalModel, SpringDamperModel
from ..classic.env import MIMoEnv, Observation
from ..classic.params import COMPONENTS, DEFAULT_TOUCH_PARAMS, DEFAULT_TOUCH_PARAMS_V2
from .config import Config, Given, load, on
from .groups import of_groups
from .logs import Entry, TrainingLog
from .measures import HANDS, MEASURES, Touches
from .rooms import body_of, room_of

MODELS = {"spring_damper": SpringDamperModel, "muscle": MuscleModel, "positional": PositionalModel}
SETTLING, RANDOM = 100, 10  # physics steps


class BabyBenchEnv(MIMoEnv):
    """An infant in one of the scenes; rewards are 0, and `info` tells what the behaviour is measured by.

    With `training` each episode is logged in the folder `save_dir`/logs of the configuration.
    """

    def __init__(self, config: Given = "test_installation", training: bool = True, **arguments: Any) -> None:
        self.config: Config = load(config)
        size = self.config["render_size"]
        standard = {"frame_skip": 1, "goals_in_observation": False, "width": size, "height": size}
        super().__init__(room_of(self.config), **{**standard, **_senses(self.config), **arguments})
        self.frame_skip = self.config["frame_skip"]  # steps of the world are single physics steps
        self.metadata = {**self.metadata, "render_fps": round(1 / self.dt)}
        self.steps = 0
        self.save_dir = None if self.config["save_dir"] is None else Path(self.config["save_dir"])
        folder = self.save_dir / "logs" if training and self.save_dir is not None else None
        self._log = TrainingLog(folder, self.config["save_logs_every"]) if training else None
        self._body = Touches(self)
        self._measure = MEASURES[self.config["behavior"]](self)
        self._last = self._measure.told()
        self._settle()

    # ---- Episodes ------------------------------------------------------------------------------------------------

    def reset(
        self, *, seed: Optional[int] = None, options: Optional[Dict[str, Any]] = None
    ) -> Tuple[Observation, Dict[str, Any]]:
        """Starts an episode where the infant has settled; with a behaviour after ten random physics steps."""
        super(MIMoEnv, self).reset(seed=seed)
        if seed is None and not self._seeded:
            seed = secrets.randbits(64)
        self._seeded = True
        self._end_episode()
        self.world.reset_into(None, seed)
        self.data.qvel = self.init_qvel
        self.data.qpos = self.init_qpos
        if self.config["behavior"] != "none":
            self._move_at_random()
        self.world.observe()
        return self._get_obs(), {}

    def step(self, action: NDArray[np.float32]) -> Tuple[Observation, float, bool, bool, Dict[str, Any]]:
        """Goes one step on, of `frame_skip` physics steps."""
        for _ in range(self.frame_skip - 1):
            self.world.step_into(None, action)
        self.world.step(action)
        self._measure.take()
        self._last = {"steps": self.steps, **self._measure.told()}
        self.steps += 1
        if self.render_mode == "human":
            self.render()
        return self._get_obs(), 0.0, False, False, dict(self._last)

    def close(self) -> None:
        """Logs the episode that runs, and closes the world."""
        self._end_episode()
        if self._log is not None:
            self._log.flush()
        super().close()

    def _settle(self) -> None:
        """The infant comes to rest; resets start from there."""
        self.world.reset(0)
        still = np.zeros(len(self.world.action_names), np.float32)
        for _ in range(SETTLING):
            self.world.step_into(None, still)
        self.init_qpos, self.init_qvel = self.data.qpos.copy(), self.data.qvel.copy()
        self.world.observe()

    def _move_at_random(self) -> None:
        low, high = self.world.action_low, self.world.action_high
        for _ in range(RANDOM):
            self.world.step_into(None, low + (high - low) * self.world.random(len(low)))

    def _end_episode(self) -> None:
        """Logs what the episode came to. As in the competition a reset without steps is an entry, too."""
        if self._log is not None:
            self._log.add({**self._last, "steps": self.steps})
        self.steps = 0
        self._measure.begin()
        self._last = self._measure.told()

    @property
    def log(self) -> List[Entry]:
        """The episodes that have ended, one entry a reset."""
        return [] if self._log is None else self._log.entries

    # ---- Members that scripts use ----------------------------------------------------------------------------------

    @property
    def right_hand_geoms(self) -> List[int]:
        """Numbers of the geoms of the right palm."""
        return sorted(self._body.palms[HANDS[0]])

    @property
    def left_hand_geoms(self) -> List[int]:
        """Numbers of the geoms of the left palm."""
        return sorted(self._body.palms[HANDS[1]])

    @property
    def mimo_geoms(self) -> List[int]:
        """Numbers of all geoms of the infant."""
        return sorted(self._body.body)


def _senses(config: Config) -> Dict[str, Any]:
    """The original's arguments for what a configuration says of senses and motors."""
    pixels = {"width": config["vision_resolution"], "height": config["vision_resolution"]}
    return {
        "proprio_params": {"components": [part for part in COMPONENTS if config[f"proprio_{part}"]]},
        "vestibular_params": {} if config["vestibular_active"] else None,
        "vision_params": {"eye_left": pixels, "eye_right": pixels} if config["vision_active"] else None,
        "touch_params": _touch(config),
        "actuation_model": MODELS[config["actuation_model"]],
    }


def _touch(config: Config) -> Optional[Dict[str, Any]]:
    """Bodies of the groups that sense, with their distances times `touch_scale`; None without touch."""
    if not config["touch_active"] or config["touch_scale"] == 0:
        return None
    usual = DEFAULT_TOUCH_PARAMS_V2 if body_of(config) == "fingers" else DEFAULT_TOUCH_PARAMS
    bodies = of_groups(usual["scales"], on(config, "touch"))
    if not bodies:
        return None
    return {
        "scales": {body: usual["scales"][body] * config["touch_scale"] for body in bodies},
        "touch_function": config["touch_function"],
        "response_function": config["touch_response"],
    }
