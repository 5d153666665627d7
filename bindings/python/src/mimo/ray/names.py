"""Checks names and options here rather than on another machine."""

from __future__ import annotations

import difflib
from typing import Any, Mapping, Union

from ..options import EnvOptions, refuse_unknown
from ..registration import ENVIRONMENTS
from ..scene import Scene, scenes
from ..vector import VectorEnv as LocalVectorEnv


def scene_of(scene: Union[str, Scene]) -> Union[str, Scene]:
    """The scene of a name, also of Gymnasium's names ("mimo/Reach-v0")."""
    return dict(ENVIRONMENTS).get(scene, scene) if isinstance(scene, str) else scene


def check(scene: Union[str, Scene], options: Mapping[str, Any]) -> None:
    """Refuses unknown names and options."""
    known = [*scenes(), *(name for name, _ in ENVIRONMENTS)]
    if isinstance(scene, str) and scene not in known:
        near = difflib.get_close_matches(scene, known, 1)
        meant = f"; did you mean {near[0]!r}?" if near else ""
        raise ValueError(f"scene is {scene!r}, expected one of {', '.join(known)}{meant}")
    for name, why in REFUSED.items():
        if name in options:
            raise TypeError(f"unexpected keyword argument {name!r}: {why}")
    rest = {name: value for name, value in options.items() if name not in OF_WORLDS}
    refuse_unknown(rest, EnvOptions, LocalVectorEnv.__init__)


OF_WORLDS = ("task", "flatten", "autoreset_mode", "ages")  # arguments of mimo.VectorEnv
REFUSED = {
    "threads": "an actor has as many as `cpus`",
    **dict.fromkeys(("render_mode", "camera", "width", "height"), "worlds in actors draw no pictures for people"),
}
