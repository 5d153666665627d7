#!/usr/bin/env python3
"""Fits filters of two poles and two zeros to what a rigid sphere does to sound, and writes original/sphere_filter.csv.

Needs numpy and scipy. The sphere's surface hears a far source as a series of Hankel functions (Rayleigh; Duda and
Martens 1998), over the free field at its middle. What is fitted is that without Woodworth's delay, as a function of the
sphere's radius over the wavelength, so that one table does for all heads; each angle starts from its neighbour's
numbers, so that values between them can be taken along straight lines.
"""

import csv
from pathlib import Path

import numpy as np
from scipy.optimize import least_squares
from scipy.special import eval_legendre, spherical_jn, spherical_yn

# Circumference over wavelength: 0.15 is 100 Hz and 6.6 is 4.9 kHz for a head of 18 months, which is what counts most.
SIZES = np.concatenate([np.geomspace(0.15, 1, 12)[:-1], np.linspace(1, 7, 31), np.linspace(7.4, 12, 12)])
WEIGHTS = np.where(SIZES < 1.2, 2.0, np.where(SIZES <= 6.6, 1.0, 0.3))  # of a decibel
TIMED = SIZES <= 2.2
DELAY = 0.03  # radii over the speed of sound, that count as much as a decibel
STEP, WRITTEN = 1, 5  # degrees
LOWEST, HIGHEST = 1e-3, 6.0
START_ANGLE, START = 100, (1.03, 0.75, 1.1, 0.66)


def sphere(angle: float) -> np.ndarray:
    heard = []
    for size in SIZES:
        orders = np.arange(int(1.3 * size + 25))
        slope = spherical_jn(orders, size, True) + 1j * spherical_yn(orders, size, True)
        terms = (2 * orders + 1) * (-1j) ** (orders - 1) * eval_legendre(orders, np.cos(angle)) / slope
        heard.append(terms.sum() / size**2)
    return np.conj(heard)


def woodworth(angle: float) -> float:
    return -np.cos(angle) if angle <= np.pi / 2 else angle - np.pi / 2


def filtered(numbers: np.ndarray) -> np.ndarray:
    b1, b2, a1, a2 = numbers
    s = 1j * SIZES
    return (1 + b1 * s + b2 * s * s) / (1 + a1 * s + a2 * s * s)


def fit(degrees: int, start: np.ndarray, loyalty: float) -> np.ndarray:
    angle = np.radians(degrees)
    wanted = sphere(angle) * np.exp(1j * SIZES * woodworth(angle))

    def wrong(numbers: np.ndarray) -> np.ndarray:
        ratio = filtered(numbers) / wanted
        level, late = 20 * np.log10(np.abs(ratio)) * WEIGHTS, (np.angle(ratio) / SIZES)[TIMED] / DELAY
        return np.concatenate([level, late, (np.log(numbers) - np.log(start)) * loyalty])

    return least_squares(wrong, np.clip(start, 1.01 * LOWEST, HIGHEST), bounds=(LOWEST, HIGHEST)).x


def main() -> None:
    fitted = {START_ANGLE: fit(START_ANGLE, np.array(START), 0)}
    for degrees in range(
        START_ANGLE + STEP, 181, STEP
    ):  # in the shadow the best ones jump: hold on
        fitted[degrees] = fit(degrees, fitted[degrees - STEP], 4)
    for degrees in range(START_ANGLE - STEP, -1, -STEP):
        fitted[degrees] = fit(degrees, fitted[degrees + STEP], 1)
    path = Path(__file__).resolve().parent / "original" / "sphere_filter.csv"
    with path.open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["theta_deg", "b1", "b2", "a1", "a2"])
        for degrees in range(0, 181, WRITTEN):
            writer.writerow([degrees, *(f"{number:.4f}" for number in fitted[degrees])])


if __name__ == "__main__":
    main()
