"""The page's right side: time, scene, task, the infants' age and faces, and layers."""

from __future__ import annotations

from typing import Any, Callable, Dict, List, Optional

from ..constants import Kind, Quantity
from ..scene import scenes, tasks
from .camera import Camera
from .clock import Clock
from .motors import CHOICES, Motors
from .source import Source

SCENES_OWN = "the scene's own"
OLDEST = 24.0  # months
SEEDS = 2**31
Ask = Callable[[Callable[[], None]], None]


class TimeControls:
    """Pause, step, speed, reset and seed; and the time."""

    def __init__(self, server: Any, source: Source, clock: Clock, restart: Callable[[], None], ask: Ask) -> None:
        self._source, self._clock = source, clock
        gui = server.gui
        self._status = gui.add_markdown("")
        self._pause = gui.add_button("")
        step = gui.add_button("Step")
        self._pause.on_click(lambda _: ask(self._toggle))
        step.on_click(lambda _: ask(clock.step_once))
        speed = gui.add_slider("speed", min=0.1, max=4.0, step=0.1, initial_value=clock.speed)
        speed.on_update(lambda event: setattr(clock, "speed", float(event.target.value)))
        self.seed: Any = None
        self._place: Any = None
        if source.length is not None:
            end = max(source.length * source.step_seconds, source.step_seconds)
            self._place = gui.add_slider("time (s)", min=0.0, max=end, step=source.step_seconds, initial_value=0.0)
            self._place.on_update(lambda event: self._chosen(event, ask))
        if source.drives:
            self.seed = gui.add_number("seed", 1, min=0, max=SEEDS, step=1)
            gui.add_button("Reset").on_click(lambda _: ask(restart))

    def _chosen(self, event: Any, ask: Ask) -> None:
        if event.client is not None:  # not by update()
            step = round(float(event.target.value) / self._source.step_seconds)
            ask(lambda: self._source.seek(min(step, self._source.length or 0)))

    def _toggle(self) -> None:
        self._clock.paused = not self._clock.paused

    def update(self) -> None:
        """Shows the time."""
        world, clock = self._source.world, self._clock
        state = "paused" if clock.paused else f"{clock.reached:.2f} x real time"
        reward = ", ".join(f"{value:.3g}" for value in world.reward)
        told = f", reward {reward}" if world.layout.terms else ""
        seconds = world.time
        if self._place is not None:
            seconds = self._source.at * self._source.step_seconds
            if abs(self._place.value - seconds) > self._source.step_seconds / 2:
                self._place.value = seconds
        self._status.content = f"**{seconds:.2f} s** ({state}), task {world.task}{told}"
        self._pause.label = "Go on" if clock.paused else "Pause"


class SceneControls:
    """Scene and task."""

    def __init__(self, server: Any, source: Source, task: str, change: Callable[[str, str], None], ask: Ask) -> None:
        names = scenes() if source.scenes else [source.scene]
        self._scene = server.gui.add_dropdown("scene", names, initial_value=source.scene, disabled=not source.scenes)
        choices = [SCENES_OWN, *tasks()]
        self._task = server.gui.add_dropdown(
            "task", choices, initial_value=task or SCENES_OWN, disabled=not source.scenes
        )
        self._change, self._ask = change, ask
        for chosen in (self._scene, self._task):
            chosen.on_update(self._chosen)

    def _chosen(self, event: Any) -> None:
        if event.client is None:
            return
        if event.target is self._scene:
            self._task.value = SCENES_OWN  # the other scene may not have the task
        scene, task = self._scene.value, self._task.value
        self._ask(lambda: self._change(scene, "" if task == SCENES_OWN else task))

    def set(self, scene: str, task: str) -> None:
        """Shows the current values, also after a refused change."""
        self._scene.value, self._task.value = scene, task or SCENES_OWN


class InfantControls:
    """Ages, which change at the next reset, and faces, which change at once."""

    def __init__(self, server: Any, source: Source, restart: Callable[[], None], ask: Ask) -> None:
        self._world = source.world
        self._given: Dict[int, float] = {}
        faces = [self._world.name(Kind.FACE, i) for i in range(self._world.count(Kind.FACE))]
        for agent, infant in enumerate(self._world.agents):
            with server.gui.add_folder(infant.name or "infant"):
                if source.drives:
                    self._add_age(server.gui, agent, restart, ask)
                if self._world.face(agent):
                    self._add_face(server.gui, agent, faces, ask)

    def _add_age(self, gui: Any, agent: int, restart: Callable[[], None], ask: Ask) -> None:
        age = float(self._world.get(Quantity.AGENT_AGE)[agent])
        shown = gui.add_slider("age (months)", min=0.0, max=OLDEST, step=0.5, initial_value=min(age, OLDEST))

        def changed(event: Any) -> None:
            self._given[agent] = float(event.target.value)
            ask(restart)

        shown.on_update(changed)

    def _add_face(self, gui: Any, agent: int, faces: List[str], ask: Ask) -> None:
        shown = gui.add_dropdown("face", faces, initial_value=self._world.face(agent))
        shown.on_update(lambda event: ask(lambda: self._world.set_face(event.target.value, agent)))

    @property
    def ages(self) -> Optional[List[Optional[float]]]:
        """The ages for resets; None without a change."""
        return [self._given.get(agent) for agent in range(len(self._world.agents))] if self._given else None


class MotorControls:
    """The choice of actions."""

    def __init__(self, server: Any, motors: Motors) -> None:
        self._motors = motors
        self._choice = server.gui.add_dropdown("actions", CHOICES, initial_value=motors.choice)
        self._choice.on_update(lambda event: setattr(motors, "choice", event.target.value))

    def show(self) -> None:
        """Shows the current choice."""
        self._choice.value = self._motors.choice


def layer_switches(server: Any, layers: Dict[str, Any]) -> None:
    """A box for each layer of the scene."""
    for name, layer in layers.items():
        box = server.gui.add_checkbox(name, layer.visible)
        box.on_update(lambda event, layer=layer: setattr(layer, "visible", bool(event.target.value)))


def follow_switch(server: Any, camera: Camera) -> None:
    """A box that keeps the infants in the middle."""
    box = server.gui.add_checkbox("follow", camera.follows, hint="keeps the infants in the middle of the page")
    box.on_update(lambda event: setattr(camera, "follows", bool(event.target.value)))
