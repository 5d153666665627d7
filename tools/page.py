"""The pages in build/web: the infant, which any server of files serves, and a page for recordings, one file."""

import base64
import gzip
import shutil

from . import site
from .javascript import LICENCES, PACKAGE, install_compiler, take_module, test_javascript, test_packed
from .need import need
from .python import sessions, wheel
from .shell import BUILD, ROOT, copy, fail, fresh, run
from .web import build_web

SOURCES = ROOT / "web"
POLICIES = ROOT / "examples/policies"
PAGE = BUILD / "web"
LINKS = (
    ("README.html", "What libmimo is"),
    ("docs/readers/index.html", "for each kind of reader"),
    ("docs/python.html", "Python"),
    ("bindings/javascript/README.html", "JavaScript"),
    ("docs/learning.html", "learning"),
)


def documentation():
    """Links to the documentation, which is copied beside the page if it was made; else how it is made."""
    if not site.SITE.is_dir():
        return "The documentation is in the folder docs of libmimo; ./dev docs makes a site of it."
    shutil.copytree(site.SITE, PAGE / "docs")
    found = [(file, text) for file, text in LINKS if (site.SITE / file).is_file()]
    return "Read on: " + ", ".join(f'<a href="docs/{file}">{text}</a>' for file, text in found) + "."


def bundle(source, made):
    """All JavaScript of a page as one script; files that open from a disk cannot have modules."""
    options = ("--bundle", "--minify", "--format=iife", "--target=es2022", "--legal-comments=eof")
    quiet = ("--external:node:fs/promises", "--log-override:empty-import-meta=silent", "--log-level=warning")
    run("npx", "esbuild", f"src/{source}", *options, *quiet, f"--outfile={made}", cwd=SOURCES)


def packed(content):
    """Bytes as text, as web/src/inside.js reads them."""
    return base64.b64encode(gzip.compress(content, mtime=0)).decode()


def licences():
    """The licences of all that is inside a page, as one text."""
    files = {"libmimo": ROOT / "LICENSE", "three.js": SOURCES / "node_modules/three/LICENSE"}
    files |= {file.stem: file for file in sorted(LICENCES.glob("*.txt"))}
    return "\n\n".join(f"{name}\n\n{file.read_text(encoding='utf-8')}" for name, file in files.items())


def make_recording_page():
    """The page that mimo export --html puts a recording into, with all that it needs inside."""
    script = BUILD / "recording.js"
    bundle("recording.js", script)
    inside = {
        "style": f"<style>{(SOURCES / 'page.css').read_text(encoding='utf-8')}</style>",
        "licences": packed(licences().encode()),
        "module": packed((PACKAGE / "mimo.wasm").read_bytes()),
        "script": f"<script>{script.read_text(encoding='utf-8')}</script>",
    }
    text = (SOURCES / "recording.html").read_text(encoding="utf-8")
    for name, content in inside.items():
        text = text.replace(f"<!-- {name} -->", content)
    (PAGE / "recording.html").write_text(text, encoding="utf-8")
    script.unlink()


def make_page():
    if not take_module():
        fail("the page needs the module: ./dev build --web")
    install_compiler(SOURCES)
    fresh(PAGE)
    bundle("main.js", PAGE / "page.js")
    make_recording_page()
    copy([SOURCES / "page.css", PACKAGE / "mimo.wasm", ROOT / "LICENSE"], PAGE)
    policies = [file.read_text(encoding="utf-8") for file in sorted(POLICIES.glob("*.json"))]
    (PAGE / "policies.json").write_text(f"[{','.join(policies)}]", encoding="utf-8")
    shutil.copy(SOURCES / "node_modules/three/LICENSE", PAGE / "LICENSE.three")
    if (PACKAGE / "licences").is_dir():
        shutil.copytree(PACKAGE / "licences", PAGE / "licences")
    text = (SOURCES / "index.html").read_text(encoding="utf-8")
    (PAGE / "index.html").write_text(text.replace("<!-- links -->", documentation()), encoding="utf-8")


def page_for_packages():
    """Makes the module, if it is not there, and the page for recordings; returns its file."""
    build_web()
    make_page()
    return PAGE / "recording.html"


def test_web():
    """Tests the npm package in Node, also as it is packed, and the page in a headless browser.

    Without the module only what needs none is tested.
    """
    test_javascript()
    if take_module():
        test_packed()
        make_page()
        need("view")
        wheel()
        sessions("page")


def web():
    make_page()
    print(f"The page is in {PAGE}; serve it, for example by: python3 -m http.server --directory {PAGE}")
