#!/usr/bin/env python3
"""make_eyes.py [MIMO]: draws maturity_eyes.png, the same view of eyes of six ages, and fovea.png. Needs Pillow."""

import subprocess
import sys
import tempfile
from pathlib import Path

from PIL import Image

AGES = (0, 1, 3, 6, 12, 24)
SIDE = 256
IMAGES = Path(__file__).resolve().parent


def seen(program: str, folder: str, age: float, *options: str) -> Image.Image:
    """What the left eye of the infant of 18 months sees with eyes of an age: the view stays the same."""
    out = Path(folder) / f"{age}.png"
    look = ["--scene", "playdate", "--camera", "anna/eye_left", "--width", str(SIDE), "--height", str(SIDE)]
    subprocess.run(
        [program, "render", "--age", "18", "--physiological-age", str(age), *look, *options, "--out", out], check=True
    )
    return Image.open(out)


def main() -> None:
    program = sys.argv[1] if len(sys.argv) > 1 else str(IMAGES.parents[1] / "build/bin/mimo")
    sheet = Image.new("RGB", (3 * SIDE, 2 * SIDE))
    with tempfile.TemporaryDirectory() as folder:
        for i, age in enumerate(AGES):
            sheet.paste(seen(program, folder, age), (i % 3 * SIDE, i // 3 * SIDE))
        pair = Image.new("RGB", (2 * SIDE, SIDE))
        pair.paste(seen(program, folder, 18), (0, 0))
        pair.paste(seen(program, folder, 18, "--foveation", "10"), (SIDE, 0))
    pair.save(IMAGES / "fovea.png", optimize=True)
    sheet.save(IMAGES / "maturity_eyes.png", optimize=True)


if __name__ == "__main__":
    main()
