"""Building library and program for this system, on which MuJoCo, and running them."""

import platform
import re
import shutil
import sys
from pathlib import Path

from .need import need
from .pins import PINS, download, fetch_package, unzip
from .shell import BUILD, PYTHON, ROOT, copy, fail, fresh, run, say_and_do, try_run

CMAKE = (3, 25)
MEGABYTE = 1000 * 1000
SPACE = 300 * MEGABYTE  # library, program and their parts, with a reserve
NINJA = {"NINJA_STATUS": "[%f of %t, %es] "}
PROGRAM = ("mimo", "mimo_program")  # the targets that users get
BENCH = ("mimo", "mimo_bench_program")
RATIOS = (
    "bench_render",
    "bench_touch",
    "bench_muscle",
    "bench_worlds",
    "bench_extras",
    "bench_making",
    "bench_models",
    "bench_own_sense",
)
DEMO = """The pictures are in {}. Open first:
  outside.png           the infant, as you would see it
  left.png, right.png   what its eyes see
  touch.png             what its skin feels
Next: ./dev test --quick     runs the tests
      build/bin/mimo --help  what the program can do"""
MUJOCO4 = BUILD / "mujoco4"  # headers and library of MuJoCo 4, in its folder mujoco
IN_USE = MUJOCO4 / "in_use"  # exists while build/ has copies of what was built on it


def cmake(preset, *targets):
    """Configures and builds targets, by default all, by a preset."""
    check_cmake()
    check_space()
    configure(preset)
    run("cmake", "--build", "--preset", preset, *(["--target", *targets] if targets else []), env=NINJA)


def configure(preset):
    """Makes the build files; where CMake misses libraries, its sentence that names them is the message."""
    status, said = try_run("cmake", "--preset", preset)
    if status != 0:
        missing = re.search(r"libmimo needs .*?(?=\n\n|Call Stack|\Z)", said, re.DOTALL)
        fail(" ".join(missing[0].split()) if missing else f"cmake --preset {preset} failed: {said}")


def check_cmake():
    """Presets need a CMake that knows them; one that does not says less."""
    found = re.search(r"cmake version (\d+)\.(\d+)", try_run("cmake", "--version")[1])
    if found and (int(found[1]), int(found[2])) < CMAKE:
        fail(
            f"CMake {found[1]}.{found[2]} is too old; please install {CMAKE[0]}.{CMAKE[1]} or newer: pip install cmake"
        )


def check_space():
    free = shutil.disk_usage(ROOT).free
    if free < SPACE:
        fail(f"only {free // MEGABYTE} MB are free on the disk of {ROOT}; please make room for {SPACE // MEGABYTE} MB")


def build(preset, *targets):
    need("build")
    if preset == "release":
        leave_mujoco4()
    cmake(preset, *targets)


def build_program():
    build("release", *PROGRAM)


def use_mujoco(avx=False):
    """Chooses the MuJoCo 2.2.2 of the build folder's library: Debian's, or the faster build of MuJoCo's own package.

    One that lies beside the library comes before Debian's. Their interface is the same, and their numbers to rounding.
    """
    for file in BUILD.glob("lib/libmujoco.so.*"):
        file.unlink()
    if not avx:
        return
    if platform.machine() != "x86_64" or " avx " not in Path("/proc/cpuinfo").read_text():
        print("This processor has no AVX: Debian's MuJoCo stays in use")
        return
    library = BUILD / "mujoco" / PINS["mujoco"]["linux"]["file"]
    if not library.is_file():
        fetch_package("mujoco", "linux", BUILD / "mujoco")
    copy([library], BUILD / "lib")


def fetch_mujoco4():
    if (sys.platform, platform.machine()) != ("linux", "x86_64"):
        fail("MuJoCo 4 is pinned for Linux on x86-64 only; set mujoco_ROOT for CMake")
    if not any(MUJOCO4.glob("mujoco/libmujoco.so.4*")):
        fetch_package("mujoco4", "linux", MUJOCO4)


def prepare_mujoco4():
    """Puts MuJoCo 4 beside the library that is built on it, which looks for it there."""
    fetch_mujoco4()
    copy(MUJOCO4.glob("mujoco/libmujoco.so.*"), ROOT / "build-mujoco4/lib")


def build_mujoco4():
    """Builds on MuJoCo 4 in a folder of its own, as it has other headers, and copies what was made to build/."""
    prepare_mujoco4()
    build("mujoco4", *PROGRAM)
    IN_USE.touch()
    made = ROOT / "build-mujoco4"
    for file in [*made.glob("lib/libmimo-mujoco4.so*"), *made.glob("lib/libmujoco.so*"), made / "bin/mimo"]:
        place = BUILD / file.relative_to(made)
        place.parent.mkdir(parents=True, exist_ok=True)
        place.unlink(missing_ok=True)
        shutil.copy2(file, place, follow_symlinks=False)


def leave_mujoco4():
    """Removes these copies; the next build makes its own files again."""
    if IN_USE.exists():
        for file in [
            *BUILD.glob("lib/libmimo-mujoco4.so*"),
            *BUILD.glob("lib/libmujoco.so.4*"),
            BUILD / "bin/mimo",
            IN_USE,
        ]:
            file.unlink(missing_ok=True)


def demo(arguments):
    options = arguments or ["--scene", "benchmark", "--seconds", "10"]
    say_and_do(
        ("Debian packages that are missing", "half a minute", lambda: need("build")),
        ("compile the library and the program", "two and a half minutes on two cores", build_program),
        ("simulate an infant and draw", "seconds", lambda: run(BUILD / "bin/mimo", "run", "--out", "demo", *options)),
    )
    print(DEMO.format(ROOT / "demo"))


def bench(arguments):
    build("release", *BENCH)
    run(BUILD / "bin/mimo-bench", *arguments)


def ratios(arguments):
    use_mujoco()
    build("release", *BENCH, *RATIOS)
    run(PYTHON, "tests/bench/ratios.py", *arguments)


def fetch_zoo():
    """The folder of the packages of tests/zoo/packages.txt, which are fetched again when the list changes."""
    folder, wanted = BUILD / "zoo", ROOT / "tests/zoo/packages.txt"
    fetched, packages = folder / "packages.txt", folder / "packages"
    if not fetched.is_file() or fetched.read_text() != wanted.read_text():
        print("Fetching the packages of tests/zoo/packages.txt, about 400 MB")
        download(fresh(folder) / "wheels", "3.12", "-r", wanted)
        for wheel in folder.glob("wheels/*.whl"):
            unzip(wheel, packages / re.split(r"-\d", wheel.name)[0])
        shutil.copy(wanted, fetched)
    return packages


def zoo(asan, arguments):
    packages = fetch_zoo()
    build("asan" if asan else "release", "mimo", "zoo_visit")
    visit = ROOT / ("build-asan" if asan else "build") / "bin/zoo_visit"
    run(PYTHON, "tests/zoo/zoo.py", visit, packages, *arguments)


def clean():
    for folder in [*ROOT.glob("build*"), ROOT / "demo", ROOT / "runs"]:
        shutil.rmtree(folder, ignore_errors=True)
