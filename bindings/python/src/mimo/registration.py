"""The names of Gymnasium's registry, and their registration as soon as Gymnasium is imported."""

from __future__ import annotations

from typing import List, Tuple

from .importing import when_imported

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
    when_imported(GYMNASIUM, register)
