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


def record():
    """Makes a recording of an infant of six months, in a scene without textures, which would be most of it."""
    folder = fresh(BUILD / "kept")
    file = folder / "recording.h5"
    run(BUILD / "bin/kept_states", "scene", folder / "saved")
    scene = (folder / "saved/scene.xml").read_text()
    (folder / "plain.xml").write_text(re.sub(r'<texture [^>]*/>| texture="[^"]*"', "", scene))
    options = ("--age", 6, "--touch", 0.1, "--seconds", 0.3, "--state-every", 0.1, "--seed", 7, "--keep", "all")
    run(BUILD / "bin/mimo", "record", "--scene", folder / "plain.xml", *options, "--out", file)
    return file


def contents(recording):
    """All that a recording holds, except which build made it; HDF5 adds the time of the clock."""
    import h5py  # Debian's, which freeze() installs

    held = {}

    def take(name, thing):
        data = (str(thing.dtype), thing.shape, thing[()].tobytes()) if isinstance(thing, h5py.Dataset) else ()
        held[name] = data, {key: str(value) for key, value in thing.attrs.items() if key != "build"}

    with h5py.File(recording) as file:
        take("", file)
        file.visititems(take)
    return held


def keep_recording(made, kept):
    """Puts a new recording in the place of the kept one, unless it holds the same."""
    if kept.exists() and contents(made) == contents(kept):
        print(f"{kept} stays: a new recording holds the same")
    else:
        shutil.copy(made, kept)


def freeze():
    """Keeps the interface as it is now as that of its version; docs/abi.md."""
    need("build", "abigail-tools", "python3-h5py")
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
    keep_recording(record(), states / "recording.h5")
    print(f"Frozen as {name}; git diff tests/abi tests/states shows what is promised from now on")
