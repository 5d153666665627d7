"""The vectorised environment: Gymnasium's VectorEnv on the library's batch."""

from __future__ import annotations

import secrets
from typing import Any, Dict, Optional, Sequence, Tuple, Union

import gymnasium.vector
import numpy as np
from gymnasium.vector.utils import batch_space
from numpy.typing import NDArray
from typing_extensions import Unpack

from .batch import Batch
from .constants import Autoreset
from .env import check_sole, with_task
from .options import EnvOptions
from .scene import Scene
from .spaces import action_box, flat, observation_space
from .tasks import Task, judgement

MODES = {"NextStep": Autoreset.NEXT_STEP, "SameStep": Autoreset.SAME_STEP, "Disabled": Autoreset.NONE}


def _declared(mode: str) -> Any:
    """The mode as Gymnasium's wrappers look for it: an enum since Gymnasium 1.1, which 1.0 does not have."""
    modes = getattr(gymnasium.vector, "AutoresetMode", None)
    return mode if modes is None else modes(mode)


class VectorEnv(gymnasium.vector.VectorEnv[Any, Any, Any]):
    """Many worlds of one scene, stepped by the library's threads.

    Observations are views of the library's blocks, not copies. There are two blocks in turn, so an observation is
    good until the second step after it: copy what is to be kept longer. With `flatten` they are copied into one row of
    numbers a world.

    `autoreset_mode` is "NextStep" (the step after an end starts the next episode), "SameStep" (the step that ends an
    episode also starts the next; the old one's last observation is in infos["final_obs"]) or "Disabled" (worlds go
    on until reset(options={"reset_mask": mask})).
    """

    def __init__(
        self,
        scene: Union[str, Scene] = "benchmark",
        num_envs: int = 1,
        *,
        task: Union[Task, str, None] = None,
        flatten: bool = False,
        autoreset_mode: Any = "NextStep",
        threads: int = 0,
        render_mode: Optional[str] = None,
        **options: Unpack[EnvOptions],
    ) -> None:
        mode = getattr(autoreset_mode, "value", autoreset_mode)
        if mode not in MODES:
            raise ValueError(f"autoreset_mode is {mode!r}, expected one of {', '.join(MODES)}")
        if render_mode not in (None, "rgb_array"):
            raise ValueError(f"render_mode is {render_mode!r}, expected 'rgb_array' or None")
        self._mode, self.render_mode, self.num_envs, self._flatten = MODES[mode], render_mode, num_envs, flatten
        self._task = task if isinstance(task, Task) else None
        # The library starts worlds anew by itself where nothing has to be asked or done in between.
        by_library = self._mode == Autoreset.NEXT_STEP and self._task is None
        self.batch = Batch(
            scene,
            num_envs,
            threads=threads,
            autoreset=Autoreset.NEXT_STEP if by_library else Autoreset.NONE,
            **with_task(options, task),
        )
        check_sole(self.batch.agents)
        self._by_library = by_library
        first = self.batch.world(0)
        self.single_observation_space = observation_space(self.batch.layout, flatten)
        self.single_action_space = action_box(self.batch.action_low, self.batch.action_high)
        self.observation_space = batch_space(self.single_observation_space, num_envs)
        self.action_space = batch_space(self.single_action_space, num_envs)
        fps = round(1 / (first.timestep * first.frame_skip))
        self.metadata = {"autoreset_mode": _declared(mode), "render_modes": ["rgb_array"], "render_fps": fps}
        self._over = np.zeros(num_envs, np.bool_)
        self._seeded = False
        self._prepare()

    def _prepare(self) -> None:
        """What belongs to this object's own batch: blocks, and what the task has looked up."""
        self._blocks = [self.batch.blocks, self.batch.layout.new_block(self.num_envs)]
        self._views = [self.batch.layout.views(blocks) for blocks in self._blocks]
        self._turn = 0
        self._worlds = [self.batch.world(i) for i in range(self.num_envs)]
        if self._task is not None:
            self._task.setup(self.batch)

    # ---- Gymnasium -----------------------------------------------------------------------------------------------

    def reset(
        self,
        *,
        seed: Optional[Union[int, Sequence[Optional[int]]]] = None,
        options: Optional[Dict[str, Any]] = None,
    ) -> Tuple[Any, Dict[str, Any]]:
        """Starts episodes. One seed s means s, s + 1, ...; options={"reset_mask": mask} restarts some worlds only."""
        mask = None if options is None else options.get("reset_mask")
        if mask is not None:
            return self._reset_some(seed, np.asarray(mask, np.bool_))
        super().reset(seed=seed if isinstance(seed, int) else None)
        if seed is None and not self._seeded:
            seed = secrets.randbits(63)
        self._seeded = True
        self._turn = 1 - self._turn
        self._start(self._blocks[self._turn], seed, None)
        self._over[:] = False
        return self._observation(), {}

    def step(
        self, actions: Any
    ) -> Tuple[Any, NDArray[np.float64], NDArray[np.bool_], NDArray[np.bool_], Dict[str, Any]]:
        """Goes one step on in all worlds."""
        self.send(actions)
        return self.receive()

    def send(self, actions: Any) -> None:
        """Starts a step and returns, so that something else can be done meanwhile; receive() gives its results."""
        self.batch.send(actions, self._blocks[1 - self._turn])

    def receive(self) -> Tuple[Any, NDArray[np.float64], NDArray[np.bool_], NDArray[np.bool_], Dict[str, Any]]:
        """Waits for the step that was sent."""
        self.batch.receive()
        self._turn = 1 - self._turn
        reward, terminated, truncated, success = self._judged()
        if self._mode == Autoreset.NEXT_STEP and not self._by_library:
            self._begin(self._over, reward, terminated, truncated)
        self._over = terminated | truncated
        infos = self._infos(self._over, success)
        if self._mode == Autoreset.SAME_STEP:
            self._restart(self._over, infos)
        return self._observation(), reward, terminated, truncated, infos

    def render(self) -> Optional[Tuple[NDArray[np.uint8], ...]]:
        """One picture a world."""
        if self.render_mode is None:
            return None
        return tuple(world.render(width=240, height=180) for world in self._worlds)

    def close_extras(self, **kwargs: Any) -> None:
        """Closes the batch."""
        if hasattr(self, "batch"):  # Gymnasium calls this, too, for an object that could not be made
            self.batch.close()

    # ---- Episodes ------------------------------------------------------------------------------------------------

    def _judged(self) -> Tuple[NDArray[np.float64], NDArray[np.bool_], NDArray[np.bool_], Any]:
        batch = self.batch
        truncated = batch.truncated[:, 0].copy()
        if self._task is None:
            return batch.reward[:, 0].copy(), batch.terminated[:, 0].copy(), truncated, None
        batch.observation = self._views[self._turn]
        judged = judgement(self._task, batch)
        reward = np.array(np.broadcast_to(judged.reward, self.num_envs), np.float64)
        terminated = np.array(np.broadcast_to(judged.terminated, self.num_envs), np.bool_)
        return reward, terminated, truncated, np.broadcast_to(judged.success, self.num_envs)

    def _infos(self, over: NDArray[np.bool_], success: Any) -> Dict[str, Any]:
        """Success and reward terms of the worlds whose episode has ended."""
        if not over.any():
            return {}
        ended = np.flatnonzero(over)
        infos: Dict[str, Any] = {"is_success": np.zeros(self.num_envs, np.bool_), "_is_success": over.copy()}
        if success is not None:
            infos["is_success"][ended] = success[ended]
            return infos
        terms: Dict[str, Any] = {}
        for index in ended:
            world = self._worlds[index]
            infos["is_success"][index] = world.outcome().success
            for name, value in world.reward_terms().items():
                terms.setdefault(name, np.zeros(self.num_envs))[index] = value
                terms["_" + name] = over.copy()
        infos["reward_terms"], infos["_reward_terms"] = terms, over.copy()
        return infos

    def _restart(self, over: NDArray[np.bool_], infos: Dict[str, Any]) -> None:
        """SameStep: keeps the last observations of what has ended, and starts it anew."""
        if not over.any():
            return
        last: NDArray[Any] = np.full(self.num_envs, None, object)
        for index in np.flatnonzero(over):
            last[index] = self._copy_of(int(index))
        infos["final_info"], infos["_final_info"] = dict(infos), over.copy()
        infos["final_obs"], infos["_final_obs"] = last, over.copy()
        self._start(self._blocks[self._turn], None, over)

    def _begin(self, due: NDArray[np.bool_], *results: NDArray[Any]) -> None:
        """NextStep with a task in Python: worlds whose episode ended in the last step begin one instead of acting."""
        if not due.any():
            return
        for result in results:
            result[due] = 0
        self._start(self._blocks[self._turn], None, due)

    def _start(self, blocks: NDArray[np.uint8], seed: Any, mask: Optional[NDArray[np.bool_]]) -> None:
        self.batch.reset_into(blocks if self._task is None else None, seed, mask)
        if self._task is not None:
            self._task.reset(self.batch, mask)
            self.batch.observe_into(blocks, mask)

    def _reset_some(self, seed: Any, mask: NDArray[np.bool_]) -> Tuple[Any, Dict[str, Any]]:
        self._start(self._blocks[self._turn], seed, mask)
        self._over &= ~mask
        return self._observation(), {}

    # ---- Observations --------------------------------------------------------------------------------------------

    def _observation(self) -> Any:
        views = self._views[self._turn]
        return flat(views, self.num_envs) if self._flatten else dict(views)

    def _copy_of(self, index: int) -> Any:
        row = {name: field[index].copy() for name, field in self._views[self._turn].items()}
        return flat(row) if self._flatten else row

    # ---- Copies: by the batch's state; blocks and names are made anew ----------------------------------------------

    def __getstate__(self) -> Dict[str, Any]:
        mine = {key: value for key, value in self.__dict__.items() if key not in ("_blocks", "_views", "_worlds")}
        return {**mine, "_block": self._blocks[self._turn].copy()}

    def __setstate__(self, state: Dict[str, Any]) -> None:
        block = state.pop("_block")
        self.__dict__.update(state)
        self._prepare()
        self._blocks[self._turn][...] = block


def make_vec(scene: Union[str, Scene] = "benchmark", num_envs: int = 1, **options: Any) -> VectorEnv:
    """Many worlds of a scene as a gymnasium.vector.VectorEnv; see mimo.VectorEnv for the options."""
    return VectorEnv(scene, num_envs, **options)
