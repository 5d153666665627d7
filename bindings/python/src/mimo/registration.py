"""The names of Gymnasium's registry, and their registration as soon as Gymnasium is imported."""

from __future__ import annotations

import importlib.util
import sys
from importlib.abc import MetaPathFinder
from importlib.machinery import ModuleSpec
from typing import Any, List, Optional, Tuple

ENVIRONMENTS: List[Tuple[str, str]] = [
    ("mimo/Reach-v0", "reach"),
    ("mimo/Standup-v0", "standup"),
    ("mimo/SelfBody-v0", "selfbody"),
    ("mimo/Catch-v0", "catch"),
    ("mimo/Rollover-v0", "rollover"),
    ("mimo/SelfTouch-v0", "babybench-crib"),
    ("mimo/HandRegard-v0", "babybench-cubes"),
    ("mimo/Benchmark-v0", "benchmark"),
    ("mimo/Free-v0", "free"),
    ("mimo/Showroom-v0", "showroom"),
]
GYMNASIUM = "gymnasium"


def register() -> None:
    """Registers "mimo/Reach-v0" and the others with Gymnasium."""
    from gymnasium.envs.registration import register as add
    from gymnasium.envs.registration import registry

    for name, scene in ENVIRONMENTS:
        if name not in registry:
            add(name, entry_point="mimo:Env", vector_entry_point="mimo:VectorEnv", kwargs={"scene": scene})


def register_when_imported() -> None:
    """The same now if the program has imported Gymnasium, otherwise when it does; `import mimo` calls it.

    Programs that use mimo.World or mimo.Batch only do without Gymnasium.
    """
    if GYMNASIUM in sys.modules:
        register()
    elif not any(isinstance(finder, _Waiting) for finder in sys.meta_path):
        sys.meta_path.insert(0, _Waiting())


class _Waiting(MetaPathFinder):
    """Finds Gymnasium as Python does, and registers after its import; then it is gone."""

    def find_spec(self, fullname: str, path: Any = None, target: Any = None) -> Optional[ModuleSpec]:
        if fullname != GYMNASIUM:
            return None
        sys.meta_path.remove(self)
        spec = importlib.util.find_spec(fullname)
        loader: Any = None if spec is None else spec.loader
        if loader is None:
            return spec
        execute = loader.exec_module

        def execute_and_register(module: Any) -> None:
            execute(module)
            register()

        loader.exec_module = execute_and_register
        return spec
