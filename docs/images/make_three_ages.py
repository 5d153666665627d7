#!/usr/bin/env python3
"""make_three_ages.py: draws three_ages.png, six moments of learned rolling at three ages. Needs Pillow."""

from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw

import mimo

IMAGES = Path(__file__).resolve().parent
POLICY = IMAGES.parents[1] / "examples/policies/roll-to-belly.json"
AGES, SEED, SIDE, MOMENTS, SECONDS = (3, 6, 12), 0, 180, 6, 1.5
VIEW = {"azimuth": 125, "elevation": -25, "distance": 1.1, "look_at": (0, 0, 0.08)}


def episode(policy, age):
    """Seconds and picture of moments at equal distances, the first and the last included."""
    world = mimo.World(policy.scene, age=age, maturity=["body", "delays"], touch=False, vision=False)
    policy.attach(world)
    world.reset(seed=SEED)
    step = world.timestep * world.frame_skip
    for moment in np.linspace(0, SECONDS, MOMENTS):
        while world.time < moment - step / 2:
            world.step(policy.act(world.observation, world.action_low, world.action_high, world.time))
        yield moment, Image.fromarray(world.render(width=2 * SIDE, height=2 * SIDE, **VIEW))


def main():
    policy = mimo.Policy.load(POLICY)
    sheet = Image.new("RGB", (MOMENTS * SIDE, len(AGES) * SIDE))
    for row, age in enumerate(AGES):
        for column, (moment, picture) in enumerate(episode(policy, age)):
            small = picture.resize((SIDE, SIDE), Image.Resampling.LANCZOS)
            ImageDraw.Draw(small).text((5, 4), f"{age} months, {moment:g} s", fill=(20, 20, 20))
            sheet.paste(small, (column * SIDE, row * SIDE))
    sheet.quantize(96, dither=Image.Dither.NONE).save(IMAGES / "three_ages.png", optimize=True)


if __name__ == "__main__":
    main()
