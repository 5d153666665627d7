"""Senses on a simulation that runs somewhere else: in the mujoco package, or in any other host of MuJoCo."""

from __future__ import annotations

import ctypes
import importlib
from typing import Any, Dict, Optional

from typing_extensions import Unpack

from ._handle import Handle
from ._library import LIB, check
from .arguments import number_of
from .layout import Field, Layout, Observation, Supply
from .options import PhysicsOptions
from .scene import Scene
from .world import env_config


class Senses(Handle):
    """Senses that look at a MuJoCo model which knows nothing of them, and never change it.

        scene = mimo.Scene()
        scene.add_agent(body="scene", root="torso", vestibular_at="head", vision=False)
        scene.set_touch(None, 0.03)
        senses = mimo.Senses(scene, model)  # a mujoco.MjModel
        mujoco.mj_step(model, data)
        senses.observe(data)["touch/force"]

    The scene describes the agents and cameras. The model is a mujoco.MjModel of exactly the MuJoCo version that this
    library runs on (mimo.mujoco_version()), or the address of an mjModel together with the host's mj_version(). It has
    to outlive the senses; they keep a reference.
    """

    def __init__(
        self,
        scene: Scene,
        model: Any,
        *,
        mujoco_version: Optional[int] = None,
        **options: Unpack[PhysicsOptions],
    ) -> None:
        version = _version_of(model) if mujoco_version is None else number_of("mujoco_version", mujoco_version, 31)
        handle = ctypes.c_void_p()
        config = env_config(dict(options), PhysicsOptions)
        check(LIB.mimo_senses_attach(scene._handle, config, _address_of(model), version, 0, 0, handle))
        self._own(handle.value, LIB.mimo_senses_destroy)
        self._handle.keeps = model
        self._layout = Layout(self._handle, "senses")
        self._supply = Supply(self._layout)

    @property
    def fields(self) -> Dict[str, Field]:
        """What an observation holds, by name."""
        return dict(self._layout.fields)

    def observe(self, data: Any) -> Observation:
        """What is sensed of data (a mujoco.MjData, or the address of an mjData) as they are."""
        address, observation = self._supply.take()
        check(LIB.mimo_senses_observe(self._handle, _address_of(data), address, self._layout.bytes))
        return observation


def _address_of(struct: Any) -> int:
    address = getattr(struct, "_address", struct)
    if not isinstance(address, int):
        raise TypeError(f"{struct!r} is neither of the mujoco package nor an address")
    return number_of("address", address, 64)


def _version_of(model: Any) -> int:
    package = type(model).__module__.split(".")[0]
    if isinstance(model, int):
        raise TypeError("mujoco_version is needed with an address: what mj_version() of the host says")
    return int(importlib.import_module(package).mj_version())
