"""The README's commands exist and its programs print what it says; tests/package and tests/consumer follow the rest."""

import contextlib
import io
import re
import shlex
import subprocess
import sys

import pytest
import recorded


@pytest.fixture(scope="module")
def readme(root):
    return (root / "README.md").read_text(encoding="utf-8")


def commands(text):
    """What the reader is to type: indented lines, and words in code that begin with a program's name."""
    text = re.sub(r"^```.*?^```", "", text, flags=re.DOTALL | re.MULTILINE)
    lines = re.findall(r"^    (\S.*)", text, re.MULTILINE)
    lines += re.findall(r"`((?:\./dev|pip|cc|cmake|apt|build/bin/mimo)[ /][^`]*)`", text)
    parts = [part.strip() for line in lines for part in line.split("  #")[0].split("&&")]
    return [shlex.split(part) for part in dict.fromkeys(parts)]


def follow_dev(root, words, folder):
    """./dev knows the command and its options; what it does is the matter of other tests."""
    done = subprocess.run([sys.executable, "-m", "tools", words[0], "--help"], cwd=root, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    for option in (word for word in words[1:] if word.startswith("--")):
        assert option in done.stdout, f"./dev {words[0]} has no {option}"


def follow_program(root, words, folder):
    short = ["0.05" if before == "--seconds" else word for before, word in zip(["", *words], words)]
    done = subprocess.run([recorded.program(), *short], cwd=folder, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert done.stdout.strip()
    if "--out" in words:
        assert len(list((folder / words[words.index("--out") + 1]).glob("*.png"))) == 12


def follow_pip(root, words, folder):
    assert words[0] == "install"
    assert (root / words[1] / "pyproject.toml").is_file()


def elsewhere(root, words, folder):
    """consumer.readme compiles the program; ./dev test --package installs packages."""


FOLLOWED = {
    "./dev": follow_dev,
    "build/bin/mimo": follow_program,
    "pip": follow_pip,
    "cc": elsewhere,
    "cmake": elsewhere,
    "apt": elsewhere,
    "cd": elsewhere,
}


def test_commands(readme, root, tmp_path):
    if sys.version_info < (3, 11):
        pytest.skip("./dev needs Python 3.11")
    found = commands(readme)
    assert len(found) >= 10
    for words in found:
        assert words[0] in FOLLOWED, f"no test follows {shlex.join(words)}"
        FOLLOWED[words[0]](root, words[1:], tmp_path)


def test_program_prints_what_the_page_says(readme):
    (code,) = re.findall(r"^```python\n(.*?)^```", readme, re.DOTALL | re.MULTILINE)
    said = io.StringIO()
    with contextlib.redirect_stdout(said):
        exec(code, {})
    assert f"It prints `{said.getvalue().strip()}`" in readme


def test_numbers_of_senses(readme):
    import mimo

    everything = {"senses": "all", "hearing": True, "vision_width": 8, "vision_height": 8}
    with mimo.World("benchmark", **everything) as world:
        assert f"{len(world.layout.fields)} fields of senses" in readme
        assert f"{world.layout.fields['touch/force'].receptors:,} sensors of the skin" in readme
        assert f"{len(world.action_names)} motors" in readme
    with mimo.World("benchmark", vision=False, touch=False, actuation="muscle") as world:
        assert f"{len(world.action_names)} muscles" in readme
