"""The documentation as a site: guides as they stand, reference of each language, tutorials also as notebooks."""

from .need import need
from .pins import environment
from .shell import BUILD, CORES, PYTHON, ROOT, copy, fail, fresh, run, sources, start

DOCS = BUILD / "docs"
PAGES = DOCS / "pages"  # what Sphinx reads: files of the repository, each at its place, and pages made here
SITE = DOCS / "html"
ARTICLES = (
    "README.md",
    "CHANGELOG.md",
    "CONTRIBUTING.md",
    "CITATION.cff",
    "LICENSE",
    "docs",
    "examples",
    "models/README.md",
)
READMES = tuple(f"bindings/{language}/README.md" for language in ("csharp", "javascript", "matlab", "python", "rust"))
LANGUAGES = {
    "c": "c",
    "cpp": "c++",
    "cs": "csharp",
    "lua": "lua",
    "m": "matlab",
    "mjs": "javascript",
    "py": "python",
    "rs": "rust",
}


def write(page, title, *lines):
    page.parent.mkdir(parents=True, exist_ok=True)
    page.write_text("\n".join([f"# {title}", "", *lines, ""]))


def listed(pages):
    return ["```{toctree}", ":maxdepth: 1", "", *pages, "```"]


def lay_out_reference(language, name, files):
    """A page for each header, and one that lists them."""
    pages = []
    for file in files:
        header = file.relative_to(ROOT / "include")
        pages.append("-".join(header.parts[1:]).rpartition(".")[0])
        write(PAGES / f"reference/{language}/{pages[-1]}.md", header.name, f"```{{doxygenfile}} {header.name}", "```")
    listing = "mimo.h" if language == "c" else "mimo.hpp"
    text = [f"Programs include `mimo/{listing}`, which includes all of these.", "", *listed(pages)]
    write(PAGES / f"reference/{language}/index.md", name, *text)


def lay_out_examples():
    """A page for each program, and one for each folder of programs or of numbers."""
    languages = sorted(folder for folder in (PAGES / "examples").iterdir() if folder.is_dir())
    for folder in languages:
        programs = sorted(file for file in folder.iterdir() if file.suffix[1:] in LANGUAGES)
        for program in programs:
            shown = [f"```{{literalinclude}} {program.name}", f":language: {LANGUAGES[program.suffix[1:]]}", "```"]
            write(folder / f"{program.name}.md", program.name, *shown)
        write(folder / "index.md", f"Examples: {folder.name}", *listed(program.name for program in programs))
    write(PAGES / "examples/index.md", "Examples", *listed(f"{folder.name}/index" for folder in languages))
    for folder in sorted(folder for folder in (PAGES / "docs/data").rglob("*") if folder.is_dir()):
        files = sorted(file.name for file in folder.iterdir() if file.is_file())
        folders = sorted(f"{below.name}/index.md" for below in folder.iterdir() if below.is_dir())
        write(folder / "index.md", f"Data: {folder.name}", *(f"- [{name}]({name})" for name in [*folders, *files]))
        shown = (folder / "index.md").read_text()
        (folder / "index.md").write_text(f"---\norphan: true\n---\n\n{shown}")


def lay_out():
    fresh(PAGES)
    for file in sources(*ARTICLES, *READMES, ":!docs/site"):
        copy([ROOT / file], (PAGES / file).parent)
    headers = [ROOT / file for file in sources("include/mimo/*.h", ":!include/mimo/mimo_export.h")]
    lay_out_reference("c", "C", headers)
    lay_out_reference("cpp", "C++", [ROOT / file for file in sources("include/mimo/*.hpp")])
    lay_out_examples()
    run(PYTHON, "docs/make_tutorials.py", "--notebooks", PAGES / "docs/tutorials")


def make_site():
    """Makes the site; whatever doxygen or Sphinx warns of is an error."""
    lay_out()
    fresh(DOCS / "xml")
    if start(("doxygen", "docs/Doxyfile")).returncode != 0:
        fail("doxygen found something")
    sphinx = environment("site", "site") / "sphinx-build"
    run(sphinx, "-q", "-j", CORES, "--fail-on-warning", "-c", "docs/site", "-d", DOCS / "read", PAGES, SITE)
    run("tests/readme/check_pages", SITE)


def docs():
    need("docs")
    make_site()
    print(f"The documentation is in {SITE}/README.html")
