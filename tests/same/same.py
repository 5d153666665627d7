"""The scenario of tests/capi/same.c, which gives the same hashes in every language.

Python is too slow for hashing byte by byte, so all blocks go to a file in the folder that is given, for
tests/same/fnv1a to hash; names of scenes and sums of rewards are printed.
"""

import sys
from pathlib import Path

import numpy as np

import mimo


def run(scene: str, folder: Path) -> None:
    with mimo.World(scene) as world, (folder / scene).open("wb") as file:
        motors = np.arange(len(world.action_names))
        world.reset(seed=7)
        file.write(world.block.tobytes())
        total = 0.0
        for step in range(100):
            total += world.step(((7 * step + 3 * motors) % 21 - 10) / 10).reward[0]
            file.write(world.block.tobytes())
    print(f"{scene} {total:.6f}")


for name in ("reach", "standup", "selfbody", "benchmark"):
    run(name, Path(sys.argv[1]))
