"""Skins of MuJoCo's models, moved by the bones of their bodies."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from .frames import after, inverse, turned

AXES = np.eye(3)


class Skinning:
    """Moves the vertices of a model's skins: each is the weighted mean of where its bones would carry it."""

    def __init__(self, model: Any) -> None:
        self.count = len(model.skin_vert)
        if not self.count:
            return
        owners = np.concatenate([np.full(bones, skin) for skin, bones in enumerate(model.skin_bonenum)]).astype(int)
        entries = np.repeat(np.arange(len(owners)), model.skin_bonevertnum)
        vertices = model.skin_bonevertid + model.skin_vertadr[owners[entries]]
        weights = model.skin_bonevertweight.astype(float)[:, None]
        weighted = np.hstack([model.skin_vert[vertices] * weights, weights])
        ends = np.cumsum(model.skin_bonevertnum)[:-1]
        self._vertices, self._weighted = np.split(vertices, ends), np.split(weighted, ends)  # of each bone
        self._bodies = model.skin_bonebodyid
        self._bind_places = model.skin_bonebindpos.astype(float)
        self._unbind = inverse(model.skin_bonebindquat.astype(float))

    def move(self, data: Any, to: NDArray[np.float64]) -> None:
        """Writes the vertices into `to`, in the world's frame."""
        turns = after(data.xquat[self._bodies], self._unbind)
        places = data.xpos[self._bodies] - turned(turns, self._bind_places)
        rows = [turned(turns, np.broadcast_to(axis, (len(turns), 3))) for axis in AXES]
        carriers = np.stack([*rows, places], axis=1)  # of each bone 4 x 3: where the axes and the origin go
        to.fill(0)
        for vertices, weighted, carrier in zip(self._vertices, self._weighted, carriers):
            to[vertices] += weighted @ carrier
