"""An infant's ears tell where a sound comes from: a toy beeps now on the left and now on the right.

    python examples/python/hearing.py

Prints, for each side, what the time between the ears and the levels in both of them say.
"""

import numpy as np

import mimo

RATE = 16000
TOYS = {"left toy": (0.0, 0.6, 0.3), "right toy": (0.0, -0.6, 0.3)}


def main() -> None:
    scene = mimo.Scene("benchmark")
    scene.add_agent(vision=False, touch=False, hearing=True)
    for name, position in TOYS.items():
        scene.add_object(name=name, shape=mimo.Shape.SPHERE, size=(0.03,), position=position, fixed=True)
    noise = np.random.default_rng(1).normal(0, 0.02, RATE // 10).astype(np.float32)  # 0.02 Pa: a conversation
    with mimo.World(scene) as world:
        for toy in TOYS:
            world.reset(seed=0)
            world.play(toy, noise)
            for _ in range(8):
                heard = world.step().observation
            late = float(heard["hearing/time_difference"][0])
            left, right = heard["hearing/bands"].sum(axis=1)
            side = "left" if late > 0 else "right"
            print(f"{toy}: {1e6 * late:+.0f} us, {left:.0f} dB left and {right:.0f} dB right: it is on the {side}")
            assert toy.startswith(side)
            assert (left > right) == (side == "left")


if __name__ == "__main__":
    main()
