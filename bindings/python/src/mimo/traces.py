"""Curves of a recording, for plots: joints, rewards, touch by part, gaze and sound. Replays it once."""

from __future__ import annotations

from typing import Any, Dict, List, NamedTuple, Optional

import numpy as np
from numpy.typing import NDArray

from .constants import Kind, Quantity
from .drawing import EARS, limited, prefixes, touch_field
from .frames import inverse, turned
from .recordings import Recording
from .selection import Selection
from .world import World

REFERENCE = 20e-6  # Pa
QUIET = 0.0  # dB, the lower end of the scale
Numbers = NDArray[np.float64]


class Traces(NamedTuple):
    """Curves of one infant; a row per step."""

    time: Numbers  # end of the step, s
    joints: List[str]
    bends: Numbers  # position of each joint in its range, -1 to 1
    parts: List[str]  # parts of the body that were touched
    forces: Numbers  # on each part, N
    gaze: Numbers  # left eye sideways and up, then right eye, in the head's frame, degrees; left is positive
    levels: Optional[Numbers]  # left and right ear, dB re 20 uPa; None without ears
    rewards: Numbers


def _own(world: World, prefix: str) -> Selection:
    """An infant's joints with limits."""
    joints = limited(world)
    return Selection(world, joints.ids[[name.startswith(f"{prefix}robot:") for name in joints.names]], joints.kind)


class Listener:
    """Collects the curves of one infant, step by step."""

    def __init__(self, world: World, agent: int) -> None:
        self._world, self._agent = world, agent
        self._prefix = list(prefixes(world))[agent]
        self.joints = _own(world, self._prefix)
        self._low, self._high = self.joints._get(Quantity.JOINT_RANGE).reshape(-1, 2).T
        fields = world.layout.fields
        self._touch = touch_field(world, self._prefix)
        self._owners = world.layout.receptors(self._touch).bodies if self._touch else np.zeros(0, np.int32)
        head = f"{self._prefix}head"
        self._head = world.bodies(head) if head in world.bodies().names else None
        self.hears = self._prefix + EARS[0] in fields
        self.rows: Dict[str, List[Any]] = {"bends": [], "forces": [], "gaze": [], "levels": [], "rewards": []}

    def add(self) -> None:
        """Adds a step."""
        world, rows = self._world, self.rows
        angles = self.joints._get(Quantity.JOINT_POSITION)
        rows["bends"].append(2 * (angles - self._low) / (self._high - self._low) - 1)
        rows["rewards"].append(float(world.reward[self._agent]))
        rows["forces"].append(self._forces())
        rows["gaze"].append(self._gaze())
        if self.hears:
            heard = [world.observation[self._prefix + ear] for ear in EARS]
            pressure = [np.sqrt(np.mean(np.square(ear, dtype=np.float64))) for ear in heard]
            rows["levels"].append(np.maximum(20 * np.log10(np.maximum(pressure, 1e-12) / REFERENCE), QUIET))

    def _forces(self) -> Numbers:
        if self._touch is None:
            return np.zeros(0)
        felt = np.linalg.norm(self._world.observation[self._touch].reshape(len(self._owners), -1), axis=1)
        return np.asarray(np.bincount(self._owners, felt, self._world.count(Kind.BODY)), np.float64)

    def _gaze(self) -> Numbers:
        if self._head is None:
            return np.full(4, np.nan)
        back = inverse(self._head.orientation)  # of the same moment as the eyes' poses
        gaze = self._world.gaze(self._agent)
        ahead, left, up = turned(back, [gaze.left.direction, gaze.right.direction]).T
        sides, heights = np.arctan2(left, ahead), np.arctan2(up, np.hypot(ahead, left))
        return np.asarray(np.degrees(np.column_stack([sides, heights]).ravel()), np.float64)


def traces(recording: Recording, agent: int = 0, scene: Optional[str] = None) -> Traces:
    """Replays a recording and collects the curves of an infant."""
    with recording.world(0, scene) as world:
        if not 0 <= agent < len(world.agents):
            raise ValueError(f"infant is {agent}, expected 0 to {len(world.agents) - 1}")
        listener = Listener(world, agent)
        recording.seek(world, 0, compare_fields=False)
        for _ in range(recording.steps):
            recording.step(world)
            listener.add()
        names = world.bodies().names
        rows = {name: np.array(values, np.float64) for name, values in listener.rows.items()}
        forces = rows["forces"].reshape(recording.steps, -1)
        felt = np.flatnonzero(forces.any(axis=0))
        return Traces(
            time=recording.read("time", np.float64, 0, recording.steps).ravel(),
            joints=[_short(name) for name in listener.joints.names],
            bends=rows["bends"],
            parts=[_short(names[body]) for body in felt],
            forces=forces[:, felt],
            gaze=rows["gaze"],
            levels=rows["levels"] if listener.hears else None,
            rewards=rows["rewards"],
        )


def _short(name: str) -> str:
    return name.split("/")[-1].split(":")[-1].replace("_", " ")
