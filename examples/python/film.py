"""Records what a learned policy does, at several ages: a recording for each, to watch, to film and to send as a page.

python film.py ../policies/sit.json --ages 6 9 12 --out films
python -m mimo.view --recording films/sit-6.h5                 # in the viewer
python -m mimo.video films/sit-6.h5 --out sit-6.mp4            # as a film
mimo export --html sit-6.html films/sit-6.h5                   # as a page that plays it in any browser
"""

import argparse
from pathlib import Path

import mimo


def record(policy, age, seed, path):
    """An episode without eyes and skin; returns success if it came to that at any time, else how it ended."""
    maturity = mimo.Mature.BODY | (mimo.Mature.DELAYS if policy.delays else 0)  # of nerves: as it has learned
    world = mimo.World(policy.scene, age=age, maturity=maturity, touch=False, vision=False)
    policy.attach(world)
    world.reset(seed=seed)
    told = set()
    with mimo.Recorder(world, path, replace=True):
        while not (world.terminated or world.truncated):
            world.step(policy.act(world.observation, world.action_low, world.action_high, world.time))
            told.add(mimo.Outcome(world.outcome))
    return "success" if mimo.Outcome.SUCCESS in told else mimo.Outcome(world.outcome).name.lower()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("policy", type=Path, help="a file of examples/policies, or policy.json of cohort.py")
    parser.add_argument("--ages", type=float, nargs="+", default=[3, 6, 9], help="months")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--out", type=Path, default=Path("films"))
    options = parser.parse_args()
    policy = mimo.Policy.load(options.policy)
    options.out.mkdir(parents=True, exist_ok=True)
    for age in options.ages:
        path = options.out / f"{policy.scene}-{age:g}.h5"
        print(f"{path}: {record(policy, age, options.seed, path)}", flush=True)


if __name__ == "__main__":
    main()
