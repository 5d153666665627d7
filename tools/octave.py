"""Building and testing the MEX gateway with Octave."""

import re

from .build import build_program
from .need import need
from .rust import check_acyclic, follow
from .shell import BUILD, ROOT, fail, fresh, run, try_run

GATEWAY = ROOT / "bindings/matlab"
BARE = ("octave-cli", "--no-init-file", "--norc", "--no-history", "--path", GATEWAY)
OCTAVE = (*BARE, "--path", GATEWAY / "tests", "--path", BUILD / "matlab")  # with the gateway of the build folder


def build_mex():
    need("octave")
    folder = BUILD / "matlab"
    folder.mkdir(parents=True, exist_ok=True)
    run(*BARE, "--eval", f"mimo_build('{ROOT}')", cwd=folder, env={"CFLAGS": "-O2 -Wall -Wextra -Werror"})


def check_says(message, folder, code, **variables):
    """Checks what Octave says that runs code in a folder, with the functions on its path."""
    _, said = try_run(*BARE, "--eval", code, cwd=folder, env={"CFLAGS": "-O0", **variables})
    if message not in said:
        fail(f"Octave says: {said}")


def check_building():
    """Compiles the gateway for a clone on a relative path, and for a library that the compiler finds."""
    elsewhere = fresh(BUILD / "octave")
    clone, empty = elsewhere / "libmimo", elsewhere / "no"
    fresh(clone / "build/installed")
    empty.mkdir()
    (clone / "build/lib").symlink_to(BUILD / "lib")
    (clone / "include").symlink_to(ROOT / "include")
    check_says("mimo_build compiles it", elsewhere, "mimo_version()")
    check_says("libmimo is 'nowhere', which is no folder", elsewhere, "mimo_build('nowhere')")
    check_says(f"run ./dev build in {empty}", elsewhere, "mimo_build('no')")
    check_says("good", elsewhere, "mimo_build('libmimo'); cd no; addpath('..'); mimo_version(), disp('good')")
    found = {"CPATH": ROOT / "include", "LIBRARY_PATH": BUILD / "lib", "LD_LIBRARY_PATH": BUILD / "lib"}
    check_says("good", clone / "build/installed", "mimo_build(); mimo_version(), disp('good')", **found)


def check_parts():
    uses = {}
    for file in GATEWAY.glob("*.[ch]"):
        others = re.findall(r'^#include "(\w+)\.h"', file.read_text(), re.MULTILINE)
        uses.setdefault(file.stem, set()).update({*others} - {file.stem})
    check_acyclic("the parts of the MEX gateway", uses)


def test_octave():
    check_parts()
    build_program()
    build_mex()
    print("Tests of the MEX gateway")
    run(*OCTAVE, "--eval", "tests")
    check_building()
    for example in ROOT.glob("examples/matlab/*.m"):
        run(*OCTAVE, example)
    follow("matlab")
