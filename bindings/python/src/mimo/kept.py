"""What a recording keeps, as tables with names, units and frames; writers of other files read these."""

from __future__ import annotations

import os
from typing import Any, Dict, Iterator, List, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np
from numpy.typing import NDArray

from ._handle import Closing
from .arguments import meant
from .constants import Quantity, Sex
from .drawing import prefixes
from .errors import NotFoundError
from .layout import Field
from .recorded_world import world_as_recorded, world_without_senses
from .recordings import Recording
from .world import World

CHUNK_BYTES = 1 << 22  # of rows that are read at once
AXES = ("x", "y", "z")
OF_SKIN = ("normal", "tangent1", "tangent2")
QUATERNION = ("qw", "qx", "qy", "qz")
PICTURE, SOUND, NUMBERS = "picture", "sound", "numbers"  # kinds of tables


class Column(NamedTuple):
    """One number of each row."""

    name: str  # "robot:left_elbow", "right_hand/3/x"
    unit: str  # "rad", "" for none
    frame: str  # "world", "joint", "head", ...; "" for none


class Table(NamedTuple):
    """One dataset of a recording."""

    name: str  # without the infant's prefix: "joints/position", "proprioception/torque"
    dataset: str  # in the recording
    dtype: Any
    shape: Tuple[int, ...]  # of a row
    columns: Tuple[Column, ...]  # in the order of the flattened row; one for all pixels or samples
    kind: str
    late: float  # s from the end of a step to the moment of its row, <= 0
    sample_rate: float  # of sound
    infant: Optional[int]  # None: of no infant, or of all
    receptors: Tuple[Tuple[str, Tuple[float, ...]], ...] = ()  # body, and place in its frame (m), of each sensor

    @property
    def unit(self) -> str:
        """The unit of all columns, or all units that occur: "m or rad"."""
        return " or ".join(dict.fromkeys(column.unit for column in self.columns if column.unit))

    @property
    def frame(self) -> str:
        """The frame of all columns, or all frames that occur."""
        return " or ".join(dict.fromkeys(column.frame for column in self.columns if column.frame))


class Infant(NamedTuple):
    """One infant, as it was at the start."""

    name: str  # "" for a single one
    age: Optional[float]  # months
    sex: str  # "F", "M", or "U" for the mean of both
    mass: float  # kg
    height: float  # m


class Event(NamedTuple):
    """Something that happened after a step."""

    time: float  # s
    name: str  # "terminated", "truncated", "changed"
    outcome: str  # "success", "failure" or "n/a"
    infant: Optional[int]


class Kept(Closing):
    """A recording, and all that it says of its numbers.

        with Kept("run.h5") as kept:
            for table in kept.tables:
                rows = kept.read(table)

    `fields` chooses senses and fields; the default is all that the recording keeps. Senses of a user's own that it has
    are needed: `own_senses` are paths of shared libraries, whose code runs.
    """

    def __init__(
        self,
        path: "Union[str, os.PathLike[str]]",
        fields: Optional[Sequence[str]] = None,
        own_senses: Sequence[str] = (),
    ) -> None:
        self.recording = Recording(path)
        try:
            for sense in own_senses:
                self.recording.load_sense(sense)
            self._describe(fields)
        except BaseException:
            self.recording.close()
            raise

    def close(self) -> None:
        """Closes the recording."""
        self.recording.close()

    def _describe(self, fields: Optional[Sequence[str]]) -> None:
        recording = self.recording
        if recording.format_version < 3:
            raise ValueError(
                f"{recording.path} has format version {recording.format_version}, expected 3, which holds its world; "
                f"'mimo replay {recording.path} --scene SCENE --out NEW.h5' writes it anew"
            )
        if recording.steps == 0:
            raise ValueError(f"{recording.path} has no steps, expected one or more")
        self.times = recording.read("time", np.float64).ravel()
        with world_as_recorded(recording, recording.path) as world:
            self.task = world.task
            self.prefixes = list(prefixes(world))
            self.infants = self._infants(world)
            self.tables = [*self._of_run(world), *self._of_fields(world, fields)]

    @property
    def rate(self) -> Optional[float]:
        """Rows per second; None where steps are not evenly spaced."""
        apart = np.diff(self.times)
        even = len(apart) == 0 or np.allclose(apart, self.recording.step_seconds, rtol=0, atol=1e-9)
        return 1 / self.recording.step_seconds if even else None

    def read(self, table: Table) -> NDArray[Any]:
        """All rows of a table."""
        rows = self.recording.read(table.dataset, table.dtype)
        return rows.reshape(len(rows), *table.shape)

    def chunks(self, table: Table) -> Iterator[NDArray[Any]]:
        """The rows of a table in parts of a few megabytes."""
        steps = self.recording.steps
        width = max(1, int(np.prod(table.shape)) * np.dtype(table.dtype).itemsize)
        many = max(1, CHUNK_BYTES // width)
        for first in range(0, steps, many):
            rows = self.recording.read(table.dataset, table.dtype, first, min(many, steps - first))
            yield rows.reshape(len(rows), *table.shape)

    def poses(self) -> Tuple[List[str], List[int], NDArray[np.float32]]:
        """Names and parents of all bodies, and their poses after each step: steps x bodies x 7, m and w x y z."""
        recording = self.recording
        with world_without_senses(recording, recording.path) as world:
            bodies = world.bodies()
            moved = np.empty((recording.steps, len(bodies), 7), np.float32)
            recording.seek(world, 0, compare_fields=False, joints=True)
            for step in range(recording.steps):
                recording.step(world, senses=False)
                moved[step] = bodies.read("pose", now=True)
            return bodies.names, bodies.body_ids.tolist(), moved

    def events(self) -> List[Event]:
        """Ends of episodes, and moments at which something other than a step changed the world."""
        read, found = self.recording.read, []
        ends = {name: read(name, np.uint8) for name in ("terminated", "truncated")}
        outcome = read("outcome", np.int32)
        for name, flags in ends.items():
            for step, infant in zip(*np.nonzero(flags)):
                result = {1: "success", -1: "failure"}.get(int(outcome[step, infant]), "n/a")
                found.append(Event(float(self.times[step]), name, result, int(infant)))
        given = read("states/given", np.uint8).ravel()
        for step in read("states/step", np.int64).ravel()[given != 0]:
            found.append(Event(float(self.times[step - 1]) if step > 0 else 0.0, "changed", "n/a", None))
        return sorted(found)

    def _infants(self, world: World) -> List[Infant]:
        growth: Any = []
        if world.agents:
            growth = self.recording.read("bodies/growth", np.float64, 0, 1).reshape(len(world.agents), -1)
        ages = [world.get(Quantity.AGENT_AGE, [number]) for number in range(len(world.agents))]
        sexes = {Sex.FEMALE: "F", Sex.MALE: "M"}
        return [
            Infant(
                agent.name,
                float(age[0]) if age.size else None,
                sexes.get(Sex(int(row[2])), "U"),
                float(agent.mass),
                float(agent.height),
            )
            for agent, age, row in zip(world.agents, ages, growth)
        ]

    def _has(self, dataset: str, dtype: Any) -> bool:
        try:
            self.recording.read(dataset, dtype, 0, 1)
        except NotFoundError:
            return False
        return True

    def _of_run(self, world: World) -> Iterator[Table]:
        """What every recording has."""

        def table(name: str, dtype: Any, columns: List[Column], infant: Optional[int] = None) -> Table:
            return Table(name, name, dtype, (len(columns),), tuple(columns), NUMBERS, 0.0, 0.0, infant)

        positions, velocities = _joint_columns(world)
        yield table("joints/position", np.float64, positions)
        yield table("joints/velocity", np.float64, velocities)
        layout = world.layout
        if layout.actions and self._has("actions", np.float32):
            columns = [Column(action.name, action.unit, "actuator") for action in layout.actions]
            yield table("actions", np.float32, columns)
        if world.agents:
            names = [agent.name or "reward" for agent in world.agents]
            yield table("rewards", np.float64, [Column(name, "", "") for name in names])
        if layout.terms:
            terms = [Column(self.prefixes[term.agent] + term.name, "", "") for term in layout.terms]
            yield table("terms", np.float64, terms)

    def _of_fields(self, world: World, wanted: Optional[Sequence[str]]) -> Iterator[Table]:
        layout, kept = world.layout, []
        for field in layout.fields.values():
            if self._has(f"fields/{field.name}", field.dtype):
                kept.append(field)
        for name in wanted or []:
            if not any(is_meant(name, field.name) for field in kept):
                names = [field.name for field in kept]
                raise ValueError(
                    f"{self.recording.path} keeps no {name!r}{meant(name, names) or ';'} it keeps "
                    f"{', '.join(names) or 'no fields'}; 'mimo replay {self.recording.path} --keep {name} "
                    "--out NEW.h5' keeps more"
                )
        for field in kept:
            if wanted is None or any(is_meant(name, field.name) for name in wanted):
                yield table_of(world, field)

    def of_infant(self, table: Table, infant: int) -> List[int]:
        """The columns of a table that belong to an infant, or to none."""
        if table.infant is not None:
            return list(range(len(table.columns))) if table.infant == infant else []
        others = [prefix for number, prefix in enumerate(self.prefixes) if number != infant]
        names = [it.name for number, it in enumerate(self.infants) if number != infant]
        return [
            number
            for number, column in enumerate(table.columns)
            if not any(column.name.startswith(prefix) for prefix in others) and column.name not in names
        ]


def as_texts(rows: NDArray[Any]) -> Iterator[List[str]]:
    """Numbers of each row with as many digits as they need to be read back to the last bit."""
    digits = "%.9g" if rows.dtype == np.float32 else "%r"
    for row in rows.reshape(len(rows), -1):
        yield [digits % number for number in row.tolist()]


def is_meant(name: str, field: str) -> bool:
    """Whether a name of a sense or field, with or without an infant's prefix, means a field."""
    return field == name or field.startswith(f"{name}/") or f"/{name}/" in field or field.endswith(f"/{name}")


def table_of(world: World, field: Field) -> Table:
    """A field of a world as a table."""
    infant, name = None, field.name
    for number, prefix in enumerate(prefixes(world)):
        if prefix == "" or field.name.startswith(prefix):
            infant, name = number, field.name[len(prefix) :]
    sensors: Tuple[Tuple[str, Tuple[float, ...]], ...] = ()
    if field.receptors > 0:
        places, bodies = world.layout.receptors(field.name), world.bodies().names
        sensors = tuple((bodies[body], tuple(at)) for body, at in zip(places.bodies, places.position.tolist()))
    kind, columns = _columns_of(field, name, [body for body, _ in sensors])
    dataset = f"fields/{field.name}"
    return Table(name, dataset, field.dtype, field.shape, columns, kind, field.end, field.sample_rate, infant, sensors)


def _columns_of(field: Field, name: str, owners: List[str]) -> Tuple[str, Tuple[Column, ...]]:
    def column(label: str) -> Column:
        return Column(label, field.unit, field.frame)

    last = name.rsplit("/", 1)[-1]
    if field.sample_rate > 0:
        return SOUND, (column(last),)
    if len(field.shape) == 3 and not field.labels and not owners:
        return PICTURE, (column(last),)
    if field.labels:
        return NUMBERS, tuple(map(column, field.labels))
    if not owners:
        count = int(np.prod(field.shape))
        return NUMBERS, tuple(column(last if count == 1 else f"{last}/{number}") for number in range(count))
    width = int(np.prod(field.shape)) // len(owners)
    parts = [f"/{part}" for part in _parts(width, field.frame)] if width > 1 else [""]
    numbers: Dict[str, int] = {}
    columns = []
    for owner in owners:
        number = numbers.get(owner, 0)
        numbers[owner] = number + 1
        columns += [column(f"{owner}/{number}{part}") for part in parts]
    return NUMBERS, tuple(columns)


def _parts(width: int, frame: str) -> Sequence[str]:
    if frame == "skin" and width <= 3:
        return OF_SKIN[3 - width :]  # two numbers lie in the skin's plane
    return AXES if width == 3 else [str(number) for number in range(width)]


def _joint_columns(world: World) -> Tuple[List[Column], List[Column]]:
    """Of positions and velocities of all joints, which the recording's "m or rad" does not tell apart."""
    joints, bodies = world.joints(), world.bodies().names
    positions, velocities = [], []
    slides = _slides(world)
    for index, (name, owner) in enumerate(zip(joints.names, joints.body_ids)):
        label = name or bodies[owner]
        width = joints._width(Quantity.JOINT_POSITION, joints.ids[index : index + 1])
        if width == 1:
            unit = "m" if joints.ids[index] in slides else "rad"
            positions.append(Column(label, unit, "joint"))
            velocities.append(Column(label, f"{unit}/s", "joint"))
            continue
        frame = "world" if width == 7 else "parent"
        if width == 7:
            positions += [Column(f"{label}/{axis}", "m", "world") for axis in AXES]
            velocities += [Column(f"{label}/{axis}", "m/s", "world") for axis in AXES]
        positions += [Column(f"{label}/{part}", "", frame) for part in QUATERNION]
        velocities += [Column(f"{label}/w{axis}", "rad/s", "body") for axis in AXES]
    return positions, velocities


def _slides(world: World) -> List[int]:
    """Joints that move their bodies and do not turn them."""
    joints, slides = world.joints(), []
    for number, owner in zip(joints.ids, joints.body_ids):
        one = [int(number)]
        if joints._width(Quantity.JOINT_POSITION, np.array(one, np.int32)) != 1:
            continue
        at, before = world.get(Quantity.JOINT_POSITION, one), _turn(world, owner)
        world.set(Quantity.JOINT_POSITION, at + 0.1, one)
        if np.allclose(_turn(world, owner), before, rtol=0, atol=1e-6):
            slides.append(int(number))
        world.set(Quantity.JOINT_POSITION, at, one)
    return slides


def _turn(world: World, body: int) -> NDArray[np.float64]:
    return np.asarray(world.get(Quantity.BODY_ORIENTATION, [int(body)], now=True))
