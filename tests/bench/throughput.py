#!/usr/bin/env python3
"""Steps of worlds a second against worlds and threads, with and without eyes. About two minutes.

    tests/bench/throughput.py [THREADS]    2 by default
"""
import sys

from ratios import bench, run

WORLDS = (1, 2, 4, 8, 16, 32, 64)
STEPS = {"off": "150", "64": "80", "256": "40"}  # of each world: as many for all, for episodes begin cheaply


def measure(worlds, threads, vision):
    steps = STEPS[vision]
    if worlds < threads:
        result = run(bench("--vision", vision, "--steps", steps))
        return 1e3 / result["ms_per_step"], None, None
    result = run(bench("--vision", vision, "--steps", steps, "--worlds", str(worlds), "--threads", str(threads)))
    return result["steps_per_second"] / result["scaling"], result["steps_per_second"], result["scaling"]


def main(threads):
    print(f"{'eyes':>5} {'worlds':>7} {'1 thread':>10} {f'{threads} threads':>10} {'scaling':>8}   (steps a second)")
    for vision in STEPS:
        for worlds in WORLDS:
            values = measure(worlds, threads, vision)
            print(f"{vision:>5} {worlds:7}", *("" if value is None else f"{value:10.{digits}f}"
                                               for value, digits in zip(values, (0, 0, 2))))


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 2)
