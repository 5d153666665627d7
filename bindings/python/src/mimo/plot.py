"""Pictures of observations with matplotlib. Needs the extra [plot].

    observation = world.observe()
    mimo.plot.eyes(observation)
    mimo.plot.touch_map(world)
    mimo.plot.joint_angles(times, angles, world.joints(...))

    python -m mimo.plot run.h5 --out run.png       # a recording at a glance

Each function returns a matplotlib Figure: a notebook shows it as the last value of a cell, `figure.savefig("file.pdf")`
saves it. pyplot does not keep it.
"""

from __future__ import annotations

import argparse
import io
import os
import sys
from typing import Any, Callable, List, NamedTuple, Optional, Sequence, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._files import new_file, require_writable
from .body_map import BodyMap
from .display import has_display
from .drawing import STOPS, STRONG, WEAK
from .errors import Error, UnsupportedError
from .layout import Observation
from .recordings import Recording, add_sense_option
from .selections import Joints
from .traces import Traces, traces
from .world import World

try:
    import matplotlib
    import matplotlib.pyplot as plt
    from matplotlib.colors import LinearSegmentedColormap, LogNorm
    from matplotlib.figure import Figure
except ImportError as error:
    raise ImportError("pictures need matplotlib: pip install 'mimo[plot]'") from error

IDLE = "0.55"  # of sensors without force: a grey that printers still print
MEAN = 0.25  # s: touch is averaged over this time, as single steps are too short to see
HEAT = LinearSegmentedColormap.from_list("heat", STOPS / 255)  # as in the viewer


def _figure(width: float, height: float) -> Figure:
    """A figure outside pyplot, where a notebook would show it twice and it would stay in memory."""
    return Figure(figsize=(width, height), layout="constrained")


def anaglyph(left: NDArray[np.uint8], right: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Both eyes in one picture for red-cyan glasses: red from the left eye, green and blue from the right."""
    return np.concatenate([left[..., :1], right[..., 1:]], axis=-1)


def eyes(observation: Observation, agent: str = "") -> Figure:
    """The pictures of both eyes, and their anaglyph."""
    prefix = f"{agent}/" if agent else ""
    pictures = [observation.get(f"{prefix}vision/eye_{side}") for side in ("left", "right")]
    left, right = pictures
    if left is None or right is None:
        raise ValueError("the observation has no pictures; make the world with vision=mimo.Vision.RGB")
    figure = _figure(9, 3.4)
    titled = zip(figure.subplots(1, 3), (left, right, anaglyph(left, right)), ("left eye", "right eye", "anaglyph"))
    for place, picture, title in titled:
        place.imshow(picture)
        place.set_title(title)
        place.axis("off")
    return figure


def touch_map(world: World, observation: Optional[Observation] = None, agent: int = 0) -> Figure:
    """All touch sensors, seen from the front and from the back, coloured by the force on each."""
    body = BodyMap(world, agent)
    force = body.force if observation is None else body.force_in(observation)
    felt = np.flatnonzero(force > 0)
    felt = felt[np.argsort(force[felt])]
    figure = _figure(2.4 + 4.6 * body.width, 5.4)
    axes = figure.subplots()
    axes.scatter(body.places[:, 0], body.places[:, 1], s=3, color=IDLE, linewidths=0)
    scale = LogNorm(WEAK, STRONG)
    points = axes.scatter(
        body.places[felt, 0], body.places[felt, 1], s=14, c=force[felt], cmap=HEAT, norm=scale, linewidths=0
    )
    for middle, side in zip(body.middles, ("front", "back")):
        axes.text(middle, -0.05, side, ha="center", va="top")
    axes.set(aspect="equal", xlim=(-0.02, body.width + 0.02), ylim=(-0.12, 1.04))
    axes.set_axis_off()
    bar = figure.colorbar(points, ax=axes, label="force on a sensor (N)", extend="both", shrink=0.8)
    bar.set_ticks([0.1, 0.3, 1, 3, 10], labels=["0.1", "0.3", "1", "3", "10"])
    return figure


def joint_angles(times: ArrayLike, angles: ArrayLike, joints: Joints) -> Figure:
    """Joint angles over time (times x joints, rad) between their limits, in grey; a small plot per joint."""
    time, angle = np.asarray(times, np.float64), np.asarray(angles, np.float64)
    names, limits = joints.names, joints.range.reshape(-1, 2)
    columns = min(4, len(names))
    rows = -(-len(names) // columns)
    figure = _figure(2.6 * columns, 1.7 * rows)
    axes = figure.subplots(rows, columns, squeeze=False, sharex=True)
    for place, name, (low, high), line in zip(axes.flat, names, limits, angle.T):
        place.axhspan(low, high, color="0.92")
        place.plot(time, line, linewidth=1)
        place.set_title(name.split(":")[-1], fontsize=8)
    for place in list(axes.flat)[len(names) :]:
        place.set_axis_off()
    figure.supxlabel("time (s)")
    figure.supylabel("angle (rad)")
    return figure


def run(traces: Traces, title: str = "") -> Figure:
    """A recording at a glance: joints, touch by part, gaze, sound and rewards over time."""
    shown = [part for part in _PARTS if part.has(traces)]
    heights = [part.height(traces) for part in shown]
    figure = _figure(10, sum(heights) + 0.9)
    ratios = {"height_ratios": heights}
    axes = figure.subplots(len(shown), 1, sharex=True, squeeze=False, gridspec_kw=ratios)
    for part, place in zip(shown, axes[:, 0]):
        part.draw(traces, place)
        place.set_title(part.title, loc="left", fontsize=10)
    axes[-1, 0].set_xlabel("time (s)")
    axes[-1, 0].set_xlim(0, float(traces.time[-1]))
    if title:
        figure.suptitle(title, fontsize=11)
    return figure


class _Part(NamedTuple):
    title: str
    has: Callable[[Traces], bool]
    height: Callable[[Traces], float]  # inches
    draw: Callable[[Traces, Any], None]


def _rows(axes: Any, time: NDArray[np.float64], values: NDArray[np.float64], names: List[str], **how: Any) -> Any:
    """Rows of colours over time."""
    step = float(time[0]) if len(time) == 1 else float(time[1] - time[0])
    extent = (float(time[0]) - step, float(time[-1]), len(names) - 0.5, -0.5)
    picture = axes.imshow(values.T, aspect="auto", extent=extent, interpolation="nearest", **how)
    axes.set_yticks(range(len(names)), names, fontsize=6)
    axes.tick_params(axis="y", length=0)
    return picture


def running_mean(time: NDArray[np.float64], values: NDArray[np.float64], seconds: float = MEAN) -> Any:
    """Running means (times x values) over a time window, which shrinks at both ends."""
    step = float(np.median(np.diff(time))) if len(time) > 1 else seconds
    half = max(0, round((seconds / step - 1) / 2))
    sums = np.concatenate([np.zeros((1, *values.shape[1:])), np.cumsum(values, axis=0)])
    first = np.maximum(np.arange(len(values)) - half, 0)
    end = np.minimum(np.arange(len(values)) + half + 1, len(values))
    return (sums[end] - sums[first]) / (end - first).reshape(-1, *[1] * (values.ndim - 1))


def _legend(axes: Any) -> None:
    """Above the plot."""
    axes.legend(ncols=4, fontsize=7, loc="lower right", bbox_to_anchor=(1, 1), borderaxespad=0.1, frameon=False)


def _draw_joints(traces: Traces, axes: Any) -> None:
    picture = _rows(axes, traces.time, traces.bends, traces.joints, cmap="RdBu_r", vmin=-1, vmax=1)
    bar = axes.figure.colorbar(picture, ax=axes, pad=0.01)
    bar.set_ticks([-1, 0, 1], labels=["lower limit", "middle", "upper limit"])


def _draw_touch(traces: Traces, axes: Any) -> None:
    forces = np.ma.masked_less(running_mean(traces.time, traces.forces), WEAK / 10)
    picture = _rows(axes, traces.time, forces, traces.parts, cmap=HEAT, norm=LogNorm(WEAK, 10 * STRONG))
    axes.set_facecolor("0.95")
    axes.figure.colorbar(picture, ax=axes, pad=0.01, label="N")


def _draw_gaze(traces: Traces, axes: Any) -> None:
    styles = (("left eye", "tab:blue"), ("right eye", "tab:red"))
    for (eye, color), (side, up) in zip(styles, ((0, 1), (2, 3))):
        axes.plot(traces.time, traces.gaze[:, side], color=color, linewidth=1, label=f"{eye}, to the left")
        axes.plot(traces.time, traces.gaze[:, up], color=color, linewidth=1, linestyle=":", label=f"{eye}, up")
    axes.axhline(0, color="0.8", linewidth=0.8, zorder=0)
    axes.set_ylabel("degrees")
    _legend(axes)


def _draw_sound(traces: Traces, axes: Any) -> None:
    if traces.levels is not None:
        axes.plot(traces.time, traces.levels[:, 0], color="tab:blue", linewidth=0.8, label="left ear")
        axes.plot(traces.time, traces.levels[:, 1], color="tab:red", linewidth=0.8, label="right ear")
    axes.set_ylabel("dB re 20 µPa")
    _legend(axes)


def _draw_rewards(traces: Traces, axes: Any) -> None:
    axes.plot(traces.time, traces.rewards, color="tab:green", linewidth=1)


_PARTS = (
    _Part(
        "joints, in their ranges", lambda it: len(it.joints) > 0, lambda it: 0.1 * len(it.joints) + 0.3, _draw_joints
    ),
    _Part(
        f"touch, by part of the body, means over {MEAN:g} s",
        lambda it: len(it.parts) > 0,
        lambda it: max(0.11 * len(it.parts), 1.0) + 0.3,
        _draw_touch,
    ),
    _Part("gaze, from the head", lambda it: bool(np.isfinite(it.gaze).any()), lambda it: 1.6, _draw_gaze),
    _Part("sound at the ears", lambda it: it.levels is not None, lambda it: 1.6, _draw_sound),
    _Part("reward", lambda it: bool(it.rewards.any()), lambda it: 1.3, _draw_rewards),
)


class Window:
    """A live window for a sequence of pictures."""

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
        """Shows a picture and handles the window's events."""
        if self._image is None:
            axes = self._figure.add_axes((0, 0, 1, 1))
            axes.set_axis_off()
            self._image = axes.imshow(picture)
            plt.show(block=False)
        self._image.set_data(picture)
        self._figure.canvas.draw_idle()
        self._figure.canvas.flush_events()

    @property
    def is_open(self) -> bool:
        """Whether the user has not closed it."""
        return bool(plt.fignum_exists(self._figure.number))

    def close(self) -> None:
        """Closes the window."""
        plt.close(self._figure)


def main() -> int:
    """Draws a recording: python -m mimo.plot run.h5 --out run.png."""
    parser = argparse.ArgumentParser(prog="python -m mimo.plot", description="Draws a recording.")
    parser.add_argument("recording", metavar="FILE.h5", help="the recording")
    parser.add_argument("--out", required=True, metavar="FILE.png", help="the picture: .png, .pdf or .svg")
    parser.add_argument("--infant", type=int, default=0, help="which one: 0, the first")
    parser.add_argument("--title", default="", help="title above the picture")
    parser.add_argument("--scene", help="scene of the recording, if it does not name its world")
    add_sense_option(parser)
    asked = parser.parse_args()
    plt.switch_backend("Agg")
    try:
        require_writable(asked.out)
        with Recording(asked.recording) as recording:
            for sense in asked.sense:
                recording.load_sense(sense)
            figure = run(traces(recording, asked.infant, asked.scene), asked.title)
        drawn = io.BytesIO()  # matplotlib's PDFs do not survive a full disk
        figure.savefig(drawn, dpi=130, format=os.path.splitext(asked.out)[1][1:] or "png")
        with new_file(asked.out) as file:
            file.write_bytes(drawn.getvalue())
    except (Error, OSError, ValueError) as error:
        print(f"python -m mimo.plot: {error}", file=sys.stderr)
        return 1
    print(f"{asked.out}: {recording.steps * recording.step_seconds:g} s")
    return 0


if __name__ == "__main__":
    sys.exit(main())
