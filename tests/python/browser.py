"""A headless browser for tests of pages; what it lacks is a reason to skip them."""

import contextlib
import os
import shutil

import pytest

PROGRAMS = ("chromium", "chromium-browser", "google-chrome")
SOFTWARE = ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]  # a server has no GPU


@contextlib.contextmanager
def page(width=900, height=560):
    """A page of a browser, and a list of what goes wrong on it. MIMO_BROWSER names the browser's program."""
    playwright = pytest.importorskip("playwright.sync_api", reason="playwright is not installed")
    program = os.environ.get("MIMO_BROWSER") or next(filter(None, map(shutil.which, PROGRAMS)), None)
    if program is None:
        pytest.skip(f"no browser is installed: none of {', '.join(PROGRAMS)}, and MIMO_BROWSER names none")
    wrong = []
    with playwright.sync_playwright() as driver:
        browser = driver.chromium.launch(executable_path=program, args=SOFTWARE)
        opened = browser.new_page(viewport={"width": width, "height": height})
        opened.set_default_timeout(120_000)
        opened.on("pageerror", lambda error: wrong.append(str(error)))
        opened.on("console", lambda message: message.type == "error" and wrong.append(message.text))
        yield opened, wrong
        browser.close()
