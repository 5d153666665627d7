"""The scenario of tests/capi/same.c, which gives the same hashes in every language.

Python is too slow for hashing byte by byte, so all blocks go to a file in the folder that is given, for
tests/same/fnv1a to hash; names of scenes and sums of rewards are printed.
"""

import sys
from pathlib import Path
from typing import Union

import numpy as np
from gymnasium.spaces import Box

import mimo


class Height(mimo.WorldTask):
    """The task "own" of tests/capi/same.c."""

    terms = ("height", "effort")
    fields = dict.fromkeys(("desired_goal", "achieved_goal"), Box(-np.inf, np.inf, (), np.float32))
    units = dict.fromkeys(fields, "m")
    frames = dict.fromkeys(fields, "world")
    memory = 1

    def reset(self, world: mimo.World, moment: mimo.Moment) -> None:
        moment.memory[0] = 0.2 + 0.2 * world.random(1)[0]
        moment.fields["desired_goal"][...] = moment.memory[0]

    def evaluate(self, world: mimo.World, moment: mimo.Moment) -> mimo.Judgement:
        hand, height = world.bodies("left_hand").position[0, 2], moment.memory[0]
        effort = 0.0
        for action in moment.action.astype(float):
            effort += action * action
        moment.fields["achieved_goal"][...] = hand
        return mimo.Judgement(terms={"height": hand - height, "effort": -0.01 * effort}, success=hand > height)


def scene_of(name: str) -> Union[str, mimo.Scene]:
    if name != "own":
        return name
    scene = mimo.Scene("benchmark")
    scene.add_agent(vision=False)
    scene.set_task(Height())
    return scene


def run(scene: str, folder: Path) -> None:
    with mimo.World(scene_of(scene)) as world, (folder / scene).open("wb") as file:
        motors = np.arange(len(world.action_names))
        world.reset(seed=7)
        file.write(world.block.tobytes())
        total = 0.0
        for step in range(100):
            total += world.step(((7 * step + 3 * motors) % 21 - 10) / 10).reward[0]
            file.write(world.block.tobytes())
    print(f"{scene} {total:.6f}")


def draw_stage(folder: Path) -> None:
    """The picture of tests/capi/same.c."""
    pixels = np.array([200, 30, 90, 20, 180, 60, 40, 80, 220, 250, 240, 130], np.uint8)
    texture = {"types": [mimo.TextureType.FLAT], "widths": [2], "heights": [2], "pixels": pixels, "srgb": [1]}
    stage = mimo.Stage(
        geoms={
            "object_type": 5,
            "forms": [mimo.Form.PLANE, mimo.Form.SPHERE],
            "sizes": [[0, 0, 0], [0.5, 0, 0]],
            "colors": [[1, 1, 1, 1], [0.9, 0.2, 0.1, 1]],
            "materials": [0, -1],
        },
        textures=texture,
        materials={"colors": [[1, 1, 1, 1]], "textures": [0]},
        lights={"types": [mimo.Lamp.SUN]},
    )
    poses = {
        "geom_positions": [[0, 0, 0], [0, 0, 0.5]],
        "geom_rotations": [np.eye(3), np.eye(3)],
        "light_positions": [[0, 0, 5]],
        "light_directions": [[0, 0.6, -0.8]],
    }
    view = mimo.StageView(width=64, height=48, position=[0, 0, 4], rotation=np.eye(3), depth=True, segmentation=True)
    picture = stage.draw(poses, view)
    parts = (picture.rgb, picture.depth, picture.segmentation)
    (folder / "stage").write_bytes(b"".join(part.tobytes() for part in parts))
    print(f"stage {picture.rgb.sum():.6f}")


for name in ("reach", "standup", "selfbody", "benchmark", "own"):
    run(name, Path(sys.argv[1]))
draw_stage(Path(sys.argv[1]))
