#!/usr/bin/env python3
"""make_infant.py: draws infant.webp of the README, an infant that moves among toys: its room, its eyes, its skin.

Needs Pillow and matplotlib, and the package mimo.
"""

import io
from pathlib import Path

import matplotlib as mpl
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import LogNorm
from PIL import Image, ImageDraw, ImageFont

import mimo
import mimo.plot
from mimo.body_map import BodyMap

OUT = Path(__file__).resolve().parent / "infant.webp"
ROOM, EYE, SKIN = (560, 420), 210, 300  # pixels
LABELS = [
    ("left eye", ROOM[0] + 6, 4),
    ("right eye", ROOM[0] + 6, EYE + 4),
    ("skin, front and back", ROOM[0] + EYE + 78, 4),
]
FORCES = LogNorm(0.1, 10)
SECONDS, RATE = 6.0, 12.5  # pictures a second
FONT = ImageFont.truetype(Path(mpl.get_data_path()) / "fonts/ttf/DejaVuSans.ttf", 13)


def course(time, motors):
    """Commands of all motors, smooth and different for each, and the same at the end as at the beginning."""
    random = np.random.default_rng(4)
    phase = random.uniform(0, 2 * np.pi, (3, motors))
    turns = random.integers(1, 5, (3, motors))
    return np.sin(2 * np.pi * turns * time / SECONDS + phase).mean(axis=0)


def skin(body, force):
    """The sensors from the front and the back, coloured by the force on each."""
    figure = plt.figure(figsize=(SKIN / 100, ROOM[1] / 100), dpi=100, facecolor="white")
    axes = figure.add_axes((0.02, 0.13, 0.96, 0.83))
    axes.scatter(*body.places[:, :2].T, s=1.2, color="0.75", linewidths=0)
    felt = np.flatnonzero(force > 0)
    felt = felt[np.argsort(force[felt])]
    points = axes.scatter(*body.places[felt, :2].T, s=9, c=force[felt], cmap=mimo.plot.HEAT, norm=FORCES, linewidths=0)
    axes.set(aspect="equal", xlim=(-0.02, body.width + 0.02), ylim=(-0.02, 1.02))
    axes.set_axis_off()
    bar = figure.colorbar(points, cax=figure.add_axes((0.32, 0.09, 0.36, 0.02)), orientation="horizontal")
    bar.set_ticks([0.1, 1, 10], labels=["0.1", "1", "10 N"])
    bar.ax.tick_params(labelsize=9, length=0, which="both")
    drawn = io.BytesIO()
    figure.savefig(drawn)
    plt.close(figure)
    return Image.open(drawn).convert("RGB")


def main():
    world = mimo.World("babybench-cubes", touch=True, vision_width=EYE, vision_height=EYE, samples=4)
    world.reset(seed=1)
    body, pictures = BodyMap(world), []
    low, high = world.action_low, world.action_high
    steps = round(1 / RATE / (world.timestep * world.frame_skip))
    for picture in range(round(SECONDS * RATE)):
        for step in range(steps):
            time = (picture * steps + step) * world.timestep * world.frame_skip
            world.step((low + high) / 2 + (high - low) / 2 * 0.6 * course(time, len(low)))
        seen = world.observe()
        sheet = Image.new("RGB", (ROOM[0] + EYE + SKIN, ROOM[1]), "white")
        room = world.render(
            width=ROOM[0], height=ROOM[1], look_at=(0.08, -0.02, 0.17), distance=0.95, azimuth=152, elevation=-16
        )
        sheet.paste(Image.fromarray(room), (0, 0))
        for row, side in enumerate(("left", "right")):
            sheet.paste(Image.fromarray(np.asarray(seen[f"vision/eye_{side}"])), (ROOM[0], row * EYE))
        sheet.paste(skin(body, body.force_in(seen)), (ROOM[0] + EYE, 0))
        draw = ImageDraw.Draw(sheet)
        for text, x, y in LABELS:
            draw.text((x, y), text, fill="black", font=FONT)
        pictures.append(sheet)
    pictures[0].save(
        OUT, save_all=True, append_images=pictures[1:], duration=round(1000 / RATE), loop=0, quality=70, method=6
    )
    print(f"{OUT.name}: {len(pictures)} pictures, {OUT.stat().st_size / 1e6:.2f} MB")


if __name__ == "__main__":
    main()
