"""Tests of builds for other Linux systems: in files of other Debian releases, and by QEMU."""

import re
import shutil
import sys
import tempfile

from .build import build, use_mujoco
from .cross import build_for
from .ctest import run_workflow
from .need import need
from .pins import tool
from .same import check_same, steps_of
from .shell import BUILD, PYTHON, ROOT, copy, fail, fresh, must, only, output, run, run_quietly, try_run
from .systems import SYSTEMS
from .wheels import RELEASE, WHEELS, put_wheel, wheel_for

LINUX, ARM = SYSTEMS["linux"], SYSTEMS["arm"]
PACKAGES = RELEASE / "packages"  # the wheel for any Linux and what it needs, for the Python of this system
FIRST_STEPS = "tests/package/first_steps.py"


def check_same_as_here(expected, *command):
    """Checks that a command says what the build for any Linux says here."""
    text = " ".join(str(word) for word in command)
    check_same(f"other bytes by {text}", expected, output(*command))
    print(f"The same bytes by {text}")


def steps_here():
    """Makes the wheel for any Linux; returns what a newcomer's first steps say with it here."""
    wheel_for(LINUX)
    put_wheel(LINUX, "{}.{}".format(*sys.version_info), PACKAGES)
    return output(PYTHON, FIRST_STEPS, env={"PYTHONPATH": PACKAGES})


def foreign_debian(name, suite, architecture):
    """Unpacks another release, or one for another processor, with Python, without installing it."""
    folder = RELEASE / name
    if (folder / "complete").is_file():
        return folder
    need("debootstrap")
    RELEASE.mkdir(parents=True, exist_ok=True)
    print(f"Fetching Debian {suite} for {architecture}")
    options = ("--download-only", "--arch", architecture, "--variant", "minbase", "--include", "python3")
    with tempfile.TemporaryDirectory() as fetched:  # debootstrap finds no dependencies on a path with a space
        must(f"Debian {suite} for {architecture} cannot be fetched", "debootstrap", *options, suite, fetched)
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(fetched, folder, symlinks=True)
    archives = folder / "var/cache/apt/archives"
    for package in archives.glob("*.deb"):
        run("dpkg-deb", "--extract", package, folder)
    shutil.rmtree(archives)
    (folder / "opt").mkdir(exist_ok=True)
    (folder / "complete").touch()
    return folder


def test_system(system):
    """Runs the C tests of a build, by what stands in for its system."""
    build_for(system)
    run_workflow(system.name)


def check_moved(here, there, folder, steps=20):
    """Moves states to another system for some steps and back: the worlds go on as if they had stayed here.

    here, there: commands of the program in tests/states, which run in the folder.
    """
    for name in ("start", "first", "stayed", "there", "back"):
        fresh(folder / name)
    run(*here, "write", "start", cwd=folder)
    run(*here, "go", "start", steps, "first", 20, "stayed", cwd=folder)
    run(*there, "go", "start", steps, "there", cwd=folder)
    run(*here, "go", "there", 20, "back", cwd=folder)
    for one, other in (("first", "there"), ("stayed", "back")):
        for file in folder.glob(f"{one}/*.state"):
            if file.read_bytes() != (folder / other / file.name).read_bytes():
                fail(f"{folder}: {file.name} of '{one}' and '{other}' differ by {there[0]}")
    print(f"States move by {there[0]} for {steps} steps and back, and worlds go on with the same bytes")


def check_release(suite, python, same, steps):
    """Checks that another release of Debian, whose C library is another, gives the same numbers as this system."""
    root = foreign_debian(suite, suite, "amd64")
    programs = (LINUX.folder / "bin" / name for name in ("capi_same", "kept_states"))
    copy([ROOT / FIRST_STEPS, *programs, *(LINUX.folder / library for library in LINUX.libraries)], root / "opt")
    inside, native = ("chroot", root, "env"), "/opt/packages/mimo/_native"
    check_same_as_here(same, *inside, "LD_LIBRARY_PATH=/opt", "/opt/capi_same")
    there = (*inside, "--chdir=/opt/moved", "LD_LIBRARY_PATH=/opt", "/opt/kept_states")
    check_moved((LINUX.folder / "bin/kept_states",), there, root / "opt/moved")
    put_wheel(LINUX, python, root / "opt/packages")
    check_same_as_here(steps, *inside, "PYTHONPATH=/opt/packages", "/usr/bin/python3", "/opt/first_steps.py")
    run_quietly(*inside, f"LD_LIBRARY_PATH={native}", f"{native}/mimo", "info")  # without /proc


def test_linux():
    """Tests the build for any Linux here, on releases of 2021 and 2025 (C libraries 2.31, 2.41), and without AVX."""
    test_system(LINUX)
    steps, same = steps_here(), output(LINUX.folder / "bin/capi_same")
    said = " ".join(output(tool("auditwheel"), "show", only(WHEELS, "mimo-*manylinux_2_28_x86_64.whl")).split())
    if not re.search(r'consistent with the following platform tag: "manylinux_2_\d+_x86_64"', said):
        fail(f"auditwheel does not confirm the wheel's tag: {said}")
    check_release("bullseye", "3.9", same, steps)
    check_release("trixie", "3.13", same, steps)
    need("qemu-user")
    program = LINUX.folder / "bin/mimo"
    status, said = try_run("qemu-x86_64", "-cpu", "Nehalem", program, "run", "--seconds", "0.1")
    if status == 0 or "has no AVX" not in said:
        fail(f"on a processor of 2008, which has no AVX, the program says: {said}")


def test_arm():
    """Tests the build for 64-bit ARM, whose MuJoCo gives the numbers of Debian's: both are for all processors."""
    need("arm")
    test_system(ARM)
    build("release", "capi_same", "kept_states", "same_steps", "same_maths")
    use_mujoco()
    qemu = ("qemu-aarch64", "-L")
    foreign = (*qemu, "/usr/aarch64-linux-gnu")
    check_same_as_here(output(BUILD / "bin/capi_same"), *foreign, ARM.folder / "bin/capi_same")
    check_same("other bytes on ARM", steps_of(BUILD, 100), steps_of(ARM.folder, 100, *foreign))
    print("The same bytes of all senses in 100 steps on ARM")
    check_moved((BUILD / "bin/kept_states",), (*foreign, ARM.folder / "bin/kept_states"), ARM.folder / "moved")
    root = foreign_debian("debian-arm", "bookworm", "arm64")
    packages, steps = root / "opt/packages", steps_here()
    wheel_for(ARM)
    put_wheel(ARM, "3.11", packages)
    check_same_as_here(steps, *qemu, root, "-E", f"PYTHONPATH={packages}", root / "usr/bin/python3", FIRST_STEPS)
    run_quietly(*qemu, root, packages / "mimo/_native/mimo", "info")
