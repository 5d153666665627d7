"""Cameras of MuJoCo's models, fixed, free and tracking ones, as views of a stage."""

from __future__ import annotations

import math
import operator
from typing import Any, List

import numpy as np

from . import _abi
from ._library import defaults
from .arguments import described
from .stage import pointer


class Sight:
    """A view from a camera of a model. MuJoCo itself says where its cameras are and what they see."""

    def __init__(self, mujoco: Any, model: Any, height: int, width: int, samples: int) -> None:
        self._mujoco, self._model = mujoco, model
        self._scene = mujoco.MjvScene(model, 1)
        self._eyes = self._scene.camera[0], self._scene.camera[1]
        self._own = mujoco.MjvCamera()
        self.camera: Any = self._own  # the mujoco.MjvCamera that it looks through
        self._position, self._rotation = np.zeros(3), np.zeros(9)
        self.struct = defaults(_abi.StageView)
        self.struct.height, self.struct.width, self.struct.samples = height, width, samples
        self.struct.position, self.struct.rotation = pointer(self._position), pointer(self._rotation)
        self.struct.surface_groups = 1  # hidden ones are in group 1

    def resize(self, height: int, width: int) -> None:
        """Takes pictures of another size."""
        self.struct.height, self.struct.width = height, width
        self._open(*self._eyes)

    def look(self, data: Any, camera: Any) -> None:
        """Takes the view of an id, a name, -1 (the free camera) or a mujoco.MjvCamera."""
        mujoco = self._mujoco
        if not isinstance(data, mujoco.MjData):
            raise TypeError(f"data is {described(data)}, expected a mujoco.MjData")
        self.camera = camera if isinstance(camera, mujoco.MjvCamera) else self._by_id(self._number(camera))
        if int(self.camera.type) == int(mujoco.mjtCamera.mjCAMERA_USER):
            raise ValueError("camera is one of type mjCAMERA_USER, expected a free, tracking or fixed one")
        mujoco.mjv_updateCamera(self._model, data, self.camera, self._scene)
        left, right = self._eyes
        self._place([(a + b) / 2 for a, b in zip(left.pos.tolist(), right.pos.tolist())], left)
        self._open(left, right)

    def _number(self, camera: Any) -> int:
        count = self._model.ncam
        if isinstance(camera, str):
            number = int(self._mujoco.mj_name2id(self._model, int(self._mujoco.mjtObj.mjOBJ_CAMERA), camera))
            if number < 0:
                names = ", ".join(repr(self._model.camera(i).name) for i in range(count)) or "none"
                raise ValueError(f'The camera "{camera}" does not exist. There are: {names}')
            return number
        try:
            number = operator.index(camera)
        except TypeError:
            raise TypeError(f"camera is {described(camera)}, expected a number, a name or a mujoco.MjvCamera") from None
        if not -1 <= number < count:
            raise ValueError(f"The camera id {number} is out of range [-1, {count}).")
        return number

    def _by_id(self, number: int) -> Any:
        camera, kinds = self._own, self._mujoco.mjtCamera
        camera.fixedcamid = number
        if number >= 0:
            camera.type = int(kinds.mjCAMERA_FIXED)
        else:
            camera.type = int(kinds.mjCAMERA_FREE)
            self._mujoco.mjv_defaultFreeCamera(self._model, camera)
        return camera

    def _place(self, position: List[float], eye: Any) -> None:
        (fx, fy, fz), (ux, uy, uz) = eye.forward.tolist(), eye.up.tolist()
        rx, ry, rz = fy * uz - fz * uy, fz * ux - fx * uz, fx * uy - fy * ux
        self._position[:] = position
        self._rotation[:] = rx, ux, -fx, ry, uy, -fy, rz, uz, -fz

    def _open(self, left: Any, right: Any) -> None:
        """The frustum: symmetric ones by their angle or height, others by focal lengths and the principal point."""
        view, near, top, bottom = self.struct, left.frustum_near, left.frustum_top, left.frustum_bottom
        view.ortho_height = top - bottom if getattr(left, "orthographic", 0) else 0
        if view.ortho_height:
            view.focal_x = view.focal_y = 0
            return
        middle = (left.frustum_center + right.frustum_center) / 2
        half_width = getattr(left, "frustum_width", 0) or (top - bottom) / 2 * view.width / view.height
        if top == -bottom and not middle and not getattr(left, "frustum_width", 0):
            view.fovy = math.degrees(2 * math.atan(top / near))
            view.focal_x = view.focal_y = 0
            return
        view.focal_x, view.focal_y = view.width * near / (2 * half_width), view.height * near / (top - bottom)
        view.center_x = view.width * (half_width - middle) / (2 * half_width)
        view.center_y = view.height * top / (top - bottom)
