"""Many worlds of BabyBench in one environment, stepped by the library's threads."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Callable, Dict, List, Mapping, Optional, Tuple

import numpy as np
from gymnasium import spaces
from numpy.typing import NDArray

from ..classic.params import Senses, senses_of
from ..classic.scenes import scene_of
from ..classic.senses import Observer
from ..constants import Autoreset, Quantity
from ..layout import Observation
from ..scene import Scene
from ..spaces import of_worlds
from ..vector import Flags, Results, VectorEnv
from .config import Config, Given, load
from .counts import counts_of
from .logs import Entry, log_of
from .params import Parameters, arguments_of
from .rooms import room_of

Reward = Callable[[Mapping[str, NDArray[Any]]], Any]


class BabyBenchVectorEnv(VectorEnv):
    """Worlds of one configuration, with the observations of BabyBenchEnv.

    `infos` has the counts in arrays, one row per world: for self-touch whether each geom of the body was touched.
    Rewards are 0, or the values of `reward`, a function of the observations: touch_count, touched_sensors,
    saliency_of_eyes, or another one. With `training` each episode is logged when it ends; with autoreset_mode
    "Disabled" it continues until a reset or close(), as in BabyBenchEnv. Other options are those of mimo.VectorEnv.
    """

    def __init__(
        self,
        config: Given = "test_installation",
        num_envs: int = 1,
        *,
        training: bool = True,
        reward: Optional[Reward] = None,
        **options: Any,
    ) -> None:
        self.config: Config = load(config)
        scene, senses = _scene_of(self.config, options.pop("parameters", None))
        steps = {"max_steps": self.config["max_episode_steps"], "frame_skip": self.config["frame_skip"]}
        super().__init__(scene, num_envs, **{**steps, **options})
        first = self.batch.world(0)
        self._view: Any = _Shown(Observer(first, senses))
        self.single_observation_space = self._view.space
        self.observation_space = of_worlds(self.single_observation_space, num_envs)
        self.save_dir = None if self.config["save_dir"] is None else Path(self.config["save_dir"])
        self._log = log_of(self.config) if training else None
        self._counts = counts_of(self.config, first)
        self._reward = reward
        self._steps = np.zeros(num_envs, int)
        self._achieved = self._now()

    # ---- Episodes ------------------------------------------------------------------------------------------------

    def reset(self, *, seed: Any = None, options: Optional[Dict[str, Any]] = None) -> Tuple[Any, Dict[str, Any]]:
        """Starts episodes, like VectorEnv."""
        started = super().reset(seed=seed, options=options)
        mask = (options or {}).get("reset_mask")
        self._end_episodes(np.ones(self.num_envs, np.bool_) if mask is None else np.asarray(mask, np.bool_))
        return started

    def close_extras(self, **kwargs: Any) -> None:
        """Logs the current episodes, and closes the batch."""
        if getattr(self, "_log", None) is not None:
            self._end_episodes(self._steps > 0)
            self._log.flush()  # type: ignore[union-attr]
        super().close_extras(**kwargs)

    @property
    def log(self) -> List[Entry]:
        """Ended episodes, in the order of their ends."""
        return [] if self._log is None else self._log.entries

    def _results(self) -> Results:
        begins = self._over if self._mode == Autoreset.NEXT_STEP else np.zeros_like(self._over)
        acted = ~begins
        observation, reward, terminated, truncated, infos = super()._results()
        if self._reward is None:
            reward = np.zeros_like(reward)  # a behaviour's scene has its own
        else:
            reward = np.where(acted, self._reward(observation), 0.0)
            for index in np.flatnonzero(infos.get("_final_obs", ())):
                reward[index] = self._reward(infos["final_obs"][index])
        return observation, reward, terminated, truncated, infos

    def _infos(self, over: Flags, acted: Flags, judged: Any) -> Dict[str, Any]:
        """The counts of the worlds. Logs ended episodes before new ones begin."""
        self._achieved = self._now()
        infos = {"steps": self._steps.copy(), **self._counts.told_of_all(self._achieved)}
        infos = {**super()._infos(over, acted, judged), **self._masked(infos, acted)}
        self._steps[acted] += 1
        if self._mode != Autoreset.NONE:
            self._end_episodes(over)
        return infos

    def _end_episodes(self, over: Flags) -> None:
        """As in the competition, a reset without steps is an entry, too."""
        for index in np.flatnonzero(over):
            if self._log is not None:
                self._log.add({**self._counts.told(self._achieved[index]), "steps": int(self._steps[index])})
        self._steps[over], self._achieved[over] = 0, 0

    def _now(self) -> NDArray[np.float64]:
        return self.batch.get(Quantity.AGENT_ACHIEVED).reshape(self.num_envs, -1)


class _Shown:
    """The observations of many worlds, for VectorEnv."""

    def __init__(self, observer: Observer) -> None:
        self._observer = observer
        boxes: Dict[str, spaces.Space[Any]] = dict(observer.boxes)
        self.space = spaces.Dict(boxes)

    def show(self, views: Observation, own: Any = None, worlds: int = 0) -> Dict[str, NDArray[Any]]:
        """The observation; `worlds` is the length of the arrays' first axis."""
        del own
        return self._observer.see(views, worlds)


def _scene_of(config: Config, parameters: Parameters) -> Tuple[Scene, Senses]:
    """The parts that BabyBenchEnv makes of the same configuration."""
    given = arguments_of(config, parameters)
    senses = senses_of(*(given[f"{sense}_params"] for sense in ("proprio", "touch", "vision", "vestibular")))
    infant = {**senses.options, "actuation": given["actuation_model"].actuation}
    return scene_of(room_of(config), infant, senses, {}, given["parameters"]), senses


def make_vec(config: Given = "test_installation", num_envs: int = 1, **options: Any) -> BabyBenchVectorEnv:
    """Many worlds from a YAML file or a dict; see BabyBenchVectorEnv for the options."""
    return BabyBenchVectorEnv(config, num_envs, **options)
