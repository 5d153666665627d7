#!/usr/bin/env python3
"""make_cameras.py: draws cameras.png, two models by mujoco.Renderer on OSMesa and by mimo.Renderer.

Needs mimo, mujoco, gymnasium, gymnasium_robotics and Pillow.
"""

import importlib.util
import os
from pathlib import Path
from typing import Any

os.environ["MUJOCO_GL"] = "osmesa"

import mujoco
import numpy as np
from PIL import Image

import mimo

SIZE = (240, 320)
# Package, file, and the free camera's distance, azimuth, elevation and the point that it looks at.
SHOWN = (
    ("gymnasium", "envs/mujoco/assets/humanoid.xml", (3.2, 140, -12, (0, 0, 1.1))),
    ("gymnasium_robotics", "envs/assets/hand/manipulate_block.xml", (0.55, 55, -35, (1.0, 0.87, 0.17))),
)


def drawn(renderer: Any, data: Any, camera: Any) -> np.ndarray:
    renderer.update_scene(data, camera)
    return renderer.render()


def main() -> None:
    rows = []
    for package, file, (distance, azimuth, elevation, point) in SHOWN:
        folder = Path(importlib.util.find_spec(package).submodule_search_locations[0])
        model = mujoco.MjModel.from_xml_path(str(folder / file))
        data = mujoco.MjData(model)
        mujoco.mj_forward(model, data)
        camera = mujoco.MjvCamera()
        camera.distance, camera.azimuth, camera.elevation, camera.lookat[:] = distance, azimuth, elevation, point
        theirs = mujoco.Renderer(model, *SIZE)
        with mimo.Renderer(model, *SIZE, samples=4) as ours:
            rows.append(np.hstack([drawn(theirs, data, camera), drawn(ours, data, camera)]))
        theirs.close()
    Image.fromarray(np.vstack(rows)).quantize(128).save(Path(__file__).with_name("cameras.png"), optimize=True)


if __name__ == "__main__":
    main()
