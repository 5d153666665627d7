"""Two infants babble at each other: each waits until it has heard nothing for a while, then says a few syllables.

    python examples/python/babble.py [OUT.wav]

Prints who says what when. With a file name it also writes what the first infant hears, two channels.
"""

import sys
import wave
from typing import Dict, List

import numpy as np

import mimo

SECONDS, SYLLABLE, PAUSE = 8.0, 0.25, 0.4
MUTE = {"loudness": 0.0, "pitch": 0.0, "opening": 1.0, "front": 1.0}


class Babbler:
    """Says two to four syllables, then listens until the other one has been silent for a while."""

    def __init__(self, name: str, seed: int) -> None:
        self.name, self.random = name, np.random.default_rng(seed)
        self.waits = self.random.uniform(0, 1)
        self.left = 0.0  # of the syllable, s
        self.syllables = 0
        self.vowel: Dict[str, float] = {}

    def act(self, time: float, step: float, loudest: float) -> Dict[str, float]:
        """What its voice is told now; `loudest` is what it hears, Pa."""
        if self.left <= 0 and self.syllables > 0:
            self.syllables, self.left = self.syllables - 1, SYLLABLE
            opening, front = self.random.uniform(0.7, 1.3, 2)
            self.vowel = {
                "pitch": self.random.uniform(-0.3, 0.3),
                "opening": opening,
                "front": front,
            }
        if self.left > 0:
            self.left -= step
            self.waits = PAUSE + self.random.uniform(0, 0.3)
            return {"loudness": 0.5 if self.left > SYLLABLE / 3 else 0.0, **self.vowel}
        self.waits = max(self.waits, PAUSE) if loudest > 0.002 else self.waits - step
        if self.waits <= 0:
            self.syllables = int(self.random.integers(2, 5))
            print(f"{time:5.2f} s  {self.name} says {self.syllables} syllables")
        return MUTE


def make_world() -> mimo.World:
    scene = mimo.Scene("playdate")
    scene.add_agents(vision=False, touch=False, hearing=True, voice=True)
    return mimo.World(scene)


def write_wave(path: str, heard: np.ndarray, rate: float) -> None:
    """16 bits; the loudest is full scale, for one's own voice is far above 1 Pa."""
    with wave.open(path, "wb") as file:
        file.setnchannels(2)
        file.setsampwidth(2)
        file.setframerate(round(rate))
        file.writeframes((heard / np.abs(heard).max() * 32767).astype("<i2").T.tobytes())


def main() -> None:
    heard: List[np.ndarray] = []
    with make_world() as world:
        names = [agent.name for agent in world.agents]
        babblers = [Babbler(name, seed) for seed, name in enumerate(names)]
        numbers = {action.name: i for i, action in enumerate(world.layout.actions)}
        ear = world.layout.fields[f"{names[0]}/hearing/ear_left"]
        world.reset(seed=0)
        told = np.zeros(len(numbers), np.float32)
        for i in range(round(SECONDS / ear.period)):
            seen = world.step(told).observation
            for babbler in babblers:
                loudest = float(np.abs(seen[f"{babbler.name}/hearing/ear_left"]).max())
                for part, value in babbler.act(i * ear.period, ear.period, loudest).items():
                    told[numbers[f"{babbler.name}/voice:{part}"]] = value
            heard.append(np.stack([seen[f"{names[0]}/hearing/ear_{side}"] for side in ("left", "right")]))
    both = np.concatenate(heard, axis=1)
    level = 20 * np.log10(np.sqrt(np.mean(np.square(both))) / 20e-6)
    print(f"{names[0]} hears {level:.0f} dB on average, mostly itself")
    assert level > 60
    if len(sys.argv) > 1:
        write_wave(sys.argv[1], both, ear.sample_rate)


if __name__ == "__main__":
    main()
