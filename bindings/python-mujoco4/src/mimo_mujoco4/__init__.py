"""libmimo for programs that simulate with the Python package mujoco; mimo looks here."""

from pathlib import Path

MUJOCO = "4.0.1"
LIBRARY = Path(__file__).resolve().parent / "libmimo-mujoco4.so.1"
