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
    ("mimo/HeadLift-v0", "head-lift"),
    ("mimo/ChestLift-v0", "chest-lift"),
    ("mimo/RollToBelly-v0", "roll-to-belly"),
    ("mimo/RollToBack-v0", "roll-to-back"),
    ("mimo/SitWithHands-v0", "sit-with-hands"),
    ("mimo/Sit-v0", "sit"),
    ("mimo/SitUp-v0", "sit-up"),
    ("mimo/HandsAndKnees-v0", "hands-and-knees"),
    ("mimo/Crawl-v0", "crawl"),
    ("mimo/PullToStand-v0", "pull-to-stand"),
    ("mimo/StandWithSupport-v0", "stand-with-support"),
    ("mimo/Stand-v0", "stand"),
    ("mimo/Cruise-v0", "cruise"),
    ("mimo/WalkWithHelp-v0", "walk-with-help"),
    ("mimo/Walk-v0", "walk"),
    ("mimo/HandToMouth-v0", "hand-to-mouth"),
    ("mimo/HandsTogether-v0", "hands-together"),
    ("mimo/FootGrasp-v0", "foot-grasp"),
    ("mimo/ReachMoving-v0", "reach-moving"),
    ("mimo/Lift-v0", "lift"),
    ("mimo/Bang-v0", "bang"),
    ("mimo/Drop-v0", "drop"),
    ("mimo/Follow-v0", "follow"),
    ("mimo/Prefer-v0", "prefer"),
    ("mimo/Mobile-v0", "mobile"),
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
