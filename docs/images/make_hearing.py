#!/usr/bin/env python3
"""make_hearing.py: draws hearing.png, spectrograms of both ears while a block of wood falls left of an infant.

Needs the Python package, numpy and matplotlib.
"""

from pathlib import Path

import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt

import mimo

IMAGES = Path(__file__).resolve().parent
SECONDS, HEIGHT, WINDOW, HOP = 0.7, 0.5, 256, 32
REFERENCE = 20e-6  # Pa


def listen() -> "tuple[np.ndarray, float]":
    """What the ears of an infant that lies still hear, 2 x samples, and how many a second."""
    scene = mimo.Scene("benchmark")
    scene.add_agent(vision=False, touch=False, hearing=True)
    scene.add_object(
        name="block", shape=mimo.Shape.BOX, size=(0.02, 0.02, 0.02), mass=0.05, position=(0.0, 0.6, HEIGHT)
    )
    scene.set_material("block", "hardwood")
    with mimo.World(scene) as world:
        world.reset(seed=0)
        field = world.layout.fields["hearing/ear_left"]
        heard = [[], []]
        for _ in range(round(SECONDS / field.period)):
            seen = world.step().observation
            for ear, name in enumerate(("hearing/ear_left", "hearing/ear_right")):
                heard[ear].append(seen[name].copy())
        return np.array([np.concatenate(ear) for ear in heard]), field.sample_rate


def spectrogram(samples: np.ndarray) -> np.ndarray:
    """Level in dB, frequency by time."""
    starts = range(0, len(samples) - WINDOW, HOP)
    frames = np.array([samples[start : start + WINDOW] * np.hanning(WINDOW) for start in starts])
    amplitude = np.abs(np.fft.rfft(frames, axis=1)) * 4 / WINDOW / np.sqrt(2)
    return 20 * np.log10(np.maximum(amplitude, 1e-9) / REFERENCE).T


def main() -> None:
    heard, rate = listen()
    figure, axes = plt.subplots(2, 1, figsize=(8, 5), sharex=True, constrained_layout=True)
    for axis, samples, name in zip(axes, heard, ("left ear", "right ear")):
        picture = axis.imshow(
            spectrogram(samples),
            origin="lower",
            aspect="auto",
            vmin=-10,
            vmax=60,
            extent=(0, len(samples) / rate, 0, rate / 2000),
        )
        axis.set_ylabel(f"{name}, kHz")
    axes[1].set_xlabel("time, s")
    figure.colorbar(picture, ax=axes, label="dB of 20 µPa")
    figure.savefig(IMAGES / "hearing.png", dpi=100)


if __name__ == "__main__":
    main()
