"""Sessions of nox that test the Python package; ./dev test makes the wheel that they install, and runs them.

`build/tools/bin/nox --envdir build/nox -s package -- tests/python/test_env.py -x` runs some of a session's tests.
"""

import shutil
from pathlib import Path

import nox

ROOT = Path(__file__).parent
PYTEST = ("python", "-m", "pytest", "-q", "-p", "no:cacheprovider", "-rs")
DEBIAN = Path("/usr/lib/python3/dist-packages")


def install(session: nox.Session, *lists: str) -> None:
    """Installs the packages of tools/pins/LIST.txt, each with its hash, and the wheel."""
    for one in lists:
        files = ("--only-binary=:all:", "-r", f"tools/pins/{one}.txt")
        session.install("-q", "--require-hashes", *(("--no-deps",) if one.endswith("-alone") else ()), *files)
    (wheel,) = (ROOT / "build/python-wheel").glob("mimo-*.whl")
    session.install("-q", "--no-deps", str(wheel))


def install_learner(session: nox.Session, extra: str, *lists: str) -> None:
    """The same with torch: Debian's where there is one, with the releases that go with it, otherwise PyPI's."""
    if shutil.which("apt-get"):
        install(session, *lists)
        (packages,) = Path(session.virtualenv.location).glob("lib/python3.*/site-packages")
        (packages / "torch").symlink_to(DEBIAN / "torch")
    else:
        (wheel,) = (ROOT / "build/python-wheel").glob("mimo-*.whl")
        session.install("-q", f"{wheel}[{extra}]", "torch", "pytest>=7")


def check(session: nox.Session, *names: str, guides: str = "") -> None:
    """Runs files of tests/python, and the programs of the pages that belong to these."""
    files = [f"tests/python/test_{name}.py" for name in names]
    files += ["tests/python/test_guides.py", "--guides", guides] if guides else []
    session.run(*PYTEST, *(session.posargs or files))


@nox.session
def package(session: nox.Session) -> None:
    """All tests that need no learner."""
    install(session, "test")
    session.run(*PYTEST, *(session.posargs or ["tests/python", "--ignore", "tests/python/test_sb3.py"]))


@nox.session(python=["3.9", "3.10", "3.11", "3.12", "3.13"])
def versions(session: nox.Session) -> None:
    """The same on each version of Python that is there."""
    package(session)


@nox.session
def shown(session: nox.Session) -> None:
    """Programs of the pages that show infants, and what they show."""
    install(session, "view")
    check(session, "shown", guides="shown")


@nox.session
def files(session: nox.Session) -> None:
    """Recordings as files of other programs, read and checked by these, and streams."""
    install(session, "files")
    check(session, "export", "fmu", "lsl", "markers", guides="files")


@nox.session
def learning(session: nox.Session) -> None:
    """Stable-Baselines3, the same algorithms compiled by JAX (sbx), and the cohort."""
    install_learner(session, "train", "train", "train-alone")
    check(session, "sb3", "cohort", "tutorials", guides="learning")


@nox.session
@nox.parametrize("gymnasium", ["0.28", "0.29"])
def earlier(session: nox.Session, gymnasium: str) -> None:
    """Environments on earlier versions of Gymnasium, with the NumPy and Stable-Baselines3 of their time."""
    if not shutil.which("apt-get"):
        session.skip("the lists go with Debian's torch")
    install_learner(session, "train", f"gymnasium-{gymnasium}", f"gymnasium-{gymnasium}-alone")
    check(
        session, "env", "vector", "tasks", "copies", "classic", "classic_model", "classic_scripts", "babybench", "sb3"
    )


@nox.session
def train(session: nox.Session) -> None:
    """A short training; arguments are those of examples/python/train.py."""
    install_learner(session, "train", "train", "train-alone")
    usual = ("--task", "reach", "--algorithm", "ppo", "--steps", "20000")
    session.run("python", "examples/python/train.py", *(session.posargs or usual))


@nox.session
def view(session: nox.Session) -> None:
    """The viewer, in a headless browser, Rerun, and USD."""
    install(session, "view")
    check(session, "view", "view_door", "video", "babybench_pictures", "recordings", "plot", "rerun", "usd", "shown")


@nox.session
def page(session: nox.Session) -> None:
    """The pages of build/web, in a headless browser."""
    install(session, "view")
    check(session, "web_page", "recording_page")


@nox.session
def ray(session: nox.Session) -> None:
    """Worlds and learning on clusters of local nodes, of which one is killed."""
    install_learner(session, "ray", "ray")
    check(session, "ray", guides="ray")


@nox.session
def mujoco(session: nox.Session) -> None:
    """Programs of the pages beside the package mujoco, with the library that was built on MuJoCo 4."""
    for one in ("test", "mujoco"):
        session.install("-q", "--require-hashes", "--only-binary=:all:", "-r", f"tools/pins/{one}.txt")
    library = ROOT / "build-mujoco4/lib/libmimo-mujoco4.so"
    sources = ROOT / "bindings/python/src"
    session.env.update(MIMO_LIBRARY=str(library), PYTHONPATH=str(sources))
    check(session, "renderer", "use_rays", guides="mujoco")


@nox.session
@nox.parametrize("mujoco", ["2.3", "3.1", "3.3", "3.10"])
def mujocos(session: nox.Session, mujoco: str) -> None:
    """mimo.Renderer with earlier versions of the package mujoco, and with no other package than NumPy."""
    install(session, f"mujoco-{mujoco}")
    check(session, "renderer")


@nox.session
def robosuite(session: nox.Session) -> None:
    """A whole environment of robosuite that draws with rays. Its packages take 1.1 GB."""
    install(session, "robosuite", "robosuite-alone")
    check(session, "use_rays")
