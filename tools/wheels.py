"""Wheels with a library that was built already: for other systems, and for the package mujoco."""

import re
import shutil
from pathlib import Path

from .build import cmake, fetch_mujoco4
from .cross import CROSS, build_for, prepare, zig
from .need import need
from .pins import LISTS, PIP, tool
from .python import WHEELS, pip_wheel
from .shell import BUILD, ROOT, copy, fresh, only, run, run_quietly
from .systems import SYSTEMS

RELEASE = BUILD / "release"
PACKAGED = {  # licences of Debian's packages
    "libeigen3-dev": "eigen",
    "libfmt-dev": "fmt",
    "libcli11-dev": "cli11",
    "nlohmann-json3-dev": "nlohmann-json",
}
MINGW = {"g++-mingw-w64-x86-64-posix": "gcc-mingw", "mingw-w64-x86-64-dev": "mingw-w64"}


def licences(system, folder):
    """Collects the licences of all that is inside library and program of a system, and the texts that these name."""
    mujoco = CROSS / "mujoco" / system.name
    files = {"mujoco.txt": mujoco / "LICENSE", "mujoco-third-party.md": mujoco / "LICENSES_THIRD_PARTY.md"}
    for package, name in {**PACKAGED, **({} if system.zig else MINGW)}.items():
        files[f"{name}.txt"] = Path(f"/usr/share/doc/{package}/copyright")
    if system.zig:
        files.update({"libcxx.txt": zig() / "lib/libcxx/LICENSE.TXT", "zig.txt": zig() / "LICENSE"})
    copy([ROOT / "LICENSE", *CROSS.glob("licences/*.txt")], fresh(folder))
    for name, file in files.items():
        shutil.copy(file, folder / name)
    said = "".join(file.read_text() for file in folder.glob("*.txt"))
    (folder / "texts").mkdir()
    for text in {*re.findall(r"/usr/share/common-licenses/([A-Za-z0-9.+-]*[A-Za-z0-9])", said)}:
        shutil.copy(f"/usr/share/common-licenses/{text}", folder / "texts" / f"{text}.txt")


def collect(system):
    """Builds for a system; returns a folder of the libraries that programs load, the program, and the licences."""
    build_for(system, "mimo", "mimo_program")
    folder = fresh(RELEASE / system.name)
    copy([system.folder / library for library in system.libraries], folder / "libraries")
    copy([file for file in system.folder.glob("bin/mimo*") if file.name in ("mimo", "mimo.exe")], folder / "program")
    licences(system, folder / "licences")
    return folder


def make_wheel(sources, native, licences, tag):
    """Makes a wheel around native files; the tag promises where pip may install it."""
    print(f"Wheel of {sources} for {tag}")
    variables = {"MIMO_PREBUILT": native, "MIMO_LICENCES": licences}
    made = pip_wheel(sources, RELEASE / "wheel", fresh(RELEASE / "python-build"), **variables)
    run_quietly(tool("wheel"), "tags", "--remove", "--platform-tag", tag, made)
    copy([only(RELEASE / "wheel", "*.whl")], WHEELS)


def wheel_for(system, page=None):
    """Makes a system's wheel, with the page for recordings if there is one."""
    folder = collect(system)
    native = folder / "native"
    copy([*folder.glob("libraries/*"), *folder.glob("program/*"), *([page] if page else [])], native)
    make_wheel("bindings/python", native, folder / "licences", system.wheel_tag)
    shutil.rmtree(native)


def wheel_for_mujoco4():
    """Makes the wheel for programs that use the package mujoco: the library alone, on the MuJoCo of mujoco-core."""
    linux, native, folder = SYSTEMS["linux"], RELEASE / "mujoco4", RELEASE / "licences"
    need("patchelf")
    fetch_mujoco4()
    prepare(linux)
    cmake("linux-mujoco4", "mimo")
    licences(linux, folder)
    for file in folder.glob("mujoco*"):
        file.unlink()
    copy([ROOT / "build-linux-mujoco4/lib/libmimo-mujoco4.so.1"], fresh(native))
    run("patchelf", "--set-rpath", "$ORIGIN/../mujoco", native / "libmimo-mujoco4.so.1")
    make_wheel("bindings/python-mujoco4", native, folder, linux.wheel_tag)


def put_wheel(system, python, folder, pins=""):
    """Unpacks a system's wheel, and what it needs for a Python, into a folder, chosen by their tags."""
    older = ("manylinux_2_28", "manylinux2014", "manylinux_2_27")
    tags = {system.wheel_tag.replace("manylinux_2_28", tag): None for tag in older}
    tagged = [word for tag in tags for word in ("--platform", tag)]
    # pip install compares what packages require with the Python that runs it, not with the version that it is told.
    place = ("--target", folder, "--implementation", "cp", "--python-version", python, "--ignore-requires-python")
    pip = (tool("pip"), "install", "-q", "--only-binary=:all:", "--no-deps", *place, *tagged)
    shutil.rmtree(folder, ignore_errors=True)
    pinned = ("--require-hashes", "-r", LISTS / f"{pins or f'run-{python}'}.txt")
    for what in (pinned, (only(WHEELS, f"mimo-*-{system.wheel_tag}.whl"),)):
        run(*pip, *what, env=PIP)
