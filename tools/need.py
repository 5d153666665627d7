"""What has to be installed: Debian packages, by what needs them."""

import os
import re
import shutil
import time

from .shell import fail, try_run

PACKAGES = {
    "build": """g++ cmake ninja-build ccache pkgconf python3 libgtest-dev libmujoco-dev libeigen3-dev libpugixml-dev
        libfmt-dev libhwy-dev libosmesa6-dev libcli11-dev nlohmann-json3-dev libpng-dev zlib1g-dev libhdf5-103-1""",
    "test": "abigail-tools locales luajit xvfb xauth python3-h5py libglfw3-dev libgl-dev libegl1 libgl1-mesa-dri",
    "lint": "clang clang-format clang-tidy doxygen",
    "docs": "doxygen",
    "package": "debhelper dpkg-dev file lintian python3",
    "release": "file clang binutils",
    "python": "python3-venv libosmesa6 libegl1 libgl1-mesa-dri",
    "rust": "cargo rustc rustfmt rust-clippy",
    "csharp": "mono-mcs mono-runtime libmono-system4.0-cil libmono-system-core4.0-cil",
    "octave": "octave octave-dev",
    "view": "chromium",
    "javascript": "nodejs npm",
    # PyPI's torch for Linux brings gigabytes of CUDA along. Debian's takes the plain BLAS, which is slow, otherwise.
    "train": "python3-torch libopenblas0-pthread",
    "cross": """dpkg-dev libeigen3-dev libfmt-dev libosmesa6-dev libcli11-dev nlohmann-json3-dev python3-venv
        ninja-build cmake ccache""",
    "windows": "g++-mingw-w64-x86-64-posix mingw-w64-tools llvm wine64",
    "arm": "qemu-user libc6-arm64-cross libgcc-s1-arm64-cross",
    "macos": "llvm",
    "web": "emscripten brotli",
}
PATIENCE = 600  # seconds that another apt may take


def need(*groups):
    """Installs the packages of groups, or single ones; fails with the command where that is not possible."""
    packages = dict.fromkeys(package for group in groups for package in PACKAGES.get(group, group).split())
    if not shutil.which("apt-get"):  # only programs can be looked for; CMake names the libraries that it misses
        programs = ["c++", "cmake", "ninja", *(package for package in packages if package in PACKAGES["lint"].split())]
        missing = [program for program in programs if not shutil.which(program)]
        return fail(f"please install: {' '.join(missing)}") if missing else None
    missing = not_installed(packages)
    if not missing:
        return None
    command = ["apt-get", "install", "--no-install-recommends", *missing]
    if os.geteuid() != 0:
        fail(f"packages are missing; please run: sudo apt-get update && sudo {' '.join(command)}")
    print(f"Installing {' '.join(missing)}, and what they need")
    said = update()
    quietly = ("-y", "-qq", "-o", f"DPkg::Lock::Timeout={PATIENCE}")
    status, more = try_run(*command, *quietly, env={"DEBIAN_FRONTEND": "noninteractive", "LC_ALL": "C"})
    return fail(explain(f"{said}\n{more}", command)) if status else None


def explain(said, command):
    """What to do about an apt that failed, in a sentence."""
    lines = said.strip().splitlines() or ["it says nothing"]
    reason = next((line for line in lines if line.startswith("E: ")), lines[-1])
    if re.search("Failed to fetch|Temporary failure|Could not (resolve|connect)", said):
        return f"packages cannot be fetched; please check the network, or that of apt's mirror ({reason})"
    if lacking := re.search(r"Unable to locate package (\S+)", said):
        return (
            f"this system's apt has no {lacking[1]}: ./dev installs packages on Debian 12 only; elsewhere please "
            "build as CONTRIBUTING.md says, with mujoco_ROOT set to the folder of a MuJoCo 2.2"
        )
    if "enough free space" in said or "No space left" in said:
        return f"the disk is too full for the packages; please make room for 700 MB ({reason})"
    return f"please see why this fails, and run ./dev again: {' '.join(command)} ({reason})"


def not_installed(packages):
    known = try_run("dpkg-query", "-W", "-f", "${Package} ${db:Status-Status}\n", *packages)[1].splitlines()
    users = ["libmujoco-dev"] if "mujoco_ROOT" in os.environ else []  # the user's own is used
    return [package for package in packages if f"{package} installed" not in known and package not in users]


def update():
    """Renews apt's lists; returns what apt said. Unlike apt-get install, apt-get update waits for no other apt."""
    end = time.monotonic() + PATIENCE
    command = ("apt-get", "update", "-qq", "-o", f"DPkg::Lock::Timeout={PATIENCE}")
    while (done := try_run(*command, env={"LC_ALL": "C"}))[0] != 0:
        if "Could not get lock" not in done[1] or time.monotonic() > end:
            fail(explain(done[1], command))
        time.sleep(1)
    return done[1]
