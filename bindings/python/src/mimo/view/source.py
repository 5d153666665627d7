"""Sources of a viewer's frames: a world that the viewer steps, or one that its owner steps.

Derive other kinds from Source.
"""

from __future__ import annotations

from typing import Any, Dict, Optional, Sequence, Union

import numpy as np
from numpy.typing import NDArray

from ..drawing import EYES
from ..scene import Scene, prepare
from ..world import World


class Source:
    """A world, its next step, and its start."""

    drives = False  # whether the viewer steps it, resets it and chooses its actions
    scenes = False  # whether it can change to another built-in scene
    length: Optional[int] = None  # steps of a recording
    at = 0  # played steps of a recording
    world: World
    scene = ""

    @property
    def step_seconds(self) -> float:
        """How far a step goes."""
        return self.world.timestep * self.world.frame_skip

    def advance(self, action: Optional[NDArray[np.float32]], senses: bool) -> bool:
        """The next moment; without senses only what moves is new. Returns whether an episode ended there."""
        raise NotImplementedError

    def restart(self, seed: Optional[int], ages: Any = None) -> None:
        """The start of an episode."""
        raise NotImplementedError

    def change(self, scene: str, task: str) -> None:
        """Changes to another scene; "" is the scene's task."""
        raise NotImplementedError

    def seek(self, step: int) -> None:
        """Goes to the moment after `step` steps of a recording."""
        raise NotImplementedError

    def close(self) -> None:
        """Closes what it has opened."""


class Followed(Source):
    """A world that its owner steps."""

    def __init__(self, world: World) -> None:
        self.world, self.scene = world, world._scene.source


class Live(Source):
    """A world that the viewer steps. Each infant has the own senses: paths of shared libraries, whose code runs."""

    drives = True

    def __init__(
        self, scene: Union[str, Scene], task: str = "", own_senses: Sequence[str] = (), **options: Any
    ) -> None:
        self._own_senses = own_senses
        self.scenes = isinstance(scene, str)
        self._options = {**self._usual(), **options} if self.scenes else options
        self.scene = scene if isinstance(scene, str) else scene.source
        self.world = self._made(scene, task)

    @staticmethod
    def _usual() -> Dict[str, Any]:
        """Senses to show, also in scenes whose tasks do not need them."""
        return {"vision": True, "vision_width": EYES, "vision_height": EYES, "touch": True, "hearing": True}

    def _made(self, scene: Union[str, Scene], task: str) -> World:
        wanted: Any = {**self._options, **({"task": task} if task else {})}
        made, options = prepare(scene, wanted)
        for path in self._own_senses:
            for agent in range(made._agents):
                made.load_sense(path, agent)
        return World(made, **options)

    def advance(self, action: Optional[NDArray[np.float32]], senses: bool) -> bool:
        """A step of the world."""
        self.world.step_into(self.world.block if senses else None, action)
        return bool(np.any(self.world.terminated) or np.any(self.world.truncated))

    def restart(self, seed: Optional[int], ages: Any = None) -> None:
        """A reset of the world."""
        self.world.reset(seed, ages)

    @classmethod
    def asked(
        cls, scene: Optional[str], eyes: int, age: Optional[float], task: str = "", own_senses: Sequence[str] = ()
    ) -> "Live":
        """A source for the command line: pixels of each eye, 0 for none; the infants' age in months."""
        options: Dict[str, Any] = {"vision": False}
        if eyes != 0:
            options = {"vision_width": eyes, "vision_height": eyes}
        if age is not None:
            options["age"] = age
        return cls(scene or "benchmark", task, own_senses, **options)

    def change(self, scene: str, task: str) -> None:
        """Changes to another built-in scene, with the same options; closes the old world afterwards."""
        world = self._made(scene, task)
        self.world.close()
        self.world, self.scene = world, scene

    def close(self) -> None:
        """Closes the world."""
        self.world.close()
