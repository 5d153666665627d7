"""The viewer: a page in the browser that shows and steps a world."""

from __future__ import annotations

import logging
import queue
import threading
import time
from typing import Any, Callable, Optional

from .._handle import Closing
from ..errors import Error
from .clock import Clock
from .page import Page
from .server import silence, start
from .source import Source

FRAME = 1 / 30  # s
BUDGET = 0.8 * FRAME  # s per frame for steps
LOCAL = "127.0.0.1"


class Viewer(Closing):
    """A page at `url`. One thread steps and draws the world; buttons of the page queue their requests."""

    def __init__(
        self, source: Source, host: str = LOCAL, port: int = 0, seed: Optional[int] = 1, task: str = ""
    ) -> None:
        self._source, self._task, self._seed = source, task, seed
        self._server, self._door = start(host, port)
        self._wishes: queue.SimpleQueue[Callable[[], None]] = queue.SimpleQueue()
        self._closed = threading.Event()
        self._thread: Optional[threading.Thread] = None
        self._next_frame = 0.0
        self.clock = Clock(source.step_seconds)
        try:
            if source.drives:
                source.restart(seed)
            self._page = self._built(task)
            self._server.on_client_connect(self._greet)
        except BaseException:
            self._stop()
            raise

    @property
    def url(self) -> str:
        """The page's address. It holds a token: everyone who has it may use the page."""
        host = self._server.get_host().replace("0.0.0.0", "localhost")
        return f"http://{host}:{self._server.get_port()}/{self._door.token}/"

    def _repr_html_(self) -> str:
        return f'<iframe src="{self.url}" width="100%" height="600" style="border:0"></iframe>'

    def _built(self, task: str) -> Page:
        page = Page(self._server, self._source, self.clock, task, self)
        if page.time.seed is not None and self._seed is not None:
            page.time.seed.value = self._seed
            page.motors.restart(self._seed)
        return page

    def _greet(self, client: Any) -> None:
        if client.camera.aspect < 1:  # a phone; others start with the default camera
            self._page.camera.aim(client)

    # ---- Requests of the page's buttons, done by the thread of the world ----------------------------------------

    def ask(self, wish: Callable[[], None]) -> None:
        """Queues a request."""
        self._wishes.put(wish)

    def restart(self) -> None:
        """Starts an episode with the page's seed and ages."""
        self._seed = int(self._page.time.seed.value)
        self._page.pull.release()
        self._source.restart(self._seed, self._page.infants.ages)
        self._page.motors.restart(self._seed)

    def change(self, scene: str, task: str) -> None:
        """Changes to another scene or task."""
        try:
            self._source.change(scene, task)
        except Exception:
            self._page.scene.set(self._source.scene, self._task)
            raise
        self._page.remove()
        self.clock.step_seconds, self._task = self._source.step_seconds, task
        self._source.restart(self._seed)
        self._page = self._built(task)

    def _do_wishes(self) -> None:
        while True:
            try:
                wish = self._wishes.get_nowait()
            except queue.Empty:
                return
            try:
                wish()
            except Exception as error:  # the library refused the request; the world is unchanged
                self._tell(str(error))

    def _tell(self, message: str) -> None:
        logging.getLogger("mimo").info("viewer: %s", message)
        for client in self._server.get_clients().values():
            client.add_notification("That cannot be done", message, auto_close_seconds=10, color="red")

    # ---- Stepping -------------------------------------------------------------------------------------------------

    def _steps(self) -> None:
        """Makes the steps that are due; the last one of a frame observes."""
        count, started, done = self.clock.due(), time.perf_counter(), 0
        behind = False
        while done < count and not behind:
            behind = time.perf_counter() - started > BUDGET
            last = done == count - 1 or behind or self._page.sound.on
            self._page.pull.apply(self._source.step_seconds)
            done += 1
            try:
                if self._source.advance(self._page.motors.next(), last):
                    self._source.restart(None)
            except Error as error:  # caused by the user, for example by pulling
                self._begin_again(error)
                break
            self._page.sound.hear()
            if self._source.at == self._source.length:  # the end of a recording
                self.clock.paused = True
                break
        self.clock.done(done, behind)

    def _begin_again(self, error: Error) -> None:
        """Resets a world after a failure."""
        self._source.restart(self._seed)
        self._page.pull.release()
        self._page.motors.restart(self._seed)
        self.clock.paused = True
        self._tell(f"{error}; the episode begins again")

    def frame(self) -> None:
        """A frame of a world that the viewer steps."""
        self._do_wishes()
        self._steps()
        self._page.update()

    def run(self) -> None:
        """Draws frames until it is closed."""
        while not self._closed.is_set():
            started = time.perf_counter()
            self.frame()
            self._closed.wait(max(0.0, started + FRAME - time.perf_counter()))

    def run_beside(self) -> None:
        """Runs in a new thread."""
        self._thread = threading.Thread(target=self.run, name="mimo viewer", daemon=True)
        self._thread.start()

    def show(self) -> None:
        """Shows a world after its owner's step; waits for real time, or while the page is paused."""
        self._do_wishes()
        while not self.clock.wait_for_step() and not self._closed.is_set():
            self._do_wishes()
            self._draw_in_time()
        self.clock.done(1, self.clock.late)
        self._page.pull.apply(self._source.step_seconds)
        self._page.sound.hear()
        self._draw_in_time()

    def _draw_in_time(self) -> None:
        now = time.perf_counter()
        if now >= self._next_frame:
            self._next_frame = now + FRAME
            self._page.update()

    def close(self) -> None:
        """Closes the page and the viewer's own world."""
        self._closed.set()
        if self._thread is not None:
            self._thread.join()
        self._stop()
        self._source.close()

    def _stop(self) -> None:
        with silence():
            self._server.stop()
