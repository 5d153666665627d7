"""The same bytes in every language (tests/capi/same.c) and on every processor (tests/same/steps.c)."""

import difflib
import platform
from concurrent.futures import ThreadPoolExecutor
from functools import partial

from .build import build, cmake
from .csharp import build_csharp
from .javascript import MODULE, take_module
from .need import need
from .octave import OCTAVE, build_mex
from .pins import environment
from .rust import LIBRARY
from .shell import BUILD, CORES, ROOT, fail, fresh, output

MADE = BUILD / "same"
SCENES = ("benchmark", "reach", "playdate")  # that tests/same/steps.c steps
PROCESSORS = {"AVX": "max,-avx2,-fma", "AVX2": "max"}  # QEMU's names; it knows no AVX-512
NO_FUSING = {"GLIBC_TUNABLES": "glibc.cpu.hwcaps=-AVX512F,-AVX2,-FMA,-AVX2_Usable,-FMA_Usable"}  # in the C library
VARIABLES = {**LIBRARY, "MIMO_LIBRARY": BUILD / "lib/libmimo.so", "PYTHONPATH": ROOT / "bindings/python/src"}
CRATE = "bindings/rust/mimo/Cargo.toml"


def check_same(complaint, expected, got):
    """Fails with the differences of two texts."""
    if expected != got:
        lines = difflib.unified_diff(expected.splitlines(), got.splitlines(), "expected", "got", lineterm="")
        fail("\n".join([complaint, *lines]))


def hashed(language, *command):
    """Runs a program that writes a file of blocks for each scene, and prints scenes and sums of rewards.

    Returns what it prints with the hashes of the files in between.
    """
    folder = fresh(MADE / language)
    words = [line.split() for line in output(*command, env=VARIABLES).splitlines()]
    return "\n".join(f"{scene} {output(BUILD / 'bin/same_fnv1a', folder / scene)} {total}" for scene, total in words)


def own_maths(folder):
    """What makes MuJoCo call libmimo's sin, exp and the like. LD_PRELOAD takes no spaces, which ROOT may have."""
    return {"LD_PRELOAD": (folder / "lib/libsame_maths.so").relative_to(ROOT)}


def steps_of(folder, count, *emulator, env=None, what=()):
    """The hashes of so many steps with all senses by a build, in which MuJoCo calls libmimo's sin, exp and the like."""
    program, maths = folder / "bin/same_steps", own_maths(folder)
    if emulator:
        return output(*emulator, "-E", f"LD_PRELOAD={maths['LD_PRELOAD']}", program, count, *what)
    return output(program, count, *what, env={**maths, **(env or {})})


def steps_in_node(count, *what):
    """The same in WebAssembly, where MuJoCo always calls libmimo's functions."""
    return output("node", MODULE.parents[1] / "bin/same_steps.js", count, *what)


def ways_to_step(count, emulated):
    """What can step here: its name, how many steps, and the function that takes these and scenes."""
    ways = [("this processor", count, lambda steps, *scenes: steps_of(BUILD, steps, what=scenes))]
    if MODULE.is_file():
        cmake("web", "same_steps")
        ways.append(("WebAssembly", count, steps_in_node))
    if platform.machine() != "x86_64":
        return ways
    need("qemu-user")
    unfused = partial(steps_of, BUILD, env=NO_FUSING)
    ways.append(("no fused multiplication", count, lambda steps, *scenes: unfused(steps, what=scenes)))
    for name, processor in PROCESSORS.items():
        there = ("qemu-x86_64", "-cpu", processor)
        ways.append((name, emulated, lambda steps, *scenes, there=there: steps_of(BUILD, steps, *there, what=scenes)))
    return ways


def up_to(steps, text):
    """The lines of the first steps, of those that tests/same/steps.c prints."""
    return "\n".join(line for line in text.splitlines() if int(line.split()[1]) <= steps)


def check_processors(count=300, emulated=100):
    """Compares this processor's hashes with those of WebAssembly, and without its faster instructions."""
    build("release", "same_steps", "same_maths")
    ways = ways_to_step(count, emulated)
    with ThreadPoolExecutor(CORES) as pool:
        running = [(scene, way, pool.submit(way[2], way[1], scene)) for scene in SCENES for way in ways]
        here = {}
        for scene, (name, steps, _), future in running:
            said = future.result()
            expected = up_to(steps, here.setdefault(scene, said))
            check_same(f"other bytes in {scene}: {name}", expected, said)
            print(f"{name}: {said.splitlines()[-1]}", flush=True)
    print(f"The same bytes of all senses: {', '.join(name for name, _, _ in ways)}")


def test_same():
    """Compares a line a scene, with the hash of all blocks, and one of a picture of plain arrays."""
    check_processors()
    need("rust")
    build("release", "mimo", "capi_same", "same_cpp", "same_fnv1a")
    python = environment("python-same", "test") / "python"
    build_csharp()
    build_mex()
    print("The same bytes in C, C++, Python, Rust, C# and Octave")
    expected = output(BUILD / "bin/capi_same")
    print(expected)
    in_octave = (*OCTAVE, "--path", ROOT / "tests/same", "--eval", f"same('{MADE}/octave')")
    said = {
        "C++": output(BUILD / "bin/same_cpp"),
        "Python": hashed("python", python, "tests/same/same.py", MADE / "python"),
        "Rust": output("cargo", "run", "-q", "--manifest-path", CRATE, "--example", "same", env=VARIABLES),
        "C#": output("mono", BUILD / "csharp/Same.exe", env=VARIABLES),
    }
    for language, text in said.items():
        check_same(f"{language} gives other bytes than C", expected, text)
    # MATLAB and Octave have no tasks of one's own.
    shared = "\n".join(line for line in expected.splitlines() if not line.startswith("own "))
    check_same("Octave gives other bytes than C", shared, hashed("octave", *in_octave))
    if take_module():
        test_same_in_javascript()


def test_same_in_javascript():
    """Compares with C where MuJoCo calls libmimo's functions, as it always does in the module."""
    expected = output(BUILD / "bin/capi_same", env=own_maths(BUILD))
    got = hashed("javascript", "node", "tests/same/same.mjs", MADE / "javascript")
    check_same("JavaScript gives other bytes than C", expected, got)
