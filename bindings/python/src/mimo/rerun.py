"""Logs worlds to Rerun: all senses, shapes and poses over time. Needs the extra [rerun].

    import rerun
    rerun.init("infant")
    rerun.save("infant.rrd")            # or rerun.spawn()
    for _ in range(500):
        world.step(actions)
        mimo.rerun.log(world)

Entities below "world" (`path`) are bodies with their shapes, touched sensors as coloured points, and contacts as
arrows; entities below "senses" are the fields of the observation, by their names.
"""

from __future__ import annotations

import weakref
from typing import Any, List, Optional

import numpy as np
from numpy.typing import NDArray

from .constants import Kind
from .cubes import picture, places
from .drawing import FLOOR, SEGMENTS, WEAK, ages, faces, heat, on_bodies, strength
from .frames import placed, turned
from .layout import Field
from .view.marks import contact_arrows
from .view.shapes import brightness, lit
from .world import World

try:
    import rerun as sdk
except ImportError as error:
    raise ImportError("logging to Rerun needs its SDK: pip install 'mimo[rerun]'") from error

TIMELINE = "world_time"  # s since the reset
SENSOR = 0.004  # radius of a point of the skin, m
MANY = 256  # numbers; fields with more are logged as tensors, not as lines

_logged: weakref.WeakKeyDictionary[World, List[Any]] = weakref.WeakKeyDictionary()


def log(world: World, path: str = "world", recording: Optional[Any] = None) -> None:
    """Logs the current state of a world to Rerun's current recording, or to a rerun.RecordingStream.

    The first call logs the shapes; later ones log them again after a change of age or face.
    """
    if not isinstance(world, World):
        raise TypeError(f"world is {type(world).__name__}, expected a mimo.World; of an environment, env.world")
    sdk.set_time(TIMELINE, duration=world.time, recording=recording)
    looks = [path, recording, *ages(world).tolist(), *faces(world).tolist()]
    if _logged.get(world) != looks:
        _shapes(world, path, recording)
        _names(world, path, recording)
        _logged[world] = looks
    _poses(world, path, recording)
    _contacts(world, path, recording)
    for name, field in world.layout.fields.items():
        _field(world, field, world.observation[name], path, recording)


def _shapes(world: World, path: str, recording: Any) -> None:
    (owners, positions, rotations), light = on_bodies(world), brightness(world)
    sdk.log(path, sdk.ViewCoordinates.RIGHT_HAND_Z_UP, static=True, recording=recording)
    for geom, body in enumerate(owners):
        material = lit(world.appearance(geom), light)
        if not material.visible:
            continue
        texture = None if material.texture < 0 else world.texture(material.texture)
        mesh, place = world.mesh(geom, segments=SEGMENTS, plane=FLOOR), f"{_of_body(path, int(body))}/{geom}"
        shape = sdk.Mesh3D(
            vertex_positions=placed(positions[geom], rotations[geom], mesh.positions),
            vertex_normals=turned(rotations[geom], mesh.normals),
            triangle_indices=mesh.triangles,
            vertex_texcoords=None if texture is None else places(texture, mesh.texcoords),
            albedo_texture=None if texture is None else picture(texture),
            albedo_factor=np.rint(np.multiply(material.color, 255)).astype(np.uint8),
        )
        sdk.log(place, shape, recording=recording)


def _names(world: World, path: str, recording: Any) -> None:
    """Names of the lines of fields."""
    for name, field in world.layout.fields.items():
        if field.labels:
            lines = sdk.SeriesLines(names=list(field.labels))
            sdk.log(f"{path}/senses/{name}", lines, static=True, recording=recording)


def _of_body(path: str, body: int) -> str:
    return f"{path}/bodies/{body}"


def _poses(world: World, path: str, recording: Any) -> None:
    poses = world.poses(Kind.BODY)
    for body, (position, (w, x, y, z)) in enumerate(zip(poses.positions, poses.rotations)):
        moved = sdk.Transform3D(translation=position, quaternion=sdk.Quaternion(xyzw=[x, y, z, w]))
        sdk.log(_of_body(path, body), moved, recording=recording)


def _contacts(world: World, path: str, recording: Any) -> None:
    ends = contact_arrows(world)
    shown = sdk.Arrows3D(origins=ends[:, 0], vectors=ends[:, 1] - ends[:, 0], radii=0.002, colors=[40, 170, 60])
    sdk.log(f"{path}/contacts", shown, recording=recording)


def _field(world: World, field: Field, values: NDArray[Any], path: str, recording: Any) -> None:
    place = f"{path}/senses/{field.name}"
    if field.receptors > 0:
        _skin(world, field, values, place, recording)
    elif values.ndim == 3 and values.dtype == np.uint8:
        sdk.log(place, sdk.Image(values), recording=recording)
    elif field.name.rsplit("/", 1)[-1].endswith("_depth"):
        sdk.log(place, sdk.DepthImage(values.reshape(field.shape[:2]), meter=1.0), recording=recording)
    elif field.name.rsplit("/", 1)[-1].endswith("_segmentation"):
        ids = (values.reshape(field.shape[:2]) + 1).astype(np.uint16)  # 0: background
        sdk.log(place, sdk.SegmentationImage(ids), recording=recording)
    elif values.size > MANY or (values.ndim == 2 and field.sample_rate == 0 and not field.labels):
        sdk.log(place, sdk.Tensor(np.ascontiguousarray(values)), recording=recording)
    else:
        sdk.log(place, sdk.Scalars(values.ravel().astype(np.float64)), recording=recording)


def _skin(world: World, field: Field, values: NDArray[Any], place: str, recording: Any) -> None:
    """Touched sensors as points, coloured by force. The tensor beside them has all values."""
    receptors, poses = world.layout.receptors(field.name), world.poses(Kind.BODY)
    felt = np.linalg.norm(values.reshape(len(receptors.bodies), -1), axis=1)
    on = np.flatnonzero(felt > 0)
    bodies = receptors.bodies[on]
    points = placed(poses.positions[bodies], poses.rotations[bodies], receptors.position[on])
    colors = heat(strength(felt[on])) if field.unit == "N" else heat(felt[on] / max(felt.max(), WEAK))
    sdk.log(place, sdk.Points3D(points, colors=colors, radii=SENSOR), recording=recording)
    sdk.log(f"{place}/values", sdk.Tensor(np.ascontiguousarray(values)), recording=recording)
