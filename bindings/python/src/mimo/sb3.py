"""A VecEnv of Stable-Baselines3. Needs the extra [train]."""

from __future__ import annotations

from typing import Any, Dict, List, Optional, Sequence, Tuple, Type, Union

import gymnasium
import numpy as np
from numpy.typing import NDArray

from .arguments import reset_options
from .scene import Scene
from .vector import VectorEnv

try:
    from stable_baselines3.common.vec_env.base_vec_env import VecEnv
except ImportError as error:
    raise ImportError("mimo.sb3 needs Stable-Baselines3: pip install 'mimo[train]'") from error


class SB3VecEnv(VecEnv):
    """Many worlds. Takes the arguments of mimo.make_vec, as SB3VecEnv("reach", 16), or a mimo.VectorEnv.

    Such an environment needs autoreset_mode "SameStep". As in SB3, seed() before a reset sets the seeds.
    """

    def __init__(
        self, scene: Union[str, Scene, VectorEnv] = "benchmark", num_envs: Optional[int] = None, **options: Any
    ) -> None:
        if isinstance(scene, VectorEnv):
            self.envs = _there_already(scene, num_envs, options)
        else:
            self.envs = VectorEnv(scene, 1 if num_envs is None else num_envs, autoreset_mode="SameStep", **options)
        self.render_mode = self.envs.render_mode
        super().__init__(self.envs.num_envs, self.envs.single_observation_space, self.envs.single_action_space)
        self.metadata = self.envs.metadata

    def reset(self) -> Any:
        """Starts an episode in all worlds."""
        for options in getattr(self, "_options", ()):  # since SB3 2.1
            reset_options(options)
        seed = self._seeds[0] if self._seeds else None
        observation, _ = self.envs.reset(seed=seed)
        self._reset_seeds()
        if hasattr(self, "_reset_options"):
            self._reset_options()
        self.reset_infos: List[Dict[str, Any]] = [{} for _ in range(self.num_envs)]
        return observation

    def step_async(self, actions: NDArray[Any]) -> None:
        """Starts a step."""
        self.envs.send(actions)

    def step_wait(self) -> Tuple[Any, NDArray[Any], NDArray[Any], List[Dict[str, Any]]]:
        """Waits for the step."""
        observation, reward, terminated, truncated, infos = self.envs.receive()
        done = terminated | truncated
        listed: List[Dict[str, Any]] = [{"TimeLimit.truncated": False} for _ in range(self.num_envs)]
        if told := infos.get("final_info", infos):  # the library's tasks report only at ends of episodes
            for index, info in enumerate(listed):
                info.update(_of_world(told, index))
        for index in np.flatnonzero(done).tolist():
            listed[index]["TimeLimit.truncated"] = bool(truncated[index] and not terminated[index])
            listed[index]["terminal_observation"] = infos["final_obs"][index]
        return observation, reward.astype(np.float32), done, listed

    def close(self) -> None:
        """Closes all worlds."""
        self.envs.close()

    def get_attr(self, attr_name: str, indices: Any = None) -> List[Any]:
        """An attribute of the environment; all worlds share it."""
        return [getattr(self.envs, attr_name)] * len(list(self._get_indices(indices)))

    def set_attr(self, attr_name: str, value: Any, indices: Any = None) -> None:
        """Sets an attribute of the environment for all worlds."""
        if len(list(self._get_indices(indices))) != self.num_envs:
            raise ValueError("the worlds of a batch share their attributes; set them for all")
        setattr(self.envs, attr_name, value)

    def env_method(self, method_name: str, *method_args: Any, indices: Any = None, **method_kwargs: Any) -> List[Any]:
        """Calls a method of single worlds (mimo.World), or compute_reward for HER."""
        chosen = self._get_indices(indices)
        if method_name == "compute_reward":
            return [self.envs.compute_reward(*method_args, **method_kwargs) for _ in chosen]
        return [getattr(self.envs.batch.world(i), method_name)(*method_args, **method_kwargs) for i in chosen]

    def env_is_wrapped(
        self, wrapper_class: Type[gymnasium.Wrapper[Any, Any, Any, Any]], indices: Any = None
    ) -> List[bool]:
        """Worlds are never wrapped."""
        return [False] * len(list(self._get_indices(indices)))

    def get_images(self) -> Sequence[Optional[NDArray[np.uint8]]]:
        """One picture per world."""
        return [None] * self.num_envs if self.render_mode is None else list(self.envs.render() or ())


def _there_already(envs: VectorEnv, num_envs: Optional[int], options: Dict[str, Any]) -> VectorEnv:
    if num_envs not in (None, envs.num_envs):
        raise ValueError(f"num_envs is {num_envs}, but the environment that was given has {envs.num_envs}")
    for option in options:
        raise TypeError(f"{option} comes too late: the environment that was given is made already")
    mode = getattr(envs.autoreset_mode, "value", envs.autoreset_mode)
    if mode != "SameStep":
        raise ValueError(f"the environment's autoreset_mode is {mode!r}, expected 'SameStep', as SB3 has it")
    return envs


def _of_world(infos: Dict[str, Any], index: int) -> Dict[str, Any]:
    """The info of one world, from Gymnasium's arrays and masks."""
    counts = [name for name in infos if "_" + name in infos and infos["_" + name][index]]
    return {name: _of_world(it, index) if isinstance(it := infos[name], dict) else _plain(it[index]) for name in counts}


def _plain(value: Any) -> Any:
    return value.item() if isinstance(value, np.generic) else value
