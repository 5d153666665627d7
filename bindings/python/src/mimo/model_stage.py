"""A stage that shows a MuJoCo model and follows what programs change in it."""

from __future__ import annotations

import ctypes
from typing import Any, List, Mapping, Sequence

import numpy as np

from . import _abi
from .decorations import Decorations, Tell
from .model_arrays import ModelArrays
from .stage import Arrays, Part, Stage, air_of, hold

LIVE = ("geoms", "sites", "materials", "tendons", "lights")  # what programs change while they run
PREPARED = ("meshes", "fields", "textures", "surfaces")  # what takes time to change
FOLLOWED = ("TEXTURE", "TRANSPARENT", "STATIC", "SKIN")  # MjvOption's flags that concern the arrays


class ModelStage:
    """The stage of a model, its arrays, and what MuJoCo adds to its pictures."""

    def __init__(self, mujoco: Any, model: Any, threads: int, tell: Tell) -> None:
        self._model = model
        self.arrays = ModelArrays(mujoco, model)
        parts = self.arrays.parts()
        self._stage = Stage(threads=threads, **parts)
        self._live = {name: Part(name, parts[name]) for name in LIVE if name in parts}
        self._surfaces = Part("surfaces", parts["surfaces"]) if "surfaces" in parts else None
        self._hidden: Any = None
        self._heights = model.hfield_data.copy()
        self.decorations = Decorations(mujoco, model, tell)

    def follow(self, option: Any) -> None:
        """Brings the stage up to date with the model and with a mujoco.MjvOption."""
        texture, transparent, static, skin = (self.decorations.flag(option, name) for name in FOLLOWED)
        self.arrays.refresh(texture, transparent, static)
        config = _abi.StageConfig()
        changed: List[Any] = [air_of(self.arrays.air())]
        hold(config, "air", changed[0])
        for name, part in self._live.items():
            hold(config, name, part.struct)
        if self._surfaces is not None:
            self._show_surfaces(config, option, skin)
        if self._heights.size and not np.array_equal(self._heights, self._model.hfield_data):
            self._heights[:] = self._model.hfield_data
            changed.append(Part("fields", self.arrays.fields()))
            hold(config, "fields", changed[-1].struct)
        self._stage.put(config)

    def _show_surfaces(self, config: _abi.StageConfig, option: Any, skin: bool) -> None:
        """Puts surfaces that the option hides into group 1: flexes and skins have groups of their own in MuJoCo."""
        model, flexes = self._model, self.arrays.flexes
        groups = np.clip(model.skin_group, 0, 5)
        shown = [option.skingroup[groups].astype(bool) & skin]
        if flexes:
            shown.insert(0, option.flexgroup[np.clip(model.flex_group, 0, 5)].astype(bool))
        hidden = (~np.concatenate(shown)).astype(np.int32)
        usual = np.zeros(len(hidden), np.int32) if self._hidden is None else self._hidden
        if not np.array_equal(hidden, usual):
            self._surfaces = Part("surfaces", {**self.arrays.surfaces(), "groups": hidden})
            hold(config, "surfaces", self._surfaces.struct)
            self._hidden = hidden

    def reload(self) -> None:
        """Takes over what is prepared, anew."""
        parts: Mapping[str, Arrays] = self.arrays.parts()
        self._hidden = None
        self._stage.update(**{name: parts[name] for name in PREPARED if name in parts})

    def draw(self, poses: Sequence[ctypes.Structure], views: Sequence[ctypes.Structure]) -> None:
        """Draws the views, at once."""
        self._stage.show(poses, views)

    def close(self) -> None:
        """Frees the library's objects."""
        self._stage.close()
