"""What is made of the public headers, and what is kept of them before a release."""

import re
import shutil

from .build import build
from .need import need
from .shell import BUILD, PYTHON, ROOT, copy, fresh, run, version

MADE = ROOT / "interface"


def interface(*arguments):
    """Renews what is made of the public headers, all of whose declarations have to be documented."""
    need("docs")
    run(PYTHON, MADE / "generate.py", *arguments)


def record(file):
    """Makes a recording of an infant of six months, in a scene without textures, which would be most of it."""
    folder = fresh(BUILD / "kept")
    run(BUILD / "bin/kept_states", "scene", folder / "saved")
    scene = (folder / "saved/scene.xml").read_text()
    (folder / "plain.xml").write_text(re.sub(r'<texture [^>]*/>| texture="[^"]*"', "", scene))
    file.unlink(missing_ok=True)
    options = ("--age", 6, "--touch", 0.1, "--seconds", 0.3, "--state-every", 0.1, "--seed", 7, "--keep", "all")
    run(BUILD / "bin/mimo", "record", "--scene", folder / "plain.xml", *options, "--out", file)


def freeze():
    """Keeps the interface as it is now as that of its version; docs/abi.md."""
    need("build", "abigail-tools")
    name = version("API")
    folder, states, kept = ROOT / "tests/abi/frozen" / name, ROOT / "tests/states" / name, MADE / f"frozen/{name}.json"
    shutil.rmtree(folder / "mimo", ignore_errors=True)
    copy(ROOT.glob("include/mimo/*.h"), folder / "mimo")
    copy(ROOT.glob("include/mimo/experimental/*.h"), folder / "mimo/experimental")
    copy([ROOT / "tests/abi/caller.c"], folder)
    states.mkdir(parents=True, exist_ok=True)
    kept.unlink(missing_ok=True)  # a candidate's: its sizes are no first ones
    interface()
    shutil.copy(MADE / "interface.json", kept)
    run("tests/abi/check_abi", "cc", "include/mimo/mimo.h", "tests/abi/baseline.abi", "--write")
    build("release", "mimo_program", "kept_states")
    run(BUILD / "bin/kept_states", "write", states)
    record(states / "recording.h5")
    print(f"Frozen as {name}; git diff tests/abi tests/states shows what is promised from now on")
