"""One simulated world: the C API's environment, with numpy arrays."""

from __future__ import annotations

import ctypes
from dataclasses import dataclass
from typing import Any, Dict, List, NamedTuple, Optional, Tuple, Type, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray
from typing_extensions import Unpack

from . import _abi
from ._handle import Native
from ._library import LIB, check, log_to_python, raise_error, text
from .access import Access, Mask, Numbers
from .arguments import index_in, number_of, real_number, vector, whole_number
from .constants import Kind, Look, Quantity
from .layout import Layout, Observation
from .options import Options, PhysicsOptions, PictureOptions, WorldOptions, fill
from .scene import Scene, prepare
from .states import LoadReport, reported, saved

LOOK_JOINTS = 8  # MIMO_LOOK_JOINTS

_step = LIB.mimo_env_step


@dataclass(frozen=True)
class Agent:
    """What is to be known of one infant of a world."""

    name: str  # "" for a sole one
    actions: slice  # its part of the action array
    mass: float  # kg
    height: float  # vertical extent in the initial pose, m


class StepResult(NamedTuple):
    """What a step gave, one entry for each agent. The arrays belong to the world and change with its next step."""

    observation: Observation
    reward: Numbers
    terminated: NDArray[np.bool_]
    truncated: NDArray[np.bool_]


class Contacts(NamedTuple):
    """Contacts, one a row; frames, forces and torques as mimo.h explains at MIMO_CONTACT_FRAME."""

    geoms: NDArray[np.int32]  # n x 2
    bodies: NDArray[np.int32]  # n x 2
    position: Numbers  # n x 3, world, m
    frame: Numbers  # n x 3 x 3, rows: normal from geom 1 to geom 2, two tangents
    distance: Numbers  # n, negative: overlap
    force: Numbers  # n x 3, on body 2, in the contact's frame, N
    torque: Numbers  # n x 3


class StepContacts(NamedTuple):
    """Pairs of geoms that touched during the last step, one a row; needs the option step_contacts=True."""

    geoms: NDArray[np.int32]  # n x 2
    bodies: NDArray[np.int32]  # n x 2
    start: Numbers  # n, s since the step began
    end: Numbers  # n
    impulse: Numbers  # n x 3, on body 2, world, N s
    peak_force: Numbers  # n x 3, on body 2, world, N
    peak_position: Numbers  # n x 3, world, m


class TouchSensors(NamedTuple):
    """The touch sensors of an agent, in the order of its touch fields."""

    bodies: NDArray[np.int32]  # n
    geoms: NDArray[np.int32]  # n
    position: Numbers  # n x 3, in the frame of the sensor's body, m
    frame: Numbers  # n x 3 x 3, rows: outward normal, two tangents, in the frame of the body


class Outcome(NamedTuple):
    """Whether an agent's last step was a success or a failure, also where that does not end the episode."""

    success: bool
    failure: bool


class Sightline(NamedTuple):
    """One eye's line of sight, in the world."""

    position: Numbers  # of the eye's camera, m
    direction: Numbers  # unit vector


class Gaze(NamedTuple):
    """Where an infant looks."""

    left: Sightline
    right: Sightline
    vergence: float  # angle between the lines of sight, rad; negative where they lead apart
    point: Optional[Numbers]  # where they come closest to each other, world, m; None where they lead apart
    miss: float  # how far they pass each other there, m


class LookAngles(NamedTuple):
    """Joints that make an infant look at a point: of the left eye, then of the right one; the head's before them."""

    joints: List[str]
    angles: Numbers  # rad, within the joints' ranges
    errors: Numbers  # by how much the left and the right eye miss the point because of their range, rad


class Picture(NamedTuple):
    """A drawing of the world."""

    rgb: NDArray[np.uint8]  # height x width x 3
    depth: NDArray[np.float32]  # height x width, m along the camera's axis
    segmentation: NDArray[np.int32]  # height x width, geom ids, -1: background


def env_config(options: Dict[str, Any], kind: Type[PhysicsOptions] = WorldOptions) -> _abi.EnvConfig:
    """The C struct of a world's options."""
    config = _abi.EnvConfig()
    check(LIB.mimo_env_config_init(config, ctypes.sizeof(config)))
    config.log = log_to_python
    fill(config, options, kind)
    return config


def seed_number(seed: int) -> ctypes.c_uint64:
    """A seed for the library; ctypes would silently take it modulo 2^64."""
    number = whole_number("seed", seed)
    if not 0 <= number < 2**64:
        raise ValueError(f"seed is {seed}, expected 0 to 2^64 - 1")
    return ctypes.c_uint64(number)


class World(Access):
    """One world with its infants, their senses and a task.

    `World("reach", vision=False)` makes it of a built-in scene with its infants, `World(scene)` of a scene of your own.
    Worlds can be pickled (by their scene, options and state) and copied (the copy goes on in the same state).
    """

    def __init__(self, scene: Union[str, Scene] = "benchmark", **options: Unpack[Options]) -> None:
        made, rest = prepare(scene, options)
        handle = ctypes.c_void_p()
        check(LIB.mimo_env_create(made._handle, env_config(rest), handle))
        self._own(handle.value, LIB.mimo_env_destroy)
        self._describe(made, rest, None)

    @classmethod
    def _of_batch(cls, handle: Native, scene: Scene, options: Dict[str, Any], batch: Any) -> "World":
        """A world that belongs to a batch, which it keeps alive."""
        world = cls.__new__(cls)
        world._handle = handle
        world._describe(scene, options, batch)
        return world

    def _describe(self, scene: Scene, options: Dict[str, Any], owner: Any) -> None:
        self._scene, self._options, self._owner = scene, options, owner
        handle = self._names_handle = self._handle
        if scene._task is not None and handle.value is not None:  # which is to know the world that it is asked about
            scene._task.worlds.setdefault(handle.value, self)
        self.layout = Layout(handle)
        self.agents = _agents(handle)
        self.action_names = _action_names(handle)
        self.action_low, self.action_high = _action_bounds(handle, len(self.action_names))
        count = len(self.agents)
        self.block = self.layout.new_block()
        self.observation = self._views = self.layout.views(self.block)
        self.reward = np.zeros(count)
        self._flags = np.zeros((2, count), np.uint8)
        self.terminated, self.truncated = self._flags.view(np.bool_)
        self._terms: Dict[int, Tuple[Tuple[str, ...], Numbers, int]] = {}
        self._outcome = (ctypes.c_uint8(), ctypes.c_uint8())
        self._action = np.zeros(len(self.action_names), np.float32)
        self._results = (
            self.reward.ctypes.data,
            self._flags[0].ctypes.data,
            self._flags[1].ctypes.data,
            count,
        )
        self._action_place = (self._action.ctypes.data, len(self._action))
        self._block_place = (self.block.ctypes.data, self.layout.bytes)

    # ---- Stepping ------------------------------------------------------------------------------------------------

    def reset(self, seed: Optional[int] = None) -> Observation:
        """Starts an episode; without a seed the world goes on with its own random numbers."""
        self.reset_into(self.block, seed)
        self.observation = self._views
        return self.observation

    def reset_into(self, block: Optional[NDArray[np.uint8]], seed: Optional[int] = None) -> None:
        """As reset, with a block of your own (layout.new_block()); None skips the senses."""
        number = None if seed is None else ctypes.byref(seed_number(seed))
        self._given = None
        check(LIB.mimo_env_reset(self._handle, number, *self._place(block)))

    def step(self, action: Optional[ArrayLike] = None) -> StepResult:
        """Goes one step on. Actions are clipped to their bounds; None leaves the motors as they are."""
        self.step_into(self.block, action)
        self.observation = self._views
        return StepResult(self.observation, self.reward, self.terminated, self.truncated)

    def step_into(self, block: Optional[NDArray[np.uint8]], action: Optional[ArrayLike] = None) -> None:
        """As step, with a block of your own; None skips the senses. Results are in reward, terminated, truncated."""
        self._step_at(*self._place(block), action)

    def _step_at(self, address: Optional[int], size: int, action: Optional[ArrayLike]) -> None:
        status = _step(self._handle, *self._prepared(action), address, size, *self._results)
        if status != 0:
            raise_error(status)

    def observe(self) -> Observation:
        """What the senses give for the current state, without changing the trajectory."""
        self.observe_into(self.block)
        self.observation = self._views
        return self.observation

    def observe_into(self, block: NDArray[np.uint8]) -> None:
        """As observe, with a block of your own."""
        check(LIB.mimo_env_observe(self._handle, *self._place(block)))

    def physics_step(self, count: int = 1) -> None:
        """Bare physics: physics steps with the controls as they are, without senses or task."""
        check(LIB.mimo_env_physics_step(self._handle, number_of("count", count)))

    def update(self) -> None:
        """Recomputes poses from the current joint positions."""
        check(LIB.mimo_env_update(self._handle))

    def _prepared(self, action: Optional[ArrayLike]) -> Tuple[Optional[int], int]:
        self._given = None
        if action is None:
            return None, 0
        try:
            self._action[...] = action
        except ValueError as error:
            raise ValueError(f"action: {error}; expected {len(self._action)} numbers") from None
        self._given = self._action
        return self._action_place

    def _place(self, block: Optional[NDArray[np.uint8]]) -> Tuple[Optional[int], int]:
        if block is self.block:
            return self._block_place
        if block is None:
            return None, 0
        if block.dtype != np.uint8 or not block.flags.c_contiguous or not block.flags.writeable:
            raise ValueError("block: expected a contiguous, writable array of uint8, as layout.new_block() gives it")
        return block.ctypes.data, block.nbytes

    # ---- As one of many: what a task needs that serves both ----------------------------------------------------------

    def world(self, index: int = 0) -> "World":
        """Itself: number 0 of one."""
        index_in("world", index, 1)
        return self

    # ---- What it is ----------------------------------------------------------------------------------------------

    @property
    def task(self) -> str:
        """Name of the task."""
        name = ctypes.c_char_p()
        check(LIB.mimo_env_task(self._handle, name))
        return text(name.value)

    @property
    def frame_skip(self) -> int:
        """Physics steps in a step."""
        count = ctypes.c_uint32()
        check(LIB.mimo_env_frame_skip(self._handle, count))
        return count.value

    @property
    def time(self) -> float:
        """Simulated seconds since the reset."""
        return self._number(LIB.mimo_env_time)

    @property
    def timestep(self) -> float:
        """Length of one physics step, s."""
        return self._number(LIB.mimo_env_timestep)

    @property
    def timing(self) -> Dict[str, float]:
        """Where the time of steps went, in seconds; needs the option timing=True."""
        timing = _abi.Timing()
        check(LIB.mimo_env_timing(self._handle, timing))
        return {name: getattr(timing, name) for name, *_ in timing._fields_[2:]}

    def reset_timing(self) -> None:
        """Starts counting anew."""
        check(LIB.mimo_env_timing_reset(self._handle))

    def _number(self, function: Any) -> float:
        value = ctypes.c_double()
        check(function(self._handle, value))
        return value.value

    # ---- Rewards -------------------------------------------------------------------------------------------------

    def reward_terms(self, agent: int = 0) -> Dict[str, float]:
        """The terms of the last step's reward, which is their sum."""
        agent = self._agent(agent)
        terms = self._terms.get(agent)
        if terms is None:
            names = self._term_names(agent)
            values = np.zeros(len(names))
            terms = self._terms[agent] = (names, values, values.ctypes.data)
        names, values, address = terms
        check(LIB.mimo_env_reward_terms(self._handle, agent, address, len(names)))
        return dict(zip(names, values.tolist()))

    def outcome(self, agent: int = 0) -> Outcome:
        """Success or failure of the last step."""
        success, failure = self._outcome
        check(LIB.mimo_env_outcome(self._handle, self._agent(agent), success, failure))
        return Outcome(success.value != 0, failure.value != 0)

    def _term_names(self, agent: int) -> Tuple[str, ...]:
        count, name = ctypes.c_size_t(), ctypes.c_char_p()
        check(LIB.mimo_env_reward_term_count(self._handle, agent, count))
        names = []
        for index in range(count.value):
            check(LIB.mimo_env_reward_term_name(self._handle, agent, index, name))
            names.append(text(name.value))
        return tuple(names)

    # ---- Named access --------------------------------------------------------------------------------------------

    def _read(self, quantity: int, ids: NDArray[np.int32], values: Numbers) -> None:
        get = LIB.mimo_env_get if values.dtype == np.float64 else LIB.mimo_env_get_float
        check(get(self._handle, quantity, ids.ctypes.data, len(ids), values.ctypes.data, values.size))

    def _write(self, quantity: int, ids: NDArray[np.int32], values: Numbers, mask: Mask) -> None:
        if mask is not None:
            raise ValueError("mask: there is only one world")
        check(LIB.mimo_env_set(self._handle, quantity, ids.ctypes.data, len(ids), values.ctypes.data, values.size))

    def random(self, count: int, mask: Mask = None) -> Numbers:
        """Numbers from 0 to 1 from the world's own random stream, which is part of its state."""
        if mask is not None:
            raise ValueError("mask: there is only one world")
        values = np.empty(number_of("count", count))
        check(LIB.mimo_env_random(self._handle, values.ctypes.data, len(values)))
        return values

    def contacts(self, world: int = 0) -> Contacts:
        """The contacts that the last physics step computed, or the reset."""
        return contacts_of(self.world(world)._handle)

    def step_contacts(self, world: int = 0) -> StepContacts:
        """What touched what during the last step; needs the option step_contacts=True."""
        return step_contacts_of(self.world(world)._handle)

    def warnings(self) -> Dict[str, int]:
        """How many physics steps had each kind of warning since the world was made: all 0 for a clean run."""
        counts = self.get(Quantity.WARNING_COUNT)
        return {self.name(Kind.WARNING, index): int(count) for index, count in enumerate(counts)}

    def touch_sensors(self, agent: int = 0) -> TouchSensors:
        """Where an infant's skin feels; empty where touch is off."""
        agent, count = self._agent(agent), ctypes.c_size_t()
        check(LIB.mimo_env_touch_sensors(self._handle, agent, None, None, None, None, 0, count))
        n = count.value
        bodies, geoms = np.empty(n, np.int32), np.empty(n, np.int32)
        position, frame = np.empty((n, 3)), np.empty((n, 3, 3))
        places = [array.ctypes.data for array in (bodies, geoms, position, frame)]
        check(LIB.mimo_env_touch_sensors(self._handle, agent, *places, n, count))
        return TouchSensors(bodies, geoms, position, frame)

    # ---- Looking ---------------------------------------------------------------------------------------------------

    def gaze(self, agent: int = 0) -> Gaze:
        """Where an infant looks, by the poses of its eyes' cameras as they are."""
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
        """Makes an infant look at a point (world, m) at once; springs and motors move its joints on in the next step.

        Returns the angles by which the left and the right eye miss the point because of their range, rad.
        """
        errors = np.empty(2)
        target, turns = vector("point", point, 3), whole_number("how", how, Look)
        check(LIB.mimo_env_look_at(self._handle, self._agent(agent), target.ctypes.data, turns, errors.ctypes.data))
        return errors

    def look_angles(self, point: ArrayLike, how: Look = Look.EYES, agent: int = 0) -> LookAngles:
        """Angles of the joints that make an infant look at a point (world, m), for locks and position control."""
        count = ctypes.c_size_t()
        joints, angles, errors = np.empty(LOOK_JOINTS, np.int32), np.empty(LOOK_JOINTS), np.empty(2)
        places = (joints.ctypes.data, angles.ctypes.data, LOOK_JOINTS, count, errors.ctypes.data)
        target, turns = vector("point", point, 3), whole_number("how", how, Look)
        check(LIB.mimo_env_look_angles(self._handle, self._agent(agent), target.ctypes.data, turns, *places))
        names = [self.name(Kind.JOINT, int(joint)) for joint in joints[: count.value]]
        return LookAngles(names, angles[: count.value], errors)

    # ---- What differs from world to world; it outlives resets --------------------------------------------------------

    def face(self, agent: int = 0) -> str:
        """The face that an infant shows; "" for a body without faces."""
        number = int(self.get(Quantity.AGENT_FACE, [self._agent(agent)])[0])
        return "" if number < 0 else self.name(Kind.FACE, number)

    def set_face(self, name: str, agent: int = 0) -> None:
        """Gives an infant another face, see mimo.faces(); pictures show it from the next one on."""
        self.set(Quantity.AGENT_FACE, self.find(Kind.FACE, name), [self._agent(agent)])

    def lock(self, joint: str, angle: float) -> None:
        """Holds a joint at an angle (rad), softly, from the next step on; outlives resets."""
        self.set(Quantity.JOINT_LOCK, [1, real_number("angle", angle)], [joint])

    def unlock(self, joint: str) -> None:
        """Lets a joint go, also one that the scene has locked."""
        _, angle = self.get(Quantity.JOINT_LOCK, [joint]).ravel()
        self.set(Quantity.JOINT_LOCK, [0, angle], [joint])

    def locked(self, joint: str) -> Optional[float]:
        """The angle at which a joint is held, or None."""
        held, angle = self.get(Quantity.JOINT_LOCK, [joint]).ravel()
        return float(angle) if held else None

    @property
    def gravity(self) -> Numbers:
        """Gravity, m/s^2, world frame; writable, and outlives resets."""
        return self.get(Quantity.WORLD_GRAVITY).ravel()

    @gravity.setter
    def gravity(self, xyz: ArrayLike) -> None:
        self.set(Quantity.WORLD_GRAVITY, vector("gravity", xyz, 3))

    # ---- Pictures ------------------------------------------------------------------------------------------------

    def render(self, **picture: Unpack[PictureOptions]) -> NDArray[np.uint8]:
        """Draws the current state: height x width x 3, row 0 is the top. By default 640 x 480 of the infant's front."""
        config = _picture_config(picture)
        rgb = np.empty((config.height, config.width, 3), np.uint8)
        check(LIB.mimo_env_render(self._handle, config, rgb.ctypes.data, rgb.size, None, 0, None, 0))
        return rgb

    def depth(self, **picture: Unpack[PictureOptions]) -> NDArray[np.float32]:
        """Distances along the camera's axis in such a picture: height x width, m."""
        config = _picture_config(picture)
        depth = np.empty((config.height, config.width), np.float32)
        check(LIB.mimo_env_render(self._handle, config, None, 0, depth.ctypes.data, depth.size, None, 0))
        return depth

    def draw(self, **picture: Unpack[PictureOptions]) -> Picture:
        """As render, with depth and the geom seen in each pixel."""
        config = _picture_config(picture)
        size = (config.height, config.width)
        drawn = Picture(np.empty((*size, 3), np.uint8), np.empty(size, np.float32), np.empty(size, np.int32))
        places = [part for array in drawn for part in (array.ctypes.data, array.size)]
        check(LIB.mimo_env_render(self._handle, config, *places))
        return drawn

    def project(self, points: ArrayLike, **picture: Unpack[PictureOptions]) -> Numbers:
        """Where points of the world (n x 3, m) lie in such a picture: pixels right, pixels down, depth in m (n x 3)."""
        places = np.ascontiguousarray(points, np.float64).reshape(-1, 3)
        pixels = np.empty_like(places)
        config = _picture_config(picture)
        check(LIB.mimo_env_project(self._handle, config, places.ctypes.data, len(places), pixels.ctypes.data))
        return pixels

    # ---- State ---------------------------------------------------------------------------------------------------

    def save(self) -> bytes:
        """Everything that the world's future depends on, as bytes."""
        return saved(self._handle, LIB.mimo_env_state_size, LIB.mimo_env_state_save)

    def load(self, state: bytes) -> LoadReport:
        """Goes on from a state, exactly as the world that saved it; what it lacks of a delay starts fresh."""
        return reported(LIB.mimo_env_state_load, self._handle, state, len(state))

    def clone(self) -> "World":
        """Another world of the same scene and options, in the same state. The model is shared."""
        handle = ctypes.c_void_p()
        check(LIB.mimo_env_clone(self._handle, handle))
        world = World.__new__(World)
        world._own(handle.value, LIB.mimo_env_destroy)
        world._describe(self._scene, self._options, None)
        return world

    def __copy__(self) -> "World":
        return self.clone()

    def __deepcopy__(self, memo: Dict[int, Any]) -> "World":
        return self.clone()

    def __reduce__(self) -> Tuple[Any, ...]:
        return _rebuilt, (self._scene, self._options, self.save())


def _rebuilt(scene: Scene, options: Dict[str, Any], state: bytes) -> World:
    world = World(scene, **options)
    world.load(state)
    return world


def contacts_of(handle: Native) -> Contacts:
    """The contacts in a world of this handle."""
    return Contacts(
        geoms=all_of(handle, Quantity.CONTACT_GEOMS, 2).astype(np.int32),
        bodies=all_of(handle, Quantity.CONTACT_BODIES, 2).astype(np.int32),
        position=all_of(handle, Quantity.CONTACT_POSITION, 3),
        frame=all_of(handle, Quantity.CONTACT_FRAME, 9).reshape(-1, 3, 3),
        distance=all_of(handle, Quantity.CONTACT_DISTANCE, 1).ravel(),
        force=all_of(handle, Quantity.CONTACT_FORCE, 3),
        torque=all_of(handle, Quantity.CONTACT_TORQUE, 3),
    )


def step_contacts_of(handle: Native) -> StepContacts:
    """What touched what during the last step of a world of this handle."""
    return StepContacts(
        geoms=all_of(handle, Quantity.STEP_CONTACT_GEOMS, 2).astype(np.int32),
        bodies=all_of(handle, Quantity.STEP_CONTACT_BODIES, 2).astype(np.int32),
        start=all_of(handle, Quantity.STEP_CONTACT_START, 1).ravel(),
        end=all_of(handle, Quantity.STEP_CONTACT_END, 1).ravel(),
        impulse=all_of(handle, Quantity.STEP_CONTACT_IMPULSE, 3),
        peak_force=all_of(handle, Quantity.STEP_CONTACT_PEAK_FORCE, 3),
        peak_position=all_of(handle, Quantity.STEP_CONTACT_PEAK_POSITION, 3),
    )


def all_of(handle: Native, quantity: Quantity, width: int) -> Numbers:
    """A quantity of all that a world has: a row of `width` numbers for each."""
    count = ctypes.c_size_t()
    check(LIB.mimo_env_width(handle, quantity, None, 0, count))
    values = np.empty((count.value // width, width))
    check(LIB.mimo_env_get(handle, quantity, None, 0, values.ctypes.data, values.size))
    return values


def _picture_config(picture: PictureOptions) -> _abi.PictureConfig:
    config = _abi.PictureConfig()
    check(LIB.mimo_picture_config_init(config, ctypes.sizeof(config)))
    fill(config, picture, PictureOptions)
    return config


def _agents(env: Native) -> List[Agent]:
    count, info = ctypes.c_size_t(), _abi.AgentInfo()
    check(LIB.mimo_env_agent_count(env, count))
    agents = []
    for index in range(count.value):
        check(LIB.mimo_env_agent(env, index, info))
        actions = slice(info.action_offset, info.action_offset + info.action_count)
        agents.append(Agent(text(info.name), actions, info.mass, info.height))
    return agents


def _action_names(env: Native) -> List[str]:
    count, name = ctypes.c_size_t(), ctypes.c_char_p()
    check(LIB.mimo_env_action_size(env, count))
    names = []
    for index in range(count.value):
        check(LIB.mimo_env_action_name(env, index, name))
        names.append(text(name.value))
    return names


def _action_bounds(env: Native, count: int) -> Tuple[NDArray[np.float32], NDArray[np.float32]]:
    low, high = np.empty(count, np.float32), np.empty(count, np.float32)
    check(LIB.mimo_env_action_bounds(env, low.ctypes.data, high.ctypes.data, count))
    return low, high
