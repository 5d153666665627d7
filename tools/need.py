"""What has to be installed: Debian packages, by what needs them."""

import os
import shutil
import time

from .shell import fail, must, try_run

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
    # PyPI's torch for Linux brings gigabytes of CUDA along. Debian's takes the plain BLAS, which is slow, otherwise.
    "train": "python3-torch libopenblas0-pthread",
    "cross": """dpkg-dev libeigen3-dev libfmt-dev libosmesa6-dev libcli11-dev nlohmann-json3-dev python3-venv
        ninja-build cmake ccache""",
    "windows": "g++-mingw-w64-x86-64-posix mingw-w64-tools llvm wine64",
    "arm": "qemu-user libc6-arm64-cross libgcc-s1-arm64-cross",
    "macos": "llvm",
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
        fail(f"packages are missing; please run: sudo {' '.join(command)}")
    print(f"Installing {' '.join(missing)}")
    update()
    quietly = ("-y", "-qq", "-o", f"DPkg::Lock::Timeout={PATIENCE}")
    return must(f"failed: {' '.join(command)}", *command, *quietly, env={"DEBIAN_FRONTEND": "noninteractive"})


def not_installed(packages):
    known = try_run("dpkg-query", "-W", "-f", "${Package} ${db:Status-Status}\n", *packages)[1].splitlines()
    users = ["libmujoco-dev"] if "mujoco_ROOT" in os.environ else []  # the user's own is used
    return [package for package in packages if f"{package} installed" not in known and package not in users]


def update():
    """Renews apt's lists. Unlike apt-get install, apt-get update does not wait for another apt by itself."""
    end = time.monotonic() + PATIENCE
    command = ("apt-get", "update", "-qq", "-o", f"DPkg::Lock::Timeout={PATIENCE}")
    while (done := try_run(*command, env={"LC_ALL": "C"}))[0] != 0:
        if "Could not get lock" not in done[1] or time.monotonic() > end:
            fail(f"apt-get update failed: {done[1]}")
        time.sleep(1)
