"""The same bytes in every language (tests/capi/same.c) and on every processor (tests/same/steps.c)."""

import difflib
import platform

from .build import build
from .csharp import build_csharp
from .javascript import take_module
from .need import need
from .octave import OCTAVE, build_mex
from .pins import environment
from .rust import LIBRARY
from .shell import BUILD, ROOT, fail, fresh, output

MADE = BUILD / "same"
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


def steps_of(folder, count, *emulator, env=None):
    """The hashes of so many steps with all senses by a build, in which MuJoCo calls libmimo's sin, exp and the like."""
    program, maths = folder / "bin/same_steps", own_maths(folder)
    if emulator:
        return output(*emulator, "-E", f"LD_PRELOAD={maths['LD_PRELOAD']}", program, count)
    return output(program, count, env={**maths, **(env or {})})


def up_to(steps, text):
    """The lines of the first steps, of those that tests/same/steps.c prints."""
    return "\n".join(line for line in text.splitlines() if int(line.split()[1]) <= steps)


def check_processors(count=300, emulated=100):
    """Compares the hashes of this processor with those without its faster instructions, as far as QEMU goes."""
    build("release", "same_steps", "same_maths")
    here = steps_of(BUILD, count)
    print(f"With all senses:\n{here}")
    if platform.machine() != "x86_64":
        return
    need("qemu-user")
    check_same("other bytes without fused multiplication", here, steps_of(BUILD, count, env=NO_FUSING))
    for name, processor in PROCESSORS.items():
        there = steps_of(BUILD, emulated, "qemu-x86_64", "-cpu", processor)
        check_same(f"a processor with {name} gives other bytes", up_to(emulated, here), there)
    print(f"The same bytes without fused multiplication, and on processors with {' and '.join(PROCESSORS)}")


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
        test_same_in_javascript(expected)


def test_same_in_javascript(expected):
    """Compares the scene reach: where things touch, the module, whose MuJoCo is another build, rounds otherwise."""
    got = hashed("javascript", "node", "tests/same/same.mjs", MADE / "javascript")
    lines = [[line for line in text.splitlines() if line.startswith("reach ")] for text in (expected, got)]
    check_same("JavaScript gives other bytes than C", *("\n".join(line) for line in lines))
