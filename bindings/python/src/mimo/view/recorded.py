"""A recording as the viewer's source."""

from __future__ import annotations

from typing import Any, Optional, Sequence

import numpy as np
from numpy.typing import NDArray

from ..drawing import EYES
from ..recordings import Recording
from .source import Source


class Recorded(Source):
    """A recording that the viewer plays. Own senses that it needs are paths of shared libraries, whose code runs."""

    def __init__(
        self, path: Any, eyes: int = EYES, scene: Optional[str] = None, own_senses: Sequence[str] = ()
    ) -> None:
        self._recording = Recording(path)
        try:
            for sense in own_senses:
                self._recording.load_sense(sense)
            self.world = self._recording.world(eyes, scene)
        except BaseException:
            self._recording.close()
            raise
        self.scene, self.length, self.at = self._recording.path, self._recording.steps, 0
        try:
            self.seek(0)
        except BaseException:
            self.close()
            raise

    def advance(self, action: Optional[NDArray[np.float32]], senses: bool) -> bool:
        """Plays the next step; after the last one the first."""
        if self.at == self.length:
            self.seek(0)
        self._recording.step(self.world, senses)
        self.at += 1
        return False

    def restart(self, seed: Optional[int], ages: Any = None) -> None:
        """Goes back to the start."""
        self.seek(0)

    def seek(self, step: int) -> None:
        """Goes to the moment after `step` steps."""
        self._recording.move_to(self.world, step)
        self.at = step

    def close(self) -> None:
        """Closes the world and the file."""
        self.world.close()
        self._recording.close()
