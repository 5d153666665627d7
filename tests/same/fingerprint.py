#!/usr/bin/env python3
"""Prints a hash of everything that a build gives: descriptions, pictures, observations, trajectories.

Two builds that print the same lines do the same, to the byte; a change that is to leave behaviour alone is checked by

    tests/same/fingerprint.py build >before; ...; tests/same/fingerprint.py build | diff before -
"""

import hashlib
import json
import subprocess
import sys
import tempfile
from pathlib import Path

GOLDEN = Path(__file__).parent.parent / "golden"
SCENES = {
    "benchmark": ["mitten", "fingers"],
    "free": ["mitten", "fingers"],
    "reach": ["mitten", "fingers"],
    "standup": ["mitten"],
    "selfbody": ["mitten", "fingers"],
    "catch": ["fingers"],
    "rollover": ["mitten", "fingers"],
    "showroom": ["mitten"],
    "playdate": ["mitten"],
    "babybench-base": ["mitten"],
    "babybench-crib": ["mitten"],
    "babybench-cubes": ["fingers"],
    "lift": ["fingers"],
}
MITTENS_BEHAVE = (
    *("head-lift", "chest-lift", "roll-to-belly", "roll-to-back", "sit-with-hands", "sit", "sit-up", "hands-and-knees"),
    *("crawl", "pull-to-stand", "stand-with-support", "stand", "cruise", "walk-with-help", "walk", "hand-to-mouth"),
    *("hands-together", "foot-grasp", "reach-moving", "bang", "drop", "follow", "prefer", "mobile"),
)
SCENES.update((scene, ["mitten"]) for scene in MITTENS_BEHAVE)
CONTROLS = {"mitten": "controls_v1.csv", "fingers": "controls_v2.csv"}


def run(*command: str) -> str:
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def show(title: str, content: bytes) -> None:
    print(hashlib.sha256(content).hexdigest()[:16], title, flush=True)


def show_files(title: str, folder: Path) -> None:
    for path in sorted(folder.iterdir()):
        show(f"{title} {path.name}", path.read_bytes())


def describe(mimo: str, scene: str, body: str) -> None:
    description = json.loads(run(mimo, "info", "--scene", scene, "--body", body, "--json"))
    del description["versions"]
    show(f"{scene} {body} info", json.dumps(description).encode())


def draw(mimo: str, scene: str, body: str, folder: Path) -> None:
    for renderer in ("ray", "osmesa"):
        files = [str(folder / f"{renderer}{end}") for end in (".png", "_depth.npy", "_segmentation.npy")]
        options = ["--width", "160", "--height", "120", "--renderer", renderer]
        run(mimo, "render", "--scene", scene, "--body", body, *options,
            "--out", files[0], "--depth", files[1], "--segmentation", files[2])  # fmt: skip


def live(mimo: str, scene: str, body: str, folder: Path) -> None:
    run(mimo, "run", "--scene", scene, "--body", body, "--seconds", "0.5", "--seed", "3", "--vision", "64",
        "--out", str(folder))  # fmt: skip


def roll(mimo: str, body: str, jacobian: str) -> None:
    with tempfile.TemporaryDirectory() as folder:
        states = Path(folder) / "states.json"
        run(mimo, "rollout", "--scene", "benchmark", "--body", body, "--controls", str(GOLDEN / CONTROLS[body]),
            "--jacobian", jacobian, "--out", str(states), "--every", "40")  # fmt: skip
        show(f"benchmark {body} {jacobian} rollout", states.read_bytes())


def main() -> None:
    if len(sys.argv) != 2:
        sys.exit("usage: fingerprint.py BUILD_FOLDER")
    programs = Path(sys.argv[1]) / "bin"
    mimo = str(programs / "mimo")
    print(run(str(programs / "capi_same")), end="")
    for scene, bodies in SCENES.items():
        for body in bodies:
            describe(mimo, scene, body)
            for act in (draw, live):
                with tempfile.TemporaryDirectory() as folder:
                    act(mimo, scene, body, Path(folder))
                    show_files(f"{scene} {body} {act.__name__}", Path(folder))
    for body in CONTROLS:
        for jacobian in ("dense", "sparse"):
            roll(mimo, body, jacobian)


if __name__ == "__main__":
    main()
