"""The Python programs in the pages, and which part of ./dev test has what each of them needs."""

import ast
import re
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parents[2]
FENCED = re.compile(r"^```(?:python|py)\n(.*?)^```", re.DOTALL | re.MULTILINE)
INDENTED = re.compile(r"(?:^    .*\n(?:^\n(?=    ))*)+", re.MULTILINE)

# By what a program says; those that say nothing of it run with the package's own tests.
SUITES = {
    "files": r"\bpynwb\b|mimo\.lsl|\bfmpy\b",
    "ray": r"\bray\b",
    "learning": r"stable_baselines3",
    "mujoco": r"^import mujoco$",
    "shown": r"mimo\.(view|video|rerun|usd|plot)\b|\"human\"|h5py|mimo\.Record",
}
PLAIN = "plain"


class Program(NamedTuple):
    """A program as it stands in a page."""

    page: str
    number: int  # in its page, from 1 on
    code: str

    @property
    def suite(self):
        return next((suite for suite, words in SUITES.items() if re.search(words, self.code, re.MULTILINE)), PLAIN)


def pages(root):
    found = [root / "README.md", root / "bindings/python/README.md"]
    return found + sorted((root / "docs").glob("*.md")) + sorted((root / "docs/guide").glob("*.md"))


def programs(root):
    return [
        Program(str(page.relative_to(root)), number, code)
        for page in pages(root)
        for number, code in enumerate(FENCED.findall(page.read_text()), 1)
    ]


def hidden(root):
    """Python that would not be found, as it is indented, or called text."""
    for page in pages(root):
        text = page.read_text()
        blocks = re.findall(r"^```text\n(.*?)^```", text, re.DOTALL | re.MULTILINE)
        text = re.sub(r"^```.*?^```", "", text, flags=re.DOTALL | re.MULTILINE)
        blocks += ["\n".join(line[4:] for line in block.splitlines()) for block in INDENTED.findall(text)]
        for code in blocks:
            if re.search(r"\bmimo\b|^import |^from ", code, re.MULTILINE) and _parses(code):
                yield f"{page.relative_to(root)}: {code}"


def _parses(code):
    try:
        return bool(ast.parse(code).body)
    except SyntaxError:
        return False
