"""Tests of the Rust crates."""

import graphlib
import re

from .build import build_program
from .need import need
from .shell import BUILD, ROOT, fail, output, run, run_quietly, try_run

CRATES = ROOT / "bindings/rust"
TARGET = {"CARGO_TARGET_DIR": BUILD / "rust"}
LIBRARY = {"MIMO_LIB_DIR": BUILD / "lib", "LD_LIBRARY_PATH": BUILD / "lib", **TARGET}
EXAMPLES = ("hello", "batch", "observe", "own_reward", "own_goal")


def cargo(*arguments, **variables):
    """Runs cargo on the crates, with the library of the build folder."""
    run("cargo", *arguments, cwd=CRATES, env={**LIBRARY, **variables})


def follow(binding):
    """Does what the README of a binding says, step by step."""
    run_quietly("tests/readme/follow", f"bindings/{binding}/README.md", ".")
    print(f"README of bindings/{binding} followed")


def check_acyclic(what, uses):
    """Fails if parts, each with those that it uses, use each other in a circle."""
    try:
        graphlib.TopologicalSorter(uses).prepare()
    except graphlib.CycleError as error:
        fail(f"{what} use each other in a circle: {' '.join(reversed(error.args[1]))}")


def check_modules():
    uses = {}
    for file in CRATES.glob("mimo/src/*.rs"):
        code = re.sub(r"^\s*//.*", "", file.read_text(), flags=re.MULTILINE)
        uses[file.stem] = {*re.findall(r"crate::([a-z]\w*)", code)} - {"sys"}  # sys is below all
    check_acyclic("the modules of the Rust crate", uses)


def check_refusal(message, *variables):
    """Checks what a user reads whose libmimo cannot be found."""
    command = ("env", "-u", "MIMO_LIB_DIR", *variables, "cargo", "build", "-q", "-p", "mimo-sys")
    status, said = try_run(*command, cwd=CRATES, env=TARGET)
    if status == 0 or message not in said or "panicked" in said:
        fail(f"Rust without a library says ({status}): {said}")


def check_crates():
    """What a registry would get compiles by itself, and has its licence and README."""
    for crate in ("mimo-sys", "mimo"):
        listed = output("cargo", "package", "--list", "--allow-dirty", "-p", crate, cwd=CRATES).splitlines()
        if not {"LICENSE", "README.md"} <= {*listed}:
            fail(f"{crate} has no licence or README: {listed}")
        patch = "patch.crates-io.mimo-sys.path='mimo-sys'"
        cargo("package", "-q", "--offline", "--allow-dirty", "-p", crate, "--config", patch)


def test_rust():
    need("rust")
    check_modules()
    build_program()
    print("Tests of the Rust crates")
    check_refusal('MIMO_LIB_DIR is "/nowhere", expected', "MIMO_LIB_DIR=/nowhere")
    check_refusal("set MIMO_LIB_DIR to the folder of libmimo.so", "PKG_CONFIG_LIBDIR=/nowhere")
    cargo("fmt", "--check")
    cargo("clippy", "-q", "--all-targets", "--", "-D", "warnings")
    cargo("doc", "-q", "--no-deps", RUSTDOCFLAGS="-D warnings")
    cargo("test", "-q")
    # Beside the other build folders, so that ccache knows all that the crate builds.
    bundled = {
        "MIMO_BUILD_DIR": ROOT / "build-rust",
        "MIMO_CMAKE_ARGS": "-G Ninja -DMIMO_WERROR=ON",
        "LD_LIBRARY_PATH": "",
    }
    cargo("test", "-q", "-p", "mimo-sys", "--features", "bundled", **bundled)
    check_crates()
    for example in EXAMPLES:
        cargo("run", "-q", "--example", example)
    follow("rust")
