"""Tests of the build for Windows, by wine."""

import os
import re
import shutil

from .build import PROGRAM
from .cross import build_for
from .csharp import MADE, build_tests, dotnet
from .elsewhere import FIRST_STEPS, check_moved, steps_here, test_system
from .need import need
from .pins import PINS, check_hash, unzip
from .same import check_same
from .shell import ROOT, copy, fail, fresh, must, run, run_quietly, try_run
from .systems import SYSTEMS
from .wheels import RELEASE, put_wheel, wheel_for

WINDOWS, LINUX = SYSTEMS["windows"], SYSTEMS["linux"]
FOLDER, WINE64 = WINDOWS.folder, "/usr/lib/wine/wine64"
WINE = {"WINEDEBUG": "-all", "WINEPREFIX": str(FOLDER / "wine")}
PYTHON = RELEASE / "python-windows"
PACKAGES = PYTHON / "packages"  # the wheel and what it needs
STEP_UNIT = ROOT / "tests/loading/step_unit.py"
PICTURES = ("run", "--scene", "benchmark", "--seconds", "0.05", "--seed", "3", "--vision", "64", "--out")


def on_windows(path):
    """What programs for Windows call a file under wine."""
    return f"Z:{path}".replace("/", "\\")


def wine(*command, **variables):
    """Runs a program for Windows; its lines end as here. Python there takes pipes only."""
    status, said = try_run(WINE64, *command, env={**WINE, **variables})
    return status, said.replace("\r", "").rstrip("\n")


def says(*command, **variables):
    """What a program for Windows prints that has to succeed."""
    status, said = wine(*command, **variables)
    if status != 0:
        fail(f"on Windows {command[0]} fails ({status}): {said}")
    return said


def python(*arguments, **variables):
    """Runs Windows' Python with the wheel."""
    path = f"{on_windows(PYTHON / 'lib')};{on_windows(PACKAGES)}"
    return wine(PYTHON / "python.exe", *arguments, PYTHONHOME=on_windows(PYTHON), PYTHONPATH=path, **variables)


def fetch_python():
    if (PYTHON / "python.exe").is_file():
        return
    need("maven")
    pin, folder = PINS["python"]["windows"], fresh(RELEASE / "maven")
    copy_artifact = "org.apache.maven.plugins:maven-dependency-plugin:3.6.1:copy"
    run("mvn", "-q", "-B", copy_artifact, f"-DoutputDirectory={folder}", f"-Dartifact={pin['artifact']}")
    check_hash(folder / pin["file"], pin)
    unzip(folder / pin["file"], folder)
    shutil.rmtree(PYTHON, ignore_errors=True)
    shutil.move(folder / "org/bytedeco/cpython/windows-x86_64", PYTHON)
    copy(PYTHON.glob("lib/vcruntime140*.dll"), PYTHON)
    shutil.rmtree(folder)


def check_pictures():
    """Pictures are those of the build for any Linux on the same MuJoCo: Windows aligns the renderer's stack less."""
    pictures = fresh(FOLDER / "pictures")
    build_for(LINUX, "mimo", "mimo_program")
    says(FOLDER / "bin/mimo.exe", *PICTURES, pictures / "windows")
    run_quietly(LINUX.folder / "bin/mimo", *PICTURES, pictures / "here")
    must("Windows draws other pictures", "diff", "-r", pictures / "here", pictures / "windows")
    print("The same pictures on Windows")


def check_states():
    """States move to Windows and back unchanged. Steps there differ by rounding: docs/platforms.md."""
    build_for(LINUX, "kept_states")
    here, there = LINUX.folder / "bin/kept_states", FOLDER / "bin/kept_states.exe"
    check_moved((here,), (WINE64, there), FOLDER / "moved", steps=0)


def check_wheel():
    """A newcomer's first steps say the same with the wheel for Windows as here."""
    fetch_python()
    expected = steps_here()
    wheel_for(WINDOWS)
    put_wheel(WINDOWS, "3.11", PACKAGES, "wine")
    check_same("other bytes by Windows' Python", expected, python(FIRST_STEPS)[1])
    print("The same bytes by Windows' Python")


def check_units():
    """Units of FMI that the program writes there hold all that Windows lacks, and step."""
    fetch_python()
    for version in ("2", "3"):
        unit = FOLDER / f"reach{version}.fmu"
        unit.unlink(missing_ok=True)
        options = ("--scene", "reach", "--outputs", "proprioception", "--vision", "off", "--fmi", version)
        says(FOLDER / "bin/mimo.exe", "export", "--fmu", on_windows(unit), *options)
        status, said = python(on_windows(STEP_UNIT), on_windows(unit))
        if (status, said) != (0, f"5 steps by FMI {version}, and back to a state"):
            fail(f"Windows' Python steps {unit} and says ({status}): {said}")
    print("Units of FMI on Windows")


def check_csharp():
    """Tests the C# classes by Windows' .NET, with the HDF5 that the wheel's packages brought."""
    build_tests("WindowsTests.exe", "-define:WINDOWS")
    print("Tests of the C# classes on Windows")
    libraries = {"WINEPATH": on_windows(FOLDER / "bin"), "MIMO_HDF5": on_windows(PACKAGES / "h5py/hdf5.dll")}
    print(says(*dotnet("windows"), MADE / "WindowsTests.exe", "--all", **libraries))


def check_other_mujoco():
    """A MuJoCo of another version is left alone if the program has it already, and refused in the place of ours."""
    other = FOLDER / "other"
    (other / "mimo").mkdir(parents=True, exist_ok=True)
    run("x86_64-w64-mingw32-gcc-posix", "-shared", "-o", other / "mujoco.dll", "tests/loading/stand_in.c")
    load = f"import ctypes; assert ctypes.CDLL(r'{on_windows(other / 'mujoco.dll')}').mj_version() == 999"
    done = python("-c", f"{load}; import mimo; mimo.make('reach').reset()")
    if done != (0, ""):
        fail(f"beside another MuJoCo Windows' Python says: {done[1]}")
    copy([FOLDER / "bin/mimo.dll"], other / "mimo")
    shutil.copy(other / "mujoco.dll", other / "mimo/mujoco-2.2.2.dll")
    # Windows refuses to load a library whose functions are missing; wine loads it, and libmimo looks at the version.
    ours = on_windows(other / "mimo/mimo.dll")
    status, said = python("-c", "import mimo; mimo.make('reach')", MIMO_LIBRARY=ours)
    if status == 0 or not re.search(
        r"built for MuJoCo 2\.2\.2, but found MuJoCo .*replaced the one in libmimo's folder", said, re.DOTALL
    ):
        fail(f"with another MuJoCo Windows' Python says ({status}): {said}")
    print("Other MuJoCos are left alone or refused on Windows")


def test_windows():
    os.environ.update(WINE)  # for ctest, too
    build_for(WINDOWS, *PROGRAM)
    # The first program makes wine's folder. Two that ctest starts at once would get in each other's way.
    print(says(FOLDER / "bin/mimo.exe", "--version"))
    test_system(WINDOWS)
    check_pictures()
    check_states()
    check_wheel()
    check_units()
    check_csharp()
    check_other_mujoco()
