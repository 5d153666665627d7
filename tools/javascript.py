"""The npm package: types, tests in Node, and the package itself."""

import json
import shutil

from .need import need
from .shell import BUILD, ROOT, copy, fail, fresh, output, run, version

PACKAGE = ROOT / "bindings/javascript"
MODULE = ROOT / "build-web/lib/mimo.wasm"  # ./dev build --web, and the licences of all that is inside
LICENCES = ROOT / "build-web/licences"
# Things that the module is made of, each with a word of its licence, mostly an author's name.
INSIDE = {
    "Apache-2.0": "Apache License",
    "MPL-2.0": "Mozilla",
    "emscripten": "musl",
    "hdf5": "HDF Group",
    "highway": "Apache-2.0",
    "libccd": "Fiser",
    "libeigen3-dev": "Guennebaud",
    "libfmt-dev": "Zverovich",
    "lodepng": "Vandevenne",
    "mujoco": "Apache License",
    "nlohmann-json3-dev": "Lohmann",
    "pugixml": "Kapoulkine",
    "qhull": "Barber",
    "tinyobjloader": "Fujita",
    "tinyxml2": "Thomason",
    "zlib": "Gailly",
}


def install_compiler(folder=PACKAGE):
    """Installs what the package's own tests need, by the hashes of its lock file."""
    if not shutil.which("npm"):  # other versions than Debian's are as good
        need("javascript")
    run("npm", "ci", "--ignore-scripts", "--no-audit", "--no-fund", "--silent", cwd=folder)


def take_module():
    """Puts the module and its licences beside the package's sources, where there is one; returns whether there is."""
    if MODULE.is_file():
        shutil.copy2(MODULE, PACKAGE / "mimo.wasm")
    if LICENCES.is_dir():
        copy(LICENCES.iterdir(), fresh(PACKAGE / "licences"))
    return (PACKAGE / "mimo.wasm").is_file()


def compile_types():
    """Checks the types, and makes the package's declarations of them."""
    install_compiler()
    run("npx", "tsc", "-p", ".", cwd=PACKAGE)


def test_javascript():
    """Checks the types, and runs the tests; most of them need the module and are skipped without it."""
    compile_types()
    if json.loads((PACKAGE / "package.json").read_text())["version"] != version():
        fail(f"bindings/javascript/package.json has another version than the library, {version()}")
    take_module()
    run("node", "--test", "tests/", cwd=PACKAGE)


def pack_javascript():
    """Makes the npm package; returns the file."""
    if not take_module():
        fail("the npm package needs the module: ./dev build --web")
    compile_types()
    copy([ROOT / "LICENSE"], PACKAGE)
    folder = fresh(BUILD / "packages/npm")
    return folder / output("npm", "pack", "--silent", "--pack-destination", folder, cwd=PACKAGE)


def check_licences(folder):
    """The licence of everything inside the module travels with it."""
    found = {name: folder / f"{name}.txt" for name in INSIDE}
    wrong = [name for name, file in found.items() if not file.is_file() or INSIDE[name] not in file.read_text("utf-8")]
    if wrong:
        fail(f"the npm package lacks the licences of {', '.join(wrong)}")


def test_packed():
    """Installs the package in an empty folder and steps a world there."""
    file, folder = pack_javascript(), fresh(BUILD / "javascript")
    run("npm", "install", "--no-audit", "--no-fund", "--silent", "--prefix", folder, file, cwd=folder)
    check_licences(folder / "node_modules/libmimo/licences")
    copy(ROOT.glob("examples/javascript/*.mjs"), folder)
    for example in sorted(folder.glob("*.mjs")):
        run("node", example, cwd=folder)
