"""Conan's recipe: `conan create .` in the unpacked sources makes the package libmimo, of Debian's libraries."""

import re
from pathlib import Path

from conan import ConanFile
from conan.errors import ConanInvalidConfiguration
from conan.tools.cmake import CMake, CMakeToolchain
from conan.tools.files import load
from conan.tools.system.package_manager import Apt


class Libmimo(ConanFile):
    name = "libmimo"
    description = "MIMo, the multimodal infant model, as an embeddable C library"
    license = "MIT"
    topics = ("infant", "simulation", "robotics", "mujoco")
    package_type = "shared-library"
    settings = ("os", "arch", "compiler", "build_type")
    exports_sources = (
        "CMakeLists.txt", "LICENSE", "CHANGELOG.md", "cmake/*", "docs/*", "examples/*", "include/*", "interface/*",
        "models/*", "src/*", "bindings/*",
    )  # fmt: skip

    def set_version(self):
        text = load(self, Path(self.recipe_folder) / "include/mimo/status.h")
        found = dict(re.findall(r'^#define MIMO_VERSION_([A-Z]+) +"?([^" \n]*)', text, re.MULTILINE))
        self.version = "{MAJOR}.{MINOR}.{PATCH}{LABEL}".format(**found)

    def validate(self):
        if self.settings.os != "Linux":
            raise ConanInvalidConfiguration("this recipe was tried on Debian 12 only; see docs/platforms.md for others")

    def system_requirements(self):
        packages = (
            "libmujoco-dev", "libeigen3-dev", "libpugixml-dev", "libfmt-dev", "libhwy-dev", "libosmesa6-dev",
            "libcli11-dev", "nlohmann-json3-dev", "libpng-dev", "zlib1g-dev",
        )  # fmt: skip
        Apt(self).install(list(packages))

    def layout(self):
        self.folders.build = "build"
        self.folders.generators = "build/generators"

    def generate(self):
        toolchain = CMakeToolchain(self, generator="Ninja")
        toolchain.cache_variables.update(MIMO_TESTS=False, MIMO_PROGRAM=True)
        toolchain.blocks.remove("arch_flags")  # Debian's packages are those of this processor
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        CMake(self).install()

    def package_info(self):
        self.cpp_info.libs = ["mimo"]
        self.cpp_info.set_property("cmake_find_mode", "none")  # it brings its own
        self.cpp_info.builddirs = [str(Path("lib") / "cmake" / "mimo")]
        self.cpp_info.set_property("pkg_config_name", "mimo")
