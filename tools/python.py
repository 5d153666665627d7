"""The Python package: its wheel, and the sessions of noxfile.py that test it."""

import os
import shutil
import tempfile

from .build import build_program
from .need import need
from .pins import PIP, environment, tool
from .shell import BUILD, ROOT, copy, fail, fresh, only, output, run

NATIVE = BUILD / "python-wheel"  # has the wheel for this system
WHEELS = BUILD / "wheel"  # has the wheels that were made last


def date_packages():
    """Gives the files of all packages one time: the last commit's. A source tarball's files have it already."""
    if "SOURCE_DATE_EPOCH" not in os.environ:
        in_git = (ROOT / ".git").exists()
        made = output("git", "log", "-1", "--format=%ct") if in_git else int((ROOT / "CHANGELOG.md").stat().st_mtime)
        os.environ["SOURCE_DATE_EPOCH"] = str(made)


def pip_wheel(sources, out, folder, **variables):
    """Makes the wheel of sources, built in a folder with CMake variables."""
    date_packages()
    settings = {"build-dir": folder, **{f"cmake.define.{name}": value for name, value in variables.items()}}
    pip = (tool("pip"), "wheel", "-q", "--no-deps", "--no-build-isolation", f"./{sources}", "-w", fresh(out))
    run(*pip, *(f"--config-settings={name}={value}" for name, value in settings.items()), env=PIP)
    return only(out, "*.whl")


def wheel():
    """Makes the wheel for this system, of the library and the program that are built here."""
    build_program()
    need("python")
    copy([pip_wheel("bindings/python", NATIVE, BUILD / "python")], fresh(WHEELS))


def sessions(*names, arguments=(), folder=BUILD / "nox"):
    """Runs sessions of noxfile.py; those that learn use Debian's torch where there is one."""
    learn = {"learning", "earlier", "ray", "train"} & {*names}
    need("python", *(["train"] if learn and shutil.which("apt-get") else []))
    run(tool("nox"), "--envdir", folder, "--session", *names, *arguments, env=PIP)


def check_editable():
    """Installs the package as those who change it do: it takes the library that was built last."""
    folder, python = fresh(BUILD / "editable"), environment("python-same", "test") / "python"
    pip = (tool("pip"), "install", "-q", "--no-deps", "--no-build-isolation", "--target", folder)
    run(*pip, "-e", "./bindings/python", env=PIP)
    code = f"import site; site.addsitedir({str(folder)!r}); from mimo import World; World('free'); "
    code += "from mimo._library import library_path; print(library_path().parent)"
    used = output(python, "-c", code, cwd=folder)
    if used != str(BUILD / "lib"):
        fail(f"an editable installation takes the library of {used}")


def test_python():
    wheel()
    check_editable()
    sessions("package", "shown", "files", "learning", "earlier")


def test_pythons():
    wheel()
    sessions("versions", "mujocos", "robosuite")


def test_view():
    need("view")
    wheel()
    sessions("view")


def test_ray():
    """Ray starts workers by a shell that splits the path of Python at a space, so the environment has none in its."""
    wheel()
    with tempfile.TemporaryDirectory(prefix="mimo-ray-") as folder:
        sessions("ray", folder=folder)


def train(arguments):
    wheel()
    sessions("train", arguments=("--", *arguments))
