"""Checks of sources and documents: the hooks of .pre-commit-config.yaml, and those that need all files at once."""

from concurrent.futures import ThreadPoolExecutor

from .interface import interface
from .need import need
from .pins import environment
from .shell import BUILD, CORES, Failure, changed_sources, fail, run, run_quietly, sources, try_run
from .site import make_site

TIDY = ("src/*.cpp", "tests/unit/*.cpp", "tests/golden/*.cpp", "tests/capi/*.c")
FORMATTED = ("*.c", "*.cpp", "*.h", "*.hpp", ":!tests/abi/frozen")  # headers of old versions stay as they were


def check_hooks(files):
    run(
        environment("lint", "lint") / "pre-commit",
        "run",
        "--files",
        *files,
        env={"PRE_COMMIT_HOME": BUILD / "pre-commit"},
    )


def check_tidy(files):
    folder = BUILD / "tidy"  # has the compile commands of single files, as builds compile batches
    run_quietly("cmake", "--preset", "release", "-B", folder, "-DMIMO_UNITY=OFF")
    with ThreadPoolExecutor(CORES) as pool:
        done = list(pool.map(lambda file: try_run("clang-tidy", "-p", folder, "--quiet", file), files))
    found = [said for status, said in done if status != 0 or "warning: " in said]
    if found:
        fail("\n".join(found))


def format_sources():
    need("lint")
    run("clang-format", "-i", *sources(*FORMATTED))


def lint(quick, changed):
    """Makes all checks, and says at the end which of them found something."""
    need("build", "lint")
    files = changed_sources if changed else sources
    checks = {
        "hooks": lambda: check_hooks(files()),
        "clang-tidy": lambda: check_tidy(files(*TIDY)),
        "interface": lambda: interface("--check"),
        "pages": make_site,
    }
    if quick:
        del checks["clang-tidy"]
    found = []
    for name, check in checks.items():
        print(f"lint: {name}")
        try:
            check()
        except Failure as failure:
            print(failure)
            found.append(name)
    if found:
        fail(f"lint found something: {', '.join(found)}")
    print("lint: nothing to complain about")
