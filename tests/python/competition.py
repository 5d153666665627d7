"""What tests of mimo.babybench share: its environments, the competition's tables, logs."""

import csv
import pickle

from mimo import babybench

BLIND = {"vision_active": False, "touch_active": False}


def table(root, name):
    with open(root / "tests/golden/babybench" / name) as file:
        return list(csv.DictReader(file))


def made(shipped=None, **switches):
    given = babybench.load(shipped) if shipped else {}
    return babybench.make({**given, "save_dir": None, **switches})


def logged(folder, name="training.pkl"):
    return pickle.loads((folder / "logs" / name).read_bytes())
