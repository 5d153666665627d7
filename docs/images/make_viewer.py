#!/usr/bin/env python3
"""Draws viewer.png, the viewer's page in a headless browser. Needs mimo[view], playwright, chromium.

PYTHONPATH=tests/python python docs/images/make_viewer.py
"""

import time
from pathlib import Path

import browser
from PIL import Image

from mimo import view

HERE = Path(__file__).resolve().parent
SIZE = (1200, 640)
COLORS = 256  # of the picture, so that it stays small


def main() -> None:
    viewer = view.open("playdate", seed=3)
    with browser.page(*SIZE) as (page, _):
        page.goto(viewer.url)
        page.get_by_role("button", name="Reset").click()
        time.sleep(2.5)
        page.get_by_role("button", name="Pause").click()
        page.locator(".mantine-Notification-root button").first.click()  # that there is no GPU
        time.sleep(10)
        page.screenshot(path=HERE / "viewer.png")
    viewer.close()
    picture = Image.open(HERE / "viewer.png").convert("RGB").quantize(COLORS)
    picture.save(HERE / "viewer.png", optimize=True)


if __name__ == "__main__":
    main()
