#!/usr/bin/env python3
"""Draws the viewer's page in a headless browser, wide, in a notebook's cell and on a phone; and a recording's figures.

Needs mimo[view,plot], playwright, chromium, and the program mimo in PATH.
PYTHONPATH=tests/python python docs/images/make_viewer.py
"""

import subprocess
import sys
import tempfile
import time
from pathlib import Path

import browser
import numpy as np
from PIL import Image

import mimo
import mimo.plot
from mimo import view

HERE = Path(__file__).resolve().parent
WIDE, NOTEBOOK, PHONE = (1280, 720), (900, 600), (390, 844)
COLORS = 256  # of a picture, so that it stays small
GAP = 20  # pixels


def shot(viewer: view.Viewer, size: tuple, path: Path) -> Image.Image:
    with browser.page(*size) as (page, _):
        page.goto(viewer.url)
        page.locator(".mantine-Notification-root button").first.click()  # that there is no GPU
        time.sleep(12)
        page.screenshot(path=path)
    return Image.open(path).convert("RGB")


def save(picture: Image.Image, name: str) -> None:
    picture.quantize(COLORS, kmeans=2).save(HERE / name, optimize=True)


def draw_pages(folder: Path) -> None:
    with view.Viewer(view.Live("playdate"), seed=3) as viewer:
        viewer.clock.paused = True
        for _ in range(120):  # 1.2 s
            viewer.clock.step_once()
            viewer.frame()
        viewer.run_beside()
        save(shot(viewer, WIDE, folder / "wide.png"), "viewer.png")
        pages = [shot(viewer, size, folder / "narrow.png") for size in (NOTEBOOK, PHONE)]
    both = Image.new("RGB", (sum(page.width for page in pages) + GAP, PHONE[1]), "white")
    both.paste(pages[0], (0, (PHONE[1] - NOTEBOOK[1]) // 2))
    both.paste(pages[1], (NOTEBOOK[0] + GAP, 0))
    save(both, "viewer-narrow.png")


def draw_figures(folder: Path) -> None:
    run = ["mimo", "record", "--scene", "benchmark", "--senses", "hearing", "--seconds", "6", "--seed", "3", "--out"]
    subprocess.run([*run, folder / "run.h5"], check=True, stdout=subprocess.DEVNULL)
    subprocess.run([sys.executable, "-m", "mimo.plot", folder / "run.h5", "--out", folder / "run.png"], check=True)
    save(Image.open(folder / "run.png").convert("RGB").reduce(2), "figure_run.png")
    with mimo.World("benchmark", vision=False) as world:
        world.reset(seed=1)
        for _ in range(200):  # it falls on its back
            world.step(np.zeros(len(world.action_names)))
        mimo.plot.touch_map(world).savefig(folder / "touch.png", dpi=110)
    save(Image.open(folder / "touch.png").convert("RGB"), "figure_touch.png")


def main() -> None:
    with tempfile.TemporaryDirectory() as folder:
        draw_pages(Path(folder))
        draw_figures(Path(folder))


if __name__ == "__main__":
    main()
