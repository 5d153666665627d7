"""The environments of BabyBench."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Dict, List, Optional, Tuple

import numpy as np
from numpy.typing import NDArray

from ..classic.env import MIMoEnv, Observation
from ..classic.utils import get_geoms_for_body
from ..constants import Quantity
from .config import Config, Given, load
from .counts import HANDS, counts_of, geoms_below
from .logs import Entry, log_of
from .params import Parameters, arguments_of
from .rooms import room_of


class BabyBenchEnv(MIMoEnv):
    """An infant in one of the scenes; rewards are 0, and `info` has the counts of the behaviour.

    The library's tasks settle the infant at a reset, move it at random, and count. With `training` each episode is
    logged in the folder `save_dir`/logs of the configuration.
    """

    def __init__(
        self,
        config: Given = "test_installation",
        training: bool = True,
        *,
        parameters: Parameters = None,
        **arguments: Any,
    ) -> None:
        self.config: Config = load(config)
        size = self.config["render_size"]
        given = arguments_of(self.config, parameters)
        standard = {"goals_in_observation": False, "width": size, "height": size, **given}
        super().__init__(room_of(self.config), **{**standard, **arguments})
        self.steps = 0
        self.save_dir = None if self.config["save_dir"] is None else Path(self.config["save_dir"])
        self._log = log_of(self.config) if training else None
        self._counts = counts_of(self.config, self.world)
        self._last = self._empty = self._nothing()
        self._closed = False
        self._settle()

    def _settle(self) -> None:
        """Resets settle the infant, but in a behaviour's own scene; `init_qpos` and `init_qvel` are the state then."""
        if self._counts.settles:
            self.world.physics_step(int(self.scene.parameters[f"{self._counts.task}/settle_steps"]))
        self.init_qpos, self.init_qvel = self.data.qpos.copy(), self.data.qvel.copy()
        self.forward()

    # ---- Episodes ------------------------------------------------------------------------------------------------

    def reset(
        self, *, seed: Optional[int] = None, options: Optional[Dict[str, Any]] = None
    ) -> Tuple[Observation, Dict[str, Any]]:
        """Starts an episode: settled, and with a behaviour of BabyBench's after ten random physics steps."""
        super(MIMoEnv, self).reset(seed=seed)
        self._end_episode()
        self._restart(seed)
        return self._get_obs(), {}

    def step(self, action: NDArray[Any]) -> Tuple[Observation, float, bool, bool, Dict[str, Any]]:
        """Makes one step of `frame_skip` physics steps."""
        self.do_simulation(action, self.frame_skip)
        self._last = {"steps": self.steps, **self._counted()}
        self.steps += 1
        if self.render_mode == "human":
            self.render()
        return self._get_obs(), 0.0, False, False, dict(self._last)

    def close(self) -> None:
        """Logs the current episode, and closes the world."""
        if not self._closed:
            self._end_episode()
            if self._log is not None:
                self._log.flush()
        self._closed = True
        super().close()

    def _counted(self) -> Dict[str, Any]:
        told: Dict[str, Any] = self._counts.told(self.world.get(Quantity.AGENT_ACHIEVED).ravel())
        return told

    def _nothing(self) -> Dict[str, Any]:
        """What an episode without steps tells."""
        told: Dict[str, Any] = self._counts.told(np.zeros_like(self.world.get(Quantity.AGENT_ACHIEVED).ravel()))
        return told

    def _end_episode(self) -> None:
        """Logs the episode. As in the competition, a reset without steps is an entry, too."""
        if self._log is not None:
            self._log.add({**self._last, "steps": self.steps})
        self.steps = 0
        self._last = self._empty

    @property
    def log(self) -> List[Entry]:
        """Ended episodes, one entry per reset."""
        return [] if self._log is None else self._log.entries

    # ---- Members that scripts use ----------------------------------------------------------------------------------

    @property
    def right_hand_geoms(self) -> List[int]:
        """Numbers of the geoms of the right palm."""
        return get_geoms_for_body(self.model, self.model.body(HANDS[0]).id)

    @property
    def left_hand_geoms(self) -> List[int]:
        """Numbers of the geoms of the left palm."""
        return get_geoms_for_body(self.model, self.model.body(HANDS[1]).id)

    @property
    def mimo_geoms(self) -> List[int]:
        """Numbers of all geoms of the infant."""
        return geoms_below(self.model, "hip")
