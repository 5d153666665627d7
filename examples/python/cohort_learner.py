"""The learner of cohort.py: an infant of one age practises one behaviour, and keeps what did well.

A movement is a row of numbers (movements.py). A separable CMA-ES (Ros and Hansen 2008; the package cmaes) draws rows,
the infant tries each once, and the search moves towards the better half. Some worlds practise side by side: whenever
an attempt ends, that world tries the next row. An attempt ends with success, when its time is over, when progress falls
by DROP below its best (the infant fell), or when for STALL seconds nothing was gained and not everything held.
Evaluations know none of this: they run each attempt to its end.
"""

import numpy as np
from cmaes import SepCMA

import mimo
from movements import COUNT, Infants, policy_of

WORLDS, POPULATION = 8, 16
DROP, STALL, GAIN = 0.3, 2.5, 0.02  # of progress; seconds; of progress
BEST, SUCCESS = 3.0, 1.0  # what the best progress, and success, add to the mean reward
EVALUATION_SEED = 1_000_000_000  # episodes that nobody learned from


class Learner:
    def __init__(self, behaviour, age, strength, seed, worlds=WORLDS, pose_noise=0.05):
        self.behaviour, self.age, self.strength, self.pose_noise = behaviour, age, strength, pose_noise
        self.infants = Infants(behaviour, age, worlds, strength, pose_noise)
        self.length = round(mimo.Scene(behaviour).behaviour().episode_seconds / self.infants.seconds)
        self.search = SepCMA(mean=np.zeros(COUNT), sigma=1.0, seed=seed, population_size=POPULATION)
        self.seed, self.steps = seed, 0
        self.results = []  # of each attempt, in the order of their ends: world, value, success, seconds, steps before
        self.waiting = []  # rows and values that the search is not told yet
        self.rows = np.array([self.search.ask() for _ in range(worlds)])
        self.best, self.total, self.gained = np.zeros(worlds), np.zeros(worlds), np.zeros(worlds, int)
        self._begin(np.ones(worlds, bool))

    def _begin(self, mask):
        """The next attempt of these worlds, with seeds that no attempt had before."""
        for world in np.flatnonzero(mask):
            self.infants.begin(world, self.rows[world])
        first = self.seed * 1_000_000 + len(self.results) * len(mask)
        self.infants.reset([first + world for world in range(len(mask))], mask)
        for array in (self.best, self.total, self.gained):
            array[mask] = 0

    def _end(self, world, value):
        """Tells the search what a world's row was worth, and takes another."""
        self.waiting.append((self.rows[world].copy(), -value))
        if len(self.waiting) == POPULATION:
            self.search.tell(self.waiting)
            self.waiting = []
        self.rows[world] = self.search.ask()

    def practise(self, steps):
        """For so many steps of all worlds together."""
        infants = self.infants
        for _ in range(-(-steps // len(self.rows))):
            progress, held, effort, success, over = infants.step()
            self.steps += len(self.rows)
            self.total += progress + held - effort
            gains = held | (progress > self.best + GAIN)
            self.gained[gains] = infants.steps[gains]
            self.best = np.maximum(self.best, progress)
            idle = infants.seconds * (infants.steps - self.gained) > STALL
            ends = success | over | idle | (progress < self.best - DROP)
            if ends.any():
                for world in np.flatnonzero(ends):
                    self._finish(world, success[world])
                self._begin(ends)

    def _finish(self, world, success):
        lasted = self.infants.steps[world]
        left = 2.0 * (self.length - lasted) if success else 0.0  # as if what is reached lasted: haste gains nothing
        best = 1.0 if success else self.best[world]
        value = (self.total[world] + left) / self.length + BEST * best + SUCCESS * success
        self.results.append((world, value, success, lasted * self.infants.seconds, self.steps))
        self._end(world, value)

    def evaluate(self, attempts):
        """Of the search's mean: share of attempts that succeed; means of best progress, the measure, the time held."""
        infants = Infants(self.behaviour, self.age, attempts, self.strength, self.pose_noise)
        for world in range(attempts):
            infants.begin(world, self.search.mean)
        infants.reset([EVALUATION_SEED + world for world in range(attempts)])
        done, reached, best = np.zeros(attempts, bool), np.zeros(attempts, bool), np.zeros(attempts)
        achieved = infants.achieved()
        while not done.all():
            progress, _, _, success, over = infants.step()
            achieved = np.where(done[:, None], achieved, infants.achieved())
            best = np.where(done, best, np.maximum(best, progress))
            reached |= success & ~done
            done |= success | over
        infants.batch.close()
        return [float(each.mean()) for each in (reached, best, achieved[:, 0], achieved[:, -1])]

    # ---- Checkpoints: continuing gives what would have come without the break ------------------------------------

    def save(self, path):
        """Arrays of numbers. The search is not among them: told the same results, it draws the same rows."""
        batch = self.infants.batch
        worlds = [np.frombuffer(state, np.uint8) for state in batch.save()]
        with open(path, "wb") as file:
            np.savez(
                file,
                results=np.array(self.results, float).reshape(-1, 5),
                states=np.concatenate(worlds),
                sizes=[len(world) for world in worlds],
                blocks=batch.blocks,
                numbers=[self.steps, self.seed],
                attempts=np.array([self.infants.steps, self.gained]),
                rewards=np.array([self.best, self.total]),
            )

    def load(self, path):
        """Of a learner that has not practised yet, made with the same arguments."""
        with np.load(path) as kept:
            for world, value, success, seconds, before in kept["results"]:
                self.results.append((int(world), value, bool(success), seconds, int(before)))
                self._end(int(world), value)
            for world, row in enumerate(self.rows):
                self.infants.begin(world, row)
            ends = np.cumsum(kept["sizes"])
            states = kept["states"].tobytes()
            self.infants.batch.load([states[end - size : end] for end, size in zip(ends, kept["sizes"])])
            self.infants.batch.blocks[...] = kept["blocks"]
            self.steps = int(kept["numbers"][0])
            self.infants.steps, self.gained = kept["attempts"]
            self.best, self.total = kept["rewards"]

    def policy(self, **told):
        return policy_of(self.infants, self.search.mean, age=self.age, **told)
