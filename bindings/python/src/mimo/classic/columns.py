"""MuJoCo's arrays of a model and its data: how each is read, and what writing to it does."""

from __future__ import annotations

from typing import Any, Callable, Dict, Mapping, NamedTuple, Optional

import numpy as np
from numpy.typing import NDArray

from ..constants import Kind, Quantity
from .catalog import Catalog
from .document import EQUALITIES, GEOMS, JOINTS, SENSORS, Row
from .rotations import matrices, matrix, product

Numbers = NDArray[Any]
Read = Callable[[Catalog], Any]
IN_THE_SCENE = "it is a constant of the model here: write it in the scene's document"
COMPUTED = "the physics computes it"


class Column(NamedTuple):
    """An array: how it is read and written, and what to do instead of writing."""

    read: Read
    write: Optional[Callable[[Catalog, Numbers, Numbers], None]] = None
    instead: str = IN_THE_SCENE


# ---- Makers of columns -------------------------------------------------------------------------------------------


def _quantity(kind: Kind, quantity: Quantity, instead: str = "") -> Column:
    """A quantity of the library, which can be written unless `instead` says what to do."""
    if instead:
        return Column(lambda it: it.read(kind, quantity), None, instead)
    return Column(lambda it: it.read(kind, quantity), lambda it, new, old: it.write(kind, quantity, new, old))


def _turned(kind: Kind, quantity: Quantity) -> Column:
    return Column(lambda it: matrices(it.read(kind, quantity)), None, COMPUTED)


def _constant(rows: str, value: Callable[[Any, Row], Any], dtype: Any = np.float64) -> Column:
    """A constant from the document: `value` of each of its rows."""

    def read(it: Catalog) -> Numbers:
        document = it.document
        return np.array([value(document, row) for row in getattr(document, rows)], dtype)

    return Column(read)


def _number(rows: str, name: str, standard: float, dtype: Any = np.float64) -> Column:
    return _constant(rows, lambda _, row: row.number(name, standard), dtype)


def _numbers(rows: str, name: str, *standard: float) -> Column:
    return _constant(rows, lambda _, row: row.numbers(name, standard))


def _choice(rows: str, name: str, words: Any, standard: str) -> Column:
    return _constant(rows, lambda _, row: words.index(row.at.get(name, standard)), np.int32)


# ---- Bodies and shapes -------------------------------------------------------------------------------------------


def _place(quantity: Quantity, attribute: Callable[[Catalog, Row], Any]) -> Column:
    """Where a body stands on its parent: of a body that stands on the world, where it is."""

    def read(it: Catalog) -> Numbers:
        stated = np.array([attribute(it, row) for row in it.document.bodies])
        return np.where(it.still_bodies()[:, None], it.read(Kind.BODY, quantity, now=True), stated)

    def write(it: Catalog, new: Numbers, old: Numbers) -> None:
        for body in np.flatnonzero((new != old).any(axis=1)):
            if not it.still_bodies()[body]:
                name = it.world.name(Kind.BODY, int(body))
                raise ValueError(
                    f"the place of {name!r} on its parent is a constant here: move it with data.joint(...).qpos, or "
                    "write it in the scene's document"
                )
        it.write(Kind.BODY, quantity, new, old)

    return Column(read, write)


def _relative_places(kind: Kind, quantity: Quantity) -> Column:
    def read(it: Catalog) -> Numbers:
        frames = [matrix(one) for one in it.read(Kind.BODY, Quantity.BODY_ORIENTATION, now=True)]
        origins = it.read(Kind.BODY, Quantity.BODY_POSITION, now=True)
        owners = np.arange(it.count(kind)) if kind == Kind.BODY else it.bodies_of(kind)
        places = it.read(kind, quantity, now=True)
        return np.array([(place - origins[of]) @ frames[of] for place, of in zip(places, owners)]).reshape(-1, 3)

    return Column(read)


def _relative_turns(kind: Kind, quantity: Quantity) -> Column:
    def read(it: Catalog) -> Numbers:
        frames = it.read(Kind.BODY, Quantity.BODY_ORIENTATION, now=True) * [1, -1, -1, -1]
        turns = it.read(kind, quantity, now=True)
        return np.array([product(frames[of], turn) for turn, of in zip(turns, it.bodies_of(kind))]).reshape(-1, 4)

    return Column(read)


def _owned(kind: Kind, first: bool) -> Column:
    """The first element of a kind in each body, -1 without any; or their number."""

    def read(it: Catalog) -> Numbers:
        of, bodies = it.bodies_of(kind), np.arange(it.count(Kind.BODY))
        counts = np.array([np.count_nonzero(of == body) for body in bodies], np.int32)
        if not first:
            return counts
        starts = [int(np.flatnonzero(of == body)[0]) if counts[body] else -1 for body in bodies]
        return np.array(starts, np.int32)

    return Column(read)


def _roots(it: Catalog) -> Numbers:
    parents = it.bodies_of(Kind.BODY)
    roots = np.zeros(len(parents), np.int32)
    for body in range(1, len(parents)):
        roots[body] = body if parents[body] == 0 else roots[parents[body]]
    return roots


def _below(it: Catalog, values: Numbers) -> Numbers:
    """The sums of values over each body and its descendants."""
    sums, parents = np.array(values, np.float64), it.bodies_of(Kind.BODY)
    for body in range(len(parents) - 1, 0, -1):
        sums[parents[body]] += sums[body]
    return sums


def _subtree_centers(it: Catalog) -> Numbers:
    mass = it.read(Kind.BODY, Quantity.BODY_MASS)
    moments = _below(it, mass[:, None] * it.read(Kind.BODY, Quantity.BODY_CENTER_OF_MASS))
    sums = _below(it, mass)[:, None]
    return np.where(sums > 0, moments / np.where(sums > 0, sums, 1), it.read(Kind.BODY, Quantity.BODY_POSITION))


def _spatial_velocities(it: Catalog) -> Numbers:
    """Rotation, then velocity at the centre of mass of the whole tree, as MuJoCo keeps them."""
    velocity = it.read(Kind.BODY, Quantity.BODY_VELOCITY)
    arms = _subtree_centers(it)[_roots(it)] - it.read(Kind.BODY, Quantity.BODY_POSITION)
    return np.hstack([velocity[:, 3:], velocity[:, :3] + np.cross(velocity[:, 3:], arms)])


def mocap_bodies(it: Catalog) -> NDArray[np.intp]:
    return np.array([i for i, row in enumerate(it.document.bodies) if row.at.get("mocap") == "true"], np.intp)


def _mocap_column(quantity: Quantity) -> Column:
    def write(it: Catalog, new: Numbers, old: Numbers) -> None:
        it.write_to(Kind.BODY, quantity, mocap_bodies(it), new)

    return Column(lambda it: it.read(Kind.BODY, quantity, now=True)[mocap_bodies(it)], write)


def _mocap_numbers(it: Catalog) -> Numbers:
    numbers = np.full(it.count(Kind.BODY), -1, np.int32)
    numbers[mocap_bodies(it)] = np.arange(len(mocap_bodies(it)))
    return numbers


def _materials(it: Catalog) -> Numbers:
    names = [row.at.get("name") for row in it.document.materials]
    given = [row.at.get("material") for row in it.document.geoms]
    return np.array([names.index(name) if name in names else -1 for name in given], np.int32)


def _bounds(it: Catalog) -> Numbers:
    """Radii around geoms; of meshes from their triangles."""
    kinds, sizes = MODEL["geom_type"].read(it), it.read(Kind.GEOM, Quantity.GEOM_SIZE)
    radii = np.zeros(len(kinds))
    for geom, (kind, size) in enumerate(zip(kinds, sizes)):
        name = GEOMS[kind]
        if name == "sphere":
            radii[geom] = size[0]
        elif name == "capsule":
            radii[geom] = size[0] + size[1]
        elif name == "cylinder":
            radii[geom] = np.hypot(size[0], size[1])
        elif name == "ellipsoid":
            radii[geom] = size.max()
        elif name == "box":
            radii[geom] = np.linalg.norm(size)
        elif name == "mesh":
            radii[geom] = np.linalg.norm(it.world.mesh(geom).positions, axis=1).max()
    return radii


# ---- Joints ------------------------------------------------------------------------------------------------------


def _rest(name: str) -> Read:
    """Positions of joints in the document: of hinges and slides the attribute `name`."""

    def read(it: Catalog) -> Numbers:
        document, rest = it.document, []
        for row in document.joints:
            kind = row.at.get("type", "hinge")
            if kind == "free":
                body = document.bodies[row.body]
                rest += [*body.numbers("pos", (0, 0, 0)), *document.orientation(body)]
            elif kind == "ball":
                rest += [1.0, 0, 0, 0]
            else:
                value = row.number(name)
                rest.append(document.radians(value) if kind == "hinge" else value)
        return np.array(rest)

    return read


def _ranges(it: Catalog) -> Numbers:
    limits = it.read(Kind.JOINT, Quantity.JOINT_RANGE)
    return np.where(np.isfinite(limits), limits, 0.0)


def _by_dof(value: Callable[[Catalog], Numbers]) -> Read:
    return lambda it: value(it)[it.joint_of_dof]


def _write_damping(it: Catalog, new: Numbers, old: Numbers) -> None:
    joints, damping = it.joint_of_dof, it.read(Kind.JOINT, Quantity.JOINT_DAMPING)
    changed = np.unique(joints[np.flatnonzero(new != old)])
    for joint in changed:
        axes = new[joints == joint]
        if np.ptp(axes) > 0:
            raise ValueError(f"dof_damping of a joint's axes is {axes.tolist()}, expected one value for all its axes")
        damping[joint] = axes[0]
    it.write_to(Kind.JOINT, Quantity.JOINT_DAMPING, changed, damping[changed])


# ---- Motors, sensors, locks --------------------------------------------------------------------------------------


def _gears(it: Catalog) -> Numbers:
    gears = np.zeros((it.count(Kind.ACTUATOR), 6))
    gears[:, 0] = it.read(Kind.ACTUATOR, Quantity.ACTUATOR_GEAR)
    return gears


def _write_gears(it: Catalog, new: Numbers, old: Numbers) -> None:
    if (new[:, 1:] != old[:, 1:]).any():
        raise ValueError("actuator_gear has one number a motor here, the first of the six: set actuator_gear[:, 0]")
    it.write(Kind.ACTUATOR, Quantity.ACTUATOR_GEAR, new[:, 0], old[:, 0])


def _joint_numbers(it: Catalog) -> Dict[str, int]:
    return {name: number for number, name in enumerate(it.names(Kind.JOINT))}


def _joints_of_motors(it: Catalog) -> Numbers:
    names = _joint_numbers(it)
    return np.array([[names.get(row.at.get("joint", ""), -1), -1] for row in it.document.actuators], np.int32)


def user_numbers(it: Catalog) -> Numbers:
    rows = it.document.actuators
    width = max((len(row.at.get("user", "").split()) for row in rows), default=0)
    width = max(width, int(it.document.merged("size").get("nuser_actuator", -1)))
    return np.array([row.numbers("user", [0.0] * width) for row in rows]).reshape(len(rows), -1)


def _motor_forces(it: Catalog) -> Numbers:
    forces = np.zeros(int(it.qvel_at[-1]))
    motors, gears = _joints_of_motors(it)[:, 0], it.read(Kind.ACTUATOR, Quantity.ACTUATOR_GEAR)
    for joint, force in zip(motors, gears * it.read(Kind.ACTUATOR, Quantity.ACTUATOR_FORCE)):
        if joint >= 0:
            forces[it.qvel_at[joint]] += force
    return forces


def _sensor_types(it: Catalog) -> Numbers:
    tags = [row.tag for row in it.document.sensors]
    return np.array([SENSORS.index(tag) if tag in SENSORS else -1 for tag in tags], np.int32)


def _sensor_widths(it: Catalog) -> Numbers:
    sensors = it.all_of(Kind.SENSOR)
    return np.array([sensors._width(Quantity.SENSOR_VALUE, sensors.ids[i : i + 1]) for i in range(len(sensors))], int)


def _locked_joints(it: Catalog) -> NDArray[np.intp]:
    """The joint that each equality could hold at an angle; -1 for others."""
    names = _joint_numbers(it)
    rows = it.document.equalities
    return np.array(
        [names[row.at["joint1"]] if row.tag == "joint" and "joint2" not in row.at else -1 for row in rows], np.intp
    )


def _locks(it: Catalog) -> Numbers:
    """Of each equality, whether it acts, and the angle (MuJoCo's five numbers, of others eleven)."""
    rows, joints = it.document.equalities, _locked_joints(it)
    held = it.read(Kind.JOINT, Quantity.JOINT_LOCK).reshape(-1, 2)
    active = [held[joint, 0] if joint >= 0 else row.at.get("active") != "false" for row, joint in zip(rows, joints)]
    data = np.zeros((len(rows), 11))
    for number, (row, joint) in enumerate(zip(rows, joints)):
        data[number, :5] = row.numbers("polycoef", (0, 1, 0, 0, 0))
        if joint >= 0:
            data[number, 0] = held[joint, 1]
    return np.column_stack([active, data])


def _write_locks(it: Catalog, new: Numbers, old: Numbers) -> None:
    joints = _locked_joints(it)
    for number in np.flatnonzero((new != old).any(axis=1)):
        joint = joints[number]
        if joint < 0:
            raise ValueError("only equalities that hold a joint at an angle can be changed here; see mimo.Scene.weld")
        it.write_to(Kind.JOINT, Quantity.JOINT_LOCK, [joint], new[number : number + 1, :2])


def _write_active(it: Catalog, new: Numbers, old: Numbers) -> None:
    locks = _locks(it)
    _write_locks(it, np.column_stack([new, locks[:, 1:]]), locks)


def _write_angles(it: Catalog, new: Numbers, old: Numbers) -> None:
    if (new[:, 1:] != old[:, 1:]).any() and (new[:, 1:5] != [1, 0, 0, 0]).any() and new[:, 1:].any():
        raise ValueError("eq_data: only the first number of a joint's equality can be changed, the angle")
    locks = _locks(it)
    _write_locks(it, np.column_stack([locks[:, 0], new]), locks)


def _partner(attribute: str) -> Column:
    def read(it: Catalog) -> Numbers:
        kinds = {"joint": Kind.JOINT, "weld": Kind.BODY, "connect": Kind.BODY}
        found = []
        for row in it.document.equalities:
            kind = kinds.get(row.tag, Kind.BODY)
            name = row.at.get(f"{'joint' if row.tag == 'joint' else 'body'}{attribute}")
            found.append(it.names(kind).index(name) if name in it.names(kind) else (-1 if kind == Kind.JOINT else 0))
        return np.array(found, np.int32)

    return Column(read)


_LIMITED = ("false", "true")
_FACTS: Dict[str, Column] = {
    "body_pos": _place(Quantity.BODY_POSITION, lambda it, row: row.numbers("pos", (0, 0, 0))),
    "body_quat": _place(Quantity.BODY_ORIENTATION, lambda it, row: it.document.orientation(row)),
    "geom_type": _choice("geoms", "type", GEOMS, "sphere"),
    "geom_contype": _number("geoms", "contype", 1, np.int32),
    "geom_conaffinity": _number("geoms", "conaffinity", 1, np.int32),
    "geom_condim": _number("geoms", "condim", 3, np.int32),
    "geom_group": _number("geoms", "group", 0, np.int32),
    "geom_margin": _number("geoms", "margin", 0),
    "geom_solref": _numbers("geoms", "solref", 0.02, 1),
    "geom_solimp": _numbers("geoms", "solimp", 0.9, 0.95, 0.001, 0.5, 2),
    "jnt_type": _choice("joints", "type", JOINTS, "hinge"),
    "jnt_stiffness": _number("joints", "stiffness", 0),
    "jnt_axis": _constant("joints", lambda _, row: _unit(row.numbers("axis", (0, 0, 1)))),
    "jnt_pos": _numbers("joints", "pos", 0, 0, 0),
    "jnt_margin": _number("joints", "margin", 0),
    "jnt_solref": _numbers("joints", "solreflimit", 0.02, 1),
    "actuator_ctrlrange": _numbers("actuators", "ctrlrange", 0, 0),
    "actuator_forcerange": _numbers("actuators", "forcerange", 0, 0),
    "actuator_ctrllimited": _choice("actuators", "ctrllimited", _LIMITED, "false"),
    "actuator_forcelimited": _choice("actuators", "forcelimited", _LIMITED, "false"),
    "actuator_gainprm": _numbers("actuators", "gainprm", 1, *[0.0] * 9),
    "actuator_biasprm": _numbers("actuators", "biasprm", *[0.0] * 10),
    "site_size": _numbers("sites", "size", 0.005, 0.005, 0.005),
    "site_group": _number("sites", "group", 0, np.int32),
    "eq_type": _constant("equalities", lambda _, row: EQUALITIES.index(row.tag), np.int32),
    "cam_fovy": _number("cameras", "fovy", 45),
    "mat_rgba": _numbers("materials", "rgba", 1, 1, 1, 1),
}


def _unit(vector: Numbers) -> Numbers:
    return vector / (np.linalg.norm(vector) or 1)


MODEL: Mapping[str, Column] = {
    **_FACTS,
    "body_mass": _quantity(Kind.BODY, Quantity.BODY_MASS),
    "body_parentid": Column(lambda it: it.bodies_of(Kind.BODY)),
    "body_rootid": Column(_roots),
    "body_subtreemass": Column(lambda it: _below(it, it.read(Kind.BODY, Quantity.BODY_MASS)), None, COMPUTED),
    "body_mocapid": Column(_mocap_numbers),
    "body_ipos": _relative_places(Kind.BODY, Quantity.BODY_CENTER_OF_MASS),
    "body_geomadr": _owned(Kind.GEOM, True),
    "body_geomnum": _owned(Kind.GEOM, False),
    "body_jntadr": _owned(Kind.JOINT, True),
    "body_jntnum": _owned(Kind.JOINT, False),
    "geom_bodyid": Column(lambda it: it.bodies_of(Kind.GEOM)),
    "geom_size": _quantity(Kind.GEOM, Quantity.GEOM_SIZE),
    "geom_friction": _quantity(Kind.GEOM, Quantity.GEOM_FRICTION),
    "geom_rgba": _quantity(Kind.GEOM, Quantity.GEOM_COLOR),
    "geom_pos": _relative_places(Kind.GEOM, Quantity.GEOM_POSITION),
    "geom_quat": _relative_turns(Kind.GEOM, Quantity.GEOM_ORIENTATION),
    "geom_rbound": Column(_bounds),
    "geom_matid": Column(_materials),
    "jnt_bodyid": Column(lambda it: it.bodies_of(Kind.JOINT)),
    "jnt_qposadr": Column(lambda it: it.qpos_at[:-1].astype(np.int32)),
    "jnt_dofadr": Column(lambda it: it.qvel_at[:-1].astype(np.int32)),
    "jnt_range": Column(_ranges),
    "jnt_limited": Column(
        lambda it: np.isfinite(it.read(Kind.JOINT, Quantity.JOINT_RANGE)).all(axis=1).astype(np.uint8)
    ),
    "qpos0": Column(_rest("ref")),
    "qpos_spring": Column(_rest("springref")),
    "dof_damping": Column(_by_dof(lambda it: it.read(Kind.JOINT, Quantity.JOINT_DAMPING)), _write_damping),
    "dof_armature": Column(_by_dof(lambda it: _of_joints(it, "armature"))),
    "dof_frictionloss": Column(_by_dof(lambda it: _of_joints(it, "frictionloss"))),
    "dof_jntid": Column(lambda it: it.joint_of_dof.astype(np.int32)),
    "dof_bodyid": Column(lambda it: it.bodies_of(Kind.JOINT)[it.joint_of_dof]),
    "actuator_gear": Column(_gears, _write_gears),
    "actuator_trnid": Column(_joints_of_motors),
    "actuator_user": Column(user_numbers),
    "sensor_type": Column(_sensor_types),
    "sensor_dim": Column(lambda it: _sensor_widths(it).astype(np.int32)),
    "sensor_adr": Column(lambda it: np.concatenate([[0], np.cumsum(_sensor_widths(it))[:-1]]).astype(np.int32)),
    "eq_active": Column(lambda it: _locks(it)[:, 0].astype(np.uint8), _write_active),
    "eq_active0": Column(lambda it: _locks(it)[:, 0].astype(np.uint8), _write_active),
    "eq_data": Column(lambda it: _locks(it)[:, 1:], _write_angles),
    "eq_obj1id": _partner("1"),
    "eq_obj2id": _partner("2"),
    "site_bodyid": Column(lambda it: it.bodies_of(Kind.SITE)),
    "site_pos": _relative_places(Kind.SITE, Quantity.SITE_POSITION),
    "site_quat": _relative_turns(Kind.SITE, Quantity.SITE_ORIENTATION),
    "cam_bodyid": Column(lambda it: it.bodies_of(Kind.CAMERA)),
    "cam_pos": _relative_places(Kind.CAMERA, Quantity.CAMERA_POSITION),
    "cam_quat": _relative_turns(Kind.CAMERA, Quantity.CAMERA_ORIENTATION),
    "light_pos": _quantity(Kind.LIGHT, Quantity.LIGHT_POSITION),
    "light_dir": _quantity(Kind.LIGHT, Quantity.LIGHT_DIRECTION),
    "light_diffuse": _quantity(Kind.LIGHT, Quantity.LIGHT_COLOR),
}


def _of_joints(it: Catalog, name: str) -> Numbers:
    return np.array([row.number(name) for row in it.document.joints])


def _motion(quantity: Quantity, at: Callable[[Catalog], NDArray[np.intp]]) -> Column:
    return Column(
        lambda it: it.read(Kind.JOINT, quantity).ravel(),
        lambda it, new, old: it.write_joints(quantity, at(it), new, old),
    )


_MOVE = f"{COMPUTED}: move bodies with data.qpos, or data.joint(...).qpos"
DATA: Mapping[str, Column] = {
    "qpos": _motion(Quantity.JOINT_POSITION, lambda it: it.qpos_at),
    "qvel": _motion(Quantity.JOINT_VELOCITY, lambda it: it.qvel_at),
    "qfrc_applied": _motion(Quantity.JOINT_FORCE, lambda it: it.qvel_at),
    "qacc": Column(lambda it: it.read(Kind.JOINT, Quantity.JOINT_ACCELERATION).ravel(), None, COMPUTED),
    "qfrc_actuator": Column(_motor_forces, None, COMPUTED),
    "ctrl": _quantity(Kind.ACTUATOR, Quantity.ACTUATOR_CONTROL),
    "actuator_force": _quantity(Kind.ACTUATOR, Quantity.ACTUATOR_FORCE, COMPUTED),
    "xfrc_applied": _quantity(Kind.BODY, Quantity.BODY_FORCE),
    "xpos": _quantity(Kind.BODY, Quantity.BODY_POSITION, _MOVE),
    "xquat": _quantity(Kind.BODY, Quantity.BODY_ORIENTATION, _MOVE),
    "xmat": _turned(Kind.BODY, Quantity.BODY_ORIENTATION),
    "xipos": _quantity(Kind.BODY, Quantity.BODY_CENTER_OF_MASS, _MOVE),
    "cvel": Column(_spatial_velocities, None, COMPUTED),
    "subtree_com": Column(_subtree_centers, None, COMPUTED),
    "geom_xpos": _quantity(Kind.GEOM, Quantity.GEOM_POSITION, _MOVE),
    "geom_xmat": _turned(Kind.GEOM, Quantity.GEOM_ORIENTATION),
    "site_xpos": _quantity(Kind.SITE, Quantity.SITE_POSITION, _MOVE),
    "site_xmat": _turned(Kind.SITE, Quantity.SITE_ORIENTATION),
    "cam_xpos": _quantity(Kind.CAMERA, Quantity.CAMERA_POSITION, _MOVE),
    "cam_xmat": _turned(Kind.CAMERA, Quantity.CAMERA_ORIENTATION),
    "sensordata": Column(lambda it: it.read(Kind.SENSOR, Quantity.SENSOR_VALUE).ravel(), None, COMPUTED),
    "mocap_pos": _mocap_column(Quantity.BODY_POSITION),
    "mocap_quat": _mocap_column(Quantity.BODY_ORIENTATION),
    "eq_active": MODEL["eq_active"],
}
