"""The Gymnasium environment: one world with one infant."""

from __future__ import annotations

import secrets
from typing import TYPE_CHECKING, Any, Dict, Optional, Sequence, Tuple, Union

import gymnasium
import numpy as np
from gymnasium.error import ResetNeeded
from numpy.typing import NDArray

from .ages import Age
from .arguments import known_keywords, reset_options
from .constants import Outcome
from .layout import Observation, Supply
from .options import EnvOptions, refuse_unknown
from .pictures import ARRAYS, Painter, without_mode
from .scene import Scene
from .spaces import View, action_box
from .tasks import GoalTask, Judge, Judgement, Task
from .world import World

if TYPE_CHECKING:
    from typing_extensions import Unpack

PICTURE = (480, 360)
SUCCESS, FAILURE = int(Outcome.SUCCESS), int(Outcome.FAILURE)  # compared in every step, where enums are slow


class Env(gymnasium.Env[Any, NDArray[np.float32]]):
    """A world as a Gymnasium environment.

    Observations are dicts of arrays by field name; with `flatten` one row of numbers. `task` is an instance of a class
    derived from mimo.Task, or the name of a built-in task. mimo.World has the other options. `render_mode` is
    "rgb_array", "depth_array" (m) or "human", a page in the browser that shows the steps in real time (needs the extra
    [view]); `camera` names the camera to render from, None is a view from the front; `width` and `height` are pixels.
    """

    metadata: Dict[str, Any] = {"render_modes": [*ARRAYS, "human"], "render_fps": 100}  # noqa: RUF012

    def __init__(
        self,
        scene: Union[str, Scene] = "benchmark",
        *,
        task: Union[Task, str, None] = None,
        flatten: bool = False,
        render_mode: Optional[str] = None,
        camera: Optional[str] = None,
        width: Optional[int] = None,
        height: Optional[int] = None,
        **options: Unpack[EnvOptions],
    ) -> None:
        refuse_unknown(options, EnvOptions, Env.__init__)
        self._painter = Painter(render_mode, (width, height), PICTURE, camera, self.metadata["render_modes"])
        self.world = World(scene, **with_task(options, task))
        check_sole(self.world.agents)
        self.render_mode = render_mode
        self._judge = Judge(task, self.world) if isinstance(task, Task) else None
        self._view = View(self.world.layout.fields, self._judge.fields if self._judge else {}, flatten)
        self.observation_space: Any = self._view.space
        self.action_space: Any = action_box(self.world.action_low, self.world.action_high)
        self.metadata = {**self.metadata, "render_fps": round(1 / self.world.layout.step_seconds)}
        if isinstance(task, GoalTask):  # only with goals: learners test for this attribute
            self.compute_reward = task.compute_reward
        self._viewer: Any = None
        self._supply = Supply(self.world.layout)
        self._seeded = False

    @known_keywords
    def reset(
        self, *, seed: Optional[int] = None, options: Optional[Dict[str, Any]] = None
    ) -> Tuple[Any, Dict[str, Any]]:
        """Starts an episode. Without a seed the first one is random; later ones continue its random numbers.

        options={"age": 6} sets the infant's age in months; so does {"age": {"age": 6, "sex": "female"}}.
        """
        age = reset_options(options, "age").get("age")
        super().reset(seed=seed)
        if seed is None and not self._seeded:
            seed = secrets.randbits(64)
        self._seeded = True
        block = self.world.layout.new_block()
        begin(self.world, self._judge, block, seed, age)
        if self.render_mode == "human":
            self.render()
        info = start_info(self.world) if self._judge is None else judged_info(Judgement())
        return self._observation(dict(self.world.observation)), info

    def step(self, action: NDArray[np.float32]) -> Tuple[Any, float, bool, bool, Dict[str, Any]]:
        """Makes one step."""
        if not self._seeded:
            raise ResetNeeded("call reset() before step(): the first episode has not begun, and its task is not set up")
        world = self.world
        address, views = self._supply.take()  # a fresh block: arrays that were returned before stay
        world._step_at(address, world.layout.bytes, action)
        world._sense(views)
        if self.render_mode == "human":
            self.render()
        truncated = bool(world.truncated[0])
        if self._judge is None:
            reward, terminated = float(world.reward[0]), bool(world.terminated[0])
            return self._view.show(views), reward, terminated, truncated, world_info(world)
        judged = self._judge.judged(world)[""]
        reward, terminated = float(judged.total()), bool(judged.terminated)
        truncated = truncated or bool(judged.truncated)
        return self._observation(views), reward, terminated, truncated, judged_info(judged)

    def render(self) -> Any:
        """A picture with render_mode "rgb_array" or "depth_array"; with "human" it shows in the browser."""
        if self.render_mode is None:
            without_mode(type(self))
            return None
        if self.render_mode != "human":
            return self._painter.paint(self.world)
        if self._viewer is None:
            from . import view  # only needed for people

            self._viewer = view.opened_for_people(self)
        self._viewer.show()
        return None

    def close(self) -> None:
        """Closes the world, and its page in the browser."""
        if self._viewer is not None:
            self._viewer.close()
            self._viewer = None
        self.world.close()

    def _observation(self, views: Observation) -> Any:
        own = {} if self._judge is None else self._judge.observed(self.world)[""]
        return self._view.show(views, own)

    def __getstate__(self) -> Dict[str, Any]:
        return {**self.__dict__, "_viewer": None, "_supply": None}

    def __setstate__(self, state: Dict[str, Any]) -> None:
        self.__dict__.update(state)
        self._supply = Supply(self.world.layout)
        if self._judge is not None:
            self._judge.task.setup(self.world)  # its selections belong to the other world


def begin(world: World, judge: Optional[Judge], block: NDArray[np.uint8], seed: Optional[int], age: Age = None) -> None:
    """Starts an episode with the world's task or one in Python, and observes into the block."""
    if judge is None:
        world.reset_into(block, seed, age)
        return
    world.reset_into(None, seed, age)
    judge.task.reset(world, None)
    world.observe_into(block)


def world_info(world: World, agent: int = 0) -> Dict[str, Any]:
    """The info of an infant's step by the world's task."""
    outcome = world.outcome.item(agent)
    return {
        "is_success": outcome == SUCCESS,
        "is_failure": outcome == FAILURE,
        "reward_terms": world.reward_terms(agent),
    }


def start_info(world: World) -> Dict[str, Any]:
    """The same before the first step."""
    terms = dict.fromkeys((term.name for term in world.layout.terms), 0.0)
    return {"is_success": False, "is_failure": False, "reward_terms": terms}


def judged_info(judged: Judgement) -> Dict[str, Any]:
    """The info of a step in one world by a task in Python."""
    info = {"is_success": bool(judged.success), "is_failure": bool(judged.failure), **judged.info}
    return {**info, "reward_terms": dict(judged.terms)} if judged.terms else info


def check_sole(agents: Sequence[Any]) -> None:
    """Raises unless a world has exactly one infant."""
    if len(agents) == 0:
        raise ValueError("the scene has no infant; add one with its add_agent()")
    if len(agents) != 1:
        raise ValueError(f"the scene has {len(agents)} infants, expected one; for several use mimo.ParallelEnv")


def with_task(options: Any, task: Union[Task, str, None]) -> Any:
    """Options with a built-in task's name; a mimo.Task replaces the scene's task."""
    if task is None:
        return options
    if isinstance(task, type):
        raise TypeError(f"task is the class {task.__name__}, expected an object of it: {task.__name__}(...)")
    return {**options, "task": "none" if isinstance(task, Task) else task}
