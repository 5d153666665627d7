"""The page's content for one world."""

from __future__ import annotations

from typing import Any, Callable, Dict, Optional

from .camera import Camera
from .clock import Clock
from .controls import InfantControls, MotorControls, SceneControls, TimeControls, follow_switch, layer_switches
from .lights import add_lights
from .marks import Bones, Contacts, Layer, Pulled, Skin
from .motors import Motors
from .pull import Pull
from .pull_handle import PullHandle
from .senses_panel import SensesPanel
from .shapes import Shapes
from .sliders import ActionSliders, JointSliders
from .sound import Sound
from .source import Source

SLOW = 6  # frames between two updates of bars and sliders
SOUND = 8  # frames between two updates of sound


class Page:
    """The scene and the panels of a world. All of it runs in the thread that steps the world."""

    def __init__(self, server: Any, source: Source, clock: Clock, task: str, commands: Any) -> None:
        self._server, self._source, self.commands = server, source, commands
        self._frames = 0
        self.pull, self.motors = Pull(source.world), Motors(source.world, source.step_seconds)
        self._build_controls(clock, task)
        add_lights(server)
        self.camera = Camera(server, source.world)
        self.shapes = Shapes(server, source.world, self._handle.body_dragged if self._handle else None)
        marks: Dict[str, Layer] = {
            "touch": Skin(server, source.world),
            "contacts": Contacts(server, source.world),
            "joints": Bones(server, source.world),
        }
        self._marks = [*marks.values(), Pulled(server, self.pull)]
        self._senses = SensesPanel(server, source.world)
        with self._show_tab:
            layer_switches(server, {"bodies": self.shapes, **marks})
            follow_switch(server, self.camera)
        self.update()

    def _build_controls(self, clock: Clock, task: str) -> None:
        server, source, ask = self._server, self._source, self.commands.ask
        restart: Callable[[], None] = self.commands.restart
        self.time = TimeControls(server, source, clock, restart, ask)
        self.sound = Sound(server, source.world, clock)
        tabs = server.gui.add_tab_group()
        self._handle: Optional[PullHandle] = None
        if source.length is None:  # a recording does not change
            with tabs.add_tab("World"):
                if source.drives:
                    self.scene = SceneControls(server, source, task, self.commands.change, ask)
                self.infants = InfantControls(server, source, restart, ask)
                self._handle = PullHandle(server, source.world, self.pull, ask)
        with tabs.add_tab("Joints"):
            self._joints = JointSliders(server, source.world, ask, fixed=source.length is not None)
        if source.drives:
            with tabs.add_tab("Actions"):
                choice = MotorControls(server, self.motors)
                ActionSliders(server, source.world, self.motors, choice.show)
        self._show_tab = tabs.add_tab("Show")

    def update(self) -> None:
        """Shows the current state."""
        with self._server.atomic():
            self.camera.update()
            self.shapes.update()
            for marks in self._marks:
                marks.update()
            if self._handle is not None:
                self._handle.update()
        if self._frames % 2 == 0:
            self._senses.update_pictures()
        if self._frames % SOUND == 0:
            self.sound.update()
        if self._frames % SLOW == 0:
            self.time.update()
            self._senses.update_bars()
            self._joints.update()
        self._frames += 1

    def remove(self) -> None:
        """Removes everything from the page."""
        self.pull.release()
        self._senses.remove()
        self._server.gui.reset()
        self._server.scene.reset()
