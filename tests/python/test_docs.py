"""Pages that are generated from the library, and names that pages use."""

import importlib.util
import re

import gymnasium

import mimo
from mimo.options import EnvOptions, enums


def test_the_body_s_names(root):
    spec = importlib.util.spec_from_file_location("make_body", root / "docs" / "make_body.py")
    make_body = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(make_body)
    assert make_body.PAGE.read_text() == make_body.page(), "python docs/make_body.py writes it anew"


def test_names_of_the_original_on_its_page(root):
    page = (root / "docs" / "coming-from-mimo.md").read_text()
    worlds = [
        mimo.World(name, vision=True, vision_width=8, vision_height=8, vestibular=True)
        for name in ("catch", "selfbody")
    ]
    fields = {
        name for world in [*worlds, mimo.World("free", vision_width=8, vision_height=8)] for name in world.layout.fields
    }
    known = fields | set(mimo.Scene("reach").parameters) | set(gymnasium.registry)
    families = "proprioception|vestibular|touch|vision|task|reach|standup|selfbody|catch|mimo"
    named = set(re.findall(rf"\b(?:{families})/\w+(?:-v\d)?", re.sub(r"\(.*?\)", "", page))) - {"mimo/Reach"}
    assert len(named) > 20
    assert named <= known
    for option in re.findall(r"`(\w+)=", page.split("## Options of an environment")[1].split("## Observations")[0]):
        if option not in ("proprio_params", "touch_params", "vision_params", "actuation_model"):
            assert option in {*enums(EnvOptions), "touch_function", "response_function"}
    for name, steps in re.findall(r"`mimo/(\w+)-v0` \| (\d+) \|", page):
        assert mimo.Scene("reach").parameters[f"{name.lower()}/episode_steps"] == int(steps)
    faces = page.split("| face of the original")[1].split("## Learning")[0]
    assert set(re.findall(r"`(\w+)`", faces)) == set(mimo.faces())


def test_parameters_in_documents_exist(root):
    parameters = set(mimo.Scene("reach").parameters)
    tasks = "|".join(sorted({name.split("/")[0] for name in parameters}))
    for page in [root / "README.md", *sorted((root / "docs").rglob("*.md"))]:
        named = set(re.findall(rf"`(?:{tasks})/[a-z_]+", page.read_text()))
        assert {name.lstrip("`") for name in named} <= parameters, page.name
    differences = (root / "docs" / "differences.md").read_text()
    assert "`catch/jitter`" in differences
