"""Videos of an infant: both eyes, the scene from outside, touch and sound. Needs the extra [video].

    python -m mimo.video run.h5 --out run.mp4
    python -m mimo.video --scene showroom --seconds 5 --out live.mp4

`film(source, path)` does it with a mimo.view.Source.
"""

from __future__ import annotations

import argparse
import os
import sys
from contextlib import contextmanager, suppress
from typing import Any, Iterable, Iterator, List, Optional, Tuple

import numpy as np
from numpy.typing import NDArray

from ._files import new_file
from .body_map import BodyMap
from .constants import Kind
from .drawing import EARS, EYES, heat, prefixes, strength, touch_field
from .errors import Error, UnsupportedError
from .frames import placed
from .recordings import add_sense_option
from .scene import scenes
from .view.motors import Motors
from .view.recorded import Recorded
from .view.source import Live, Source
from .world import World

SIZE = (1120, 640)  # pixels of the video
OUTSIDE = (720, 640)
SIDE = SIZE[0] - OUTSIDE[0]  # pixels of the right part: eyes above, touch below
CAMERA = {"distance": 1.35, "azimuth": 145.0, "elevation": -25.0, "fovy": 45.0}
FOLLOW = 0.2  # share of its way to the infant that the camera moves per frame
RATE = 25  # pictures per second
FULL_SCALE = 1.0  # Pa, 94 dB, as in the program's sound files
FORMATS = (".mp4", ".m4v", ".mov", ".mkv", ".avi", ".ts")  # containers for H.264 and AAC
GREY, SKIN, PAPER = (110, 110, 110), (140, 140, 140), (255, 255, 255)


class Frame:
    """Draws the pictures of a video."""

    def __init__(self, world: World, agent: int = 0) -> None:
        self._world = world
        self._prefix = list(prefixes(world))[agent]
        fields = world.layout.fields
        self._eyes = [name for side in ("left", "right") if (name := f"{self._prefix}vision/eye_{side}") in fields]
        self._map = BodyMap(world, agent) if touch_field(world, self._prefix) else None
        names = world.bodies().names
        self._hip = names.index(f"{self._prefix}hip") if f"{self._prefix}hip" in names else 1
        self._at = world.poses(Kind.BODY).positions[self._hip].copy()

    def draw(self) -> NDArray[np.uint8]:
        """A picture of the current state."""
        from PIL import Image

        whole = Image.new("RGB", SIZE, PAPER)
        self._at += FOLLOW * (self._world.poses(Kind.BODY).positions[self._hip] - self._at)
        whole.paste(self._outside(), (0, 0))
        top = 0
        if len(self._eyes) == 2:
            edge = SIDE // 2 - 6
            for column, name in enumerate(self._eyes):
                seen = Image.fromarray(self._world.observation[name]).resize((edge, edge))
                whole.paste(seen, (OUTSIDE[0] + 4 + column * (edge + 4), 4))
            top = edge + 8
        if self._map is not None:
            whole.paste(self._touch(self._map, SIDE, SIZE[1] - top), (OUTSIDE[0], top))
        return np.asarray(whole)

    def _outside(self) -> Any:
        """The scene, with dots on touched sensors."""
        from PIL import Image, ImageDraw

        view = {**CAMERA, "look_at": self._at.tolist(), "width": OUTSIDE[0], "height": OUTSIDE[1]}
        drawn = self._world.draw(**view)
        picture = Image.fromarray(drawn.rgb)
        if self._map is None:
            return picture
        force = self._map.force
        felt = np.flatnonzero(force > 0)
        if len(felt) == 0:
            return picture
        receptors, poses = self._world.layout.receptors(self._map.field), self._world.poses(Kind.BODY)
        bodies = receptors.bodies[felt]
        places = placed(poses.positions[bodies], poses.rotations[bodies], receptors.position[felt])
        pen = ImageDraw.Draw(picture)
        for (x, y, depth), color in zip(self._world.project(places, **view), heat(strength(force[felt]))):
            inside = 0 <= x < OUTSIDE[0] and 0 <= y < OUTSIDE[1] and depth > 0
            if inside and depth < drawn.depth[int(y), int(x)] + 0.01:
                pen.circle((x, y), 3, tuple(color.tolist()))
        return picture

    def _touch(self, body: BodyMap, width: int, height: int) -> Any:
        """The skin from the front and from the back; the scale below."""
        from PIL import Image, ImageDraw

        picture = Image.new("RGB", (width, height), PAPER)
        pen = ImageDraw.Draw(picture)
        scale = min((width - 16) / body.width, height - 74)
        left, bottom = (width - scale * body.width) / 2, height - 50
        spots = np.column_stack([left + scale * body.places[:, 0], bottom - scale * body.places[:, 1]])
        force = body.force
        for x, y in spots[force == 0]:
            pen.point((x, y), SKIN)
        order = np.flatnonzero(force > 0)[np.argsort(force[force > 0])]
        for (x, y), color in zip(spots[order], heat(strength(force[order]))):
            pen.circle((x, y), 3, tuple(color.tolist()))
        for at, word in zip(body.middles, ("front", "back")):
            pen.text((left + scale * at, bottom + 4), word, GREY, anchor="ma")
        self._scale(pen, width, height - 26)
        return picture

    @staticmethod
    def _scale(pen: Any, width: int, top: int) -> None:
        colors = heat(np.linspace(0, 1, width - 120))
        for x, color in enumerate(colors):
            pen.line((60 + x, top, 60 + x, top + 9), tuple(color.tolist()))
        for x, word, anchor in ((56, "0.1 N", "ra"), (width - 56, "10 N", "la")):
            pen.text((x, top), word, GREY, anchor=anchor)


class File:
    """A video file being written, in one of FORMATS."""

    def __init__(
        self,
        path: str,
        rate: int,
        sound_rate: Optional[int] = None,
        full_scale: float = FULL_SCALE,
        size: Tuple[int, int] = SIZE,
    ) -> None:
        av = self._av = _av()
        self._file = av.open(path, "w")
        codec = "libx264" if "libx264" in av.codecs_available else "mpeg4"
        self._pictures = self._file.add_stream(codec, rate=rate)
        self._pictures.width, self._pictures.height = size
        self._pictures.pix_fmt = "yuv420p"
        if codec == "libx264":
            self._pictures.options = {"crf": "18"}
        self._sound = None if sound_rate is None else self._file.add_stream("aac", rate=sound_rate, layout="stereo")
        if self._sound is not None:
            self._sound.bit_rate = 160_000
        self._rate, self._full_scale, self._done = sound_rate, full_scale, 0

    def show(self, picture: NDArray[np.uint8]) -> None:
        """Adds a picture."""
        self._mux(self._pictures, self._av.VideoFrame.from_ndarray(picture, format="rgb24"))

    def play(self, samples: NDArray[np.float32]) -> None:
        """Adds sound: samples x 2, Pa."""
        loud = np.clip(samples.T / self._full_scale, -1, 1).astype(np.float32)
        frame = self._av.AudioFrame.from_ndarray(np.ascontiguousarray(loud), format="fltp", layout="stereo")
        frame.sample_rate, frame.pts = self._rate, self._done
        self._done += len(samples)
        self._mux(self._sound, frame)

    def _mux(self, stream: Any, frame: Any) -> None:
        for packet in stream.encode(frame):
            self._file.mux(packet)

    def finish(self) -> None:
        """Writes the end of the file."""
        for stream in (self._pictures, self._sound):
            if stream is not None:
                self._mux(stream, None)
        self._file.close()

    def give_up(self) -> None:
        """Closes a file that cannot be finished."""
        with suppress(self._av.FFmpegError):
            self._file.close()


def _av() -> Any:
    try:
        import av
        import PIL.Image  # noqa: F401
    except ImportError:
        raise UnsupportedError("videos need PyAV and Pillow: pip install 'mimo[video]'") from None
    return av


def film(
    source: Source,
    path: str,
    seconds: Optional[float] = None,
    rate: int = RATE,
    agent: int = 0,
    full_scale: float = FULL_SCALE,
) -> int:
    """Films a recording from its current step, or a live world; returns the number of pictures."""
    world, step_seconds = source.world, source.step_seconds
    if not 1 <= rate <= 1 / step_seconds:
        raise ValueError(f"--rate is {rate}, expected 1 to {1 / step_seconds:g} pictures per second")
    ears = [list(prefixes(world))[agent] + ear for ear in EARS]
    hears = ears[0] in world.layout.fields
    sound_rate = round(world.layout.fields[ears[0]].sample_rate) if hears else None
    motors, frame, count = Motors(world, step_seconds), Frame(world, agent), 0
    with _video(path, rate, sound_rate, full_scale) as file:
        for step in range(_steps(source, seconds)):
            if _due(step, count, step_seconds * rate):
                file.show(frame.draw())
                count += 1
            if source.advance(motors.next(), hears or _due(step + 1, count, step_seconds * rate)):
                source.restart(None)
            if hears:
                file.play(np.stack([world.observation[ear] for ear in ears], axis=1))
    return count


def write(path: str, pictures: Iterable[NDArray[np.uint8]], rate: int, size: Tuple[int, int]) -> None:
    """Writes pictures of a size (width, height) into a silent video."""
    width, height = size
    with _video(path, rate, size=size) as file:
        for picture in pictures:
            if np.shape(picture) != (height, width, 3):
                raise ValueError(f"a picture has the shape {np.shape(picture)}, expected {(height, width, 3)}")
            file.show(np.ascontiguousarray(picture, np.uint8))


@contextmanager
def _video(
    path: str,
    rate: int,
    sound_rate: Optional[int] = None,
    full_scale: float = FULL_SCALE,
    size: Tuple[int, int] = SIZE,
) -> Iterator[File]:
    """A file that gets its name when it is complete."""
    if os.path.splitext(path)[1].lower() not in FORMATS:
        raise ValueError(f"{path} cannot be written as a video: expected a name that ends with {', '.join(FORMATS)}")
    with new_file(path) as beside:
        file = File(str(beside), rate, sound_rate, full_scale, size)
        try:
            yield file
            file.finish()
        finally:
            file.give_up()


def _due(step: int, count: int, pictures_a_step: float) -> bool:
    return step * pictures_a_step >= count - 1e-9


def _steps(source: Source, seconds: Optional[float]) -> int:
    wanted = None if seconds is None else max(1, round(seconds / source.step_seconds))
    if source.length is None:
        return wanted if wanted is not None else round(10 / source.step_seconds)
    left = source.length - source.at
    return left if wanted is None else min(left, wanted)


def arguments(given: Optional[List[str]] = None) -> argparse.Namespace:
    """The arguments of the command line."""
    parser = argparse.ArgumentParser(prog="python -m mimo.video", description="Films an infant and its senses.")
    parser.add_argument("recording", nargs="?", metavar="FILE.h5", help="a recording; default: a scene, random actions")
    parser.add_argument("--out", required=True, metavar="FILE.mp4", help="the video")
    parser.add_argument("--scene", help=f"one of {', '.join(scenes())} (benchmark)")
    parser.add_argument("--seed", type=int, default=1, help="of a scene (1)")
    parser.add_argument("--age", type=float, help="age of a scene's infants, months")
    add_sense_option(parser)
    parser.add_argument("--start", type=float, default=0.0, metavar="S", help="start in a recording, s (0)")
    parser.add_argument("--seconds", type=float, metavar="S", help="length, s; the default for a scene is 10")
    parser.add_argument("--eyes", type=int, default=EYES, help=f"pixels of each eye, across and down ({EYES}); 0: none")
    parser.add_argument("--rate", type=int, default=RATE, help=f"pictures per second ({RATE})")
    parser.add_argument("--infant", type=int, default=0, help="number of the infant (0)")
    help_loud = f"sound pressure of full scale, Pa ({FULL_SCALE:g})"
    parser.add_argument("--full-scale", type=float, default=FULL_SCALE, metavar="PA", help=help_loud)
    return parser.parse_args(given)


def opened(asked: argparse.Namespace) -> Source:
    """The requested source, at its start."""
    if asked.seconds is not None and not asked.seconds > 0:
        raise ValueError(f"--seconds is {asked.seconds:g}, expected more than 0")
    if not 0 < asked.full_scale < float("inf"):
        raise ValueError(f"--full-scale is {asked.full_scale:g}, expected more than 0 Pa")
    if asked.recording is None:
        live = Live.asked(asked.scene, asked.eyes, asked.age, own_senses=asked.sense)
        live.restart(asked.seed)
        return live
    source = Recorded(asked.recording, asked.eyes, asked.scene, asked.sense)
    step, length = round(asked.start / source.step_seconds), source.length or 0
    if not 0 <= step < length:
        end = length * source.step_seconds
        source.close()
        raise ValueError(f"--start is {asked.start:g}, but {asked.recording} ends at {end:g} s")
    source.seek(step)
    return source


def main() -> int:
    """Writes a video and prints its length."""
    asked = arguments()
    try:
        _av()
        source = opened(asked)
        try:
            if not 0 <= asked.infant < len(source.world.agents):
                raise ValueError(f"--infant is {asked.infant}, expected 0 to {len(source.world.agents) - 1}")
            count = film(source, asked.out, asked.seconds, asked.rate, asked.infant, asked.full_scale)
        finally:
            source.close()
    except (Error, OSError, ValueError) as error:
        print(f"python -m mimo.video: {error}", file=sys.stderr)
        return 1
    print(f"{asked.out}: {count / asked.rate:g} s in {count} pictures")
    return 0


if __name__ == "__main__":
    sys.exit(main())
