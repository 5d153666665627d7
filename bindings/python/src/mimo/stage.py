"""Stages: shapes, lights and textures from plain arrays, moved by poses and drawn with rays, without a simulation."""

from __future__ import annotations

import ctypes
from typing import Any, Dict, List, Mapping, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _abi
from ._handle import Handle
from ._library import LIB, check, defaults, log_to_python
from .arguments import described, number_of, real_number, unexpected, vector, whole_number
from .constants import Render
from .stage_columns import PARTS, POSES, Column

Arrays = Mapping[str, Any]
LARGEST = 16384  # width and height of pictures, pixels


SINGLE = {"object_type": -1, "from_corner": 0}  # numbers of parts that are no arrays, and what they are if not given
AIR = tuple(field[0] for field in _abi.StageAir._fields_ if field[0] not in ("struct_size", "reserved"))


def pointer(array: NDArray[Any]) -> int:
    """The address of an array's first number."""
    return int(array.__array_interface__["data"][0])


def fitting(name: str, value: Any, column: Column) -> NDArray[Any]:
    """The numbers as they lie where they already have the type, else a copy: elements x width."""
    given = np.asarray(value)
    if given.dtype.kind not in "biuf":
        raise TypeError(f"{name}: expected numbers, not {described(value)}")
    if given.dtype == bool:
        given = given.view(np.uint8)
    if column.kind in (np.int32, np.uint8) and given.dtype.kind == "f" and given.size:
        raise TypeError(f"{name}: expected whole numbers, not {given.dtype}")
    if column.kind in (np.int32, np.uint8) and given.dtype != column.kind and given.size:
        least, most = int(given.min()), int(given.max())
        limits = np.iinfo(column.kind)
        if least < limits.min or most > limits.max:
            worst = most if most > limits.max else least
            raise ValueError(f"{name} has {worst}, expected {limits.min} to {limits.max}")
    given = np.ascontiguousarray(given, column.kind)
    if given.size % column.width or (given.ndim > 1 and given.size and given[0].size % column.width):
        raise ValueError(f"{name} of the shape {given.shape}, expected n x {column.width}")
    return given


def fill(struct: ctypes.Structure, part: str, columns: Mapping[str, Column], arrays: Arrays) -> List[NDArray[Any]]:
    """Writes arrays' addresses and counts into a struct; returns the arrays, which must live as long as it is used."""
    counts: Dict[str, Tuple[str, int]] = {}
    kept: List[NDArray[Any]] = []
    for name, value in arrays.items():
        column = columns.get(name)
        if column is None:
            raise TypeError(f"{part}: {unexpected(name, columns)}")
        if value is None:
            continue
        array = fitting(f"{part}[{name!r}]", value, column)
        count = array.size // column.width
        first, known = counts.setdefault(column.by, (name, count))
        if count != known:
            raise ValueError(f"{part}[{name!r}] has {count} elements, expected {known}, as {part}[{first!r}]")
        setattr(struct, name, pointer(array))
        kept.append(array)
    for member, (_, count) in counts.items():
        setattr(struct, member, count)
    return kept


class Part:
    """A part of a stage as the library takes it, and the arrays that it points to."""

    def __init__(self, name: str, given: Arrays) -> None:
        kind, columns = PARTS[name]
        self.struct = kind()
        arrays = dict(given)
        for single, usual in SINGLE.items():
            if hasattr(kind, single):
                setattr(self.struct, single, whole_number(f"{name}[{single!r}]", arrays.pop(single, usual)))
        self.kept = fill(self.struct, name, columns, arrays)


def air_of(given: Arrays) -> _abi.StageAir:
    """What a stage is in: the library's defaults, with what is given in their place."""
    air = defaults(_abi.StageAir)
    for name, value in given.items():
        if name not in AIR:
            raise TypeError(f"air: {unexpected(name, AIR)}")
        if isinstance(getattr(air, name), ctypes.Array):
            getattr(air, name)[:] = vector(f"air[{name!r}]", value, 3).tolist()
        elif name == "headlight":
            air.headlight = bool(value)
        else:
            setattr(air, name, real_number(f"air[{name!r}]", value))
    return air


class StagePicture(NamedTuple):
    """What a view of a stage gave; parts that were not asked for are None."""

    rgb: Optional[NDArray[np.uint8]]
    depth: Optional[NDArray[np.float32]]
    segmentation: Optional[NDArray[np.int32]]


class StageView:
    """From where a picture of a stage is taken, and what it shows.

    `position` (3) and `rotation` (3 x 3: x right, y up and z backward, as columns in the world) place the camera.
    `rgb`, `depth` and `segmentation` choose the parts of the picture. `focal` and `center` (pixels) take the place of
    `fovy` (degrees) where a camera's axis does not go through the middle. `ortho_height` (m) makes the camera
    orthographic: it sees so much from the lower edge to the upper one.
    """

    def __init__(
        self,
        position: ArrayLike,
        rotation: ArrayLike,
        *,
        width: int = 320,
        height: int = 240,
        fovy: float = 45,
        focal: Optional[ArrayLike] = None,
        center: Optional[ArrayLike] = None,
        rgb: bool = True,
        depth: bool = False,
        segmentation: bool = False,
        samples: int = 1,
        render: Any = None,
        pose: int = 0,
        ortho_height: float = 0,
    ) -> None:
        self.struct = defaults(_abi.StageView)
        self._camera = [vector("position", position, 3), np.ascontiguousarray(rotation, np.float64).reshape(-1)]
        if self._camera[1].size != 9:
            raise ValueError(f"rotation of the shape {np.shape(rotation)}, expected (3, 3)")
        self.struct.position, self.struct.rotation = (pointer(one) for one in self._camera)
        self.struct.width, self.struct.height = pixels("width", width), pixels("height", height)
        self.struct.fovy, self.struct.samples = real_number("fovy", fovy), number_of("samples", samples)
        self.struct.pose = number_of("pose", pose)
        self.struct.ortho_height = real_number("ortho_height", ortho_height)
        if focal is not None:
            self.struct.focal_x, self.struct.focal_y = vector("focal", focal, 2).tolist()
            middle = (width / 2, height / 2) if center is None else center
            self.struct.center_x, self.struct.center_y = vector("center", middle, 2).tolist()
        if render is not None:
            self.struct.render = whole_number("render", render, Render)
        self._wanted = (rgb, depth, segmentation)

    def canvas(self) -> StagePicture:
        """New arrays for the picture, which the struct then points to."""
        size = (self.struct.height, self.struct.width)
        rgb, depth, segmentation = self._wanted
        picture = StagePicture(
            np.empty((*size, 3), np.uint8) if rgb else None,
            np.empty(size, np.float32) if depth else None,
            np.empty((*size, 2), np.int32) if segmentation else None,
        )
        point_to(self.struct, picture.rgb, picture.depth, picture.segmentation)
        return picture


def pixels(name: str, value: Any) -> int:
    """A width or height."""
    number = whole_number(name, value)
    if not 1 <= number <= LARGEST:
        raise ValueError(f"{name} is {value!r}, expected 1 to {LARGEST}")
    return number


def point_to(
    view: _abi.StageView,
    rgb: Optional[NDArray[np.uint8]],
    depth: Optional[NDArray[np.float32]] = None,
    segmentation: Optional[NDArray[np.int32]] = None,
) -> None:
    """Lets a view write into these arrays, and into no others."""
    view.rgb, view.rgb_bytes = (None, 0) if rgb is None else (pointer(rgb), rgb.size)
    view.depth, view.depth_count = (None, 0) if depth is None else (pointer(depth), depth.size)
    if segmentation is None:
        view.segmentation, view.segmentation_count = None, 0
    else:
        view.segmentation, view.segmentation_count = pointer(segmentation), segmentation.size


class Stage(Handle):
    """Shapes, lights and textures from plain arrays, drawn with rays into arrays.

    Parts are mappings from the members of the C structs (mimo/experimental/stage.h) to arrays: `geoms` with forms,
    sizes, colors, materials, ...; `sites`, `meshes`, `fields`, `textures`, `materials`, `surfaces`, `tendons`, `lights`
    and `air`. Counts follow from the arrays. `threads` draw; 1 by default.
    """

    def __init__(self, *, threads: int = 1, **parts: Arrays) -> None:
        config = _abi.StageConfig(threads=number_of("threads", threads), log=log_to_python)
        kept = _put(config, parts)
        handle = ctypes.c_void_p()
        check(LIB.mimo_stage_create(config, handle))
        del kept
        self._own(handle.value, LIB.mimo_stage_destroy)

    def update(self, **parts: Arrays) -> None:
        """Replaces the parts that are given, all at once; the others stay."""
        config = _abi.StageConfig()
        kept = _put(config, parts)
        self.put(config)
        del kept

    def put(self, config: _abi.StageConfig) -> None:
        """The same with structs that the caller keeps."""
        check(LIB.mimo_stage_update(self._handle, config))

    def draw(
        self, poses: Union[Arrays, Sequence[Arrays]], views: Union[StageView, Sequence[StageView]]
    ) -> Union[StagePicture, List[StagePicture]]:
        """Draws one view, or several at once on the stage's threads: of one pose, or each of the pose that it names.

        Poses are mappings from the members of mimo_stage_poses to arrays: geom_positions, geom_rotations, ...
        """
        several = [poses] if isinstance(poses, Mapping) else list(poses)
        shown = [views] if isinstance(views, StageView) else list(views)
        structs = [_abi.StagePoses() for _ in several]
        kept = [fill(struct, "poses", POSES, one) for struct, one in zip(structs, several)]
        pictures = [view.canvas() for view in shown]
        self.show(structs, [view.struct for view in shown])
        del kept
        return pictures[0] if isinstance(views, StageView) else pictures

    def show(self, poses: Sequence[ctypes.Structure], views: Sequence[ctypes.Structure]) -> None:
        """The same with structs that the caller keeps."""
        check(LIB.mimo_stage_draw(self._handle, pointers(poses), len(poses), pointers(views), len(views)))


def pointers(structs: Sequence[ctypes.Structure]) -> Any:
    """An array of pointers to structs of one type."""
    kind: Any = ctypes.POINTER(type(structs[0])) if structs else ctypes.c_void_p
    return (kind * max(len(structs), 1))(*(ctypes.pointer(one) for one in structs))


def _put(config: _abi.StageConfig, parts: Mapping[str, Arrays]) -> List[Any]:
    kept: List[Any] = []
    for name, given in parts.items():
        if name == "air":
            struct: Any = air_of(given)
        elif name in PARTS:
            part = Part(name, given)
            struct = part.struct
            kept.append(part)
        else:
            raise unexpected(name, (*PARTS, "air", "threads"))
        hold(config, name, struct)
    return kept


def hold(config: _abi.StageConfig, name: str, struct: ctypes.Structure) -> None:
    """Lets a config point to the struct of a part, which it then keeps."""
    setattr(config, name, ctypes.pointer(struct))
