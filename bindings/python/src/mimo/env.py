"""The Gymnasium environment: one world with one infant."""

from __future__ import annotations

import secrets
from typing import Any, ClassVar, Dict, List, Optional, Sequence, Tuple, Union

import gymnasium
import numpy as np
from numpy.typing import NDArray
from typing_extensions import Unpack

from .layout import Supply
from .options import EnvOptions
from .scene import Scene
from .spaces import action_box, flat, observation_space
from .tasks import Task, judgement
from .world import World

PICTURE = {"width": 480, "height": 360}


class Env(gymnasium.Env[Any, NDArray[np.float32]]):
    """A world as Gymnasium wants it.

    Observations are dicts of arrays by field name; with `flatten` one row of numbers. `task` may be an object derived
    from mimo.Task, or the name of a built-in task. All further options are those of mimo.World.
    `render_mode` is "rgb_array" or "human"; `camera` names the camera to render from, None is a view from the front.
    """

    metadata: Dict[str, Any] = {"render_modes": ["rgb_array", "human"], "render_fps": 100}  # noqa: RUF012
    render_modes: ClassVar[Sequence[Optional[str]]] = (None, "rgb_array", "human")

    def __init__(
        self,
        scene: Union[str, Scene] = "benchmark",
        *,
        task: Union[Task, str, None] = None,
        flatten: bool = False,
        render_mode: Optional[str] = None,
        camera: Optional[str] = None,
        **options: Unpack[EnvOptions],
    ) -> None:
        if render_mode not in self.render_modes:
            raise ValueError(f"render_mode is {render_mode!r}, expected one of {self.metadata['render_modes']}")
        self.world = World(scene, **with_task(options, task))
        check_sole(self.world.agents)
        self._flatten, self.render_mode, self._camera = flatten, render_mode, camera
        self.observation_space: Any = observation_space(self.world.layout, flatten)
        self.action_space: Any = action_box(self.world.action_low, self.world.action_high)
        self.metadata = {**self.metadata, "render_fps": round(1 / (self.world.timestep * self.world.frame_skip))}
        self._task = task if isinstance(task, Task) else None
        self._window: Any = None
        self._supply = Supply(self.world.layout)
        self._seeded = False
        if self._task is not None:
            self._task.setup(self.world)

    def reset(
        self, *, seed: Optional[int] = None, options: Optional[Dict[str, Any]] = None
    ) -> Tuple[Any, Dict[str, Any]]:
        """Starts an episode. The first one without a seed starts from chance, further ones go on from there."""
        super().reset(seed=seed)
        if seed is None and not self._seeded:
            seed = secrets.randbits(64)
        self._seeded = True
        block = self.world.layout.new_block()
        observation = self.world.layout.views(block)
        begin(self.world, self._task, block, seed)
        if self.render_mode == "human":
            self.render()
        return flat(observation) if self._flatten else observation, self._info(success=False)

    def step(self, action: NDArray[np.float32]) -> Tuple[Any, float, bool, bool, Dict[str, Any]]:
        """Goes one step on."""
        world = self.world
        address, views = self._supply.take()  # fresh: what was returned before stays as it is
        world._step_at(address, world.layout.bytes, action)
        observation = flat(views) if self._flatten else views
        if self.render_mode == "human":
            self.render()
        if self._task is None:
            return (
                observation,
                float(world.reward[0]),
                bool(world.terminated[0]),
                bool(world.truncated[0]),
                self._info(),
            )
        world.observation = views
        judged = judgement(self._task, world)
        info = self._info(success=bool(judged.success))
        return observation, float(judged.reward), bool(judged.terminated), bool(world.truncated[0]), info

    def render(self) -> Any:
        """A picture (height x width x 3) with render_mode "rgb_array"; draws to the window with "human"."""
        if self.render_mode is None:
            return None
        camera = {} if self._camera is None else {"camera": self._camera}
        picture = self.world.render(**PICTURE, **camera)  # type: ignore[arg-type]
        if self.render_mode == "rgb_array":
            return picture
        if self._window is None:
            from .plot import Window  # matplotlib is only needed for windows and plots

            self._window = Window(f"MIMo: {self.world.task}")
        self._window.show(picture)
        return None

    def close(self) -> None:
        """Closes the world, and the window if there is one."""
        if self._window is not None:
            self._window.close()
            self._window = None
        self.world.close()

    def _info(self, success: Optional[bool] = None) -> Dict[str, Any]:
        if self._task is not None:
            return {"is_success": bool(success)}
        world = self.world
        return {"is_success": world.outcome().success, "reward_terms": world.reward_terms()}

    def __getstate__(self) -> Dict[str, Any]:
        return {**self.__dict__, "_window": None, "_supply": None}

    def __setstate__(self, state: Dict[str, Any]) -> None:
        self.__dict__.update(state)
        self._supply = Supply(self.world.layout)
        if self._task is not None:
            self._task.setup(self.world)  # what it had looked up belonged to the other world


def begin(world: World, task: Optional[Task], block: NDArray[np.uint8], seed: Optional[int]) -> None:
    """Starts an episode, as the world's own task or one in Python has it, and senses into the block."""
    if task is None:
        world.reset_into(block, seed)
        return
    world.reset_into(None, seed)
    task.reset(world, None)
    world.observe_into(block)


def check_sole(agents: Sequence[Any]) -> None:
    """Raises unless a world has just one infant."""
    if len(agents) == 0:
        raise ValueError("the scene has no infant; add one with its add_agent()")
    if len(agents) != 1:
        raise ValueError(f"the scene has {len(agents)} infants, expected one; for several use mimo.ParallelEnv")


def with_task(options: Any, task: Union[Task, str, None]) -> Any:
    """Options with a built-in task's name; a task of one's own takes the place of the scene's."""
    if task is None:
        return options
    return {**options, "task": "none" if isinstance(task, Task) else task}


ENVIRONMENTS: List[Tuple[str, str]] = [
    ("mimo/Reach-v0", "reach"),
    ("mimo/Standup-v0", "standup"),
    ("mimo/SelfBody-v0", "selfbody"),
    ("mimo/Catch-v0", "catch"),
    ("mimo/Benchmark-v0", "benchmark"),
    ("mimo/Free-v0", "free"),
    ("mimo/Showroom-v0", "showroom"),
]


def register() -> None:
    """Makes gymnasium.make("mimo/Reach-v0") and its like work; `import mimo` calls it."""
    for name, scene in ENVIRONMENTS:
        if name not in gymnasium.registry:
            gymnasium.register(
                name, entry_point="mimo:Env", vector_entry_point="mimo:VectorEnv", kwargs={"scene": scene}
            )
