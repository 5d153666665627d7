"""The original's base class, with its arguments, members and methods, on a world of the library."""

from __future__ import annotations

import secrets
import warnings
from typing import Any, Dict, Mapping, Optional, Sequence, Tuple

import gymnasium
import numpy as np
from gymnasium import spaces
from numpy.typing import ArrayLike, NDArray

from ..constants import Kind, Outcome, Quantity
from ..spaces import action_box
from ..world import World
from .actuation import SpringDamperModel, model_of
from .differences import DifferenceWarning, differences_of
from .model import DataView, ModelView
from .params import Params, senses_of
from .pictures import MODES, Renderer
from .scenes import scene_of, split
from .senses import Observer

Numbers = NDArray[np.float64]
Observation = Dict[str, NDArray[Any]]
GOALS = ("achieved_goal", "desired_goal")


class MIMoEnv(gymnasium.Env[Observation, NDArray[np.float32]]):
    """One world with the original's observations, goals and info.

    `model_path` is the name of a built-in scene, the path of an MJCF file, or a mimo.Scene. `initial_qpos`
    has angles of joints (rad) by name, seven numbers for the root `mimo_location`. mimo.classic.params documents the
    dictionaries of senses; None switches a sense off. `parameters` are those of the library's task, other options those
    of mimo.World. With `tell_differences` the environment warns of each difference from the original's numbers.

    Custom environments derive from it and override the same methods as with the original: compute_reward, is_success,
    is_failure, is_truncated, sample_goal, get_achieved_goal, reset_model, _step_callback.
    """

    metadata: Dict[str, Any] = {"render_modes": list(MODES), "render_fps": 100}  # noqa: RUF012
    torque_sensors: Optional[Sequence[str]] = None  # sensors with torques in `observation`; None: all
    extra_fields: Sequence[str] = ()  # fields of the library at the end of `observation`

    def __init__(
        self,
        model_path: Any,
        initial_qpos: Optional[Mapping[str, ArrayLike]] = None,
        frame_skip: int = 2,
        proprio_params: Params = None,
        touch_params: Params = None,
        vision_params: Params = None,
        vestibular_params: Params = None,
        actuation_model: Any = SpringDamperModel,
        goals_in_observation: bool = True,
        done_active: bool = False,
        render_mode: Optional[str] = None,
        width: int = 500,
        height: int = 500,
        camera_name: Optional[str] = None,
        default_camera_config: Optional[Mapping[str, Any]] = None,
        tell_differences: bool = False,
        parameters: Optional[Mapping[str, float]] = None,
        **options: Any,
    ) -> None:
        if render_mode is not None and render_mode not in MODES:
            raise ValueError(f"render_mode is {render_mode!r}, expected {', '.join(map(repr, MODES))} or None")
        self.actuation_model = model_of(actuation_model)
        senses = senses_of(proprio_params, touch_params, vision_params, vestibular_params)
        infant, simulated = split(options, type(self).__name__)
        infant.update(senses.options, actuation=self.actuation_model.actuation)
        self.scene = scene_of(model_path, infant, senses, initial_qpos or {}, parameters or {})
        self.world = World(self.scene, frame_skip=frame_skip, **simulated)
        self.frame_skip, self.render_mode = frame_skip, render_mode
        self.goals_in_observation, self.done_active = goals_in_observation, done_active
        self.model, self.data = ModelView(self.world), DataView(self.world)
        self.init_qpos, self.init_qvel = self.data.qpos.copy(), self.data.qvel.copy()
        self.mujoco_renderer = Renderer(self.world, width, height, camera_name, default_camera_config)
        self._observer = Observer(self.world, senses, self.torque_sensors, self.extra_fields)
        self._seeded = False
        self.goal: Numbers = self.sample_goal()
        self.action_space: Any = action_box(self.world.action_low, self.world.action_high)
        self.observation_space: Any = self._space()
        self.metadata = {**self.metadata, "render_fps": round(1 / self.dt)}
        if tell_differences:
            for line in differences_of(type(self)):
                warnings.warn(line, DifferenceWarning, stacklevel=2)

    # ---- Gymnasium -----------------------------------------------------------------------------------------------

    def reset(
        self, *, seed: Optional[int] = None, options: Optional[Dict[str, Any]] = None
    ) -> Tuple[Observation, Dict[str, Any]]:
        """Starts an episode. Without a seed the first one is random; later ones continue its random numbers."""
        super().reset(seed=seed)
        if seed is None and not self._seeded:
            seed = secrets.randbits(64)
        self._seeded = True
        self.world.reset(seed)
        self.goal = self.sample_goal()
        observation = self.reset_model()
        if self.render_mode == "human":
            self.render()
        return observation, self._told(False, False)

    def step(self, action: NDArray[np.float32]) -> Tuple[Observation, float, bool, bool, Dict[str, Any]]:
        """Makes one step."""
        self.world.step(action)
        self._step_callback()
        observation = self._get_obs()
        achieved = self.get_achieved_goal()
        success = bool(self.is_success(achieved, self.goal))
        failure = bool(self.is_failure(achieved, self.goal))
        info = self._told(success, failure)
        reward = float(self.compute_reward(achieved, self.goal, info))
        if self.render_mode == "human":
            self.render()
        terminated = self.done_active and (success or failure)
        return observation, reward, terminated, bool(self.is_truncated()), info

    def render(self) -> Any:
        """A picture with render_mode "rgb_array" or "depth_array"; with "human" it shows in a window."""
        return None if self.render_mode is None else self.mujoco_renderer.render(self.render_mode)

    def close(self) -> None:
        """Closes the world."""
        self.mujoco_renderer.close()
        self.world.close()

    # ---- For custom environments -----------------------------------------------------------------------------------

    def compute_reward(self, achieved_goal: Any, desired_goal: Any, info: Any) -> Any:
        """The reward of the last step, by the library's task; not a function of goals alone."""
        if np.ndim(achieved_goal) > 1:
            raise TypeError(f"rewards of {type(self).__name__} do not follow from goals: there is one at a time")
        return self.world.reward.item(0)

    def is_success(self, achieved_goal: Any, desired_goal: Any) -> bool:
        """Whether the last step succeeded."""
        return bool(self.world.outcome.item(0) == int(Outcome.SUCCESS))

    def is_failure(self, achieved_goal: Any, desired_goal: Any) -> bool:
        """Whether it failed."""
        return bool(self.world.outcome.item(0) == int(Outcome.FAILURE))

    def is_truncated(self) -> bool:
        """Whether the episode is cut off here, as by Gymnasium's limit of steps."""
        return False

    def sample_goal(self) -> Numbers:
        """The goal of the new episode: numbers of the task, empty without one."""
        return self.world.get(Quantity.AGENT_GOAL).ravel()

    def get_achieved_goal(self) -> Numbers:
        """The achieved goal."""
        return self.world.get(Quantity.AGENT_ACHIEVED).ravel()

    def reset_model(self) -> Observation:
        """Prepares an episode after a reset, and returns the first observation."""
        return self._get_obs()

    def _step_callback(self) -> None:
        """Called in each step between physics and observation. After changing the state, call world.observe()."""

    # ---- Helpers of these ------------------------------------------------------------------------------------------

    def _get_obs(self) -> Observation:
        seen = self._observer.see(self.world.observation)
        if self.goals_in_observation:
            seen.update(achieved_goal=np.array(self.get_achieved_goal()), desired_goal=np.array(self.goal))
        return seen

    def set_state(self, qpos: ArrayLike, qvel: ArrayLike) -> None:
        """Sets positions and velocities of all joints, and observes."""
        self.data.qvel = qvel
        self.data.qpos = qpos
        self.world.observe()

    @property
    def dt(self) -> float:
        """Length of a step, s."""
        return self.world.timestep * self.frame_skip

    @property
    def touch(self) -> Any:
        """The skin: sensor_positions and sensor_outputs by number of body; None without touch."""
        return self._observer.touch

    @property
    def n_actuators(self) -> int:
        """The number of MIMo's motors."""
        return len(self.mimo_actuators)

    @property
    def mimo_actuators(self) -> NDArray[np.intp]:
        """The numbers of MIMo's motors."""
        return self._named(Kind.ACTUATOR, "act:")

    @property
    def mimo_joints(self) -> NDArray[np.intp]:
        """Numbers of MIMo's joints."""
        return self._named(Kind.JOINT, "robot:")

    def _named(self, kind: Kind, start: str) -> NDArray[np.intp]:
        names = (self.world.name(kind, number) for number in range(self.world.count(kind)))
        return np.array([number for number, name in enumerate(names) if name.startswith(start)], np.intp)

    def _told(self, success: bool, failure: bool) -> Dict[str, Any]:
        info: Dict[str, Any] = {"is_success": success, "is_failure": failure}
        if not self.goals_in_observation:
            info.update(achieved_goal=np.array(self.get_achieved_goal()), desired_goal=np.array(self.goal))
        return info

    def _space(self) -> spaces.Dict:
        boxes: Dict[str, spaces.Space[Any]] = dict(self._observer.boxes)
        if self.goals_in_observation:
            shapes = np.shape(self.get_achieved_goal()), np.shape(self.goal)
            boxes.update({name: spaces.Box(-np.inf, np.inf, shape, np.float64) for name, shape in zip(GOALS, shapes)})
        return spaces.Dict(boxes)
