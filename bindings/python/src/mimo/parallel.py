"""PettingZoo: several infants in one world, each an agent. Needs the extra [pettingzoo]."""

from __future__ import annotations

import secrets
from typing import TYPE_CHECKING, Any, Dict, List, Optional, Tuple, Union

import numpy as np
from gymnasium import spaces
from numpy.typing import NDArray

from .arguments import known_keywords, numbers_in
from .env import PICTURE, begin, judged_info, with_task, world_info
from .layout import Observation
from .options import EnvOptions, refuse_unknown
from .pictures import ARRAYS, Painter, without_mode
from .scene import Scene
from .spaces import View, action_box, split
from .tasks import GoalTask, Judge, Task
from .world import World

if TYPE_CHECKING:
    from typing_extensions import Unpack

try:
    from pettingzoo import ParallelEnv as _ParallelEnv
except ImportError as error:
    raise ImportError("mimo.ParallelEnv needs PettingZoo: pip install 'mimo[pettingzoo]'") from error

SOLE = "infant"  # name of an infant that has none


class ParallelEnv(_ParallelEnv[str, Any, Any]):
    """All infants of a world act at the same time. Names in their observations have no prefix.

    An infant whose episode has ended leaves `agents` and its motors rest; the others continue. `task` is an instance
    of a class derived from mimo.Task whose evaluate returns {name: Judgement}, or the name of a built-in task.
    `flatten`, `render_mode` and its options are those of mimo.Env.
    """

    metadata: Dict[str, Any] = {"name": "mimo", "render_modes": [*ARRAYS], "is_parallelizable": True}  # noqa: RUF012

    def __init__(
        self,
        scene: Union[str, Scene],
        *,
        task: Union[Task, str, None] = None,
        flatten: bool = False,
        render_mode: Optional[str] = None,
        camera: Optional[str] = None,
        width: Optional[int] = None,
        height: Optional[int] = None,
        **options: Unpack[EnvOptions],
    ) -> None:
        refuse_unknown(options, EnvOptions, ParallelEnv.__init__)
        self._painter = Painter(render_mode, (width, height), PICTURE, camera)
        self.world = World(scene, **with_task(options, task))
        if not self.world.agents:
            raise ValueError("the scene has no infant; add some with its add_agent()")
        self.render_mode = render_mode
        self.possible_agents = [agent.name or SOLE for agent in self.world.agents]
        self.agents: List[str] = []
        self._judge = Judge(task, self.world, self.possible_agents) if isinstance(task, Task) else None
        if isinstance(task, GoalTask):  # only with goals: learners test for this attribute
            self.compute_reward = task.compute_reward
        own = self._judge.fields if self._judge else {}
        fields = self.world.layout.fields
        named = [agent.name for agent in self.world.agents if agent.name]
        self._fields = split(fields, named) if named else {SOLE: dict(fields)}
        self._views = {agent: View(part, own, flatten) for agent, part in self._fields.items()}
        low, high = self.world.action_low, self.world.action_high
        parts = zip(self.possible_agents, self.world.agents)
        self._action_spaces = {name: action_box(low[agent.actions], high[agent.actions]) for name, agent in parts}
        self._seeded = False

    def observation_space(self, agent: str) -> spaces.Space[Any]:
        """The space of one infant's observations."""
        return self._views[agent].space

    def action_space(self, agent: str) -> spaces.Box:
        """The space of one infant's actions."""
        return self._action_spaces[agent]

    @known_keywords
    def reset(
        self, seed: Optional[int] = None, options: Optional[Dict[str, Any]] = None
    ) -> Tuple[Dict[str, Any], Dict[str, Dict[str, Any]]]:
        """Starts an episode for all infants. Options are ignored; PettingZoo's checker passes one."""
        if seed is None and not self._seeded:
            seed = secrets.randbits(64)
        self._seeded = True
        self.agents = list(self.possible_agents)
        block = self.world.layout.new_block()
        begin(self.world, self._judge, block, seed)
        return self._observations(self.world.observation, self.agents), {agent: {} for agent in self.agents}

    def step(
        self, actions: Dict[str, Any]
    ) -> Tuple[Dict[str, Any], Dict[str, float], Dict[str, bool], Dict[str, bool], Dict[str, Dict[str, Any]]]:
        """Makes one step; actions by name, of the infants in `agents`."""
        block = self.world.layout.new_block()
        self.world.step_into(block, self._joined(actions))
        acted = self.agents
        numbers = {agent: self.possible_agents.index(agent) for agent in acted}
        rewards, terminated, truncated, infos = self._judged(numbers)
        self.agents = [agent for agent in acted if not (terminated[agent] or truncated[agent])]
        return self._observations(self.world.observation, acted), rewards, terminated, truncated, infos

    def _judged(
        self, numbers: Dict[str, int]
    ) -> Tuple[Dict[str, float], Dict[str, bool], Dict[str, bool], Dict[str, Dict[str, Any]]]:
        """Rewards, ends and infos of the infants that acted, by the world's task or a mimo.Task."""
        world = self.world
        truncated = {agent: bool(world.truncated[i]) for agent, i in numbers.items()}
        if self._judge is None or not numbers:
            return (
                {agent: float(world.reward[i]) for agent, i in numbers.items()},
                {agent: bool(world.terminated[i]) for agent, i in numbers.items()},
                truncated,
                {agent: world_info(world, i) for agent, i in numbers.items()},
            )
        judged = self._judge.judged(world, list(numbers))
        return (
            {agent: float(it.total()) for agent, it in judged.items()},
            {agent: bool(it.terminated) for agent, it in judged.items()},
            {agent: truncated[agent] or bool(it.truncated) for agent, it in judged.items()},
            {agent: judged_info(it) for agent, it in judged.items()},
        )

    def render(self) -> Optional[NDArray[Any]]:
        """A picture of the world."""
        if self.render_mode is None:
            without_mode(type(self))
            return None
        picture: NDArray[Any] = self._painter.paint(self.world)
        return picture

    def close(self) -> None:
        """Closes the world."""
        self.world.close()

    def _joined(self, actions: Dict[str, Any]) -> NDArray[np.float32]:
        joined = np.zeros(len(self.world.action_names), np.float32)
        for agent, action in actions.items():
            if agent not in self.possible_agents:
                raise ValueError(f"actions has {agent!r}, expected infants: {', '.join(self.possible_agents)}")
            place = self.world.agents[self.possible_agents.index(agent)].actions
            joined[place] = numbers_in(f"actions[{agent!r}]", action, joined[place].shape)
        return joined

    def _observations(self, views: Observation, agents: List[str]) -> Dict[str, Any]:
        own = self._judge.observed(self.world, agents) if self._judge else {}
        parts = {a: {name: views[field.name] for name, field in self._fields[a].items()} for a in agents}
        return {agent: self._views[agent].show(part, own.get(agent, {})) for agent, part in parts.items()}
