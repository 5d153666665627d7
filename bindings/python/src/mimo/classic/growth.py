"""The original's functions of growth: a scene's document for an infant of another age."""

from __future__ import annotations

import os
import shutil
import tempfile
from typing import Any, Mapping, Optional

from .scenes import age_of, opened

_PREFIX = "mimo_growth_"


def adjust_mimo_to_age(age: float, path_scene: Any, custom: Optional[Mapping[str, float]] = None) -> str:
    """Writes a scene with an infant of an age in months, and returns the path of its document."""
    scene, body = opened(path_scene)
    infant: Any = {**({"body": body} if body else {}), **age_of(age, custom)}
    scene.add_agents(**infant)
    folder = tempfile.mkdtemp(prefix=_PREFIX)
    scene.save(folder)
    return os.path.join(folder, "scene.xml")


def delete_growth_scene(path_scene: str) -> None:
    """Removes such a document, with its folder."""
    folder = os.path.dirname(os.path.abspath(path_scene))
    if not os.path.basename(folder).startswith(_PREFIX):
        raise ValueError(f"path_scene is {path_scene!r}, expected the path that adjust_mimo_to_age returned")
    shutil.rmtree(folder)


__all__ = ["adjust_mimo_to_age", "delete_growth_scene"]
