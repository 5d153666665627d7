"""Tests of CMake's workflow presets: configured, built and run; which of them are slow, and which failed."""

import xml.etree.ElementTree as ET

from .build import NINJA, check_cmake, check_space, leave_mujoco4
from .need import need
from .shell import CORES, ROOT, run

SLOWEST = 20
FOLDERS = {"release": "build", "asan-rooms": "build-asan"}  # of presets that do not give theirs their name


def cases(preset):
    """The tests of a preset that were run last, as ctest describes them."""
    file = ROOT / FOLDERS.get(preset, f"build-{preset}") / "tests.xml"
    return list(ET.parse(file).getroot().iter("testcase")) if file.is_file() else []


def failed_tests(preset):
    return [case.get("name") for case in cases(preset) if case.get("status") == "fail"]


def run_workflow(preset):
    """Configures, builds and tests by a workflow preset; names the slowest tests."""
    need("build", "test")
    if preset == "release":
        leave_mujoco4()
    check_cmake()
    check_space()
    try:
        run("cmake", "--workflow", "--preset", preset, env={"CTEST_PARALLEL_LEVEL": CORES, **NINJA})
    finally:
        print_slowest(preset)


def print_slowest(preset):
    times = sorted(((float(case.get("time")), case.get("name")) for case in cases(preset)), reverse=True)
    print(f"The slowest of {len(times)} tests, which took {sum(time for time, _ in times):.0f} s together:")
    for time, name in times[:SLOWEST]:
        print(f"{time:8.1f} s  {name}")
