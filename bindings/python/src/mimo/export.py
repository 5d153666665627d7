"""Exports scenes to other programs: python -m mimo.export --usd infant.usdc --scene S."""

from __future__ import annotations

import argparse
import sys

from . import usd
from .errors import Error
from .scene import scenes
from .world import World


def main() -> int:
    """Writes the initial state of a scene."""
    parser = argparse.ArgumentParser(prog="python -m mimo.export", description="Writes a scene as a USD file.")
    parser.add_argument("--usd", required=True, metavar="FILE", help="file to write: .usdc, .usda, or .usdz")
    parser.add_argument("--scene", default="benchmark", help=f"one of {', '.join(scenes())}")
    parser.add_argument("--seed", type=int, default=0, help="of the start (0)")
    parser.add_argument("--age", type=float, help="of the infants, months")
    parser.add_argument("--face", help="of the infants")
    parser.add_argument("--segments", type=int, default=24, help="pieces of a circle (24)")
    asked = parser.parse_args()
    options = {name: getattr(asked, name) for name in ("age", "face") if getattr(asked, name) is not None}
    try:
        with World(asked.scene, vision=False, touch=False, **options) as world:
            world.reset(seed=asked.seed)
            written = usd.write(world, asked.usd, segments=asked.segments)
    except (Error, OSError, ValueError) as error:
        print(f"python -m mimo.export: {error}", file=sys.stderr)
        return 1
    print(f"wrote {', '.join(map(str, written[:2]))}{' ...' if len(written) > 2 else ''}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
