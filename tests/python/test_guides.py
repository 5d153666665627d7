"""Every Python program in the pages runs as it stands, in a fresh folder: those that --guides names, and with an own
file of the reader where the page speaks of one."""

import os
import re
import subprocess
import sys

import guides
import numpy as np

import mimo

ROBOT = """<mujoco><worldbody>
  <body name="torso" pos="0 0 1"><freejoint/><geom type="capsule" size=".1 .2" mass="4"/>
    <body name="head" pos="0 0 .4"><joint name="neck" axis="0 1 0"/><geom type="sphere" size=".1" mass="1"/>
      <site name="head_site"/></body>
  </body></worldbody>
  <sensor><accelerometer name="acc" site="head_site"/><gyro name="gyro" site="head_site"/></sensor></mujoco>"""


def robot(path):
    path.write_text(ROBOT)


def room(path):
    path.write_text(ROBOT.replace("head_site", "head"))


def run(path):
    """A recording of 40 steps."""
    with mimo.World("benchmark", vision_width=16, vision_height=16) as world:
        world.reset(seed=1)
        with mimo.Recorder(world, path):
            for _ in range(40):
                world.step(np.zeros(len(world.action_names)))


BEGINS = {"wrist": "hand", "elbow": "lower_arm", "shoulder": "upper_arm", "knee": "lower_leg"}  # bodies at the joints


def points(path):
    """Where wrists, elbows, shoulders and knees are, for a tenth of a second."""
    sides = ("left", "right")
    with mimo.World("free", vision=False, touch=False, age=6) as world:
        world.reset(seed=1)
        names = [f"{side}_{joint}:{axis}" for side in sides for joint in BEGINS for axis in "xyz"]
        rows = [",".join(["time", *names])]
        for step in range(4):
            places = world.bodies(*(f"{side}_{body}" for side in sides for body in BEGINS.values())).position.ravel()
            rows.append(",".join(map(str, [0.03 * step, *places])))
            world.step()
    path.write_text("\n".join(rows) + "\n")


OWN = {"robot.xml": robot, "room.xml": room, "run.h5": run, "points.csv": points}


def pytest_generate_tests(metafunc):
    if "program" in metafunc.fixturenames:
        suite = metafunc.config.getoption("guides")
        chosen = [program for program in guides.programs(guides.ROOT) if program.suite == suite]
        metafunc.parametrize("program", chosen, ids=[f"{program.page}-{program.number}" for program in chosen])


def test_program(program, tmp_path):
    for name, make in OWN.items():
        if f'"{name}"' in program.code:
            make(tmp_path / name)
    environment = {name: value for name, value in os.environ.items() if name != "DISPLAY"}
    (tmp_path / ".program.py").write_text(program.code)
    done = subprocess.run(
        [sys.executable, ".program.py"],
        cwd=tmp_path,
        env={**environment, "MPLBACKEND": "Agg"},
        capture_output=True,
        text=True,
        timeout=500,
    )
    assert done.returncode == 0, done.stderr


def test_every_suite_runs_somewhere(root):
    sessions = (root / "noxfile.py").read_text()
    named = set(re.findall(r'guides="(\w+)"', sessions))
    assert named == set(guides.SUITES)
    found = {program.suite for program in guides.programs(root)}
    assert found == {*guides.SUITES, guides.PLAIN}


def test_python_is_found(root):
    assert len(guides.programs(root)) > 30
    assert list(guides.hidden(root)) == []
