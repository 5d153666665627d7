"""The world's shapes on the page: a node for each body, its geoms below it."""

from __future__ import annotations

from dataclasses import replace
from typing import Any, Callable, Dict, List, Optional

import numpy as np

from ..constants import Kind
from ..cubes import picture, places
from ..drawing import FLOOR, SEGMENTS, ages, faces, on_bodies
from ..frames import placed, turned
from ..geometry import Appearance
from ..world import World
from .camera import ROOT
from .glb import binary

STILL = 1e-5  # m, and of quaternions: smaller movements are not sent

Dragged = Callable[[str, Any], None]  # the body's name, viser's event


class Shapes:
    """Draws all geoms that MuJoCo would draw, and updates their poses and looks."""

    def __init__(self, server: Any, world: World, dragged: Optional[Dragged] = None) -> None:
        self._scene, self._world, self._dragged = server.scene, world, dragged
        self._geoms = world.geoms()
        self._body_of = self._geoms.body_ids
        self._names = world.bodies().names
        self._pictures: Dict[int, Any] = {}
        self._shown: List[Any] = [None] * len(self._geoms)  # handles
        self._bodies: Dict[int, Any] = {}
        self._visible = True
        self._brightness = brightness(world)
        self._begin()

    def _begin(self) -> None:
        poses = self._world.poses(Kind.BODY)
        self._sent = np.hstack([poses.positions, poses.rotations])
        for body in sorted(set(self._body_of.tolist())):
            pose = self._sent[body]
            name = f"{ROOT}/bodies/{body}"
            self._bodies[body] = self._scene.add_frame(name, show_axes=False, position=pose[:3], wxyz=pose[3:])
        self._ages, self._faces, self._looks = ages(self._world), faces(self._world), self._own_looks()
        self._textures = self._texture_numbers()
        self._draw(range(len(self._geoms)))

    def _own_looks(self) -> Any:
        return np.hstack([self._geoms.color, self._geoms.size])

    def _texture_numbers(self) -> Any:
        return np.array([self._world.appearance(geom).texture for geom in range(len(self._geoms))])

    def _changed(self) -> Any:
        """Geoms whose look has changed since the last call."""
        aged, faced, looks, textures = ages(self._world), faces(self._world), self._own_looks(), self._textures
        if not np.array_equal(faced, self._faces):
            textures = self._texture_numbers()
        changed = (looks != self._looks).any(axis=1) | (textures != self._textures)
        if not np.array_equal(aged, self._ages):
            changed[:] = True
        self._ages, self._faces, self._looks, self._textures = aged, faced, looks, textures
        return np.flatnonzero(changed)

    def _draw(self, geoms: Any) -> None:
        _, places, rotations = on_bodies(self._world)
        for geom in geoms:
            if self._shown[geom] is not None:
                self._shown[geom].remove()
                self._shown[geom] = None
            material = self._world.appearance(int(geom))
            if material.visible:
                self._shown[geom] = self._add(int(geom), material, places[geom], rotations[geom])

    def _add(self, geom: int, material: Appearance, place: Any, rotation: Any) -> Any:
        mesh = self._world.mesh(geom, segments=SEGMENTS, plane=FLOOR)
        if material.texture >= 0:
            mesh = replace(mesh, texcoords=places(self._world.texture(material.texture), mesh.texcoords))
        data = binary(
            mesh,
            lit(material, self._brightness),
            self._picture(material.texture),
            placed(place, rotation, mesh.positions),
            turned(rotation, mesh.normals),
        )
        body = int(self._body_of[geom])
        handle = self._scene.add_glb(
            f"{ROOT}/bodies/{body}/{geom}",
            data,
            visible=self._visible or body == 0,
            cast_shadow=body != 0,  # no shadows on itself: the page's shadows are too coarse
            receive_shadow=body == 0,
        )
        if self._dragged is not None and body != 0:
            name, dragged = self._names[body], self._dragged
            handle.on_drag("left", modifier="cmd/ctrl")(lambda event: dragged(name, event))
        return handle

    def _picture(self, texture: int) -> Any:
        if texture < 0:
            return None
        if texture not in self._pictures:
            from PIL import Image

            self._pictures[texture] = Image.fromarray(picture(self._world.texture(texture)))
        return self._pictures[texture]

    @property
    def visible(self) -> bool:
        """Whether movable bodies are visible."""
        return self._visible

    @visible.setter
    def visible(self, visible: bool) -> None:
        self._visible = visible
        for geom, handle in enumerate(self._shown):
            if handle is not None and self._body_of[geom] != 0:
                handle.visible = visible

    def update(self) -> None:
        """Updates changed poses and looks."""
        changed = self._changed()
        if len(changed) > 0:
            self._draw(changed)
        poses = self._world.poses(Kind.BODY)
        now = np.hstack([poses.positions, poses.rotations])
        for body in np.flatnonzero((np.abs(now - self._sent) > STILL).any(axis=1)):
            node = self._bodies.get(int(body))
            if node is not None:
                node.position, node.wxyz = now[body, :3], now[body, 3:]
            self._sent[body] = now[body]


def brightness(world: World) -> float:
    """The light on a surface that faces all lamps, for which MuJoCo's colours are made."""
    lights = [light for light in [world.light(), *world.light_sources()] if light.active]
    return float(max(np.sum([light.ambient + light.diffuse for light in lights], axis=0), default=1.0))


def lit(material: Appearance, strength: float) -> Appearance:
    """The material's colour with its emission and the world's light; the page's lamps make white things white.

    A colour that would be brighter than white keeps its hue.
    """
    bright = (strength + material.emission) * np.asarray(material.color[:3])
    red, green, blue = (bright / max(1.0, float(bright.max()))).tolist()
    return replace(material, color=(red, green, blue, material.color[3]))
