"""The tutorials: their programs run, print what the pages say, and draw the pictures that the pages show."""

import importlib.util
import re

import guides
import pytest

TUTORIALS = sorted((guides.ROOT / "docs/tutorials").glob("*.md"))
_spec = importlib.util.spec_from_file_location("make_tutorials", guides.ROOT / "docs/make_tutorials.py")
make_tutorials = importlib.util.module_from_spec(_spec)
_spec.loader.exec_module(make_tutorials)


def suite(page):
    """The part of ./dev test that has what the page needs."""
    code = "\n".join(code for code, _ in make_tutorials.programs(page))
    return "learning" if re.search(guides.SUITES["learning"], code) else guides.PLAIN


def pytest_generate_tests(metafunc):
    if "page" in metafunc.fixturenames:
        chosen = [page for page in TUTORIALS if suite(page) == metafunc.config.getoption("guides")]
        metafunc.parametrize("page", chosen, ids=[page.stem for page in chosen])


def test_tutorial(page, tmp_path, monkeypatch):
    monkeypatch.setenv("MPLBACKEND", "Agg")
    monkeypatch.setenv("MIMO_DATA", str(guides.ROOT / "docs/data"))
    pieces = make_tutorials.programs(page)
    if any("PIL" in code for code, _ in pieces):
        pytest.importorskip("PIL", reason="Pillow is not installed")
    printed = make_tutorials.run(page, tmp_path)
    if suite(page) == guides.PLAIN:  # what is learned depends on the release of PyTorch
        assert printed == [said for _, said in pieces]
    text = page.read_text(encoding="utf-8")
    for name in make_tutorials.PICTURE.findall(text):
        assert (tmp_path / name).stat().st_size > 10_000
        assert (make_tutorials.IMAGES / name).is_file()


def test_training_helps(page):
    """The tutorial of learning says how often the ball was touched before and after."""
    text = page.read_text(encoding="utf-8")
    touched = [int(number) for number in re.findall(r"touched in (\d+) of 16 episodes\n", text)]
    assert not touched or touched[0] < touched[1]


def test_program_in_c_is_the_example():
    text = (guides.ROOT / "docs/tutorials/embed.md").read_text(encoding="utf-8")
    (program,) = re.findall(r"^```c\n(.*?)^```", text, re.DOTALL | re.MULTILINE)
    assert program == (guides.ROOT / "examples/c/engine_loop.c").read_text(encoding="utf-8")


@pytest.mark.parametrize("tutorial", TUTORIALS, ids=[page.stem for page in TUTORIALS])
def test_a_page_for_readers_links_it(tutorial):
    """The site takes the order of tutorials from these links."""
    readers = (guides.ROOT / "docs/readers").glob("*.md")
    assert any(f"../tutorials/{tutorial.name}" in page.read_text(encoding="utf-8") for page in readers)


@pytest.mark.parametrize("tutorial", TUTORIALS, ids=[page.stem for page in TUTORIALS])
def test_page_says_what_the_reader_will_have(tutorial):
    assert tutorial.read_text(encoding="utf-8").splitlines()[2].startswith("**At the end")
