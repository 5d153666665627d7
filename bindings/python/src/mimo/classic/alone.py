"""`mujoco.MjModel` and `mujoco.MjData` for scripts without the package: worlds of a document, without senses."""

from __future__ import annotations

import os
from typing import Any

from ..scene import Scene
from ..world import World
from .live import PAGE
from .model import DataView, ModelView
from .scenes import opened


class MjModel:
    """Makes models, as MuJoCo's class of this name does."""

    def __init__(self, *arguments: Any) -> None:
        raise TypeError(f"mujoco.MjModel: use from_xml_path or from_xml_string; {PAGE}")

    @staticmethod
    def from_xml_path(filename: Any, assets: Any = None) -> ModelView:
        """The model of a document."""
        if assets is not None:
            raise NotImplementedError(f"mujoco.MjModel.from_xml_path: assets are not there; {PAGE}")
        scene, body = opened(os.fspath(filename))
        if body != "scene" and not os.path.exists(filename):
            scene.add_agents(body=body or "mitten", vision=False, touch=False)  # a scene of the original
        return _model(scene)

    @staticmethod
    def from_xml_string(xml: str, assets: Any = None) -> ModelView:
        """The model of a document's text."""
        if assets is not None:
            raise NotImplementedError(f"mujoco.MjModel.from_xml_string: assets are not there; {PAGE}")
        return _model(Scene(xml=xml))


def _model(scene: Scene) -> ModelView:
    model = ModelView(World(scene))
    data = DataView(model._it)
    model._stage.start = (data.qpos.copy(), data.qvel.copy())
    return model


def MjData(model: Any) -> DataView:
    """The state of a model: each model has one here."""
    if not isinstance(model, ModelView):
        raise TypeError(f"mujoco.MjData: model is {model!r}, expected one of MjModel")
    return DataView(model._it)
