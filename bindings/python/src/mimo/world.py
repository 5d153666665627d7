"""One simulated world: the C API's environment, with numpy arrays."""

from __future__ import annotations

import ctypes
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Dict, List, Mapping, NamedTuple, Optional, Sequence, Tuple, Type, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _abi
from ._handle import Native
from ._library import LIB, check, defaults, from_struct, log_to_python, raise_error, result, text
from ._strict import reading
from .ages import Age, growths, of_agents
from .arguments import index_in, known_keywords, number_of, numbers_in, real_number, vector, whole_number
from .constants import Kind, Look, Movement, Quantity
from .contacts import contacts_of, step_contacts_of
from .geometry import Geometry
from .layout import Layout, Observation
from .options import Options, PhysicsOptions, PictureOptions, WorldOptions, fill
from .own_sense import fill_all
from .results import Followed, Numbers, Results, StepResult
from .scene import Scene, prepare
from .selection import Mask
from .selections import Contacts, StepContacts
from .sounds import play
from .states import LoadReport, reported, saved

if TYPE_CHECKING:
    from typing_extensions import Unpack

_step = LIB.mimo_env_step


@dataclass(frozen=True)
class Agent:
    """One infant of a world."""

    name: str  # "" for a single infant
    actions: slice  # its part of the action array
    mass: float  # kg
    height: float  # vertical extent in the initial pose, m


class Sightline(NamedTuple):
    """One eye's line of sight, in the world."""

    position: Numbers  # of the eye's camera, m
    direction: Numbers  # unit vector


class Gaze(NamedTuple):
    """The gaze of an infant."""

    left: Sightline
    right: Sightline
    vergence: float  # angle between the lines of sight, rad; negative if they diverge
    point: Optional[Numbers]  # the point where they are closest, world, m; None if they diverge
    miss: float  # their distance there, m


class LookAngles(NamedTuple):
    """Joints that make an infant look at a point: of the head, the left eye, and the right eye."""

    joints: List[str]
    angles: Numbers  # rad, within the joints' ranges
    errors: Numbers  # errors of the left and the right eye because of their range, rad


class Picture(NamedTuple):
    """A drawing of the world."""

    rgb: NDArray[np.uint8]  # height x width x 3
    depth: NDArray[np.float32]  # height x width, m along the camera's axis
    segmentation: NDArray[np.int32]  # height x width, geom ids, -1: background


def env_config(options: Dict[str, Any], kind: Type[PhysicsOptions] = WorldOptions) -> _abi.EnvConfig:
    """The C struct of a world's options."""
    config = defaults(_abi.EnvConfig)
    config.log = log_to_python
    fill(config, options, kind)
    return config


def reset_config(seed: Optional[int], ages: Sequence[Age] = ()) -> Optional[_abi.ResetConfig]:
    """The C struct of a reset; without a seed random numbers continue, without ages infants stay the same."""
    if seed is None and not ages:
        return None
    growth, count = growths(ages) if ages else (None, 0)
    seeded = {} if seed is None else {"seeded": 1, "seed": number_of("seed", seed, 64)}
    return _abi.ResetConfig(growth=growth, growth_count=count, **seeded)


class World(Geometry):
    """One world with its infants, their senses and a task.

    `World("reach", vision=False)` makes it of a built-in scene with its infants, `World(scene)` of a mimo.Scene.
    Worlds can be pickled (by their scene, options and state) and copied (the copy has the same state).
    """

    block: NDArray[np.uint8]  # observations of step, reset and observe
    _growths: Sequence[Mapping[str, Any]] = ()  # options of growth, per infant
    _owner: Any = None  # the batch that it belongs to and keeps alive
    _row: Any = None  # of a world in a batch: its row of the batch's observations

    def __init__(self, scene: Union[str, Scene] = "benchmark", **options: Unpack[Options]) -> None:
        made, rest = prepare(scene, options)
        handle = ctypes.c_void_p()
        check(LIB.mimo_env_create(made._handle, env_config(rest), handle))
        self._begin(Native(handle.value, LIB.mimo_env_destroy), made, rest)

    def _begin(self, handle: Native, scene: Scene, options: Dict[str, Any]) -> None:
        layout = Layout(handle, LIB.mimo_env_layout)
        self._describe(handle, scene, options, layout, Results(layout))

    @classmethod
    def _of_batch(cls, batch: Any, index: int, keeps: bool) -> "World":
        """A world of a batch, with a row of its results; `keeps` says whether it keeps the batch alive."""
        world = cls.__new__(cls)
        world._owner, world._row = batch if keeps else None, batch._row_of(index)
        handle, results = batch._world_handle(index), batch._results.of_world(index)
        world._describe(handle, batch._scene, batch._options, batch.layout, results)
        return world

    def _describe(
        self, handle: Native, scene: Scene, options: Dict[str, Any], layout: Layout, results: Results
    ) -> None:
        self._scene, self._options, self._growths = scene, options, scene._growths
        self._handle = self._names_handle = handle
        if scene._task is not None and handle.value is not None:  # the task is called with this world
            scene._task.worlds.setdefault(handle.value, self)
        self._take(layout, agents_of(handle, layout.agents))
        self._have(block=layout.new_block())
        self._views = layout.views(self.block)
        self._show(results, self._views)
        self._term_places = [
            [(term.name, index) for index, term in enumerate(layout.terms) if term.agent == agent]
            for agent in range(layout.agents)
        ]
        self._action = np.zeros(len(layout.actions), np.float32)
        # Arguments of steps, made once.
        self._results_place = ctypes.byref(results.for_world())
        self._action_place = (self._action.ctypes.data, len(self._action))
        self._block_place = (self.block.ctypes.data, layout.bytes)

    # ---- Stepping ------------------------------------------------------------------------------------------------

    @known_keywords
    def reset(self, seed: Optional[int] = None, age: Union[Age, Sequence[Age]] = None) -> Observation:
        """Starts an episode; without a seed the world continues its random numbers.

        `age`, months or options of growth, sets the age of its infants; a list has one for each.
        """
        self.reset_into(self.block, seed, age)
        return self._views

    @known_keywords
    def reset_into(
        self, block: Optional[NDArray[np.uint8]], seed: Optional[int] = None, age: Union[Age, Sequence[Age]] = None
    ) -> None:
        """As reset, with a block of your own (layout.new_block()); None skips the senses."""
        ages = [] if age is None else of_agents(self._growths, age)
        config = reset_config(seed, ages)
        self._last.actions = None
        check(LIB.mimo_env_reset(self._handle, config, *self._place(block)))
        self._sense(block)
        if ages:
            self._growths = ages
            self.renew()

    def step(self, action: Optional[ArrayLike] = None) -> StepResult:
        """Makes one step. Actions are clipped to their bounds; None keeps the motors' commands."""
        self.step_into(self.block, action)
        return self._result

    def step_into(self, block: Optional[NDArray[np.uint8]], action: Optional[ArrayLike] = None) -> None:
        """As step, with a block of your own; None skips the senses. Results are in reward, outcome, ..."""
        self._step_at(*self._place(block), action)
        self._sense(block)

    def _step_at(self, address: Optional[int], size: int, action: Optional[ArrayLike]) -> None:
        status = _step(self._handle, *self._prepared(action), address, size, self._results_place)
        if status != 0:
            raise_error(status)

    def _sense(self, sensed: "Union[Observation, NDArray[np.uint8], None]") -> None:
        """Remembers the latest observation: its block, or its fields; None: there was none."""
        if sensed is None:
            return
        if self._scene._own_senses:
            own = self._views if sensed is self.block else sensed
            fill_all(self._scene._own_senses, own if isinstance(own, dict) else self.layout.views(own), alone=True)
        self._last.sensed = self._views if sensed is self.block else sensed
        if self._row is not None:
            self._row.sensed_itself(self._last)

    @property
    def observation(self) -> Observation:
        """The latest observation of a step, reset or observe, in any block; zeros before the first.

        In a batch it is the latest of the batch and the world.
        """
        if self._row is not None:
            self._row.look(self._last)
        return super().observation

    def follow(self, positions: ArrayLike) -> Followed:
        """One step of a known movement: joints follow `positions`, and the senses observe.

        positions: frame_skip x positions of all joints, in the order of get(Quantity.JOINT_POSITION), for the end of
        each physics step. Returns the observation and the required forces: frame_skip x degrees of freedom, N or Nm,
        beside contacts, limits, springs and dampers.
        """
        told = np.ascontiguousarray(positions, np.float64)
        if told.ndim > 1 and len(told) != self.frame_skip:
            raise ValueError(
                f"positions of the shape {told.shape}, expected {self.frame_skip} rows, one per physics step"
            )
        forces = np.empty((self.frame_skip, len(self.get(Quantity.JOINT_VELOCITY).ravel())))
        movement = _abi.Movement(
            positions=told.ctypes.data,
            position_count=told.size,
            forces=forces.ctypes.data,
            force_count=forces.size,
        )
        check(LIB.mimo_env_follow(self._handle, movement, *self._place(self.block)))
        self._sense(self.block)
        return Followed(self._views, forces)

    def step_with(self, move: Any, senses: bool = True) -> None:
        """A step by another function, which gets this world and the addresses of its block and results."""
        self._last.actions = None
        block = self.block if senses else None
        check(move(self._handle, *self._place(block), self._results_place))
        self._sense(block)

    def renew(self) -> None:
        """Updates what depends on the age of infants."""
        self._have(agents=agents_of(self._handle, self.layout.agents))
        self.layout._renew()

    def observe(self) -> Observation:
        """Observes the current state without changing the trajectory."""
        self.observe_into(self.block)
        return self._views

    def observe_into(self, block: NDArray[np.uint8]) -> None:
        """As observe, with a block of your own."""
        check(LIB.mimo_env_observe(self._handle, *self._place(block)))
        self._sense(block)

    def physics_step(self, count: int = 1) -> None:
        """Makes physics steps with the current controls, without senses or task."""
        check(LIB.mimo_env_physics_step(self._handle, number_of("count", count)))

    def play(self, body: str, samples: ArrayLike, rate: Optional[float] = None) -> None:
        """Lets a body play samples (Pa at 1 m) from the next physics step on, after its queued sound.

        The default rate is that of the ears, Field.sample_rate. Empty samples stop it. See Scene.set_sources.
        """
        play(LIB.mimo_env_play, self._handle, self.layout, body, samples, rate)

    def update(self) -> None:
        """Recomputes poses from the current joint positions."""
        check(LIB.mimo_env_update(self._handle))

    def _prepared(self, action: Optional[ArrayLike]) -> Tuple[Optional[int], int]:
        last = self._last
        last.actions = None
        if action is None:
            return None, 0
        self._action[...] = numbers_in("action", action, self._action.shape, what="a number for each of action_names")
        last.actions = self._action
        return self._action_place

    def _place(self, block: Optional[NDArray[np.uint8]]) -> Tuple[Optional[int], int]:
        if block is self.block:
            return self._block_place
        if block is None:
            return None, 0
        if block.dtype != np.uint8 or not block.flags.c_contiguous or not block.flags.writeable:
            raise ValueError("block: expected a contiguous, writable array of uint8, as layout.new_block() gives it")
        return block.ctypes.data, block.nbytes

    # ---- As one of many, for tasks that serve both -------------------------------------------------------------------

    def world(self, index: int = 0) -> "World":
        """This world, which is number 0 of one."""
        index_in("world", index, 1)
        return self

    # ---- Properties ----------------------------------------------------------------------------------------------

    @property
    def task(self) -> str:
        """Name of the task."""
        return text(result(ctypes.c_char_p, LIB.mimo_env_task, self._handle))

    @property
    def frame_skip(self) -> int:
        """Physics steps in a step."""
        return int(result(ctypes.c_uint32, LIB.mimo_env_frame_skip, self._handle))

    @property
    def time(self) -> float:
        """Simulated seconds since the reset."""
        return float(result(ctypes.c_double, LIB.mimo_env_time, self._handle))

    @property
    def timestep(self) -> float:
        """Length of one physics step, s."""
        return float(result(ctypes.c_double, LIB.mimo_env_timestep, self._handle))

    @property
    def timing(self) -> Dict[str, float]:
        """Computing time of steps by part, s; needs the option timing=True."""
        timing = _abi.Timing()
        check(LIB.mimo_env_timing(self._handle, timing))
        return {name: getattr(timing, name) for name, *_ in timing._fields_[2:]}

    def reset_timing(self) -> None:
        """Sets these times to 0."""
        check(LIB.mimo_env_timing_reset(self._handle))

    def reward_terms(self, agent: int = 0) -> Dict[str, float]:
        """The terms of an infant's last reward, by name; the reward is their sum."""
        numbers = self.terms.tolist()
        return {name: numbers[index] for name, index in self._term_places[self._agent(agent)]}

    # ---- Named access --------------------------------------------------------------------------------------------

    def _read(self, quantity: int, ids: NDArray[np.int32], values: Numbers) -> None:
        get = LIB.mimo_env_get if values.dtype == np.float64 else LIB.mimo_env_get_float
        check(get(self._handle, quantity, ids.ctypes.data, len(ids), values.ctypes.data, values.size))

    def _write(self, quantity: int, ids: NDArray[np.int32], values: Numbers, mask: Mask) -> None:
        if mask is not None:
            raise ValueError("mask: there is only one world")
        check(LIB.mimo_env_set(self._handle, quantity, ids.ctypes.data, len(ids), values.ctypes.data, values.size))

    def random(self, count: int, mask: Mask = None) -> Numbers:
        """Random numbers from 0 to 1, from the stream in the world's state."""
        if mask is not None:
            raise ValueError("mask: there is only one world")
        values = np.empty(number_of("count", count))
        check(LIB.mimo_env_random(self._handle, values.ctypes.data, len(values)))
        return values

    def spontaneous(self, which: int = Movement.ALL, agent: int = 0) -> NDArray[np.float32]:
        """What an infant's motors do by themselves at this moment: its actions for the next step.

        `which` are kinds of `Movement`. The same episode has the same movements.
        """
        number = self._agent(agent)
        own = self.agents[number].actions
        actions = np.empty(own.stop - own.start, np.float32)
        kinds = whole_number("which", which, Movement)
        check(LIB.mimo_env_spontaneous(self._handle, number, kinds, actions.ctypes.data, len(actions)))
        return actions

    def contacts(self, world: int = 0) -> Contacts:
        """The contacts of the last physics step, or of the reset."""
        return contacts_of(self.world(world)._handle)

    def step_contacts(self, world: int = 0) -> StepContacts:
        """The contacts during the last step; needs the option step_contacts=True."""
        return step_contacts_of(self.world(world)._handle)

    def warnings(self) -> Dict[str, int]:
        """Number of physics steps with each kind of warning, since the world was made."""
        counts = self.get(Quantity.WARNING_STEPS)
        return {self.name(Kind.WARNING, index): int(count) for index, count in enumerate(counts)}

    # ---- Looking ---------------------------------------------------------------------------------------------------

    def gaze(self, agent: int = 0) -> Gaze:
        """The gaze of an infant, by the current poses of its eyes' cameras."""
        gaze = _abi.Gaze()
        check(LIB.mimo_env_gaze(self._handle, self._agent(agent), gaze))
        return Gaze(
            left=Sightline(np.array(gaze.left_position), np.array(gaze.left_direction)),
            right=Sightline(np.array(gaze.right_position), np.array(gaze.right_direction)),
            vergence=gaze.vergence,
            point=np.array(gaze.point) if gaze.meets else None,
            miss=gaze.miss,
        )

    def look_at(self, point: ArrayLike, how: Look = Look.EYES, agent: int = 0) -> Numbers:
        """Turns an infant's eyes to a point (world, m) at once; in the next step springs and motors act again.

        Returns the errors of the left and the right eye because of their range, rad.
        """
        errors = (ctypes.c_double * 2)()
        target, turns = vector("point", point, 3), whole_number("how", how, Look)
        check(LIB.mimo_env_look_at(self._handle, self._agent(agent), target.ctypes.data, turns, errors))
        return np.array(errors)

    def look_angles(self, point: ArrayLike, how: Look = Look.EYES, agent: int = 0) -> LookAngles:
        """Angles of the joints that make an infant look at a point (world, m), for locks and position control."""
        target, turns, count = vector("point", point, 3), whole_number("how", how, Look), ctypes.c_size_t()
        asked = (self._handle, self._agent(agent), target.ctypes.data, turns)
        check(LIB.mimo_env_look_angles(*asked, None, None, 0, count, None))
        joints, angles, errors = np.empty(count.value, np.int32), np.empty(count.value), (ctypes.c_double * 2)()
        places = (joints.ctypes.data, angles.ctypes.data, len(joints), count, errors)
        check(LIB.mimo_env_look_angles(*asked, *places))
        return LookAngles([self.name(Kind.JOINT, int(joint)) for joint in joints], angles, np.array(errors))

    # ---- Properties that outlive resets ------------------------------------------------------------------------------

    def face(self, agent: int = 0) -> str:
        """An infant's face; "" for a body without faces."""
        number = int(self.get(Quantity.AGENT_FACE, [self._agent(agent)])[0])
        return "" if number < 0 else self.name(Kind.FACE, number)

    def set_face(self, name: str, agent: int = 0) -> None:
        """Sets an infant's face, see mimo.faces()."""
        self.set(Quantity.AGENT_FACE, self.find(Kind.FACE, name), [self._agent(agent)])

    def lock(self, joint: str, angle: float) -> None:
        """Holds a joint at an angle (rad), softly, from the next step on; outlives resets."""
        self.set(Quantity.JOINT_LOCK, [1, real_number("angle", angle)], [joint])

    def unlock(self, joint: str) -> None:
        """Releases a joint, also one that the scene has locked."""
        _, angle = self.get(Quantity.JOINT_LOCK, [joint]).ravel()
        self.set(Quantity.JOINT_LOCK, [0, angle], [joint])

    def locked(self, joint: str) -> Optional[float]:
        """The angle at which a joint is locked, or None."""
        held, angle = self.get(Quantity.JOINT_LOCK, [joint]).ravel()
        return float(angle) if held else None

    @property
    def gravity(self) -> Numbers:
        """Gravity, m/s^2, world frame; writable, and outlives resets."""
        return reading(self.get(Quantity.WORLD_GRAVITY).ravel())

    @gravity.setter
    def gravity(self, xyz: ArrayLike) -> None:
        self.set(Quantity.WORLD_GRAVITY, vector("gravity", xyz, 3))

    # ---- Pictures ------------------------------------------------------------------------------------------------

    def render(self, **picture: Unpack[PictureOptions]) -> NDArray[np.uint8]:
        """Draws the current state: height x width x 3, row 0 is the top. Default: 640 x 480, from the front."""
        config = _picture_config(picture)
        rgb = np.empty((config.height, config.width, 3), np.uint8)
        self._draw(config, rgb=rgb.ctypes.data, rgb_bytes=rgb.size)
        return rgb

    def depth(self, **picture: Unpack[PictureOptions]) -> NDArray[np.float32]:
        """Distances along the camera's axis: height x width, m."""
        config = _picture_config(picture)
        depth = np.empty((config.height, config.width), np.float32)
        self._draw(config, depth=depth.ctypes.data, depth_count=depth.size)
        return depth

    def draw(self, **picture: Unpack[PictureOptions]) -> Picture:
        """As render, with depth and the geom in each pixel."""
        config = _picture_config(picture)
        size = (config.height, config.width)
        drawn = Picture(np.empty((*size, 3), np.uint8), np.empty(size, np.float32), np.empty(size, np.int32))
        self._draw(
            config,
            rgb=drawn.rgb.ctypes.data,
            rgb_bytes=drawn.rgb.size,
            depth=drawn.depth.ctypes.data,
            depth_count=drawn.depth.size,
            segmentation=drawn.segmentation.ctypes.data,
            segmentation_count=drawn.segmentation.size,
        )
        return drawn

    def _draw(self, config: _abi.PictureConfig, **places: int) -> None:
        check(LIB.mimo_env_render(self._handle, config, _abi.Picture(**places)))

    def project(self, points: ArrayLike, **picture: Unpack[PictureOptions]) -> Numbers:
        """Projects points (n x 3, world, m) into a picture: pixels right, pixels down, depth in m (n x 3)."""
        places = np.ascontiguousarray(points, np.float64).reshape(-1, 3)
        pixels = (ctypes.c_double * places.size)()
        config = _picture_config(picture)
        check(LIB.mimo_env_project(self._handle, config, places.ctypes.data, len(places), pixels))
        return np.array(pixels).reshape(-1, 3)

    # ---- State ---------------------------------------------------------------------------------------------------

    def save(self) -> bytes:
        """The complete state, as bytes."""
        return saved(self._handle, LIB.mimo_env_state_size, LIB.mimo_env_state_save)

    def load(self, state: bytes) -> LoadReport:
        """Loads a state; the world continues exactly like the saved one. Memories that it lacks start fresh."""
        return reported(LIB.mimo_env_state_load, self._handle, state, len(state))

    def clone(self) -> "World":
        """A copy with the same scene, options and state; it shares the model."""
        handle = ctypes.c_void_p()
        check(LIB.mimo_env_clone(self._handle, handle))
        world = World.__new__(World)
        world._begin(Native(handle.value, LIB.mimo_env_destroy), self._scene, self._options)
        world._growths = self._growths
        return world

    def __copy__(self) -> "World":
        return self.clone()

    def __deepcopy__(self, memo: Dict[int, Any]) -> "World":
        return self.clone()

    def __reduce__(self) -> Tuple[Any, ...]:
        return _rebuilt, (self._scene, self._options, self.save(), self._growths)


def _rebuilt(scene: Scene, options: Dict[str, Any], state: bytes, growths: Sequence[Mapping[str, Any]]) -> World:
    world = World(scene, **options)
    if list(growths) != list(scene._growths):
        world.reset_into(None, None, list(growths))
    world.load(state)
    return world


def _picture_config(picture: PictureOptions) -> _abi.PictureConfig:
    config = defaults(_abi.PictureConfig)
    fill(config, picture, PictureOptions)
    return config


def agents_of(env: Native, count: int) -> List[Agent]:
    """The infants of a world."""
    info = _abi.AgentInfo()
    agents = []
    for index in range(count):
        check(LIB.mimo_env_agent(env, index, info))
        actions = slice(info.action_offset, info.action_offset + info.action_count)
        agents.append(from_struct(Agent, info, actions=actions))
    return agents
