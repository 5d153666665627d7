"""The original's base class, with its arguments, members and methods, on a world of the library."""

from __future__ import annotations

import secrets
import warnings
from collections import deque
from types import FunctionType
from typing import Any, Dict, Mapping, Optional, Sequence, Tuple

import gymnasium
import numpy as np
from gymnasium import spaces
from numpy.typing import ArrayLike, NDArray

from ..constants import Kind, Outcome, Quantity
from ..layout import Observation as Views
from ..world import World
from .actuation import SpringDamperModel, is_own, model_of
from .differences import DifferenceWarning, differences_of
from .goals import RewardOfGoals
from .live import PAGE, Stage
from .model import DataView, ModelView
from .params import Params, senses_of
from .pictures import MODES, Renderer
from .plain import PlainWorld
from .scenes import age_of, split, start_of
from .senses import Observer
from .sensors import SimpleProprioception, SimpleVestibular, SimpleVision

Numbers = NDArray[np.float64]
Observation = Dict[str, NDArray[Any]]
DEFAULT_SIZE = 500  # pixels of pictures
GOALS = ("achieved_goal", "desired_goal")
# The original's names of faces, and the library's.
EMOTES = {
    "default": "neutral",
    "happy": "enjoyment",
    "sad": "sadness",
    "surprised": "surprise",
    "angry": "anger",
    "disgusted": "disgust",
    "scared": "fear",
}
# Methods of the original and of Gymnasium that nothing calls here.
_NEVER_CALLED = ("_initialize_simulation", "_get_joints", "_get_actuators", "_get_facial_expressions", "_viewer_setup")
# Methods that a derived class can have called in each physics step.
_EACH_STEP = ("do_simulation", "_single_mujoco_step", "_substep_callback", "_set_action")


class MIMoEnv(gymnasium.Env[Observation, NDArray[np.float32]]):
    """One world with the original's observations, goals and info.

    `model_path` is the name of a built-in scene, the path of an MJCF file, or a mimo.Scene. `initial_qpos`
    has angles of joints (rad) by name, seven numbers for the root `mimo_location`. mimo.classic.params documents the
    dictionaries of senses; None switches a sense off. `age` is in months; delays are in steps. `parameters` are those
    of the library's task, other options those of mimo.World. With `tell_differences` the environment warns of each
    difference from the original's numbers.

    Custom environments derive from it and override the same methods as with the original. If they override what happens
    in a physics step (do_simulation, _single_mujoco_step, _substep_callback, _set_action, or an actuation model of
    their own), Python makes the physics steps one by one.
    """

    metadata: Dict[str, Any] = {"render_modes": list(MODES), "render_fps": 100}  # noqa: RUF012
    torque_sensors: Optional[Sequence[str]] = None  # sensors with torques in `observation`; None: all
    extra_fields: Sequence[str] = ()  # fields of the library at the end of `observation`
    touch: Any = None  # the skin: sensor_positions and sensor_outputs by number of body; None without touch
    vision: Any = None
    vestibular: Any = None
    proprioception: Any = None

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
        width: int = DEFAULT_SIZE,
        height: int = DEFAULT_SIZE,
        camera_name: Optional[str] = None,
        default_camera_config: Optional[Mapping[str, Any]] = None,
        camera_id: Optional[int] = None,
        age: Optional[float] = None,
        custom_measurements: Optional[Mapping[str, float]] = None,
        sensory_delay: int = 0,
        motor_delay: int = 0,
        show_sensors: bool = False,
        print_space_sizes: bool = False,
        tell_differences: bool = False,
        parameters: Optional[Mapping[str, float]] = None,
        **options: Any,
    ) -> None:
        if render_mode is not None and render_mode not in MODES:
            raise ValueError(f"render_mode is {render_mode!r}, expected {', '.join(map(repr, MODES))} or None")
        kind = model_of(actuation_model)
        own = type(self)
        self.moves_by_hand = is_own(kind)
        for name in _NEVER_CALLED:
            if hasattr(own, name):
                warnings.warn(f"{own.__name__}.{name} is never called here; {PAGE}", stacklevel=2)
        self._by_hand = self.moves_by_hand or any(getattr(own, it) is not getattr(MIMoEnv, it) for it in _EACH_STEP)
        felt = touch_params
        if touch_params is not None and own.touch_setup is not MIMoEnv.touch_setup:
            felt = {"scales": touch_params.get("scales", {})}  # the places of sensors; the script makes the rest of it
        senses = senses_of(proprio_params, felt, vision_params, vestibular_params, age)
        infant, simulated = split(options, own.__name__)
        infant.update(senses.options, actuation=kind.actuation, **age_of(age, custom_measurements))
        self.proprio_params, self.touch_params = proprio_params, touch_params
        self.vision_params, self.vestibular_params = vision_params, vestibular_params
        self.age, self.frame_skip, self.render_mode = age, frame_skip, render_mode
        self.width, self.height, self.camera_name, self.camera_id = width, height, camera_name, camera_id
        self.goals_in_observation, self.done_active = goals_in_observation, done_active
        self.sensory_delay, self.motor_delay = sensory_delay, motor_delay
        self._late_seen: Any = deque()
        self._late_actions: Any = deque()
        given = (model_path, infant, senses, initial_qpos or {}, parameters or {})
        self.scene, self._late_pose, file = start_of(*given, drawn=render_mode is not None)
        self.fullpath = file or self.scene.source
        simulated["frame_skip"] = 1 if self._by_hand else frame_skip
        self.world = PlainWorld(self.scene, file, **simulated) if file else World(self.scene, **simulated)
        self.stage = Stage(self.world)
        self.model = ModelView(self.stage)
        self.data = DataView(self.model._it)
        self._pose()
        self.init_qpos, self.init_qvel = self.data.qpos.copy(), self.data.qvel.copy()
        self.stage.start = (self.init_qpos.copy(), self.init_qvel.copy())
        self.mujoco_renderer = Renderer(self.world, width, height, camera_name, default_camera_config, camera_id)
        self.observer = Observer(self.world, senses, self.torque_sensors, self.extra_fields)
        self.facial_expressions = {name: number for number, name in enumerate(EMOTES)}
        self._next_action: Any = None
        self._senses_due = False
        self._seeded = False
        self.actuation_model: Any = kind(self, self.mimo_actuators)
        self._set_action_space()
        self._env_setup()
        self.goal: Any = self.sample_goal()
        self._set_observation_space()
        self.metadata = {**self.metadata, "render_fps": round(1 / self.dt)}
        if print_space_sizes:
            print(f"Observation space: {self.observation_space}\nAction space: {self.action_space}")
        if show_sensors:
            warnings.warn("show_sensors: mimo.plot.touch_map(env.world) draws the sensors", stacklevel=2)
        if tell_differences:
            for line in differences_of(own):
                warnings.warn(line, DifferenceWarning, stacklevel=2)

    # ---- Gymnasium ------------------------------------------------------------------------------------------------

    def reset(
        self, *, seed: Optional[int] = None, options: Optional[Dict[str, Any]] = None
    ) -> Tuple[Observation, Dict[str, Any]]:
        """Starts an episode. Without a seed the first one is random; later ones continue its random numbers."""
        super().reset(seed=seed)
        self._restart(seed)
        self._reset_simulation()
        observation = self.reset_model()
        if self.render_mode == "human":
            self.render()
        return observation, self._told(False, False)

    def step(self, action: NDArray[np.float32]) -> Tuple[Observation, float, bool, bool, Dict[str, Any]]:
        """Makes one step."""
        self.do_simulation(action, self.frame_skip)
        self._step_callback()
        observation = self._get_obs()
        self._obs_callback()
        achieved = self.get_achieved_goal()
        success = self.is_success(achieved, self.goal)
        failure = self.is_failure(achieved, self.goal)
        info = self._told(bool(success), bool(failure))
        terminated, truncated = self._is_done(achieved, self.goal, info)
        reward = self.compute_reward(achieved, self.goal, info)
        if self.render_mode == "human":
            self.render()
        return observation, reward, bool(terminated), bool(truncated), info

    def render(self) -> Any:
        """A picture with render_mode "rgb_array" or "depth_array"; with "human" it shows in a window."""
        return None if self.render_mode is None else self.mujoco_renderer.render(self.render_mode)

    def close(self) -> None:
        """Closes the world."""
        self.mujoco_renderer.close()
        self.world.close()

    def __init_subclass__(cls, **options: Any) -> None:
        super().__init_subclass__(**options)
        own = cls.__dict__.get("compute_reward")
        if isinstance(own, FunctionType):
            setattr(cls, "compute_reward", RewardOfGoals(own))  # noqa: B010

    # ---- For custom environments -----------------------------------------------------------------------------------

    @RewardOfGoals
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

    def sample_goal(self) -> Any:
        """The goal of the new episode: numbers of the task, empty without one."""
        return self.world.get(Quantity.AGENT_GOAL).ravel()

    def get_achieved_goal(self) -> Any:
        """The achieved goal."""
        return self.world.get(Quantity.AGENT_ACHIEVED).ravel()

    def reset_model(self) -> Observation:
        """Prepares an episode after a reset, and returns the first observation."""
        return self._get_obs()

    def _is_done(self, achieved_goal: Any, desired_goal: Any, info: Any) -> Tuple[bool, bool]:
        """Whether the episode has ended, and whether it is cut off."""
        return self.done_active and (info["is_success"] or info["is_failure"]), self.is_truncated()

    def _step_callback(self) -> None:
        """Called in each step between physics and observation."""

    def _substep_callback(self) -> None:
        """Called after each physics step."""

    def _obs_callback(self) -> None:
        """Called in each step after the observation."""

    # ---- Physics --------------------------------------------------------------------------------------------------

    def do_simulation(self, action: ArrayLike, n_frames: int) -> None:
        """Makes physics steps with an action."""
        if not self._by_hand and n_frames == self.frame_skip:
            self.advance(self._delayed(action))
            return
        self._set_action(action)
        for left in reversed(range(n_frames)):
            self.actuation_model.substep_update()
            self._senses_due = left == 0 and self.world.frame_skip == 1
            self._single_mujoco_step()
            self._substep_callback()
        self._senses_due = False

    def advance(self, action: ArrayLike) -> None:
        """One step of the library's: all of its physics steps, senses and task."""
        self._next_action = None
        self.world.step(action)
        self.actuation_model.control_input = action
        self.stage.moved(observed=True)

    def _set_action(self, action: ArrayLike) -> None:
        """Sets the action of the next physics steps."""
        self.actuation_model.action(self._delayed(action))

    def act_next(self, action: Numbers) -> None:
        """Remembers an action for the next physics step, of an actuation without controls of its own."""
        self._next_action = action

    def _single_mujoco_step(self) -> None:
        """Makes one physics step."""
        self.physics_steps(1)

    def physics_steps(self, count: int) -> None:
        """Makes physics steps; the action that was set last acts from here on."""
        action, self._next_action = self._next_action, None
        if action is not None and not np.any(action) and self.world.time == 0:
            action = None  # the actuation rests already
        if self._senses_due and count == 1:  # they see what a step's senses see: the start of this physics step
            self.world.step(None if action is None else np.asarray(action, np.float32))
        elif action is None:
            self.world.physics_step(count)
        elif self.world.frame_skip == 1:
            self.world.step_into(None, np.asarray(action, np.float32))
            self.world.physics_step(count - 1)
        else:
            raise NotImplementedError(
                f"_set_action with {type(self.actuation_model).__name__}, then single physics steps, needs frame_skip=1"
                f" or a derived class with its own do_simulation; {PAGE}"
            )
        self.stage.moved(observed=self._senses_due)

    def _delayed(self, action: ArrayLike) -> Any:
        return action if self.motor_delay <= 0 else _late(self._late_actions, np.array(action), self.motor_delay)

    def _restart(self, seed: Optional[int]) -> None:
        if seed is None and not self._seeded:
            seed = secrets.randbits(64)
        self._seeded, self._next_action = True, None
        self._late_seen.clear()
        self._late_actions.clear()
        self.world.reset(seed)
        self.stage.moved(observed=True)
        self._pose()

    def _pose(self) -> None:
        for joint, position in self._late_pose.items():
            self.data.joint(joint).qpos = position

    def _reset_simulation(self) -> None:
        """Called in a reset, before reset_model."""
        self.actuation_model.control_input = np.zeros(np.shape(self.action_space.low))
        if self.moves_by_hand:
            self.actuation_model.reset()
        self.goal = self.sample_goal()

    # ---- Senses ---------------------------------------------------------------------------------------------------

    def _env_setup(self) -> None:
        """Makes the senses; scripts override the functions that it calls."""
        self.proprio_setup(self.proprio_params)
        if self.touch_params is not None:
            self.touch_setup(self.touch_params)
        if self.vision_params is not None:
            self.vision_setup(self.vision_params)
        if self.vestibular_params is not None:
            self.vestibular_setup(self.vestibular_params)

    def proprio_setup(self, proprio_params: Params) -> None:
        """Makes the member `proprioception`."""
        self.proprioception = SimpleProprioception(self, proprio_params)

    def touch_setup(self, touch_params: Params) -> None:
        """Makes the member `touch`."""
        self.touch = self.observer.touch
        if self.touch is not None:
            self.touch.belongs_to(self)

    def vision_setup(self, vision_params: Params) -> None:
        """Makes the member `vision`."""
        self.vision = SimpleVision(self, vision_params)

    def vestibular_setup(self, vestibular_params: Params) -> None:
        """Makes the member `vestibular`."""
        self.vestibular = SimpleVestibular(self, vestibular_params)

    def seen(self) -> Views:
        """The library's fields for the current state; after a step, those that the step observed."""
        if not self.stage.observed:
            self.world.observe()
            self.stage.moved(observed=True)
        return self.world.observation

    def get_proprio_obs(self) -> Numbers:
        """`observation`."""
        row: Numbers = self.proprioception.get_proprioception_obs()
        return row

    def get_touch_obs(self) -> NDArray[np.float32]:
        """`touch`."""
        felt: NDArray[np.float32] = self.touch.get_touch_obs()
        return felt

    def get_vision_obs(self) -> Dict[str, NDArray[np.uint8]]:
        """One picture a camera."""
        pictures: Dict[str, NDArray[np.uint8]] = self.vision.get_vision_obs()
        return pictures

    def get_vestibular_obs(self) -> Numbers:
        """`vestibular`."""
        balance: Numbers = self.vestibular.get_vestibular_obs()
        return balance

    def _get_obs(self) -> Observation:
        seen: Observation = {"observation": self.get_proprio_obs()}
        if self.touch is not None:
            seen["touch"] = np.ravel(self.get_touch_obs())
        if self.vision is not None:
            seen.update(self.get_vision_obs())
        if self.vestibular is not None:
            seen["vestibular"] = self.get_vestibular_obs()
        if self.goals_in_observation:
            seen.update(achieved_goal=np.array(self.get_achieved_goal()), desired_goal=np.array(self.goal))
        return seen if self.sensory_delay <= 0 else _late(self._late_seen, seen, self.sensory_delay)

    def _told(self, success: bool, failure: bool) -> Dict[str, Any]:
        info: Dict[str, Any] = {"is_success": success, "is_failure": failure}
        if not self.goals_in_observation:
            info.update(achieved_goal=np.array(self.get_achieved_goal()), desired_goal=np.array(self.goal))
        return info

    def _set_action_space(self) -> None:
        self.action_space: Any = self.actuation_model.get_action_space()

    def _set_observation_space(self) -> None:
        self.observation_space: Any = _space_of(self._get_obs())
        self._late_seen.clear()

    # ---- Members --------------------------------------------------------------------------------------------------

    def set_state(self, qpos: ArrayLike, qvel: ArrayLike) -> None:
        """Sets positions and velocities of all joints."""
        self.data.qvel = qvel
        self.data.qpos = qpos
        self.forward()

    def forward(self) -> None:
        """Computes what follows from positions and velocities: poses, contacts, sensors."""
        self.world.observe()
        self.stage.moved(observed=True)

    def state_vector(self) -> Numbers:
        """Positions, then velocities."""
        return np.concatenate([self.data.qpos, self.data.qvel])

    def get_body_com(self, body_name: str) -> Numbers:
        """The position of a body, world, m."""
        return self.data.body(body_name).xpos.copy()  # type: ignore[no-any-return]

    def swap_facial_expression(self, emotion: str) -> None:
        """Shows a face, one of `facial_expressions`."""
        if emotion not in EMOTES:
            raise ValueError(f"emotion is {emotion!r}, expected {', '.join(map(repr, EMOTES))}")
        self.world.set_face(EMOTES[emotion])

    @property
    def dt(self) -> float:
        """Length of a step, s."""
        return self.world.timestep * self.frame_skip

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
        names = self.model._it.names(kind)
        return np.array([number for number, name in enumerate(names) if name.startswith(start)], np.intp)


def _late(waiting: Any, newest: Any, steps: int) -> Any:
    """The oldest of the last `steps` things, as in the original: with 1 it is the newest."""
    waiting.append(newest)
    return waiting[0] if len(waiting) < steps else waiting.popleft()


def _space_of(seen: Observation) -> spaces.Dict:
    """Unbounded spaces, as in the original; pictures are 0 to 255."""
    boxes: Dict[str, spaces.Space[Any]] = {}
    for name, values in seen.items():
        array = np.asarray(values)
        kind = array.dtype.type if array.dtype in (np.uint8, np.float32) else np.float64
        low, high = (0, 255) if array.dtype == np.uint8 else (-np.inf, np.inf)
        boxes[name] = spaces.Box(low, high, array.shape, kind)  # type: ignore[arg-type]
    return spaces.Dict(boxes)
