"""Downloads and Python environments, all bound to the hashes of tools/pins.toml and tools/pins/*.txt."""

import hashlib
import shutil
import zipfile

import tomllib

from .need import need
from .shell import BUILD, PYTHON, ROOT, fail, fresh, must, run

LISTS = ROOT / "tools/pins"
PINS = tomllib.loads((ROOT / "tools/pins.toml").read_text())
EARLIER = ("gymnasium-0.28", "gymnasium-0.29")  # what environments are tested with besides the newest
MUJOCOS = ("mujoco-2.3", "mujoco-3.1", "mujoco-3.3", "mujoco-3.10")  # likewise mimo.Renderer
PIP = {"PIP_DISABLE_PIP_VERSION_CHECK": 1}


def environment(name, *lists):
    """The programs of a virtual environment build/NAME with the packages of lists; made again when a list changes."""
    folder = BUILD / name
    wanted = "".join((LISTS / f"{one}.txt").read_text() for one in lists)
    stamp = folder / "pins.txt"
    if not stamp.is_file() or stamp.read_text() != wanted:
        need("python")
        shutil.rmtree(folder, ignore_errors=True)
        run(PYTHON, "-m", "venv", folder)
        files = [word for one in lists for word in ("-r", LISTS / f"{one}.txt")]
        run(folder / "bin/pip", "install", "-q", "--require-hashes", "--only-binary=:all:", *files, env=PIP)
        stamp.write_text(wanted)
    return folder / "bin"


def tool(name):
    """A program that makes, fetches or tests packages of Python."""
    return environment("tools", "tools") / name


def check_hash(file, pin):
    if not file.is_file() or hashlib.sha256(file.read_bytes()).hexdigest() != pin["sha256"]:
        fail(f"{file.name} is not the one that is expected")


def unzip(archive, folder):
    with zipfile.ZipFile(archive) as packed:
        packed.extractall(folder)


def download(folder, python, *options):
    pip = (tool("pip"), "download", "-q", "--no-deps", "--only-binary=:all:", "--python-version", python, "-d", folder)
    must(f"pip cannot fetch {options[-1]}", *pip, *options, env=PIP)


def fetch_package(name, system, folder):
    """Fetches a pinned package of Python for a system and unpacks it into a folder."""
    package, pin = PINS[name], PINS[name][system]
    download(fresh(folder), package["python"], "--platform", pin["platform"], package["package"])
    for wheel in folder.glob("*.whl"):
        if "file" not in pin:
            check_hash(wheel, pin)
        unzip(wheel, folder)
        wheel.unlink()
    if "file" in pin:
        check_hash(folder / pin["file"], pin)


def renew(keep):
    """Writes tools/pins/*.txt with the newest versions, or with those that are there and what is missing."""
    uv = (tool("uv"), "pip", "compile", "--quiet", "--generate-hashes", "--no-header", *([] if keep else ["--upgrade"]))
    pins, ours = "tools/pins/", "bindings/python/pyproject.toml"

    def compile_list(name, *files, python="3.11", platform=""):
        place = ("--python-platform", platform) if platform else ("--universal",)
        run(*uv, *place, "--python-version", python, *files, "-o", f"{pins}{name}.txt")

    for name in ("tools", "conan", "zig", "lint", "site", "train", "robosuite", *EARLIER, *MUJOCOS):
        compile_list(name, f"{pins}{name}.in")
    # pip asks the Python that runs it about conditions, so each Python that it installs for has a list without any.
    for python in ("3.9", "3.11", "3.13"):
        compile_list(f"run-{python}", f"{pins}run.in", python=python, platform="linux")
    compile_list("wine", f"{pins}wine.in", platform="windows")
    compile_list("ray", f"{pins}ray.in", "--no-emit-package", "torch")
    for name in ("train-alone", "robosuite-alone", *(f"{one}-alone" for one in EARLIER), "mujoco"):
        compile_list(name, f"{pins}{name}.in", "--no-deps")
    compile_list("test", ours, "--extra", "test", python="3.9")
    extras = [word for one in ("test", "view", "video", "plot", "rerun", "usd") for word in ("--extra", one)]
    compile_list("view", ours, f"{pins}browser.in", *extras)
    extras = [word for one in ("test", "video", "nwb", "bids", "lsl") for word in ("--extra", one)]
    compile_list("files", ours, f"{pins}files.in", *extras)
