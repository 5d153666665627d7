"""The parts of ./dev test, and how they are run after each other."""

import json
import os
import time
import traceback

from . import page, web
from .build import build, prepare_mujoco4, use_mujoco
from .csharp import test_csharp
from .ctest import cases, failed_tests, run_workflow
from .elsewhere import test_arm, test_linux
from .octave import test_octave
from .packages import test_package, test_release
from .python import sessions, test_python, test_pythons, test_ray, test_view
from .rust import test_rust
from .same import check_processors, check_same, test_same
from .shell import BUILD, ROOT, Failure, fail, output
from .windows import test_windows


def test_avx():
    """The tests of rooms see that MuJoCo by the linker's path."""
    build("release")
    use_mujoco(avx=True)
    os.environ["LD_LIBRARY_PATH"] = str(BUILD / "lib")
    try:
        run_workflow("release")
    finally:
        del os.environ["LD_LIBRARY_PATH"]
        use_mujoco()


def test_mujoco4():
    prepare_mujoco4()
    run_workflow("mujoco4")
    sessions("mujoco")


def test_web():
    web.test_module()
    page.test_web()


def test_sanitized(preset):
    """Tests with sanitizers. The same seed and actions give the same bytes, however the library was compiled."""
    run_workflow(preset)
    build("release", "capi_same")
    check_same(
        "the builds give other bytes", *(output(ROOT / name / "bin/capi_same") for name in ("build", "build-asan"))
    )
    print("The same bytes in both builds")


# Each part of ./dev test: its function, and what it tests.
USUAL = {
    "quick": (lambda: run_workflow("release"), "the library and the program"),
    "python": (test_python, "the Python package, programs of the pages, learning"),
    "rust": (test_rust, "the Rust crates"),
    "csharp": (test_csharp, "the C# classes, on Mono and .NET"),
    "octave": (test_octave, "the MEX gateway, in Octave"),
    "same": (test_same, "all languages and all processors give the same bytes"),
    "package": (test_package, "Debian's packages and the sources, in a clone on a path with a space"),
    "asan": (lambda: test_sanitized("asan"), "the interface, with sanitizers for addresses and undefined behaviour"),
}
PARTS = {
    **USUAL,
    "mujoco4": (test_mujoco4, "--quick on MuJoCo 4, except what does not use it"),
    "asan-rooms": (lambda: test_sanitized("asan-rooms"), "--asan, with the tests of rooms"),
    "tsan": (lambda: run_workflow("tsan"), "what uses threads, with the sanitizer for races"),
    "avx": (test_avx, "--quick on the faster build of MuJoCo"),
    "web": (test_web, "the module of WebAssembly: C tests and the npm package in Node, the page in a browser"),
    "pythons": (test_pythons, "the Python package on each version of Python that is installed, and of MuJoCo"),
    "view": (test_view, "the viewer in a headless browser, Rerun, USD; needs chromium"),
    "ray": (test_ray, "worlds and learning on clusters of local nodes, of which one is killed; installs Ray"),
    "steps": (lambda: check_processors(100_000, 1000), "100,000 steps of three scenes on each processor: hours"),
    "linux": (test_linux, "the build for any Linux: C tests, wheel in Debian 11 and 13"),
    "arm": (test_arm, "the build for 64-bit ARM, by QEMU"),
    "windows": (test_windows, "the build for Windows, by wine: C tests, pictures, wheel, C#"),
    "release": (test_release, "packages for all systems, each tried in an empty place"),
}
PRESETS = {"quick": "release", "avx": "release"}  # of parts whose name is another
# Minutes on two idle cores, with the build. The time that a part took on this machine replaces them.
USUALLY = {
    "quick": 7,
    "python": 5,
    "rust": 1,
    "csharp": 1,
    "octave": 1,
    "same": 2,
    "package": 3,
    "asan": 8,
    "mujoco4": 8,
    "linux": 10,
    "arm": 9,
    "windows": 9,
    "ray": 8,
}
TOOK = BUILD / "took.json"  # seconds of each part when it passed last


def minutes(name, took):
    """How long a part takes, in minutes; 0: nobody knows."""
    return max(1, round(took[name] / 60)) if name in took else USUALLY.get(name, 0)


def announce(names, took):
    """Says what will be run, and how long it takes."""
    print(f"Tests to run: {' '.join(f'--{name}' for name in names)}")
    for name in names:
        print(f"{name:12}{minutes(name, took) or '?':>4} min  {PARTS[name][1]}")
    unknown = sum(not minutes(name, took) for name in names)
    more = f", and {unknown} that nobody has timed here" if unknown else ""
    print(f"Together about {sum(minutes(name, took) for name in names)} minutes{more}")


def run_part(name):
    """Runs a part; returns whether it passed."""
    test = PARTS[name][0]
    try:
        use_mujoco()
        test()
        return True
    except Failure as failure:
        print(f"dev: {failure}")
    except Exception:  # a fault of ours ends the part, not the others
        traceback.print_exc()
    for failed in failed_tests(PRESETS.get(name, name)):
        print(f"failed: {failed}")
    return False


def run_tests(names):
    """Runs parts, the usual ones or these, whatever fails, and prints a table of what became of them."""
    names = list(dict.fromkeys(names or USUAL))
    took = json.loads(TOOK.read_text()) if TOOK.is_file() else {}
    announce(names, took)
    table, failed = [f"{'part':12}{'result':8}{'seconds':>9}{'tests':>8}"], []
    for number, name in enumerate(names, 1):
        print(f"==== {number} of {len(names)}: {name}, {PARTS[name][1]}, about {minutes(name, took) or '?'} min")
        start = time.monotonic()
        if run_part(name):
            took[name] = round(time.monotonic() - start)
            TOOK.parent.mkdir(exist_ok=True)
            TOOK.write_text(json.dumps(took))
        else:
            failed.append(name)
        result, count = "FAILED" if name in failed else "passed", len(cases(PRESETS.get(name, name))) or ""
        table.append(f"{name:12}{result:8}{time.monotonic() - start:9.0f}{count:>8}")
    print("\n".join(table))
    if failed:
        fail(f"tests failed; again with: ./dev test {' '.join(f'--{name}' for name in failed)}")
    print("All tests passed")
