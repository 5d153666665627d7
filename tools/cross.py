"""Builds for other systems, and what they need, in build/cross."""

import shutil
from pathlib import Path

from .build import cmake
from .need import need
from .pins import PINS, environment, fetch_package
from .shell import BUILD, fresh, must, only, run

CROSS = BUILD / "cross"
HEADERS = ("eigen3/Eigen", "eigen3/unsupported", "fmt", "GL", "KHR", "CLI", "nlohmann")  # these know no system
COMPILED = {"pugixml": "pugixml", "zlib": "zlib", "libpng": "libpng1.6"}
KEYRING = "/usr/share/keyrings/debian-archive-keyring.gpg"
NEEDS = {"windows": ["windows"], "arm": ["arm"], "macos": ["macos"], "macos-x86": ["macos"]}


def fetch_sources(suite, *names):
    """Fetches and unpacks Debian's sources, whose signatures apt checks. It uses lists of its own, not the system's."""
    folder = CROSS / "sources"
    for place in ("lists/partial", "cache/archives/partial"):
        (folder / place).mkdir(parents=True, exist_ok=True)
    (folder / "list").write_text(f"deb-src [signed-by={KEYRING}] http://deb.debian.org/debian {suite} main\n")
    places = {"Etc::sourcelist": "list", "State::lists": "lists", "Cache": "cache"}
    options = [f"Dir::{name}={folder / place}" for name, place in places.items()]
    options += ["APT::Sandbox::User=root", "Dir::Etc::sourceparts=-"]
    apt = ("apt-get", "-qq", *(word for option in options for word in ("-o", option)))
    run(*apt, "update")
    must(f"the sources of {' '.join(names)} cannot be fetched", *apt, "source", *names, cwd=folder)


def fetch_dependencies():
    """Fetches what builds for all systems need: headers of this system, sources of the rest."""
    if (CROSS / "complete").is_file():
        return
    print("Fetching what builds for other systems need")
    fresh(CROSS)
    for folder in HEADERS:
        shutil.copytree(f"/usr/include/{folder}", CROSS / "include" / Path(folder).name)
    sources, licences = CROSS / "sources", fresh(CROSS / "licences")
    fetch_sources("bookworm", *COMPILED.values())
    fetch_sources("trixie", "highway")  # Debian 12's is older
    (CROSS / "sources.txt").write_text("".join(f"{folder.name}\n" for folder in sorted(sources.glob("*-[0-9]*/"))))
    for name in ("highway", *COMPILED):
        shutil.copy(only(sources, f"{name}*-[0-9]*/") / "debian/copyright", licences / f"{name}.txt")
    shutil.move(only(sources, "highway-*/") / "hwy", CROSS / "include")
    for name in COMPILED:
        only(sources, f"{name}*-[0-9]*/").rename(CROSS / name)
    shutil.copy(CROSS / "libpng/scripts/pnglibconf.h.prebuilt", CROSS / "libpng/pnglibconf.h")
    shutil.rmtree(sources)
    (CROSS / "complete").touch()


def zig():
    """The folder of zig, the compiler for other systems."""
    return only(environment("cross-zig", "zig").parent, "lib/python3*/site-packages/ziglang")


def write_zig_tools(system):
    """Writes zig's tools as programs of one word each, as CMake and ccache want them.

    Their C library is of the version that the target names; their C++ library goes into what is linked.
    """
    folder, program = CROSS / "zig" / system.name, zig() / "zig"
    if not folder.is_dir():
        fresh(folder)
        for tool in ("cc", "c++", "ar", "ranlib"):
            options = f" -target {system.zig} -fno-sanitize=undefined -g0" if tool.startswith("c") else ""
            (folder / tool).write_text(f'#!/bin/bash\nexec "{program}" {tool}{options} "$@"\n')
            (folder / tool).chmod(0o755)


def fetch_mujoco(system):
    """Fetches MuJoCo for a system: its library, headers and licences."""
    folder, wheel = CROSS / "mujoco" / system.name, CROSS / "wheel"
    if folder.is_dir():
        return
    fetch_package("mujoco", system.name, wheel)
    library = wheel / PINS["mujoco"][system.name]["file"]
    new = fresh(CROSS / "mujoco/new")
    for file in [library, wheel / "mujoco/include", *wheel.glob("*.dist-info/LICENSE*")]:
        shutil.move(file, new)
    if system.name == "windows":
        # Windows gives a program that asks for a library the one of that name that it has already, of any version.
        (new / "mujoco.dll").rename(new / "mujoco-2.2.2.dll")
        must("no mujoco.def", "gendef", "mujoco-2.2.2.dll", cwd=new)
        run(
            "x86_64-w64-mingw32-dlltool",
            "-d",
            "mujoco-2.2.2.def",
            "-l",
            "libmujoco.dll.a",
            "-D",
            "mujoco-2.2.2.dll",
            cwd=new,
        )
    elif system.name in ("macos", "macos-x86"):
        # The linker gets a copy that does not say that it lies in a framework; such a copy no longer runs.
        (new / "signed").mkdir()
        shutil.copy(new / library.name, new / "signed")
        run("llvm-install-name-tool-14", "-id", f"@rpath/{library.name}", new / library.name)
    new.rename(folder)
    shutil.rmtree(wheel)


def prepare(system):
    """Fetches what a build for a system needs."""
    need("cross", *NEEDS.get(system.name, []))
    fetch_dependencies()
    fetch_mujoco(system)
    if system.zig:
        write_zig_tools(system)


def build_for(system, *targets):
    prepare(system)
    cmake(system.name, *targets)
