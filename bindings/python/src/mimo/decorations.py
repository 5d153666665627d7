"""What MuJoCo adds to a picture by itself, and geoms that users add to a scene, as extra shapes of a stage's poses."""

from __future__ import annotations

from typing import Any, Callable, Dict, Iterable, List, Optional

import numpy as np

from . import _abi
from .stage import fill
from .stage_columns import POSES

DRAWN = ("PLANE", "SPHERE", "CAPSULE", "ELLIPSOID", "CYLINDER", "BOX")  # mjGEOM_
LONG = ("CAPSULE", "CYLINDER")  # whose second size MuJoCo's scenes give as the third
DECORATING = (  # MjvOption's flags that add geoms
    *("JOINT", "CAMERA", "ACTUATOR", "LIGHT", "CONSTRAINT", "INERTIA", "CONTACTPOINT", "CONTACTFORCE", "ISLAND"),
    *("AUTOCONNECT", "COM", "BODYBVH", "MESHBVH", "FLEXBVH", "SDFITER", "MIDPHASE"),
)
UNSUPPORTED = {  # flags that a picture does not follow, and the value that it shows
    "CONVEXHULL": (0, "convex hulls of meshes"),
    "FLEXVERT": (0, "vertices of flexes"),
    "FLEXFACE": (0, "faces of flexes apart from their skin"),
    "FLEXSKIN": (1, "flexes without their skin"),
}
Tell = Callable[[str], None]
Row = Dict[str, Any]


class Extras:
    """Shapes of one picture alone, from geoms of an MjvScene that are not the model's."""

    def __init__(self, mujoco: Any, poses: _abi.StagePoses, tell: Tell) -> None:
        self._names = {int(getattr(mujoco.mjtGeom, name)): name[7:] for name in _members(mujoco.mjtGeom, "mjGEOM_")}
        self._poses, self._tell = poses, tell
        self._rows: List[Row] = []
        self._kept: Any = ()

    def show(self, geoms: Iterable[Any]) -> None:
        """Puts these into the poses, and no others."""
        self._rows = self._rows_of(geoms)
        self._put(self._rows)

    def add(self, geoms: Iterable[Any]) -> None:
        """Puts these beside those that are shown."""
        self._put([*self._rows, *self._rows_of(geoms)])

    def _put(self, rows: List[Row]) -> None:
        self._poses.extra_count = len(rows)
        if rows:
            columns = {name: np.array([row[name] for row in rows]) for name in rows[0]}
            self._kept = fill(self._poses, "poses", POSES, columns)

    def _rows_of(self, geoms: Iterable[Any]) -> List[Row]:
        return [row for row in map(self._row, geoms) if row is not None]

    def _row(self, geom: Any) -> Optional[Row]:
        name = self._names.get(int(geom.type), str(int(geom.type)))
        if name not in DRAWN:
            if name != "NONE":
                self._tell(f"shapes of type {name.lower()} that MuJoCo or a program adds to a scene")
            return None
        size = geom.size.tolist()
        return {
            "extra_forms": int(geom.type),
            "extra_sizes": [size[0], size[2], 0] if name in LONG else size,
            "extra_positions": geom.pos.tolist(),
            "extra_rotations": np.asarray(geom.mat, float).ravel(),
            "extra_colors": geom.rgba.tolist(),
            "extra_objects": (int(geom.objid), int(geom.objtype)),
        }


class Decorations:
    """Decides whether MuJoCo has to list what it adds to a picture, and lists it."""

    def __init__(self, mujoco: Any, model: Any, tell: Tell) -> None:
        self._mujoco, self._model, self._tell = mujoco, model, tell
        self._flags = {
            name[6:]: int(getattr(mujoco.mjtVisFlag, name)) for name in _members(mujoco.mjtVisFlag, "mjVIS_")
        }
        self._cranks = bool((model.actuator_trntype == int(mujoco.mjtTrn.mjTRN_SLIDERCRANK)).any())
        self.hanging = _may_hang(mujoco, model)
        self._scene: Any = None
        self._ranging = bool((model.sensor_type == int(mujoco.mjtSensor.mjSENS_RANGEFINDER)).any())

    def flag(self, option: Any, name: str) -> bool:
        """One of MjvOption's flags; those that this MuJoCo does not know are off."""
        return name in self._flags and bool(option.flags[self._flags[name]])

    def wanted(self, option: Any) -> bool:
        """Whether there is anything to list; tells what no picture shows."""
        for name, (usual, what) in UNSUPPORTED.items():
            if name in self._flags and self.flag(option, name) != usual and (self._model_has(name)):
                self._tell(what)
        if self._ranging and self.flag(option, "RANGEFINDER"):
            self._tell("beams of range finders")
        if int(option.label):
            self._tell("labels")
        return (
            self._cranks or self.hanging or bool(int(option.frame)) or any(self.flag(option, one) for one in DECORATING)
        )

    def _model_has(self, flag: str) -> bool:
        return bool(getattr(self._model, "nflex", 0)) if flag.startswith("FLEX") else bool(self._model.nmesh)

    def list(self, data: Any, option: Any, camera: Any) -> List[Any]:
        """The geoms of MuJoCo's scene that it adds; with tendons where these may hang."""
        mujoco, model = self._mujoco, self._model
        if self._scene is None:
            self._scene = mujoco.MjvScene(model, 2000 + 80 * model.ntendon + 8 * (model.nbody + model.njnt + model.nu))
        bare = _without_groups(mujoco, option, keep_tendons=self.hanging)
        bare.flags[self._flags["RANGEFINDER"]] = 0
        mujoco.mjv_updateScene(model, data, bare, None, camera, int(mujoco.mjtCatBit.mjCAT_ALL), self._scene)
        return list(self._scene.geoms[: self._scene.ngeom])


def _members(kind: Any, prefix: str) -> List[str]:
    return [name for name in dir(kind) if name.startswith(prefix)]


def _without_groups(mujoco: Any, option: Any, keep_tendons: bool) -> Any:
    bare = mujoco.MjvOption()
    for name in ("jointgroup", "actuatorgroup", "flags", *(("tendongroup",) if keep_tendons else ())):
        getattr(bare, name)[:] = getattr(option, name)
    emptied = ("geomgroup", "sitegroup", "skingroup", "flexgroup", *(() if keep_tendons else ("tendongroup",)))
    for name in emptied:
        if hasattr(bare, name):
            getattr(bare, name)[:] = 0
    bare.frame, bare.label = option.frame, 0
    return bare


def _may_hang(mujoco: Any, model: Any) -> bool:
    """Whether MuJoCo might draw a tendon as a hanging curve: a slack one between two sites."""
    if not model.ntendon:
        return False
    limited = model.tendon_limited.astype(bool) & (model.tendon_range[:, 1] > 0)
    springs = np.asarray(model.tendon_lengthspring).reshape(model.ntendon, -1)
    slack = limited | (springs[:, 0] != springs[:, -1])
    spatial = model.wrap_type[model.tendon_adr] == int(mujoco.mjtWrap.mjWRAP_SITE)
    return bool((slack & spatial & (model.tendon_num == 2) & (model.tendon_group <= 2)).any())
