"""A stand-in for the package `mujoco`: its functions on our models; on its own models the package, if installed."""

from __future__ import annotations

from enum import IntEnum
from types import ModuleType
from typing import Any, Callable, Dict, Optional

import numpy as np

from ..constants import Kind, Quantity
from . import mathematics
from .elements import KINDS, OTHERS
from .live import PAGE
from .model import DataView, ModelView
from .settings import CHOICES

VIEWS = (ModelView, DataView)


def _enum(name: str, prefix: str, members: Any) -> Any:
    return IntEnum(name, {f"{prefix}{member}": number for member, number in members})


_OBJECTS = (
    *(("UNKNOWN", 0), ("BODY", 1), ("XBODY", 2), ("JOINT", 3), ("DOF", 4), ("GEOM", 5), ("SITE", 6), ("CAMERA", 7)),
    *(("LIGHT", 8), ("MESH", 10), ("TEXTURE", 13), ("MATERIAL", 14), ("PAIR", 15), ("EXCLUDE", 16), ("EQUALITY", 17)),
    *(("TENDON", 18), ("ACTUATOR", 19), ("SENSOR", 20), ("NUMERIC", 21), ("TEXT", 22), ("TUPLE", 23), ("KEY", 24)),
)
_GEOMS = (
    *(("PLANE", 0), ("HFIELD", 1), ("SPHERE", 2), ("CAPSULE", 3), ("ELLIPSOID", 4), ("CYLINDER", 5), ("BOX", 6)),
    ("MESH", 7),
)
CONSTANTS: Dict[str, Any] = {
    "mjtObj": _enum("mjtObj", "mjOBJ_", _OBJECTS),
    "mjtJoint": _enum("mjtJoint", "mjJNT_", (("FREE", 0), ("BALL", 1), ("SLIDE", 2), ("HINGE", 3))),
    "mjtGeom": _enum("mjtGeom", "mjGEOM_", _GEOMS),
    "mjtEq": _enum("mjtEq", "mjEQ_", (("CONNECT", 0), ("WELD", 1), ("JOINT", 2), ("TENDON", 3))),
    "mjtCamera": _enum("mjtCamera", "mjCAMERA_", (("FREE", 0), ("TRACKING", 1), ("FIXED", 2), ("USER", 3))),
    "mjtIntegrator": _enum("mjtIntegrator", "mjINT_", zip(("EULER", "RK4", "IMPLICIT"), range(3))),
    "mjtCone": _enum("mjtCone", "mjCONE_", zip((it.upper() for it in CHOICES["cone"]), range(2))),
    "mjtSolver": _enum("mjtSolver", "mjSOL_", zip((it.upper() for it in CHOICES["solver"]), range(3))),
    "mjMINVAL": 1e-15,
}
_KINDS = {CONSTANTS["mjtObj"][f"mjOBJ_{kind.upper()}"]: kind for kind in (*KINDS, *OTHERS)}
_KINDS[CONSTANTS["mjtObj"].mjOBJ_XBODY] = "body"


# ---- Simulation --------------------------------------------------------------------------------------------------


def _world(data: Any) -> Any:
    return data._world


def mj_step(model: Any, data: Any, nstep: int = 1) -> None:
    """Makes physics steps with the current controls."""
    steps = int(np.asarray(nstep).item())
    _world(data).physics_step(steps)
    data._stage.moved()


def mj_forward(model: Any, data: Any) -> None:
    """Computes what follows from positions and velocities."""
    _world(data).observe()
    data._stage.moved(observed=True)


def mj_kinematics(model: Any, data: Any) -> None:
    """Computes poses from positions."""
    _world(data).update()
    data._stage.moved()


def mj_resetData(model: Any, data: Any) -> None:
    """Puts positions and velocities at the start of an episode, without the randomness of a task's start."""
    _world(data).reset()
    data._stage.moved()
    if data._stage.start is not None:
        data.qpos, data.qvel = data._stage.start


def mj_setConst(model: Any, data: Any) -> None:
    """Nothing: what follows from masses is computed when they are set."""


def mj_rnePostConstraint(model: Any, data: Any) -> None:
    """Nothing: sensors compute what they need."""


# ---- Names -------------------------------------------------------------------------------------------------------


def _kind(number: Any) -> str:
    if int(number) not in _KINDS:
        raise NotImplementedError(f"object type {number!r} is not there, expected {', '.join(_KINDS.values())}; {PAGE}")
    return _KINDS[int(number)]


def mj_id2name(model: Any, type: Any, id: Any) -> Optional[str]:
    """The name of an element, None if it has none."""
    names = model.names_of(_kind(type))
    number = int(np.asarray(id).item())
    return names[number] or None if 0 <= number < len(names) else None


def mj_name2id(model: Any, type: Any, name: str) -> int:
    """The number of an element, -1 if there is none of that name."""
    kind = _kind(type)
    names = model.names_of(kind)
    if kind in KINDS:
        name = model._it.known_name(KINDS[kind][0], name)
    return names.index(name) if name in names else -1


# ---- Contacts and Jacobians --------------------------------------------------------------------------------------


def mj_contactForce(model: Any, data: Any, id: Any, result: Any) -> None:
    """Writes force and torque of a contact on geom 2, in the contact's frame."""
    result[:6] = data.contact.force(int(np.asarray(id).item())).reshape(np.shape(result[:6]))


def mj_objectVelocity(model: Any, data: Any, objtype: Any, objid: int, res: Any, flg_local: int = 0) -> None:
    """Writes rotation and velocity of a body (its frame's origin), in the world's axes or its own."""
    if _kind(objtype) != "body":
        raise NotImplementedError(f"mj_objectVelocity is there for bodies only; {PAGE}")
    velocity = _world(data).get(Quantity.BODY_VELOCITY, [int(objid)]).ravel()
    parts = [velocity[3:], velocity[:3]]
    if flg_local:
        frame = np.asarray(data.xmat[int(objid)]).reshape(3, 3)
        parts = [part @ frame for part in parts]
    res[:] = np.concatenate(parts)


def mj_jac(model: Any, data: Any, jacp: Any, jacr: Any, point: Any, body: int) -> None:
    """Writes how a point of a body moves and turns with each velocity of joints (3 x nv)."""
    it, number = data._it, int(np.asarray(body).item())
    before = it.read(Kind.JOINT, Quantity.JOINT_VELOCITY)
    arm = np.asarray(point) - it.world.get(Quantity.BODY_POSITION, [number], now=True).ravel()
    columns = []
    try:
        for dof in range(before.size):  # velocities depend linearly on those of joints
            unit = np.eye(1, before.size, dof).reshape(before.shape)
            it.all_of(Kind.JOINT)._set(Quantity.JOINT_VELOCITY, unit, None)
            columns.append(it.world.get(Quantity.BODY_VELOCITY, [number], now=True).ravel())
    finally:
        it.all_of(Kind.JOINT)._set(Quantity.JOINT_VELOCITY, before, None)
    velocity = np.array(columns).reshape(-1, 6)
    if jacp is not None:
        jacp[:] = (velocity[:, :3] + np.cross(velocity[:, 3:], arm)).T
    if jacr is not None:
        jacr[:] = velocity[:, 3:].T


def mj_jacBody(model: Any, data: Any, jacp: Any, jacr: Any, body: int) -> None:
    """The same of a body's origin."""
    mj_jac(model, data, jacp, jacr, np.asarray(data.xpos[int(body)]), body)


def mj_jacBodyCom(model: Any, data: Any, jacp: Any, jacr: Any, body: int) -> None:
    """The same of a body's centre of mass."""
    mj_jac(model, data, jacp, jacr, np.asarray(data.xipos[int(body)]), body)


def mj_jacSite(model: Any, data: Any, jacp: Any, jacr: Any, site: int) -> None:
    """The same of a site."""
    mj_jac(model, data, jacp, jacr, np.asarray(data.site_xpos[int(site)]), int(model.site_bodyid[int(site)]))


def mj_jacGeom(model: Any, data: Any, jacp: Any, jacr: Any, geom: int) -> None:
    """The same of a geom."""
    mj_jac(model, data, jacp, jacr, np.asarray(data.geom_xpos[int(geom)]), int(model.geom_bodyid[int(geom)]))


FUNCTIONS: Dict[str, Callable[..., Any]] = {
    **{name: value for name, value in list(globals().items()) if name.startswith("mj_")},
    "mj_comPos": mj_kinematics,
    "mj_fwdPosition": mj_forward,
    "mj_camlight": mj_kinematics,
    "mj_collision": mj_forward,
    "mj_subtreeVel": mj_rnePostConstraint,
    "mj_sensorPos": mj_forward,
}


# ---- The module --------------------------------------------------------------------------------------------------


class StandIn(ModuleType):
    """The module `mujoco` of a script."""

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        real = self.__dict__.get("_real")
        theirs = getattr(real, name, None) if real is not None else None
        found = self._found(name, theirs)
        self.__dict__[name] = found
        return found

    def _found(self, name: str, theirs: Any) -> Any:
        if name == "Renderer":
            from .offscreen import renderer_for

            return renderer_for(theirs)
        if name in FUNCTIONS:
            return _for_both(name, FUNCTIONS[name], theirs)
        if theirs is not None:
            return _refusing(name, theirs) if name.startswith("mj_") and callable(theirs) else theirs
        if name in CONSTANTS:
            return CONSTANTS[name]
        if name in mathematics.FUNCTIONS:
            return mathematics.FUNCTIONS[name]
        if name in mathematics.CLASSES:
            return mathematics.CLASSES[name]
        if name in ("MjModel", "MjData"):
            from . import alone

            return getattr(alone, name)
        if name.startswith(("mj_", "mju_", "mjv_", "mjr_", "Mj")):
            return _missing(name)
        raise AttributeError(f"mujoco has no {name!r} here; {PAGE}")


def stand_in(real: Optional[ModuleType]) -> StandIn:
    """The module, around the real one if it is installed."""
    module = StandIn(
        "mujoco", "MuJoCo's functions on models of mimo.classic, and on MuJoCo's own where it is installed."
    )
    module.__dict__["_real"] = real
    module.__dict__["__version__"] = getattr(real, "__version__", "3.0.0")
    if real is not None:
        module.__dict__["__path__"] = list(real.__path__)
    return module


def _for_both(name: str, own: Callable[..., Any], theirs: Optional[Callable[..., Any]]) -> Callable[..., Any]:
    def call(*arguments: Any, **named: Any) -> Any:
        if any(isinstance(it, VIEWS) for it in (*arguments, *named.values())):
            return own(*arguments, **{_NAMES.get(key, key): value for key, value in named.items()})
        if theirs is None:
            raise TypeError(f"mujoco.{name}: expected env.model and env.data; the package mujoco is not installed")
        return theirs(*arguments, **named)

    call.__name__ = name
    return call


_NAMES = {"m": "model", "d": "data"}  # MuJoCo names its arguments either way


def _refusing(name: str, theirs: Callable[..., Any]) -> Callable[..., Any]:
    """A function of the real package, which cannot take our models."""

    def call(*arguments: Any, **named: Any) -> Any:
        if any(isinstance(it, VIEWS) for it in (*arguments, *named.values())):
            raise NotImplementedError(f"mujoco.{name} is not there for models of mimo.classic; {PAGE}")
        return theirs(*arguments, **named)

    call.__name__ = name
    return call


def _missing(name: str) -> Callable[..., Any]:
    """A function that is not there: scripts may import it, but not call it."""

    def call(*arguments: Any, **named: Any) -> Any:
        raise NotImplementedError(f"mujoco.{name} is not there without the package mujoco; {PAGE}")

    call.__name__ = name
    return call
