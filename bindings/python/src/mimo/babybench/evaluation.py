"""Evaluated episodes, logged step by step in the competition's format.

evaluation = mimo.babybench.EVALS["self_touch"](env, duration=1000)
"""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any, Dict, List, Mapping, Optional

from ..scene import FILES
from .described import COUNTED, described_in_scenes
from .logs import TRAINING, write
from .reports import entries_of, report
from .scores import scores_of
from .utils import CORNERS, FRAME, RATE, evaluation_img

UNFINISHED = "unfinished.avi"


class Evaluation:
    """Tracks episodes of an environment: reset(), eval_step(info) after each step, end(episode).

    Writes logs/evaluation_<i>.pkl, a dict with `qpos` and `info` of all steps. With `render` also
    videos/evaluation_<i>.avi, with a frame a step at 60 frames a second (needs the extra [video]).
    """

    def __init__(self, env: Any, duration: int = 1000, render: Any = False, save_dir: Any = None) -> None:
        self.env, self.duration = env.unwrapped, duration
        folder = save_dir or self.env.save_dir
        if folder is None:
            raise ValueError("save_dir is None, expected a folder as an argument or in the configuration")
        self.logs, self.videos = Path(folder) / "logs", Path(folder) / "videos"
        self.render = bool(render)
        self._film: Any = None
        self.reset()

    def reset(self) -> None:
        """Begins an episode."""
        self._steps: Dict[str, List[Any]] = {"qpos": [], "info": []}
        if self._film is not None:
            self._film.give_up()
            self._film = None
            (self.videos / UNFINISHED).unlink(missing_ok=True)  # there once its first packet is

    def eval_logs(self) -> str:
        """The scores of the training, in one line; also printed."""
        path = self.logs / TRAINING
        told = report(path.name, scores_of(entries_of(path))) if path.is_file() else f"there is no {path}"
        print(told)
        return told

    def eval_step(self, info: Mapping[str, Any]) -> None:
        """Adds a step."""
        self._steps["qpos"].append(self.env.data.qpos.copy())
        self._steps["info"].append(dict(info))
        if self.render:
            self._filmed().show(evaluation_img(self.env, up=CORNERS.get(self.env.config["behavior"], CORNERS["none"])))

    def _filmed(self) -> Any:
        """The video of the episode, which is written as the steps come: a thousand frames fill a gigabyte."""
        if self._film is None:
            from ..video import File  # needs PyAV

            self.videos.mkdir(parents=True, exist_ok=True)
            self._film = File(str(self.videos / UNFINISHED), RATE, size=FRAME)
        return self._film

    def end(self, episode: int) -> Optional[Path]:
        """Ends an episode, and writes its log and its video."""
        path = self.logs / f"evaluation_{episode}.pkl"
        write(path, self._steps)
        if self._film is not None:
            self._film.finish()
            self._film = None
            os.replace(self.videos / UNFINISHED, self.videos / f"evaluation_{episode}.avi")
        return path


class _Evaluations(Dict[Any, Any]):
    """By behaviour; documents of one's own have no names to list."""

    def __missing__(self, behavior: Any) -> Any:
        if str(behavior).endswith(FILES):
            return Evaluation
        raise KeyError(behavior)


EVALS = _Evaluations.fromkeys((*COUNTED, *described_in_scenes()), Evaluation)
