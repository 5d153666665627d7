"""Senses attached to a simulation of the mujoco package, or of any other host of MuJoCo."""

from __future__ import annotations

import ctypes
import importlib
import sys
from typing import TYPE_CHECKING, Any, Optional, Sequence

import numpy as np
from numpy.typing import ArrayLike

from . import _abi
from ._handle import Handle
from ._library import LIB, advice_for_host, check, defaults, log_to_python, mujoco_version
from .arguments import known_keywords, number_of
from .errors import UnsupportedError
from .layout import Fields, Layout, Observation, Supply
from .options import SensesOptions, fill
from .scene import Scene
from .sounds import play
from .states import LoadReport, reported, saved
from .world import reset_config

if TYPE_CHECKING:
    from typing_extensions import Unpack


class Senses(Handle):
    """Senses attached to a MuJoCo model, which they never change.

        scene = mimo.Scene()
        scene.add_agent(body="scene", root="torso", vestibular_at="head", vision=False)
        scene.set_touch(None, 0.03)
        senses = mimo.Senses(scene, model)  # a mujoco.MjModel
        mujoco.mj_step(model, data)
        senses.advance(data)
        senses.observe(data)["touch/force"]

    The scene describes the agents and cameras. The model is a mujoco.MjModel of exactly the library's MuJoCo version
    (mimo.mujoco_version(); for MuJoCo 4, pip install mimo[mujoco], and import mujoco before mimo), or the address of an
    mjModel together with the host's mj_version(). It must outlive the senses, which keep a reference.
    """

    layout: Layout

    def __init__(
        self,
        scene: Scene,
        model: Any,
        *,
        mujoco_version: Optional[int] = None,
        **options: Unpack[SensesOptions],
    ) -> None:
        config = defaults(_abi.SensesConfig)
        config.log = log_to_python
        fill(config, options, SensesOptions)
        version = _version_of(model) if mujoco_version is None else number_of("mujoco_version", mujoco_version, 31)
        config.mujoco_version = version
        handle = ctypes.c_void_p()
        try:
            check(LIB.mimo_senses_attach(scene._handle, _address_of(model), config, handle))
        except UnsupportedError as error:
            _advise(error, model)
            raise
        self._own(handle.value, LIB.mimo_senses_destroy)
        self._handle.keeps = model
        self._have(layout=Layout(self._handle, LIB.mimo_senses_layout))
        self._supply = Supply(self.layout)

    @known_keywords
    def reset(self, data: Any, seed: Optional[int] = None) -> None:
        """Starts an episode: memories start from data, noise from the seed."""
        check(LIB.mimo_senses_reset(self._handle, _address_of(data), reset_config(seed)))

    def advance(self, data: Any) -> None:
        """Advances memories by one step; call it once per step, before observe."""
        check(LIB.mimo_senses_advance(self._handle, _address_of(data)))

    def drive_spindles(self, rates: ArrayLike, actuators: Optional[Sequence[int]] = None) -> None:
        """Sets the dynamic and static drive of the spindles of each motor's two muscles, Hz, for this episode.

        Four numbers per motor: of `actuators` (ids in the host's model), or of all with spindles.
        """
        numbers = np.ascontiguousarray(rates, np.float64)
        if numbers.ndim > 1 and numbers.shape[1:] != (4,):
            raise ValueError(f"rates of the shape {numbers.shape}, expected four for each motor")
        ids = None if actuators is None else np.ascontiguousarray(actuators, np.int32)
        where, count = (None, 0) if ids is None else (ids.ctypes.data, ids.size)
        check(LIB.mimo_senses_drive_spindles(self._handle, where, count, numbers.ctypes.data, numbers.size))

    def play(self, body: str, samples: ArrayLike, rate: Optional[float] = None) -> None:
        """Lets a body play samples (Pa at 1 m) from the next advance on, as World.play does."""
        play(LIB.mimo_senses_play, self._handle, self.layout, body, samples, rate)

    def observe(self, data: Any) -> Observation:
        """Observes data: a mujoco.MjData, or the address of an mjData. Memories do not change."""
        address, observation = self._supply.take()
        check(LIB.mimo_senses_observe(self._handle, _address_of(data), address, self.layout.bytes))
        return Fields(observation)

    def save(self) -> bytes:
        """The senses' memories, as bytes."""
        return saved(self._handle, LIB.mimo_senses_state_size, LIB.mimo_senses_state_save)

    def load(self, state: bytes) -> LoadReport:
        """Loads the memories of senses of such a model; those that the state lacks start fresh."""
        return reported(LIB.mimo_senses_state_load, self._handle, state, len(state))


def _address_of(struct: Any) -> int:
    address = getattr(struct, "_address", struct)
    if not isinstance(address, int):
        raise TypeError(f"{struct!r} is neither an object of the mujoco package nor an address")
    return number_of("address", address, 64)


def _advise(error: UnsupportedError, model: Any) -> None:
    host = getattr(sys.modules.get(type(model).__module__.split(".")[0]), "__version__", mujoco_version())
    if host != mujoco_version():
        error.args = (f"{error}: {advice_for_host(host)}",)


def _version_of(model: Any) -> int:
    package = type(model).__module__.split(".")[0]
    if isinstance(model, int):
        raise TypeError("an address needs mujoco_version, the host's mj_version()")
    return int(importlib.import_module(package).mj_version())
