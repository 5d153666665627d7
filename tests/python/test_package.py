"""The package as installed: complete, self-contained, and quiet."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

import mimo
from mimo import _abi
from mimo._library import _load, library_path

NATIVE = Path(mimo.__file__).parent / "_native"
installed = pytest.mark.skipif(
    not NATIVE.is_dir(), reason="runs from the source tree (MIMO_LIBRARY), not from the installed package"
)

# What may be asked of any Linux: the C and C++ runtimes and zlib, as in the manylinux policies. OSMesa is no
# dependency, it is looked for at run time.
SYSTEM = re.compile(r"(ld-linux.*|lib(c|m|dl|rt|pthread|gcc_s|stdc\+\+|z))\.so.*")


@installed
def test_every_library_is_inside_or_part_of_any_linux():
    inside = {file.name for file in NATIVE.iterdir()}
    assert {"libmimo.so.1", "libmujoco.so.2.2.2", "mimo"} <= inside
    for file in NATIVE.iterdir():
        if not file.is_file():
            continue
        dynamic = subprocess.run(["readelf", "-d", file], capture_output=True, text=True, check=True).stdout
        needed = re.findall(r"\(NEEDED\).*\[(.*)\]", dynamic)
        missing = [name for name in needed if name not in inside and not SYSTEM.fullmatch(name)]
        assert missing == [], file.name


@installed
def test_libraries_are_searched_beside_each_other_only():
    for name in ("libmimo.so.1", "mimo"):
        dynamic = subprocess.run(["readelf", "-d", NATIVE / name], capture_output=True, text=True, check=True).stdout
        assert re.findall(r"\(R(?:UN)?PATH\).*\[(.*)\]", dynamic) == ["$ORIGIN"], name


@installed
def test_the_library_takes_the_mujoco_inside(tmp_path):
    code = "import mimo; print(open('/proc/self/maps').read())"
    maps = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, cwd=tmp_path).stdout
    rows = (line.split(maxsplit=5) for line in maps.splitlines())
    files = {Path(row[5]) for row in rows if len(row) == 6}
    loaded = {file for file in files if file.name.startswith(("libmimo", "libmujoco"))}
    assert loaded == {NATIVE / "libmimo.so.1", NATIVE / "libmujoco.so.2.2.2"}


@installed
def test_the_program_is_inside(tmp_path):
    program = shutil.which("mimo", path=os.path.dirname(sys.executable))
    told = subprocess.run([program, "info", "--json"], capture_output=True, text=True, check=True, cwd=tmp_path)
    assert '"mass_kg"' in told.stdout


# By what CMake or the linker calls it; MuJoCo's brings four libraries along.
LICENCES = {
    "Eigen3": "eigen3",
    "pugixml": "pugixml",
    "fmt": "fmt",
    "hwy": "hwy",
    "CLI11": "cli11",
    "PNG": "png16",
    "nlohmann_json": "nlohmann-json",
    "mujoco": "mujoco",
    "libmujoco": "mujoco",
    "libccd": "ccd",
    "liblodepng": "lodepng",
    "libqhull_r": "qhull",
    "libtinyxml2": "tinyxml2",
    "libpng16": "png16",
}
NOT_INSIDE = {"Threads", "GTest", "ZLIB"}  # not inside the wheel, or every system's own


@installed
@pytest.mark.skipif(not Path("/etc/debian_version").exists(), reason="licences are taken from Debian's packages")
def test_the_wheel_holds_all_licences(root):
    (folder,) = NATIVE.parent.parent.glob("mimo-*.dist-info/licenses")
    assert (folder / "LICENSE").read_bytes() == (root / "LICENSE").read_bytes()
    linked = {file.name.split(".so")[0] for file in NATIVE.glob("*.so*")} - {"libmimo"}
    described = (root / "cmake/MimoDependencies.cmake").read_text()
    compiled = set(re.findall(r'^ *mimo_find\("[^"]+" \S+ (\w+)', described, re.MULTILINE)) | {"hwy"}
    assert {"Eigen3", "pugixml", "fmt"} <= compiled
    for name in linked | (compiled - NOT_INSIDE):
        text = (folder / f"{LICENCES[name]}.txt").read_text()
        assert "opyright" in text, name
        for referred in re.findall(r"/usr/share/common-licenses/([\w.+-]*\w)", text):
            assert (folder / "texts" / f"{referred}.txt").stat().st_size > 1000, name


def test_import_prints_nothing_and_makes_no_files(tmp_path):
    code = "import mimo; w = mimo.World('reach'); w.reset(seed=1); w.step(); print('done')"
    environment = {**os.environ, "PYTHONDONTWRITEBYTECODE": "1"}
    told = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, cwd=tmp_path, env=environment)
    assert (told.stdout, told.stderr, told.returncode) == ("done\n", "", 0)
    assert list(tmp_path.iterdir()) == []


def test_another_abi_version_is_refused(monkeypatch):
    monkeypatch.setattr(_abi, "ABI_VERSION", 99)
    with pytest.raises(ImportError, match="ABI version 1, this package needs 99"):
        _load(library_path())


def test_missing_functions_are_named(monkeypatch):
    monkeypatch.setitem(_abi.FUNCTIONS, "mimo_env_fly", (None, []))
    monkeypatch.setitem(_abi.FUNCTIONS, "mimo_env_swim", (None, []))
    with pytest.raises(ImportError, match="has no mimo_env_fly, mimo_env_swim; it belongs to another version"):
        _load(library_path())


def test_a_missing_library_is_named(tmp_path):
    with pytest.raises(ImportError, match=r"nothing\.so"):
        _load(tmp_path / "nothing.so")


@pytest.mark.skipif(sys.platform != "linux", reason="the name is Linux's; ./dev test --windows has its own")
def test_another_mujoco_beside_the_library_is_refused(tmp_path):
    """A library that lacks what libmimo calls, as other versions do: here a copy of libmimo."""
    for name in (library_path().name, f"libmujoco.so.{mimo.mujoco_version()}"):
        shutil.copy(library_path(), tmp_path / name)
    environment = {name: value for name, value in os.environ.items() if name != "LD_LIBRARY_PATH"}
    environment.update(MIMO_LIBRARY=str(tmp_path / library_path().name), PYTHONPATH=str(Path(mimo.__file__).parents[1]))
    done = subprocess.run([sys.executable, "-c", "import mimo"], capture_output=True, text=True, env=environment)
    said = done.stderr.splitlines()[-1]
    assert said.startswith(f"ImportError: {tmp_path / library_path().name} cannot be loaded: "), said
    assert said.endswith("the MuJoCo in its folder must be the one that came with it")


def test_version_and_scenes(root):
    header = (root / "include/mimo/status.h").read_text()
    numbers = re.findall(r"#define MIMO_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)", header)
    label = re.search(r'#define MIMO_VERSION_LABEL "(.*?)"', header).group(1)
    assert mimo.__version__ == ".".join(numbers) + label
    assert mimo.mujoco_version() == "2.2.2"
    assert {"reach", "standup", "selfbody", "catch", "rollover", "free", "babybench-crib"} <= set(mimo.scenes())
    assert {"none", "reach", "standup", "selfbody", "catch", "rollover", "selftouch", "handregard", "behaviour"} <= set(
        mimo.tasks()
    )


def library_beside(tmp_path, mujoco, imports):
    """What a program takes that imports these, where mujoco is of that version and a library for 4.0.1 is installed."""
    (tmp_path / "mujoco").mkdir()
    (tmp_path / "mujoco/__init__.py").write_text(f"__version__ = {mujoco!r}\n")
    (tmp_path / "mimo_mujoco4").mkdir()
    (tmp_path / "mimo_mujoco4/__init__.py").write_text(f"LIBRARY = {str(library_path())!r}\n")
    environment = {name: value for name, value in os.environ.items() if name != "MIMO_LIBRARY"}
    environment["PYTHONPATH"] = os.pathsep.join([str(tmp_path), str(Path(mimo.__file__).parents[1])])
    code = f"import {imports}; from mimo import library_path as taken; print(taken())"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, env=environment)
    return done.stdout.strip(), done.stderr


def test_a_program_with_mujoco_gets_the_library_for_it(tmp_path):
    assert library_beside(tmp_path, "4.0.1", "mujoco, mimo") == (str(library_path()), "")


@installed
@pytest.mark.parametrize(("mujoco", "imports"), [("3.3.7", "mujoco, mimo"), ("4.0.1", "mimo, mujoco")])
def test_other_programs_use_the_library_inside_the_package(tmp_path, mujoco, imports):
    taken, complaints = library_beside(tmp_path, mujoco, imports)
    assert (Path(taken).parent, complaints) == (NATIVE, "")


def test_errors_name_the_library_for_another_mujoco(monkeypatch):
    model = type("MjModel", (), {"__module__": "mujoco", "_address": 64})()
    for version, number, advice in (
        ("4.0.1", 4000001, r"pip install mimo\[mujoco\]"),
        ("3.3.7", 337, "no libmimo for it"),
    ):
        host = type(sys)("mujoco")
        host.__version__, host.mj_version = version, lambda number=number: number
        monkeypatch.setitem(sys.modules, "mujoco", host)
        with pytest.raises(mimo.UnsupportedError, match=advice):
            mimo.Senses(mimo.Scene("free"), model)


def test_importing_it_needs_numpy_only(tmp_path):
    code = """
import sys

class Missing:
    def find_spec(self, name, path=None, target=None):
        if name.split(".")[0] in ("gymnasium", "typing_extensions", "mujoco", "pettingzoo", "scipy", "PIL"):
            raise ModuleNotFoundError(name)

sys.meta_path.insert(0, Missing())
import mimo
mimo.World, mimo.Scene, mimo.Batch, mimo.Senses, mimo.Recorder
"""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, cwd=tmp_path)
    assert done.returncode == 0, done.stderr
