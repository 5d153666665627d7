"""The systems that libmimo is built for besides the one that builds it, and what the kinds of packages call them."""

from typing import NamedTuple

from .shell import ROOT, fail


class System(NamedTuple):
    """A system; docs/platforms.md says what is offered for it."""

    name: str  # the CMake preset's
    wheel_tag: str
    nuget: str
    rust: str  # a condition of cargo's
    libraries: tuple  # libmimo and its MuJoCo, by the names that programs ask for
    zig: str = ""  # zig's target, with the glibc whose later functions are not used; empty: another compiler

    @property
    def folder(self):
        return ROOT / f"build-{self.name}"


def linux(name, processor, nuget):
    rust = f'all(target_os = "linux", target_env = "gnu", target_arch = "{processor}")'
    libraries = ("lib/libmimo.so.1", "lib/libmujoco.so.2.2.2")
    return System(name, f"manylinux_2_28_{processor}", nuget, rust, libraries, f"{processor}-linux-gnu.2.28")


def macos(name, processor, pythons, nuget):
    rust = f'all(target_os = "macos", target_arch = "{processor}")'
    libraries = ("lib/libmimo.dylib", "lib/libmujoco.2.2.2.dylib")
    return System(name, f"macosx_11_0_{pythons}", nuget, rust, libraries, f"{processor}-macos.11.0")


WINDOWS = ("bin/mimo.dll", "bin/mujoco-2.2.2.dll")
ALL = [
    linux("linux", "x86_64", "linux-x64"),
    linux("arm", "aarch64", "linux-arm64"),
    System("windows", "win_amd64", "win-x64", 'all(windows, target_arch = "x86_64")', WINDOWS),
    macos("macos", "aarch64", "arm64", "osx-arm64"),
    macos("macos-x86", "x86_64", "x86_64", "osx-x64"),
]
SYSTEMS = {system.name: system for system in ALL}


def chosen(name):
    """The system of that name, or all of them."""
    if name not in (*SYSTEMS, "all"):
        fail(f"no platform '{name}'; there are: {' '.join(SYSTEMS)} all")
    return ALL if name == "all" else [SYSTEMS[name]]
