#!/usr/bin/env python3
"""Is libmimo still as fast as it was? Compares ratios of times measured in one run with those kept in ratios.json.

    ./dev ratios             measures and compares; fails when a ratio is more than a quarter worse than the kept one
    ./dev ratios --write     measures and keeps

No time is compared with a time of another run: each ratio divides by something that was measured in turns with it, so
a slow or busy machine moves both. Of several rounds the median counts, and what fails is measured anew, twice at
most: what got slower fails every time. Smaller is better in all of them.

Most ratios compare work of the same kind (scalar code on the same data) and hardly depend on the processor. Those of
pictures do: the ray renderer is as wide as the processor's vectors (the kept ones: 8 numbers), MuJoCo's physics is
not, and OSMesa compiles for what it finds. They serve all the same: a processor with wider vectors only makes them
smaller, and on one with narrower ones --write keeps its own.
"""
import datetime
import importlib.util
import json
import os
import pathlib
import re
import statistics
import subprocess
import sys
import time

HERE = pathlib.Path(__file__).resolve().parent
PROGRAMS = HERE.parents[1] / "build" / "bin"
KEPT = HERE / "ratios.json"
REACH = HERE.parents[1] / "examples/policies/reach.json"
PROFILE = HERE.parents[1] / "examples/python/profile_training.py"
ROUNDS = 3
WORSE = 1.25
# A share of a step that nobody would notice, and clocks hardly can: added to every limit.
UNNOTICED = 0.001


def bench(*arguments):
    return ["mimo-bench", "--json", *arguments]


BLIND = bench("--vision", "off", "--steps", "800")
NUMB = bench("--vision", "off", "--touch", "off", "--steps", "800")
SMALL = bench("--vision", "64", "--steps", "400")
USUAL = bench("--vision", "256", "--steps", "200")
LARGE = bench("--vision", "512", "--steps", "100")
EVERY_SENSE = bench("--vision", "64", "--senses", "all", "--steps", "400")
FINGERS_USUAL = bench("--body", "fingers", "--vision", "256", "--steps", "200")
MUJOCO_4 = ["../../build-mujoco4/bin/mimo-bench", *BLIND[1:]]
FINGERS = bench("--body", "fingers", "--vision", "off", "--steps", "200")
MUSCLES = bench("--vision", "off", "--actuation", "muscle", "--steps", "100")
THREADS = bench("--vision", "off", "--worlds", "2", "--threads", "2", "--steps", "200")
RENDER = ["bench_render", "8"]
TOUCH = ["bench_touch", "500"]
MUSCLE = ["bench_muscle"]
MANY_THREADS = bench("--scene", "reach", "--vision", "off", "--worlds", "64", "--threads", "2", "--steps", "100")
WORLDS = ["bench_worlds", "reach"]
WORLDS_WITH_SKIN = ["bench_worlds", "benchmark"]
MAKING = ["bench_making", "benchmark"]
CONTACTS = ["bench_extras", "contacts"]
DELAYS = ["bench_extras", "delays", "1500"]
EYES = ["bench_extras", "eyes"]
NEWBORN_SMALL = ["bench_extras", "newborn", "1000", "64"]
NEWBORN = ["bench_extras", "newborn"]
SKIN = ["bench_extras", "skin", "1500"]
CARESSES = ["bench_extras", "caresses", "1500"]
REFLEXES = ["bench_extras", "reflexes", "1500"]
VOICE = ["bench_extras", "voice", "1500"]
HEARING = ["bench_extras", "hearing", "1500"]
RECORDING = ["bench_extras", "recording", "9216"]
RECEPTORS = ["bench_extras", "receptors", "1500"]
BEHAVIOUR = ["bench_extras", "behaviour", "1500"]
SPONTANEOUS = ["bench_extras", "spontaneous", "1500"]
POLICY = ["mimo", "run", "--json", *("--policy", str(REACH)), *("--task", "none"), *("--vision", "off"),
          *("--out", str(PROGRAMS.parent / "bench_policy"))]
OWN_SENSE = ["bench_own_sense"]
RING = ["bench_models", "ring"]
PPO = [sys.executable, str(PROFILE), *("--task", "reach"), *("--algorithm", "ppo"), *("--threads", "1"),
       *("--steps", "4096")]


def step_vs_raw(result):
    return result["median"]["step_vs_raw"]


def reference_steps(result):
    return result["median"]["ms_per_step"] * 1e3 / result["median"]["reference_us"]


def on_mujoco_4(result):
    """There is no reference step for it: that of a run directly after it counts."""
    return result["median"]["ms_per_step"] * 1e3 / run(BLIND)["median"]["reference_us"]


def share(*parts):
    return lambda result: sum(result["split_ms"][part] for part in parts) / result["split_ms"]["physics"]


def threads_lost(result):
    return result["raw_scaling"] / result["scaling"]


def two_over_gain(result):
    return 2 / result["scaling"]


def allocations(result):
    return result["allocations_per_step"] or 0  # null where they cannot be counted


def policy(result):
    return result["policy_us"] / (1e3 * result["step_ms"])


def in_text(pattern, unit=1):
    """What a bench program printed in the pattern's group, in that unit, or in its first group over the second."""
    def read(text):
        found = re.search(pattern, text)
        if not found:
            sys.exit(f"ratios: no '{pattern}' in:\n{text}")
        numbers = [float(group) for group in found.groups()]
        return numbers[0] / unit if len(numbers) == 1 else numbers[0] / numbers[1]
    return read


def touch(scale):
    return in_text(rf"\nscale {scale}: .*touch ([\d.]+) us.* steps of ([\d.]+) us")


def muscles(body, model):
    return in_text(rf"{body} +{model} +muscles +([\d.]+) +physics step +([\d.]+)")


def ring(metres):
    return in_text(rf"ring at {metres:.2f} m .*times ([\d.]+)")


def renderers(pixels):
    return in_text(rf"\n +{pixels} +([\d.]+) +[\d.]+ +([\d.]+)")


RATIOS = [
    ("step without eyes and touch, over its bare physics", NUMB, step_vs_raw),
    ("step without eyes, over its bare physics", BLIND, step_vs_raw),
    ("step without eyes, reference steps", BLIND, reference_steps),
    ("step at V64, reference steps", SMALL, reference_steps),  # depends on the processor
    ("step at V256, reference steps", USUAL, reference_steps),  # depends on the processor
    ("step at V512, reference steps", LARGE, reference_steps),  # depends on the processor
    ("every sense at V64, reference steps", EVERY_SENSE, reference_steps),  # depends on the processor
    ("step without eyes on MuJoCo 4, reference steps", MUJOCO_4, on_mujoco_4),
    ("five fingers without eyes, over bare physics", FINGERS, step_vs_raw),
    ("five fingers without eyes, reference steps", FINGERS, reference_steps),
    ("five fingers at V256, reference steps", FINGERS_USUAL, reference_steps),  # depends on the processor
    ("touch, reference steps", TOUCH, touch(1)),
    ("touch at twice the density, reference steps", TOUCH, touch(2)),
    ("other senses and the rest, over physics", BLIND, share("proprioception", "vestibular", "other")),
    ("contacts of a step recorded, over the step", CONTACTS, in_text(r"(-?[\d.]+) of a step more")),
    ("a newborn's nerves, over the step without eyes", DELAYS, in_text(r"(-?[\d.]+) of a step more")),
    ("a newborn's eyes, over the step without eyes", EYES, in_text(r"(-?[\d.]+) of a step more")),
    ("a newborn's eyes and nerves, over the step at V64", NEWBORN_SMALL, in_text(r"(-?[\d.]+) of a step more")),
    ("a newborn's eyes and nerves, over the step at V256", NEWBORN, in_text(r"(-?[\d.]+) of a step more")),
    ("receptors of skin, over the step without eyes", SKIN, in_text(r"(-?[\d.]+) of a step more")),
    ("caresses of skin, over the step without eyes", CARESSES, in_text(r"(-?[\d.]+) of a step more")),
    ("hearing, over the step without eyes", HEARING, in_text(r"(-?[\d.]+) of a step more")),
    ("a voice, over the step without eyes that hears", VOICE, in_text(r"(-?[\d.]+) of a step more")),
    ("all receptors, over the step without eyes", RECEPTORS, in_text(r"(-?[\d.]+) of a step more")),
    ("recorded, over the step without eyes", RECORDING, in_text(r"(-?[\d.]+) of a step more")),
    ("reflexes, over the step without eyes", REFLEXES, in_text(r"(-?[\d.]+) of a step more")),
    ("a behaviour's measures, over the step without eyes", BEHAVIOUR, in_text(r"(-?[\d.]+) of a step more")),
    ("spontaneous movements, over the step without eyes", SPONTANEOUS, in_text(r"(-?[\d.]+) of a step more")),
    ("a policy, over the step without eyes", POLICY, policy),
    ("a pendulum's step, over its bare physics", OWN_SENSE, in_text(r"without a sense ([\d.]+) times as long")),
    ("a user's empty sense, over that physics", OWN_SENSE, in_text(r"us more, (-?[\d.]+) of that physics")),
    ("muscles, over a physics step", MUSCLE, muscles("mitten", "MIMo")),
    ("MuJoCo's muscles, over a physics step", MUSCLE, muscles("mitten", "MuJoCo")),
    ("muscles of five fingers, over a physics step", MUSCLE, muscles("fingers", "MIMo")),
    ("ray renderer at 64 pixels, over OSMesa", RENDER, renderers(64)),  # depends on the processor
    ("ray renderer at 256 pixels, over OSMesa", RENDER, renderers(256)),  # depends on the processor
    ("20,736 triangles at 0.35 m, over the picture without", RING, ring(0.35)),  # depends on the processor
    ("20,736 triangles at 0.50 m, over the picture without", RING, ring(0.50)),  # depends on the processor
    ("20,736 triangles at 0.80 m, over the picture without", RING, ring(0.80)),  # depends on the processor
    ("batch on a thread, over its worlds one by one", WORLDS, in_text(r"a batch takes ([\d.]+)")),
    ("a further world of a batch, MB", WORLDS, in_text(r"a further world takes (\d+) kB", 1000)),
    ("a further world with full skin, MB", WORLDS_WITH_SKIN, in_text(r"a further world takes (\d+) kB", 1000)),
    ("making a world, in physics steps", MAKING, in_text(r"making takes [\d.]+ ms \(([\d.]+) steps\)")),
    ("a clone, in physics steps", MAKING, in_text(r"a clone [\d.]+ ms \(([\d.]+) steps\)")),
    ("two threads, bare physics' scaling over ours", THREADS, threads_lost),
    ("two threads over 64 worlds, 2 over their gain", MANY_THREADS, two_over_gain),
    ("the environment's share of PPO, one thread", PPO, in_text(r"environment: .* ([\d.]+) %\n", 100)),  # of its learner
    ("allocations in a step at V256", USUAL, allocations),
    ("allocations in a step of five fingers", FINGERS, allocations),
    ("allocations in a step of muscles", MUSCLES, allocations),
    ("allocations in a step of a batch", THREADS, allocations),
]


def idle_cores():
    """How many cores had nothing to do during a second."""
    def read():
        fields = pathlib.Path("/proc/stat").read_text().splitlines()[0].split()[1:]
        return int(fields[3]), sum(map(int, fields))
    idle, total = read()
    time.sleep(1)
    idle_now, total_now = read()
    return (idle_now - idle) / (total_now - total) * os.cpu_count()


def measurable():
    """Threads that wait for each other every half millisecond show nothing but who else is running, if anybody is."""
    left_out = []
    if idle_cores() <= 1.8:
        print("no two cores are idle: the ratios of two threads are left out")
        left_out += [ratio for ratio in RATIOS if ratio[2] in (threads_lost, two_over_gain)]
    if importlib.util.find_spec("stable_baselines3") is None:
        print("Stable-Baselines3 is not installed: PPO's ratio is left out")
        left_out += [ratio for ratio in RATIOS if ratio[1] is PPO]
    if not (PROGRAMS / MUJOCO_4[0]).exists():
        print("./dev test --mujoco4 was not run: the ratio on MuJoCo 4 is left out")
        left_out += [ratio for ratio in RATIOS if ratio[1] is MUJOCO_4]
    return [ratio for ratio in RATIOS if ratio not in left_out]


def run(command, **environment):
    python = {"PYTHONPATH": str(HERE.parents[1] / "bindings/python/src"),
              "MIMO_LIBRARY": str(PROGRAMS.parent / "lib/libmimo.so"), "PYTHONWARNINGS": "ignore"}
    env = {**os.environ, **python, **environment}
    done = subprocess.run([PROGRAMS / command[0], *command[1:]], capture_output=True, text=True, env=env)
    if done.returncode != 0 or done.stderr:
        sys.exit(f"ratios: {' '.join(command)}: {done.stderr or 'failed'}")
    return json.loads(done.stdout) if "--json" in command else done.stdout


def measure(ratios):
    """The median of each ratio over some rounds. The bench programs take medians themselves: once is enough."""
    values = {name: [] for name, _, _ in ratios}
    for index in range(ROUNDS):
        commands = {tuple(command) for _, command, _ in ratios if index == 0 or command[0].endswith("mimo-bench")}
        results = {command: run(command) for command in sorted(commands)}
        for name, command, read in ratios:
            if tuple(command) in results:
                values[name].append(read(results[tuple(command)]))
    return {name: statistics.median(of_rounds) for name, of_rounds in values.items()}


def limit(kept):
    return 0 if kept == 0 else kept * WORSE + UNNOTICED


def failures(measured, kept):
    return [ratio for ratio in RATIOS if ratio[0] in measured and measured[ratio[0]] > limit(kept[ratio[0]])]


def processor():
    found = re.search(r"^model name\s*:\s*(.*)$", pathlib.Path("/proc/cpuinfo").read_text(), re.M)
    return found[1] if found else os.uname().machine


def write(measured):
    origin = {"processor": processor(), "cores": os.cpu_count(), "date": str(datetime.date.today())}
    ratios = {name: round(value, 4) for name, value in measured.items()}
    KEPT.write_text(json.dumps({"origin": origin, "ratios": ratios}, indent=2) + "\n")


def show(measured, kept):
    print(f"{'ratio':54} {'measured':>9} {'kept':>9} {'limit':>9}")
    for name, value in measured.items():
        bound = limit(kept[name])
        print(f"{name:54} {value:9.4f} {kept[name]:9.4f} {bound:9.4f}{'  WORSE' if value > bound else ''}")


def main():
    measured = measure(measurable())
    if sys.argv[1:] == ["--write"]:
        if len(measured) < len(RATIOS):
            sys.exit("ratios: only what was measured on an idle machine, with MuJoCo 4, is worth keeping")
        write(measured)
    stored = json.loads(KEPT.read_text())
    kept = stored["ratios"]
    for _ in range(2):
        again = failures(measured, kept)
        if again:
            print("measured anew:", "; ".join(name for name, _, _ in again))
            measured.update(measure(again))
    show(measured, kept)
    print("kept ones:", ", ".join(f"{key} {value}" for key, value in stored["origin"].items()))
    worse = failures(measured, kept)
    if worse:
        sys.exit(f"ratios: {len(worse)} worse than kept by more than a quarter")
    print(f"ratios: {len(measured)} as good as kept")


if __name__ == "__main__":
    if sys.argv[1:] not in ([], ["--write"]):
        sys.exit(__doc__)
    main()
