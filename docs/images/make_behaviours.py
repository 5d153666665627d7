#!/usr/bin/env python3
"""make_behaviours.py [SCENE...]: draws behaviours/SCENE.png, moments of an episode of each built-in behaviour.

The infant is as old as the middle infant that shows the behaviour, or 18 months where that is not known. Where
examples/policies has a policy of the scene's name, it acts as learned. Otherwise it does what came furthest of 64
trials: each sends random commands to its motors, new ones every 0.3 s, from none to all of its strength.
"""

import sys
from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw

import mimo

IMAGES = Path(__file__).resolve().parent / "behaviours"
POLICIES = IMAGES.parents[2] / "examples/policies"
SIDE, MOMENTS, CAPTION = 190, 5, 14  # pixels
SECONDS, TRIALS, HELD = 3.0, 64, 0.3
COLOURS = 48  # of a strip's palette
# From where the camera looks.
USUAL = {"azimuth": 125, "elevation": -14}
VIEWS = {
    "follow": {"azimuth": 160, "elevation": -8},
    "prefer": {"azimuth": 35, "elevation": -20},
    "drop": {"elevation": -25},
}
# What the camera sees beside the infant.
THINGS = {"follow": ("target",), "mobile": ("mobile",)}


def scene_of(name):
    """The scene with its infant, and the infant's age in months."""
    scene = mimo.Scene(name)
    norm = scene.behaviour().norm
    age = norm.age or 18
    scene.add_agent(age=age, vision=0, touch=0)
    return scene, age


def step_of(world):
    """Seconds."""
    return world.timestep * world.frame_skip


def scripts(low, high, worlds, steps, step_seconds):
    """Random commands of each trial in each step; the first trial rests, the last uses all of its strength."""
    random = np.random.default_rng(0)
    pieces = int(np.ceil(steps * step_seconds / HELD))
    strength = np.linspace(0, 1, worlds)[:, None]
    drawn = strength * random.uniform(low, high, (pieces, worlds, len(low)))
    at = (np.arange(steps) * step_seconds / HELD).astype(int)
    return drawn[at].astype(np.float32)


def best_script(scene, world):
    """The commands of the trial with the most reward, and the seed of its episode."""
    steps = round(SECONDS / step_of(world))
    batch = mimo.Batch(scene, TRIALS)
    batch.reset(seeds=1)
    commands = scripts(world.action_low, world.action_high, TRIALS, steps, step_of(world))
    rewards = np.zeros(TRIALS)
    for command in commands:
        batch.step(command)
        rewards += batch.reward.reshape(TRIALS)
    best = int(rewards.argmax())
    return commands[:, best], 1 + best


def learned(world, file):
    """What the policy does, step by step."""
    policy = mimo.Policy.load(file)
    policy.attach(world)
    while not (world.terminated or world.truncated):
        yield policy.act(world.observation, world.action_low, world.action_high, world.time)


def episode(name):
    """The world after it, the infant's age, and state, seconds and measure of each of its steps, first of its start."""
    scene, age = scene_of(name)
    world = mimo.World(scene)
    file = POLICIES / f"{name}.json"
    commands, seed = (None, 1) if file.is_file() else best_script(scene, world)
    world.reset(seed=seed)

    def moment():
        return world.save(), world.time, world.get(mimo.Quantity.AGENT_ACHIEVED, [0]).ravel()[0]

    moments = [moment()]
    for command in learned(world, file) if commands is None else commands:
        world.step(command)
        moments.append(moment())
    return world, age, moments


def frame_of(world, things):
    """The middle of the infant's head, hip, hands and feet and of these things, and how far from it the farthest is."""
    ends = ("head", "hip", "left_foot", "right_foot", "left_hand", "right_hand", *things)
    places = np.array([world.bodies(body).position.ravel() for body in ends])
    middle = (places.min(axis=0) + places.max(axis=0)) / 2
    return tuple(middle), np.linalg.norm(places - middle, axis=1).max()


def frames_of(world, moments, things):
    """The camera goes with the infant, and sees all of it in all pictures."""
    frames = []
    for state, _, _ in moments:
        world.load(state)
        frames.append(frame_of(world, things))
    distance = 2.1 * max(reach for _, reach in frames) + 0.5
    return [{"look_at": middle, "distance": distance} for middle, _ in frames]


def strip(name):
    world, age, moments = episode(name)
    unit = mimo.Scene(name).behaviour().unit
    moments = [moments[index] for index in np.linspace(0, len(moments) - 1, MOMENTS).round().astype(int)]
    sheet = Image.new("RGB", (MOMENTS * SIDE, SIDE + CAPTION), "white")
    draw = ImageDraw.Draw(sheet)
    for column, (moment, frame) in enumerate(zip(moments, frames_of(world, moments, THINGS.get(name, ())))):
        state, seconds, measure = moment
        world.load(state)
        view = {**USUAL, **frame, **VIEWS.get(name, {})}
        picture = Image.fromarray(world.render(width=2 * SIDE, height=2 * SIDE, **view))
        sheet.paste(picture.resize((SIDE, SIDE), Image.Resampling.LANCZOS), (column * SIDE, 0))
        start = f"{age:g} months, " if column == 0 else ""
        draw.text((column * SIDE + 3, SIDE + 1), f"{start}{seconds:.1f} s: {round(measure, 3) + 0.0:g} {unit}", "black")
    IMAGES.mkdir(exist_ok=True)
    sheet.quantize(COLOURS).save(IMAGES / f"{name}.png", optimize=True)


def main():
    for name in sys.argv[1:] or [name for name in mimo.scenes() if is_behaviour(name)]:
        strip(name)


def is_behaviour(name):
    try:
        mimo.Scene(name).behaviour()
    except mimo.NotFoundError:
        return False
    return True


if __name__ == "__main__":
    main()
