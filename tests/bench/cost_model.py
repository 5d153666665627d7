#!/usr/bin/env python3
"""What a step costs, so that it can be predicted for a scene of one's own: fits a model to measurements of mimo-bench.

    tests/bench/cost_model.py                   measures (about two minutes), fits, prints the model and its residuals
    tests/bench/cost_model.py --save runs.json  keeps the measurements as well
    tests/bench/cost_model.py --load runs.json  fits to kept ones

Parts are fitted one by one, to their own clocks, by least squares of relative errors. The unit is the reference step
(reference_us of mimo-bench), measured in turns with each: multiply by that of your machine. Needs numpy.
"""
import json
import pathlib
import sys

import numpy

import ratios

STEPS = "400"
FINGERS = ("--body", "fingers")
SCENES = [("--scene", scene) for scene in ("benchmark", "free", "reach", "standup", "selfbody", "rollover", "showroom", "playdate")]
SCENES += [("--scene", scene, *FINGERS) for scene in ("benchmark", "free", "reach", "catch")]
RUNS = (
    [(*scene, "--vision", "off") for scene in SCENES]
    + [(*scene, "--vision", "off", "--touch", touch)
       for scene in (SCENES[0], SCENES[6], SCENES[7]) for touch in ("0.5", "2")]
    + [(*SCENES[0], "--touch", "off", "--vision", pixels) for pixels in ("32", "64", "128", "256", "512")]
    + [(*scene, "--touch", "off", "--vision", pixels)
       for scene in (SCENES[2], SCENES[6], SCENES[7], SCENES[10]) for pixels in ("64", "256")]
)


def mitten(run):
    return "fingers" not in run["name"]


def fingers(run):
    return not mitten(run)


def pictures(run):
    return 2 * run["agents"]


# What a part depends on: the name of each term, and its size in a measurement. The bodies differ: contacts of five
# fingers have six dimensions and many sensors near them, and fingers are in the picture.
PHYSICS = {
    "a degree of freedom": lambda run: run["degrees_of_freedom"],
    "a contact": lambda run: run["mean_contacts"],
    "a contact, a degree of freedom": lambda run: run["mean_contacts"] * run["degrees_of_freedom"],
}
FINGERS_PHYSICS = {name: PHYSICS[name] for name in ("a degree of freedom", "a contact")}
TOUCH = {
    "a contact": lambda run: mitten(run) * run["mean_contacts"],
    "a contact, five fingers": lambda run: fingers(run) * run["mean_contacts"],
    "1000 sensors": lambda run: run["touch_sensors"] / 1e3,
}
VISION = {
    "a pixel of a picture's side": lambda run: (pictures(run) * run["pixels"]) ** 0.5,
    "1000 pixels": lambda run: mitten(run) * run["pixels"] / 1e3,
    "1000 pixels, five fingers": lambda run: fingers(run) * run["pixels"] / 1e3,
}


def measure(settings):
    runs = []
    for arguments in settings:
        run = ratios.run(ratios.bench("--steps", STEPS, *arguments))
        run["name"] = " ".join(word for word in arguments if word not in ("--scene", "--body")).replace("--", "")
        runs.append(run)
        print(".", end="", file=sys.stderr, flush=True)
    print(file=sys.stderr)
    return runs


def fit(title, terms, runs, cost):
    """Prints the cost of each term in reference steps, and how far the model is from each measurement."""
    measured = numpy.array([cost(run) * 1e3 / run["reference_us"] for run in runs])
    sizes = numpy.array([[size(run) for size in terms.values()] for run in runs], float)
    cost_of = numpy.linalg.lstsq(sizes / measured[:, None], numpy.ones(len(runs)), rcond=None)[0]
    predicted = sizes @ cost_of
    print(f"\n{title}, in reference steps =")
    for name, value in zip(terms, cost_of):
        print(f"  {value:.3e} x {name}")
    errors = predicted / measured - 1
    print(f"  residuals: {100 * numpy.sqrt(numpy.mean(errors**2)):.0f} % (root mean square)")
    for run, real, model, error in zip(runs, measured, predicted, errors):
        print(f"    {run['name']:40} measured {real:8.4f} model {model:8.4f} {100 * error:+5.0f} %")


def main(arguments):
    if arguments[:1] not in ([], ["--load"], ["--save"]) or len(arguments) not in (0, 2):
        sys.exit(__doc__)
    if arguments[:1] == ["--load"]:
        runs = json.loads(pathlib.Path(arguments[1]).read_text())
    else:
        runs = measure(RUNS)
    if arguments[:1] == ["--save"]:
        pathlib.Path(arguments[1]).write_text(json.dumps(runs, indent=1))
    whole = runs[: len(SCENES)]  # the others have the same physics

    def physics(run):
        return run["split_ms"]["physics"] / run["frame_skip"]

    fit("a physics step with mittens", PHYSICS, [run for run in whole if mitten(run)], physics)
    fit("a physics step with five fingers", FINGERS_PHYSICS, [run for run in whole if fingers(run)], physics)
    feeling = [run for run in runs if run["touch_sensors"] > 0]
    fit("touch", TOUCH, feeling, lambda run: run["split_ms"]["touch"])
    seeing = [run for run in runs if run["pixels"] > 0]
    fit("vision", VISION, seeing, lambda run: run["split_ms"]["vision"])


if __name__ == "__main__":
    main(sys.argv[1:])
