"""Draws models with mimo.Renderer and mujoco.Renderer in turns, and compares times and pictures.

    python -m mimo.bench_cameras                    # models of the packages that are installed, against OSMesa
    python -m mimo.bench_cameras --gl egl           # against a graphics card
    python -m mimo.bench_cameras robot.xml --camera wrist --depth
    python -m mimo.bench_cameras --compare          # which pictures of the packages' models differ, without times

One core draws, unless --cores says otherwise. Times are the shortest of --rounds turns: processor time on one core
without a graphics card, which what else runs on the machine disturbs little, otherwise time that passes.
"""

from __future__ import annotations

import argparse
import contextlib
import importlib
import importlib.util
import os
import time
from pathlib import Path
from typing import Any, Callable, Dict, Iterator, List, NamedTuple, Optional, Tuple

import numpy as np
from numpy.typing import NDArray

USUAL = {  # models that many know, by package
    "gymnasium": (
        *("envs/mujoco/assets/humanoid.xml", "envs/mujoco/assets/ant.xml", "envs/mujoco/assets/half_cheetah.xml"),
        *("envs/mujoco/assets/hopper.xml", "envs/mujoco/assets/walker2d_v5.xml"),
    ),
    "gymnasium_robotics": (
        "envs/assets/fetch/pick_and_place.xml",
        "envs/assets/hand/manipulate_block.xml",
    ),
    "robosuite": ("models/assets/robots/panda/robot.xml",),
    "dm_control": ("suite/humanoid.xml", "suite/quadruped.xml", "suite/cheetah.xml", "suite/dog.xml"),
}
WHOLE = {  # where packages keep models
    "gymnasium": "envs/mujoco/assets/*.xml",
    "gymnasium_robotics": "envs/assets/**/*.xml",
    "dm_control": "suite/*.xml",
}
MUCH = (2.0, 0.005, 0.005)  # what --compare lists: more than so many levels of 255, more than such a share of pixels
NEAR = 1e-3  # of the depth: what two renderers may differ by


class Outcome(NamedTuple):
    """What a model gave."""

    model: str
    triangles: int
    ours: float  # ms a picture
    theirs: float
    colours: float  # mean difference of 255
    depth: float  # share of pixels whose depth differs by more than NEAR of it
    objects: float  # share of pixels that show another object


def main(arguments: Optional[List[str]] = None) -> None:
    """Prints a table."""
    options = _options(arguments)
    if options.cores and hasattr(os, "sched_setaffinity"):
        os.sched_setaffinity(0, sorted(os.sched_getaffinity(0))[: options.cores])
    os.environ.setdefault("MUJOCO_GL", options.gl)
    mujoco: Any = importlib.import_module("mujoco")
    print(f"MuJoCo {mujoco.__version__}, {os.environ['MUJOCO_GL']}, {options.size} x {options.size} pixels")
    if options.compare:
        return print_differences(mujoco, options)
    print("| model | triangles | mimo, ms | mujoco, ms | times | difference | depth | objects |")
    print("|---|--:|--:|--:|--:|--:|--:|--:|")
    for file in options.files or list(installed()):
        try:
            outcome = measure(mujoco, file, options)
        except (ValueError, RuntimeError) as error:
            print(f"| {name_of(file)} | {str(error).splitlines()[0]} |")
            continue
        times = outcome.theirs / outcome.ours
        shares = f"{outcome.colours:.1f} | {outcome.depth:.2%} | {outcome.objects:.2%}"
        print(
            f"| {outcome.model} | {outcome.triangles} | {outcome.ours:.2f} | {outcome.theirs:.2f} "
            f"| {times:.1f} | {shares} |",
            flush=True,
        )


def _options(arguments: Optional[List[str]]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="python -m mimo.bench_cameras", description=__doc__.splitlines()[0])
    parser.add_argument("files", nargs="*", help="MJCF files; default: models of the packages that are installed")
    parser.add_argument("--camera", default=-1, help="a camera's name; default: the free one")
    parser.add_argument("--compare", action="store_true", help="list the models' pictures that differ much")
    parser.add_argument("--slices", type=int, help="of which MuJoCo makes round things; default: as the model says")
    parser.add_argument("--size", type=int, default=256, help="width and height, pixels (%(default)s)")
    parser.add_argument("--gl", default="osmesa", choices=["osmesa", "egl", "glfw"], help="MUJOCO_GL (%(default)s)")
    parser.add_argument("--depth", action="store_true", help="measure a colour and a depth picture, not a colour one")
    parser.add_argument("--steps", type=int, default=20, help="physics steps before the picture (%(default)s)")
    parser.add_argument("--rounds", type=int, default=7, help="turns (%(default)s)")
    parser.add_argument("--cores", type=int, default=1, help="cores that draw, 0 for all (%(default)s)")
    return parser.parse_args(arguments)


def installed() -> Iterator[str]:
    """Models of packages."""
    for package, files in USUAL.items():
        spec = importlib.util.find_spec(package)
        for folder in (spec.submodule_search_locations or []) if spec else []:
            yield from (str(Path(folder) / file) for file in files if (Path(folder) / file).is_file())


def print_differences(mujoco: Any, options: argparse.Namespace) -> None:
    """Prints a table of the pictures that differ by more than MUCH, of the free camera and the first two others."""
    print("| model | camera | difference | depth | objects |\n|---|---|--:|--:|--:|")
    count = 0
    for file in options.files or every():
        try:
            model, data = load(mujoco, file, options.steps)
        except (ValueError, RuntimeError):  # a part of a model
            continue
        if not model.ngeom:
            continue
        model.vis.quality.offsamples = 0
        with renderers(mujoco, model, options) as (ours, theirs):
            for camera in range(-1, min(model.ncam, 2)):
                count += 1
                found = compare(*(pictures(one, data, camera) for one in (ours, theirs)))
                if any(one > most for one, most in zip(found, MUCH)):
                    shares = f"{found[0]:.1f} | {found[1]:.2%} | {found[2]:.2%}"
                    print(f"| {name_of(file)} | {'free' if camera < 0 else camera} | {shares} |", flush=True)
    print(f"of {count} pictures")


def every() -> Iterator[str]:
    """All models of packages, and parts of models."""
    for package, pattern in WHOLE.items():
        spec = importlib.util.find_spec(package)
        for folder in (spec.submodule_search_locations or []) if spec else []:
            yield from sorted(map(str, Path(folder).glob(pattern)))


@contextlib.contextmanager
def renderers(mujoco: Any, model: Any, options: argparse.Namespace) -> Iterator[Tuple[Any, Any]]:
    """Ours and MuJoCo's."""
    from .renderer import Renderer

    model.vis.global_.offwidth = max(model.vis.global_.offwidth, options.size)
    model.vis.global_.offheight = max(model.vis.global_.offheight, options.size)
    if options.slices:
        model.vis.quality.numslices = model.vis.quality.numstacks = options.slices
    with Renderer(model, options.size, options.size, threads=options.cores) as ours:
        theirs = mujoco.Renderer(model, options.size, options.size)
        try:
            yield ours, theirs
        finally:
            with contextlib.suppress(Exception):  # MuJoCo before 3.0 has no close
                theirs.close()


def name_of(file: str) -> str:
    """A file's name with its package's."""
    parts = Path(file).parts
    package = next((part for part in parts if part in USUAL), "")
    return f"{package} {Path(file).stem}".strip()


def load(mujoco: Any, file: str, steps: int) -> Tuple[Any, Any]:
    """A model and its state after some steps."""
    model = mujoco.MjModel.from_xml_path(file)
    data = mujoco.MjData(model)
    if model.nkey:
        mujoco.mj_resetDataKeyframe(model, data, 0)
    mujoco.mj_forward(model, data)
    for _ in range(steps):
        mujoco.mj_step(model, data)
    mujoco.mj_forward(model, data)
    return model, data


def measure(mujoco: Any, file: str, options: argparse.Namespace) -> Outcome:
    """Draws a model in turns."""
    model, data = load(mujoco, file, options.steps)
    camera = options.camera
    with renderers(mujoco, model, options) as (ours, theirs):
        clock = time.process_time if options.cores == 1 and options.gl == "osmesa" else time.perf_counter
        draws = [drawing(one, data, camera, options.depth) for one in (ours, theirs)]
        times = in_turns(draws, options.rounds, clock)
        differences = compare(*(pictures(one, data, camera) for one in (ours, theirs)))
    triangles = int(model.mesh_facenum[model.geom_dataid[model.geom_type == int(mujoco.mjtGeom.mjGEOM_MESH)]].sum())
    return Outcome(name_of(file), triangles, times[0], times[1], *differences)


def drawing(renderer: Any, data: Any, camera: Any, depth: bool) -> Callable[[], None]:
    """A function that draws one picture, or colours and depth."""

    def draw() -> None:
        renderer.update_scene(data, camera)
        renderer.render()
        if depth:
            renderer.enable_depth_rendering()
            renderer.render()
            renderer.disable_depth_rendering()

    return draw


def in_turns(draws: List[Callable[[], None]], rounds: int, clock: Callable[[], float]) -> List[float]:
    """The shortest time of each, ms: each draws for about 30 ms before it is the other's turn."""
    counts = []
    for draw in draws:
        draw()
        begin = clock()
        draw()
        counts.append(max(1, int(0.03 / (clock() - begin))))
    shortest = [np.inf] * len(draws)
    for _ in range(rounds):
        for k, (draw, count) in enumerate(zip(draws, counts)):
            begin = clock()
            for _ in range(count):
                draw()
            shortest[k] = min(shortest[k], (clock() - begin) / count)
    return [1e3 * one for one in shortest]


def pictures(renderer: Any, data: Any, camera: Any) -> Dict[str, NDArray[Any]]:
    """Colours, depth and objects."""
    renderer.update_scene(data, camera)
    drawn = {"colours": renderer.render()}
    renderer.enable_depth_rendering()
    drawn["depth"] = renderer.render()
    renderer.disable_depth_rendering()
    renderer.enable_segmentation_rendering()
    drawn["objects"] = renderer.render()
    renderer.disable_segmentation_rendering()
    return drawn


def compare(ours: Dict[str, NDArray[Any]], theirs: Dict[str, NDArray[Any]]) -> Tuple[float, float, float]:
    """The mean difference of colours, and the shares of pixels with another depth and another object."""
    colours = np.abs(ours["colours"].astype(int) - theirs["colours"]).mean()
    deeper = np.abs(ours["depth"] - theirs["depth"]) > NEAR * theirs["depth"]
    others = (ours["objects"] != theirs["objects"]).any(axis=2)
    return float(colours), float(deeper.mean()), float(others.mean())


if __name__ == "__main__":
    main()
