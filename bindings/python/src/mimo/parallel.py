"""PettingZoo: several infants in one world, each an agent of its own. Needs the extra [pettingzoo]."""

from __future__ import annotations

import secrets
from typing import Any, Dict, List, Optional, Tuple, Union

import numpy as np
from gymnasium import spaces
from numpy.typing import NDArray
from pettingzoo import ParallelEnv as _ParallelEnv
from typing_extensions import Unpack

from .env import PICTURE, begin, with_task
from .layout import Observation
from .options import EnvOptions
from .scene import Scene
from .spaces import action_box, dict_space, split
from .tasks import Task, judgements
from .world import World

SOLE = "infant"  # PettingZoo's name of an infant without one


class ParallelEnv(_ParallelEnv[str, Any, Any]):
    """All infants of a world act at the same time. Their observations are dicts without the infants' names in front.

    An infant whose episode has ended leaves `agents`; the others go on, and its motors rest. `task` may be an object
    derived from mimo.Task whose evaluate returns {name: Judgement}, or the name of a built-in task.
    """

    metadata: Dict[str, Any] = {"name": "mimo", "render_modes": ["rgb_array"], "is_parallelizable": True}  # noqa: RUF012

    def __init__(
        self,
        scene: Union[str, Scene],
        *,
        task: Union[Task, str, None] = None,
        render_mode: Optional[str] = None,
        **options: Unpack[EnvOptions],
    ) -> None:
        if render_mode not in (None, "rgb_array"):
            raise ValueError(f"render_mode is {render_mode!r}, expected 'rgb_array' or None")
        self.world = World(scene, **with_task(options, task))
        if not self.world.agents:
            raise ValueError("the scene has no infant; add some with its add_agent()")
        self._task = task if isinstance(task, Task) else None
        self.render_mode = render_mode
        self.possible_agents = [agent.name or SOLE for agent in self.world.agents]
        self.agents: List[str] = []
        fields = self.world.layout.fields
        named = [agent.name for agent in self.world.agents if agent.name]
        self._fields = split(fields, named) if named else {SOLE: dict(fields)}
        self._observation_spaces = {agent: dict_space(part) for agent, part in self._fields.items()}
        low, high = self.world.action_low, self.world.action_high
        parts = zip(self.possible_agents, self.world.agents)
        self._action_spaces = {name: action_box(low[agent.actions], high[agent.actions]) for name, agent in parts}
        self._seeded = False
        if self._task is not None:
            self._task.setup(self.world)

    def observation_space(self, agent: str) -> spaces.Dict:
        """The space of one infant's observations."""
        return self._observation_spaces[agent]

    def action_space(self, agent: str) -> spaces.Box:
        """The space of one infant's actions."""
        return self._action_spaces[agent]

    def reset(
        self, seed: Optional[int] = None, options: Optional[Dict[str, Any]] = None
    ) -> Tuple[Dict[str, Any], Dict[str, Dict[str, Any]]]:
        """Starts an episode for all infants."""
        if seed is None and not self._seeded:
            seed = secrets.randbits(64)
        self._seeded = True
        self.agents = list(self.possible_agents)
        block = self.world.layout.new_block()
        begin(self.world, self._task, block, seed)
        views = self.world.layout.views(block)
        return self._observations(views, self.agents), {agent: {} for agent in self.agents}

    def step(
        self, actions: Dict[str, Any]
    ) -> Tuple[Dict[str, Any], Dict[str, float], Dict[str, bool], Dict[str, bool], Dict[str, Dict[str, Any]]]:
        """Goes one step on; actions of infants that are still in the game, by name."""
        block = self.world.layout.new_block()
        self.world.step_into(block, self._joined(actions))
        acted = self.agents
        numbers = {agent: self.possible_agents.index(agent) for agent in acted}
        self.world.observation = self.world.layout.views(block)
        rewards, terminated, infos = self._judged(numbers)
        truncated = {agent: bool(self.world.truncated[i]) for agent, i in numbers.items()}
        self.agents = [agent for agent in acted if not (terminated[agent] or truncated[agent])]
        return self._observations(self.world.observation, acted), rewards, terminated, truncated, infos

    def _judged(self, numbers: Dict[str, int]) -> Tuple[Dict[str, float], Dict[str, bool], Dict[str, Dict[str, Any]]]:
        """Rewards, ends and infos of the infants that acted, by the world's task or by one's own."""
        world = self.world
        if self._task is not None:
            judged = judgements(self._task, world, list(numbers))
            return (
                {agent: float(judged[agent].reward) for agent in numbers},
                {agent: bool(judged[agent].terminated) for agent in numbers},
                {agent: {"is_success": bool(judged[agent].success)} for agent in numbers},
            )
        return (
            {agent: float(world.reward[i]) for agent, i in numbers.items()},
            {agent: bool(world.terminated[i]) for agent, i in numbers.items()},
            {
                agent: {"is_success": world.outcome(i).success, "reward_terms": world.reward_terms(i)}
                for agent, i in numbers.items()
            },
        )

    def render(self) -> Optional[NDArray[np.uint8]]:
        """A picture of the world."""
        return self.world.render(**PICTURE) if self.render_mode else None  # type: ignore[arg-type]

    def close(self) -> None:
        """Closes the world."""
        self.world.close()

    def _joined(self, actions: Dict[str, Any]) -> NDArray[np.float32]:
        joined = np.zeros(len(self.world.action_names), np.float32)
        for agent, action in actions.items():
            joined[self.world.agents[self.possible_agents.index(agent)].actions] = action
        return joined

    def _observations(self, views: Observation, agents: List[str]) -> Dict[str, Any]:
        return {agent: {name: views[field.name] for name, field in self._fields[agent].items()} for agent in agents}
