"""Synchronises simulated time with real time."""

from __future__ import annotations

import time

WINDOW = 1.0  # s over which the speed is averaged
LATE = 0.1  # s
PATIENCE = 1 / 30  # s


class Clock:
    """Tells how many steps are due, and the actual speed."""

    def __init__(self, step_seconds: float) -> None:
        self.step_seconds = step_seconds
        self.speed = 1.0  # simulated seconds per second
        self.paused = False
        self.reached = 0.0  # recent simulated seconds per second
        self._due = 0.0
        self._single = 0
        self._last = self._window_start = time.perf_counter()
        self._done = 0

    def step_once(self) -> None:
        """One step, and a pause after it."""
        self.paused = True
        self._single += 1

    def due(self) -> int:
        """The number of steps that are due."""
        now = time.perf_counter()
        passed, self._last = now - self._last, now
        if self.paused:
            count, self._single, self._due = self._single, 0, 0.0
            return count
        self._due += passed * self.speed / self.step_seconds
        return int(self._due)

    def done(self, count: int, behind: bool) -> None:
        """Reports steps; a late clock does not catch up on missed time."""
        self._due = 0.0 if behind else max(0.0, self._due - count)
        self._done += count
        now = time.perf_counter()
        if now - self._window_start >= WINDOW:
            self.reached = self._done * self.step_seconds / (now - self._window_start)
            self._window_start, self._done = now, 0

    @property
    def late(self) -> bool:
        """Whether it is behind."""
        return self._due * self.step_seconds > LATE * self.speed

    def wait_for_step(self) -> bool:
        """Sleeps until the next step is due, at most a frame; returns whether it is."""
        if self.due() >= 1:
            return True
        missing = PATIENCE if self.paused else (1 - self._due) * self.step_seconds / self.speed
        time.sleep(min(missing, PATIENCE))
        return self.due() >= 1
