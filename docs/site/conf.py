"""Settings of Sphinx for `./dev docs`, which lays out the pages in build/docs/pages and runs it there (tools/site.py).

Pages are read as they stand in the repository; only where their links lead is changed while they are read, and the
contents at the side are added.
"""

import re
from pathlib import Path
from posixpath import dirname, join, normpath

from autoapi._parser import Parser

ROOT = Path(__file__).resolve().parents[2]
BUILT = ROOT / "build/docs"
LINK = re.compile(r"\]\(([^)#\s]+)(#[^)\s]*)?\)")
# Modules of the package that programs import; the others are parts of them, or of mimo itself.
EXTRAS = "babybench bids by_field classic lsl motion nwb plot ray rerun sb3 usd video view"
MODULES = {"mimo", *(f"mimo.{name}" for name in EXTRAS.split())}
READERS = "train-agents study-infants embed from-mimo cameras contribute"
LINKED = "".join((ROOT / f"docs/readers/{name}.md").read_text(encoding="utf-8") for name in READERS.split())
TUTORIALS = dict.fromkeys(re.findall(r"\.\./tutorials/([\w-]+)\.md", LINKED))  # in the order of readers
CONTENTS = {
    "Readers": [f"docs/readers/{name}" for name in READERS.split()],
    "Tutorials": [f"docs/tutorials/{name}" for name in TUTORIALS],
    "Reference": [
        "reference/c/index",
        "reference/cpp/index",
        "Python </reference/python/mimo/index>",
        "examples/index",
        "CHANGELOG",
    ],
}

project = "libmimo"
project_copyright = "libmimo contributors"
extensions = ["myst_parser", "breathe", "sphinx.ext.autodoc", "autoapi.extension", "sphinx_copybutton"]
root_doc = "README"
html_theme = "furo"
html_title = "libmimo"
html_show_sphinx = False
html_static_path = [str(ROOT / "docs/site/static")]
html_css_files = ["site.css"]
exclude_patterns = ["docs/site"]
myst_heading_anchors = 4
default_role = "code"  # of text in the package's docstrings between single backquotes
breathe_projects = {"mimo": str(BUILT / "xml")}
breathe_default_project = "mimo"
breathe_domain_by_extension = {"h": "c", "hpp": "cpp"}
autoapi_dirs = [str(ROOT / "bindings/python/src/mimo")]
autoapi_root = "reference/python"
autoapi_options = ["members", "undoc-members", "imported-members", "show-module-summary"]
autoapi_add_toctree_entry = False
autoapi_python_class_content = "both"
suppress_warnings = [
    "autoapi.python_import_resolution",  # of modules that it is told to leave out
    "duplicate_declaration.cpp",  # of namespaces, which many headers open
]


def led(link, page):
    """Where a link leads on the site: programs and folders have pages of their own, and the header is the reference."""
    target = normpath(join(dirname(page), link))
    if target == "include/mimo/mimo.h":
        return "/reference/c/index.md"
    if target.startswith(("examples/", "docs/data/")):
        return link + ("/index.md" if (ROOT / target).is_dir() else ".md" if target.startswith("examples/") else "")
    return link


def contents(pages, caption=""):
    """A list of pages that only the side shows."""
    options = [":hidden:", *([f":caption: {caption}"] if caption else [])]
    return "\n".join(
        ["", "```{toctree}", *options, "", *(page if "<" in page else f"/{page}" for page in pages), "```", ""]
    )


def children():
    """By page of a reader or of decisions: the pages that it links to first, which are below it at the side."""
    taken, found = set(), {}
    for page in [*(f"{name}.md" for name in CONTENTS["Readers"]), "docs/adr/index.md"]:
        links = [
            normpath(join(dirname(page), link)) for link, _ in LINK.findall((ROOT / page).read_text(encoding="utf-8"))
        ]
        elsewhere = ("README.md", "CHANGELOG.md", "docs/readers/", "docs/tutorials/")
        new = dict.fromkeys(link[:-3] for link in links if link.endswith(".md") and not link.startswith(elsewhere))
        found[page[:-3]] = [link for link in new if link not in taken]
        taken |= new.keys()
    return found


def read(app, page, source):
    text = LINK.sub(lambda found: f"]({led(found[1], page)}{found[2] or ''})", source[0])
    if page == "README":
        text += "".join(contents(pages, caption) for caption, pages in CONTENTS.items())
    if page in app.config.mimo_children:
        text += contents(app.config.mimo_children[page])
    if (BUILT / f"pages/{page}.ipynb").is_file():
        text += f"\n[This page as a notebook]({Path(page).name}.ipynb)\n"
    source[0] = text


def docstring(app, kind, name, thing, options, lines):
    """Docstrings are written for people: a block that is indented after an empty line is a program."""
    made = []
    for line in lines:
        indented = line.startswith("    ")
        before = next((one for one in reversed(made) if one.strip()), "")
        if indented and made and not made[-1].strip() and not before.startswith("    "):
            made += ["::", ""]
        made.append(line if indented else re.sub(r"(\w)_(?=[\s,.)])", r"\1\\_", line))
    lines[:] = made


def skip(app, what, name, thing, leave_out, options):
    return name not in MODULES if what in ("module", "package") else leave_out


def imported_on_demand(parser, node):
    """mimo imports some names when they are used, and says so under TYPE_CHECKING, where autoapi does not look."""
    if node.root().name != "mimo" or node.test.as_string() != "TYPE_CHECKING":
        return []
    return [name for line in node.body for name in parser._parse_local_import_from(line)]


def setup(app):
    Parser.parse_if = imported_on_demand
    app.add_config_value("mimo_children", children(), "env")
    app.connect("source-read", read)
    app.connect("autodoc-process-docstring", docstring)
    app.connect("autoapi-skip-member", skip)
