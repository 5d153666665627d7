"""The library as a module of WebAssembly, with MuJoCo and HDF5 compiled from their sources, and its tests in Node."""

import shutil

from .build import build, cmake
from .cross import CROSS, fetch_dependencies, fetch_sources
from .ctest import run_workflow
from .javascript import LICENCES, MODULE
from .need import need
from .pins import PINS, check_hash
from .same import SCENES, check_same, own_maths, steps_in_node, steps_of
from .shell import BUILD, ROOT, copy, fail, fresh, must, only, output

FOLDER = ROOT / "build-web"
SOURCES = CROSS / "mujoco/web"  # of MuJoCo
NAMED = ("Apache-2.0", "MPL-2.0")  # licences that Debian's texts name without repeating them
USED = ("libccd", "lodepng", "qhull", "tinyobjloader", "tinyxml2")  # by MuJoCo
MEGABYTE = 1 << 20
MOST_BYTES = 6 * MEGABYTE  # as it travels


def fetch_hdf5_sources():
    """Fetches the sources of HDF5. Those of Debian 12 run programs on the system for which they are compiled."""
    if (CROSS / "hdf5").is_dir():
        return
    print("Fetching the sources of HDF5")
    folder = CROSS / "sources"
    fetch_sources("trixie", "hdf5")
    only(folder, "hdf5-*/").rename(CROSS / "hdf5")
    shutil.rmtree(folder)


def fetch_mujoco_sources():
    """Fetches the sources of MuJoCo 2.2.2 and of what it uses."""
    if SOURCES.is_dir():
        return
    print("Fetching the sources of MuJoCo 2.2.2")
    folder, pin = CROSS / "sources", PINS["mujoco"]["web"]
    fetch_sources("bookworm", *USED)
    for name in USED:
        shutil.rmtree(CROSS / name, ignore_errors=True)
        only(folder, f"{name}-*/").rename(CROSS / name)
    fetch_sources("bookworm", "--tar-only", "mujoco")  # of Debian's own changes the mirrors have no file
    check_hash(folder / pin["file"], pin)
    new = fresh(CROSS / "mujoco/new")
    names = [f"mujoco-2.2.2/{name}" for name in ("LICENSE", "include", "src")]
    must("MuJoCo cannot be unpacked", "tar", "-xf", pin["file"], "-C", new, "--strip-components=1", *names, cwd=folder)
    shutil.rmtree(folder)
    new.rename(SOURCES)


def collect_licences():
    """The licences of all that is inside the module, in build-web/licences."""
    folder = fresh(LICENCES)
    copy([ROOT / "LICENSE"], folder)
    shutil.copy(SOURCES / "LICENSE", folder / "mujoco.txt")
    shutil.copy("/usr/share/doc/emscripten/copyright", folder / "emscripten.txt")  # its C and C++ libraries
    for name in (*USED, "hdf5"):
        shutil.copy(CROSS / name / "debian/copyright", folder / f"{name}.txt")
    for name in ("highway", "pugixml", "zlib"):
        copy([CROSS / f"licences/{name}.txt"], folder)
    for package in ("libeigen3-dev", "libfmt-dev", "nlohmann-json3-dev"):
        shutil.copy(f"/usr/share/doc/{package}/copyright", folder / f"{package}.txt")
    for name in NAMED:
        shutil.copy(f"/usr/share/common-licenses/{name}", folder / f"{name}.txt")


def prepare_web():
    need("cross", "web")
    fetch_dependencies()
    fetch_mujoco_sources()
    fetch_hdf5_sources()


def build_web(*targets):
    """Builds the module, in build-web/lib/mimo.wasm."""
    prepare_web()
    cmake("web", *(targets or ["mimo_module"]))
    collect_licences()


def check_size():
    """The module has to travel in six megabytes."""
    size = int(output("bash", "-c", f"brotli -q 9 -c '{MODULE}' | wc -c"))
    print(f"mimo.wasm has {MODULE.stat().st_size / MEGABYTE:.1f} MB, and {size / MEGABYTE:.1f} as it travels")
    if size > MOST_BYTES:
        fail(f"mimo.wasm has {size} bytes as it travels, at most {MOST_BYTES} are allowed")


def check_bytes():
    """The module gives the bytes of the library here, where MuJoCo calls the same functions, in all senses' fields."""
    build("release", "capi_same", "same_steps", "same_maths")
    here = output(BUILD / "bin/capi_same", env=own_maths(BUILD))
    check_same("WebAssembly gives other bytes", here, output("node", FOLDER / "bin/capi_same.js"))
    for scene in SCENES:
        what = ("fields", scene)
        there = steps_in_node(300, *what)
        check_same(f"WebAssembly gives other bytes in {scene}", steps_of(BUILD, 300, what=what), there)
    print(f"The same bytes in WebAssembly, and in 300 steps with all senses of {', '.join(SCENES)}:\n{here}")


def test_module():
    """Runs the C tests in Node, and compares bytes and size of the module."""
    prepare_web()
    run_workflow("web")
    check_bytes()
    build_web()
    check_size()
