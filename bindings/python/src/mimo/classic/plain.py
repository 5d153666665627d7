"""Worlds without the pictures of their document, which nothing sees until a script draws and which are slow to read."""

from __future__ import annotations

from typing import Any, Dict, Optional, Tuple

from .. import _abi
from .._library import LIB, check
from ..constants import Kind, Quantity
from ..geometry import Appearance, Texture
from ..scene import Scene
from ..world import World
from .catalog import Catalog
from .live import Stage

# What a drawing shows besides the places of bodies.
_SHOWN = (
    (Kind.GEOM, Quantity.GEOM_COLOR),
    (Kind.GEOM, Quantity.GEOM_SIZE),
    (Kind.LIGHT, Quantity.LIGHT_POSITION),
    (Kind.LIGHT, Quantity.LIGHT_DIRECTION),
    (Kind.LIGHT, Quantity.LIGHT_COLOR),
)


class PlainWorld(World):
    """A world of a scene without its pictures. Drawings are those of a world with pictures, made for the first one."""

    def __init__(self, scene: Scene, file: str, **options: Any) -> None:
        super().__init__(scene, **options)
        self._file = file
        self._with_pictures: Optional[World] = None

    def _painted(self) -> World:
        """The world with pictures, in the state of this one."""
        if self._with_pictures is None:
            scene = Scene(file=self._file)
            for method, arguments, options in self._scene._steps:
                scene.make_call(method, arguments, options)
            self._with_pictures = World(scene, **self._options)
        ours, theirs = Catalog(Stage(self)), Catalog(Stage(self._with_pictures))
        for kind, quantity in _SHOWN:
            theirs.write(kind, quantity, ours.read(kind, quantity), theirs.read(kind, quantity))
        for body in ours.still_bodies().nonzero()[0]:
            which = [int(body)]
            self._with_pictures.set(Quantity.BODY_POSE, self.get(Quantity.BODY_POSE, which, now=True), which)
        self._with_pictures.set(Quantity.JOINT_POSITION, self.get(Quantity.JOINT_POSITION))
        return self._with_pictures

    def _draw(self, config: _abi.PictureConfig, **places: int) -> None:
        check(LIB.mimo_env_render(self._painted()._handle, config, _abi.Picture(**places)))

    def appearance(self, geom: Any) -> Appearance:
        """The current look of a geom."""
        return self._painted().appearance(geom)

    @property
    def texture_count(self) -> int:
        """The number of textures; ids are 0 to texture_count - 1."""
        return self._painted().texture_count

    def texture(self, texture: int) -> Texture:
        """A texture as pixels."""
        return self._painted().texture(texture)

    def close(self) -> None:
        """Closes the world."""
        if self._with_pictures is not None:
            self._with_pictures.close()
        super().close()

    def clone(self) -> "PlainWorld":
        """A copy with the same scene, options and state."""
        made = super().clone()
        made.__class__ = PlainWorld
        made.__dict__.update(_file=self._file, _with_pictures=None)
        return made  # type: ignore[return-value]

    def __reduce__(self) -> Tuple[Any, ...]:
        return _rebuilt, (self._scene, self._file, self._options, self.save())


def _rebuilt(scene: Scene, file: str, options: Dict[str, Any], state: bytes) -> PlainWorld:
    world = PlainWorld(scene, file, **options)
    world.load(state)
    return world
