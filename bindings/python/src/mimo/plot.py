"""Pictures of what an infant senses, on matplotlib. Needs the extra [plot].

    observation = world.observe()
    mimo.plot.eyes(observation)
    mimo.plot.touch_map(world)
    mimo.plot.joint_angles(times, angles, world.joints(...))

Each function draws into `axes` (or a figure of its own) and returns the figure, to be shown or saved.
"""

from __future__ import annotations

from typing import Any, Optional, Sequence, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .access import Joints
from .display import has_display
from .errors import UnsupportedError
from .frames import placed
from .layout import Observation
from .world import World

try:
    import matplotlib
    import matplotlib.pyplot as plt
    from matplotlib.figure import Figure
except ImportError as error:
    raise ImportError("pictures need matplotlib: pip install 'mimo[plot]'") from error


def anaglyph(left: NDArray[np.uint8], right: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Both eyes in one picture for red-cyan glasses: red from the left eye, green and blue from the right."""
    return np.concatenate([left[..., :1], right[..., 1:]], axis=-1)


def eyes(observation: Observation, agent: str = "") -> Figure:
    """What both eyes see, and the anaglyph of both."""
    prefix = f"{agent}/" if agent else ""
    pictures = [observation.get(f"{prefix}vision/eye_{side}") for side in ("left", "right")]
    left, right = pictures
    if left is None or right is None:
        raise ValueError("the observation has no pictures; make the world with vision=mimo.Vision.RGB")
    figure, axes = plt.subplots(1, 3, figsize=(9, 3.4), layout="constrained")
    titled = zip(axes, (left, right, anaglyph(left, right)), ("left eye", "right eye", "anaglyph"))
    for place, picture, title in titled:
        place.imshow(picture)
        place.set_title(title)
        place.axis("off")
    return figure


def touch_map(world: World, observation: Optional[Observation] = None, agent: int = 0) -> Figure:
    """The sensors of the whole skin, seen from the front and from the side; coloured by the force that each feels."""
    name = world.agents[agent].name
    field = f"{name}/touch/force" if name else "touch/force"
    if field not in world.layout.fields:
        raise ValueError("the infant has no touch; make the world with touch=mimo.Touch.FORCE")
    shown = world.observation if observation is None else observation
    force, sensors = np.linalg.norm(shown[field], axis=-1), world.layout.receptors(field)
    bodies = world.bodies()
    places = placed(bodies.position[sensors.bodies], bodies.orientation[sensors.bodies], sensors.position)
    felt = force > 0
    figure, axes = plt.subplots(1, 2, figsize=(8, 5), layout="constrained")
    for axis, across, title in zip(axes, (1, 0), ("from the front", "from the right")):
        axis.scatter(places[:, across], places[:, 2], s=1, color="0.8")
        points = axis.scatter(places[felt, across], places[felt, 2], s=8, c=force[felt], cmap="viridis")
        axis.set(title=title, xlabel=f"{'xy'[across]} (m)", aspect="equal", adjustable="datalim")
    axes[0].set_ylabel("z (m)")
    figure.colorbar(points, ax=axes, label="force (N)")
    return figure


def joint_angles(times: ArrayLike, angles: ArrayLike, joints: Joints) -> Figure:
    """Joint angles over time (times x joints, rad) between their limits, in grey; one small plot a joint."""
    time, angle = np.asarray(times, np.float64), np.asarray(angles, np.float64)
    names, limits = joints.names, joints.range.reshape(-1, 2)
    columns = min(4, len(names))
    rows = -(-len(names) // columns)
    figure, axes = plt.subplots(
        rows, columns, figsize=(2.6 * columns, 1.7 * rows), squeeze=False, sharex=True, layout="constrained"
    )
    for place, name, (low, high), line in zip(axes.flat, names, limits, angle.T):
        place.axhspan(low, high, color="0.92")
        place.plot(time, line, linewidth=1)
        place.set_title(name.split(":")[-1], fontsize=8)
    for place in list(axes.flat)[len(names) :]:
        place.set_axis_off()
    figure.supxlabel("time (s)")
    figure.supylabel("angle (rad)")
    return figure


class Window:
    """A live window that shows one picture after the other."""

    def __init__(self, title: str = "MIMo") -> None:
        if not has_display():
            raise UnsupportedError("no window can be opened here: there is no display; use render_mode='rgb_array'")
        self._figure = plt.figure(title)
        if self._figure.canvas.required_interactive_framework is None:
            plt.close(self._figure)
            raise UnsupportedError(
                f"no window can be opened with matplotlib's backend {matplotlib.get_backend()}; "
                "install tkinter or PyQt, or use render_mode='rgb_array'"
            )
        self._image: Any = None

    def show(self, picture: Union[NDArray[np.uint8], Sequence[Any]]) -> None:
        """Shows a picture and lets the window answer its user."""
        if self._image is None:
            axes = self._figure.add_axes((0, 0, 1, 1))
            axes.set_axis_off()
            self._image = axes.imshow(picture)
            plt.show(block=False)
        self._image.set_data(picture)
        self._figure.canvas.draw_idle()
        self._figure.canvas.flush_events()

    def close(self) -> None:
        """Closes the window."""
        plt.close(self._figure)
