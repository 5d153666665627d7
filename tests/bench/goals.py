#!/usr/bin/env python3
"""The goals of docs/benchmark.md, measured several times over.

    tests/bench/goals.py [RUNS]    5 by default; about ten seconds each on an idle machine

Build first: ./dev build --avx && ./dev build (the first fetches the other build of MuJoCo, the second goes back).
"""
import importlib.util
import pathlib
import sys

from ratios import PPO, allocations, bench, in_text, reference_steps, run, threads_lost

AVX = pathlib.Path(__file__).resolve().parents[2] / "build" / "mujoco" / "libmujoco.so.2.2.2"
BLIND = bench("--vision", "off", "--steps", "800")


def seeing(pixels, steps):
    return run(bench("--vision", pixels, "--steps", steps))


def goals():
    """Name, goal (as text), and value of each."""
    blind, usual = run(BLIND), seeing("256", "300")
    two = run(bench("--vision", "off", "--worlds", "2", "--threads", "2", "--steps", "400"))
    two_seeing = run(bench("--vision", "64", "--worlds", "2", "--threads", "2", "--steps", "300"))
    yield "without eyes, reference steps", "<= 0.60", reference_steps(blind)
    yield "V64, reference steps", "<= 0.85", reference_steps(seeing("64", "500"))
    yield "V256, reference steps", "<= 2.0", reference_steps(usual)
    yield "V512, reference steps", "<= 5.0", reference_steps(seeing("512", "100"))
    yield "two threads without eyes, of raw_scaling", ">= 0.95", 1 / threads_lost(two)
    yield "two threads at V64, of raw_scaling", ">= 0.95", 1 / threads_lost(two_seeing)
    if AVX.exists():
        fast = run(BLIND, LD_PRELOAD=str(AVX))
        yield "AVX build without eyes, times as fast", ">= 1.12", reference_steps(blind) / reference_steps(fast)
        yield "AVX build without eyes, reference steps", "", reference_steps(fast)
    many = run(bench("--scene", "reach", "--vision", "off", "--worlds", "64", "--threads", "2", "--steps", "200"))
    yield "two threads over 64 worlds, times one", ">= 1.98", many["scaling"]
    yield "allocations in a step", "0", allocations(usual) + allocations(two)
    if importlib.util.find_spec("stable_baselines3"):
        on_all_cores = [*PPO[:PPO.index("--threads")], "--steps", "4096"]
        share = in_text(r"environment: .*ms, ([\d.]+) %;", 100)(run(on_all_cores))
        yield "environment's share of PPO's time, reach", "<= 0.15", share


def main(runs):
    table = {}
    for _ in range(runs):
        for name, goal, value in goals():
            table.setdefault((name, goal), []).append(value)
    for (name, goal), values in table.items():
        print(f"{name:42} {goal:8}", *(f"{value:7.3f}" for value in values))


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 5)
