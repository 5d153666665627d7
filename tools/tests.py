"""The parts of ./dev test, and how they are run after each other."""

import os
import time
import traceback

from .build import build, prepare_mujoco4, use_mujoco
from .csharp import test_csharp
from .ctest import failed_tests, run_workflow
from .elsewhere import test_arm, test_linux
from .octave import test_octave
from .packages import test_package, test_release
from .python import sessions, test_python, test_pythons, test_ray, test_view
from .rust import test_rust
from .same import check_same, test_same
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


def test_sanitized(preset):
    """Tests with sanitizers. The same seed and actions give the same bytes, however the library was compiled."""
    run_workflow(preset)
    build("release", "capi_same")
    check_same(
        "the builds give other bytes", *(output(ROOT / name / "bin/capi_same") for name in ("build", "build-asan"))
    )
    print("The same bytes in both builds")


# What each does, and what it is about.
USUAL = {
    "quick": (lambda: run_workflow("release"), "the library and the program"),
    "python": (test_python, "the Python package, programs of the pages, learning"),
    "rust": (test_rust, "the Rust crates"),
    "csharp": (test_csharp, "the C# classes, on Mono and .NET"),
    "octave": (test_octave, "the MEX gateway, in Octave"),
    "same": (test_same, "all languages give the same bytes"),
    "package": (test_package, "Debian's packages and the sources, in a clone on a path with a space"),
    "asan": (lambda: test_sanitized("asan"), "the interface, with sanitizers for addresses and undefined behaviour"),
}
PARTS = {
    **USUAL,
    "mujoco4": (test_mujoco4, "--quick on MuJoCo 4, except what does not use it"),
    "asan-rooms": (lambda: test_sanitized("asan-rooms"), "--asan, with the tests of rooms"),
    "tsan": (lambda: run_workflow("tsan"), "what uses threads, with the sanitizer for races"),
    "avx": (test_avx, "--quick on the faster build of MuJoCo"),
    "pythons": (test_pythons, "the Python package on each supported version that is installed"),
    "view": (test_view, "the viewer in a headless browser, Rerun, USD; needs chromium"),
    "ray": (test_ray, "worlds and learning on clusters of local nodes, of which one is killed; installs Ray"),
    "linux": (test_linux, "the build for any Linux: C tests, wheel in Debian 11 and 13"),
    "arm": (test_arm, "the build for 64-bit ARM, by QEMU"),
    "windows": (test_windows, "the build for Windows, by wine: C tests, pictures, wheel, C#"),
    "release": (test_release, "packages for all systems, each tried in an empty place"),
}
PRESETS = {"quick": "release", "avx": "release"}  # of parts whose name is another


def run_part(name):
    """Runs a part; returns whether it passed."""
    test, about = PARTS[name]
    print(f"==== {name}: {about}")
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
    print(f"Tests to run: {' '.join(f'--{name}' for name in names)}")
    table, failed = [f"{'part':12}{'result':8}{'seconds':>9}"], []
    for name in names:
        start = time.monotonic()
        if not run_part(name):
            failed.append(name)
        table.append(f"{name:12}{'FAILED' if name in failed else 'passed':8}{time.monotonic() - start:9.0f}")
    print("\n".join(table))
    if failed:
        fail(f"tests failed; again with: ./dev test {' '.join(f'--{name}' for name in failed)}")
    print("All tests passed")
