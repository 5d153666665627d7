"""A VectorEnv of Gymnasium on the library's batch."""

from __future__ import annotations

import secrets
from typing import TYPE_CHECKING, Any, Dict, List, Mapping, Optional, Sequence, Tuple, Union

import gymnasium.vector
import numpy as np
from gymnasium.error import ResetNeeded
from numpy.typing import NDArray

from .ages import Age
from .arguments import known_keywords, reset_options, whole_number
from .batch import Batch
from .constants import Autoreset, Outcome
from .env import check_sole, with_task
from .options import EnvOptions, refuse_unknown
from .pictures import ARRAYS, Painter, without_mode
from .scene import Scene
from .spaces import View, action_box, of_worlds
from .tasks import GoalTask, Judge, Judgement, Own, Task
from .world import World

PICTURE = (240, 180)
Flags = NDArray[np.bool_]
Results = Tuple[Any, NDArray[np.float64], Flags, Flags, Dict[str, Any]]
MODES = {"NextStep": Autoreset.NEXT_STEP, "SameStep": Autoreset.SAME_STEP, "Disabled": Autoreset.NONE}


def _declared(mode: str) -> Any:
    """The mode as Gymnasium's wrappers expect it: an enumeration since Gymnasium 1.1."""
    modes = getattr(gymnasium.vector, "AutoresetMode", None)
    return mode if modes is None else modes(mode)


if TYPE_CHECKING:
    from typing_extensions import Unpack

    VectorBase = gymnasium.vector.VectorEnv[Any, Any, Any]
elif issubclass(gymnasium.vector.VectorEnv, gymnasium.Env):

    class VectorBase(gymnasium.vector.VectorEnv):
        """Gymnasium's base class before 1.0, which resets single environments, as later versions reset theirs."""

        is_vector_env, closed, viewer = True, False, None

        def reset(self, *, seed=None, options=None):
            return gymnasium.Env.reset(self, seed=seed, options=options)

else:
    VectorBase = gymnasium.vector.VectorEnv


class VectorEnv(VectorBase):
    """Many worlds of one scene, stepped by the library's threads.

    Observations are views of two alternating blocks of the library, so an observation is valid until the second step
    after it; copy it to keep it longer. With `flatten` they are copied into one row of numbers per world.

    `autoreset_mode` is "NextStep" (the step after an end starts the next episode), "SameStep" (the step that ends an
    episode also starts the next; infos["final_obs"] has the old one's last observation) or "Disabled" (worlds
    continue until reset(options={"reset_mask": mask})).

    With `ages` (months, or options of growth) the infants of world i have the i-th age; a shorter list repeats.
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
        ages: Optional[Sequence[Age]] = None,
        render_mode: Optional[str] = None,
        camera: Optional[str] = None,
        width: Optional[int] = None,
        height: Optional[int] = None,
        **options: Unpack[EnvOptions],
    ) -> None:
        refuse_unknown(options, EnvOptions, VectorEnv.__init__)
        if whole_number("num_envs", num_envs) < 1:
            raise ValueError(f"num_envs is {num_envs}, expected 1 or more worlds")
        mode = getattr(autoreset_mode, "value", autoreset_mode)
        if mode not in MODES:
            raise ValueError(f"autoreset_mode is {mode!r}, expected one of {', '.join(MODES)}")
        self._painter = Painter(render_mode, (width, height), PICTURE, camera)
        self._mode, self.render_mode, self.num_envs = MODES[mode], render_mode, num_envs
        self.autoreset_mode = _declared(mode)
        # The library resets worlds if nothing has to be done in between.
        by_library = self._mode == Autoreset.NEXT_STEP and not isinstance(task, Task)
        self.batch = Batch(
            scene,
            num_envs,
            threads=threads,
            autoreset=Autoreset.NEXT_STEP if by_library else Autoreset.NONE,
            ages=ages,
            **with_task(options, task),
        )
        check_sole(self.batch.agents)
        self._by_library = by_library
        self._judge = Judge(task, self.batch) if isinstance(task, Task) else None
        self._view = View(self.batch.layout.fields, self._judge.fields if self._judge else {}, flatten)
        if isinstance(task, GoalTask):  # only with goals: learners test for this attribute
            self.compute_reward = task.compute_reward
        first = self.batch.world(0)
        self.single_observation_space = self._view.space
        self.single_action_space = action_box(self.batch.action_low, self.batch.action_high)
        self.observation_space = of_worlds(self.single_observation_space, num_envs)
        self.action_space = of_worlds(self.single_action_space, num_envs)
        fps = round(1 / (first.timestep * first.frame_skip))
        self.metadata = {"autoreset_mode": self.autoreset_mode, "render_modes": [*ARRAYS], "render_fps": fps}
        self._over = np.zeros(num_envs, np.bool_)
        self._seeded = False
        self._prepare()

    def _prepare(self) -> None:
        """Sets what belongs to this object's own batch."""
        self._blocks = [self.batch.blocks, self.batch.layout.new_block(self.num_envs)]
        self._views = [self.batch.layout.views(blocks) for blocks in self._blocks]
        self._turn = 0
        self._shown: List[World] = []  # worlds to be painted, made by the first picture: each has a block of its own

    # ---- Gymnasium -----------------------------------------------------------------------------------------------

    @known_keywords
    def reset(
        self,
        *,
        seed: Optional[Union[int, Sequence[Optional[int]]]] = None,
        options: Optional[Dict[str, Any]] = None,
    ) -> Tuple[Any, Dict[str, Any]]:
        """Starts episodes. One seed s means s, s + 1, ...; options={"reset_mask": mask} restarts some worlds only.

        In a list of seeds, one per world, None lets that world continue its random numbers, or chooses its first seed.
        options={"ages": [...]} sets the infants' ages, months or options of growth, one per world.
        """
        given = reset_options(options, "reset_mask", "ages")
        mask, ages = given.get("reset_mask"), given.get("ages")
        self.batch.drop_sent()
        if mask is not None:
            return self._reset_some(seed, np.asarray(mask, np.bool_), ages)
        super().reset(seed=seed if isinstance(seed, int) else None)
        seed, self._seeded = seed if self._seeded else from_chance(seed), True
        self._turn = 1 - self._turn
        self._start(self._blocks[self._turn], seed, None, ages)
        self._over[:] = False
        return self._observation(self._own()), {}

    def step(self, actions: Any) -> Results:
        """Steps all worlds."""
        self._need_reset()
        self.batch.step_into(self._blocks[1 - self._turn], actions)  # in one call, so that an interrupt loses nothing
        return self._results()

    def send(self, actions: Any) -> None:
        """Starts a step and returns at once; receive() returns its results."""
        self._need_reset()
        self.batch.send(actions, self._blocks[1 - self._turn])

    def _need_reset(self) -> None:
        if not self._seeded:
            raise ResetNeeded(
                "call reset() before step(): the first episodes have not begun, and their task is not set up"
            )

    def receive(self) -> Results:
        """Waits for the step in flight."""
        self.batch.receive()
        return self._results()

    def render(self) -> Optional[Tuple[NDArray[Any], ...]]:
        """One picture per world."""
        if self.render_mode is None:
            without_mode(type(self))
            return None
        self._shown = self._shown or [self.batch.world(i) for i in range(self.num_envs)]
        return tuple(self._painter.paint(world) for world in self._shown)

    def close_extras(self, **kwargs: Any) -> None:
        """Closes the batch."""
        if hasattr(self, "batch"):  # Gymnasium also calls this for an object whose constructor failed
            self.batch.close()

    # ---- Episodes ------------------------------------------------------------------------------------------------

    def _results(self) -> Results:
        """The results of the step that has just ended."""
        self._turn = 1 - self._turn
        self.batch._last.sensed = self._views[self._turn]  # cached
        reward, terminated, truncated, judged = self._judged()
        begins = self._over if self._mode == Autoreset.NEXT_STEP else np.zeros_like(self._over)
        self._over = (terminated | truncated) & ~begins
        infos = self._infos(self._over, ~begins, judged)
        if not self._by_library and begins.any():  # worlds whose episode ended in the last step begin a new one instead
            reward[begins], terminated[begins], truncated[begins] = 0, False, False
            self._start(self._blocks[self._turn], None, begins)
        own = self._own()
        if self._mode == Autoreset.SAME_STEP and self._over.any():
            own = self._restart(self._over, infos, own)
        return self._observation(own), reward, terminated, truncated, infos

    def _judged(self) -> Tuple[NDArray[np.float64], Flags, Flags, Optional[Judgement]]:
        batch = self.batch
        truncated = batch.truncated[:, 0].copy()
        if self._judge is None:
            return batch.reward[:, 0].copy(), batch.terminated[:, 0].copy(), truncated, None
        judged = self._judge.judged(batch)[""]
        reward, terminated = self._each(judged.total(), np.float64), self._each(judged.terminated, np.bool_)
        return reward, terminated, truncated | self._each(judged.truncated, np.bool_), judged

    def _each(self, value: Any, kind: Any = None) -> NDArray[Any]:
        """One value per world, where a task may give a single one."""
        return np.array(np.broadcast_to(value, (self.num_envs, *np.shape(value)[1:])), kind)

    def _infos(self, over: Flags, acted: Flags, judged: Optional[Judgement]) -> Dict[str, Any]:
        """Infos of ended episodes; with a mimo.Task also of each step."""
        if judged is None:
            return self._endings(over) if over.any() else {}
        infos = self._masked(judged.info, acted) if acted.any() else {}
        if judged.terms and acted.any():
            infos["reward_terms"], infos["_reward_terms"] = self._masked(judged.terms, acted), acted.copy()
        if over.any():
            outcome = {"is_success": judged.success, "is_failure": judged.failure}
            flags = {name: over & self._each(value, np.bool_) for name, value in outcome.items()}
            infos.update(self._masked(flags, over))
        return infos

    def _masked(self, values: Mapping[str, Any], mask: Flags) -> Dict[str, Any]:
        """Gymnasium's infos: an array by name, and its mask by "_name"."""
        infos: Dict[str, Any] = {name: self._each(value) for name, value in values.items()}
        return {**infos, **{"_" + name: mask.copy() for name in values}}

    def _endings(self, over: Flags) -> Dict[str, Any]:
        """Infos of ended episodes by the library's task."""
        outcome, rows = self.batch.outcome[:, 0], self.batch.terms.T
        ends = {"is_success": outcome == Outcome.SUCCESS, "is_failure": outcome == Outcome.FAILURE}
        infos = self._masked({name: over & end for name, end in ends.items()}, over)
        terms = {term.name: np.where(over, row, 0) for term, row in zip(self.batch.layout.terms, rows)}
        infos["reward_terms"], infos["_reward_terms"] = self._masked(terms, over), over.copy()
        return infos

    def _restart(self, over: Flags, infos: Dict[str, Any], own: Own) -> Own:
        """SameStep: keeps the last observations of ended episodes, and starts new ones."""
        last: NDArray[Any] = np.full(self.num_envs, None, object)
        for index in np.flatnonzero(over):
            last[index] = self._copy_of(int(index), own)
        infos["final_info"], infos["_final_info"] = dict(infos), over.copy()
        infos["final_obs"], infos["_final_obs"] = last, over.copy()
        self._start(self._blocks[self._turn], None, over)
        return self._own()

    def _start(
        self, blocks: NDArray[np.uint8], seed: Any, mask: Optional[Flags], ages: Optional[Sequence[Age]] = None
    ) -> None:
        self.batch.reset_into(blocks if self._judge is None else None, seed, mask, ages)
        if self._judge is not None:
            self._judge.task.reset(self.batch, mask)
            self.batch.observe_into(blocks, mask)
        self.batch._last.sensed = self._views[self._turn]

    def _reset_some(
        self, seed: Any, mask: NDArray[np.bool_], ages: Optional[Sequence[Age]]
    ) -> Tuple[Any, Dict[str, Any]]:
        self._start(self._blocks[self._turn], seed, mask, ages)
        self._over &= ~mask
        return self._observation(self._own()), {}

    # ---- Observations --------------------------------------------------------------------------------------------

    def _own(self) -> Own:
        """The fields of a mimo.Task."""
        return {} if self._judge is None else self._judge.observed(self.batch)[""]

    def _observation(self, own: Own) -> Any:
        return self._view.show(dict(self._views[self._turn]), own, self.num_envs)

    def _copy_of(self, index: int, own: Own) -> Any:
        rows = {name: field[index].copy() for name, field in {**self._views[self._turn], **own}.items()}
        return self._view.show(rows)

    # ---- Copies: by the batch's state; blocks and selections are new -----------------------------------------------

    def __getstate__(self) -> Dict[str, Any]:
        mine = {key: value for key, value in self.__dict__.items() if key not in ("_blocks", "_views", "_shown")}
        return {**mine, "_block": self._blocks[self._turn].copy()}

    def __setstate__(self, state: Dict[str, Any]) -> None:
        block = state.pop("_block")
        self.__dict__.update(state)
        self._prepare()
        self._blocks[self._turn][...] = block
        if self._judge is not None:
            self._judge.task.setup(self.batch)  # its selections belong to the other batch


def from_chance(seed: Any) -> Any:
    """Seeds for worlds that have none yet; missing ones are random."""
    if isinstance(seed, (list, tuple)):
        return [secrets.randbits(63) if one is None else one for one in seed]
    return secrets.randbits(63) if seed is None else seed


def make_vec(scene: Union[str, Scene] = "benchmark", num_envs: int = 1, **options: Any) -> VectorEnv:
    """Many worlds of a scene as a gymnasium.vector.VectorEnv; see mimo.VectorEnv for the options."""
    return VectorEnv(scene, num_envs, **options)
