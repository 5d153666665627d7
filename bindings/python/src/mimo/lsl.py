"""Streams the senses of a world by the Lab Streaming Layer, and takes a stream as its actions. Needs the extra [lsl].

with mimo.lsl.Streams(world, ["proprioception", "vestibular"]) as streams:
    for _ in range(1000):
        world.step(actions)
        streams.push()

actions = mimo.lsl.Actions(world, "my controller")
world.step(actions.latest())

python -m mimo.lsl --scene reach --fields proprioception --seconds 60 --actions "my controller"
"""

from __future__ import annotations

import argparse
import sys
import time
from typing import Any, Dict, List, NamedTuple, Optional, Sequence

import numpy as np
from numpy.typing import NDArray

from ._handle import Closing
from ._strict import Strict
from .errors import Error, UnsupportedError
from .kept import PICTURE, SOUND, Table, is_meant, table_of
from .layout import no_field
from .recorded_world import inner_world
from .scene import scenes
from .world import World

USUAL = ("proprioception", "vestibular")
CLOCKS = ("real", "simulated")
FORMATS = {"uint8": "int16", "int32": "int32", "float32": "float32", "float64": "double64"}  # LSL has no uint8
CONTENTS = {PICTURE: "VideoRaw", SOUND: "Audio"}
MOTION = ("proprioception/position", "proprioception/velocity")


def _need() -> Any:
    try:
        import pylsl
    except (ImportError, RuntimeError) as error:  # pylsl raises a RuntimeError where it finds no liblsl
        told = "" if isinstance(error, ImportError) else f" ({error})"
        raise UnsupportedError(f"streams need pylsl and liblsl: pip install 'mimo[lsl]'{told}") from None
    return pylsl


class _Stream(NamedTuple):
    field: str
    table: Table
    outlet: Any


class Streams(Strict, Closing):
    """A stream for each chosen field of a world.

    `fields` are senses and names of fields, by default proprioception and the vestibular sense. Streams are called
    `NAME/FIELD`. Each channel has its label, unit and frame in the stream's description. Time stamps are on LSL's
    clock: with `clock="real"` the time of the push, with "simulated" the simulated time since the first push, which
    does not jitter. Both are the moments that the fields belong to, up to a step before its end.
    """

    def __init__(
        self, world: Any, fields: Optional[Sequence[str]] = None, name: str = "mimo", clock: str = "real"
    ) -> None:
        if clock not in CLOCKS:
            raise ValueError(f"clock is {clock!r}, expected {' or '.join(map(repr, CLOCKS))}")
        pylsl, inner = _need(), inner_world(world)
        rate = 1 / inner.layout.step_seconds
        chosen = _chosen(inner, fields)
        streams = [_Stream(it, table, _outlet(pylsl, f"{name}/{it}", table, rate)) for it, table in chosen.items()]
        self._now, self._world, self._streams, self._simulated = pylsl.local_clock, inner, streams, clock == "simulated"
        self._begun: Optional[float] = None
        self._pushed = 0

    @property
    def names(self) -> List[str]:
        """The streamed fields."""
        return [stream.field for stream in self._streams]

    def push(self) -> None:
        """Sends the latest observation; call it after each step."""
        now = self._now()
        if self._begun is None:
            self._begun = now
        if self._simulated:
            now = self._begun + self._pushed * self._world.layout.step_seconds
        self._pushed += 1
        seen = self._world.observation
        for stream in self._streams:
            values, at = seen[stream.field], now + stream.table.late
            if stream.table.kind == SOUND:
                stream.outlet.push_chunk(np.ascontiguousarray(values).reshape(-1, 1), at)  # the time of the last sample
            else:
                stream.outlet.push_sample(values.ravel().tolist(), at)

    def close(self) -> None:
        """Ends the streams."""
        self._streams = []


def _chosen(world: World, wanted: Optional[Sequence[str]]) -> Dict[str, Table]:
    fields = world.layout.fields
    names = USUAL if wanted is None else wanted
    for name in names:
        if wanted is not None and not any(is_meant(name, field) for field in fields):
            raise ValueError(no_field(name, list(fields)))
    chosen = {it: table_of(world, fields[it]) for it in fields if any(is_meant(name, it) for name in names)}
    if not chosen:
        raise ValueError(f"fields is {wanted!r}, and the world has none of {', '.join(names) or 'these'}")
    return chosen


def _outlet(pylsl: Any, name: str, table: Table, rate: float) -> Any:
    """A stream with its channels described as XDF files have them."""
    content = CONTENTS.get(table.kind, "MoCap" if table.name in MOTION else "Misc")
    sound = table.kind == SOUND
    count = 1 if sound else int(np.prod(table.shape))
    form = FORMATS[np.dtype(table.dtype).name]
    info = pylsl.StreamInfo(name, content, count, table.sample_rate if sound else rate, form, f"libmimo {name}")
    told = info.desc()
    for key, text in (("manufacturer", "libmimo"), ("field", table.name), ("unit", table.unit), ("frame", table.frame)):
        told.append_child_value(key, text)
    told.append_child_value("shape", " ".join(map(str, table.shape)))
    if len(table.columns) == count:
        channels = told.append_child("channels")
        for column in table.columns:
            channel = channels.append_child("channel")
            for key, text in (("label", column.name), ("unit", column.unit), ("frame", column.frame)):
                channel.append_child_value(key, text)
    return pylsl.StreamOutlet(info)


class Actions(Strict):
    """The actions of a world, taken from a stream.

    The stream is found by its name. Its channels go to the actions of the same labels, or, if it has no labels, in the
    order of `world.action_names`. Raises TimeoutError if it does not appear within `seconds`.
    """

    time: Optional[float]  # the newest actions' time stamp, on LSL's clock

    def __init__(self, world: Any, stream: str, seconds: float = 5.0) -> None:
        pylsl, inner = _need(), inner_world(world)
        found = pylsl.resolve_byprop("name", stream, timeout=seconds)
        if not found:
            raise TimeoutError(f"no stream {stream!r} appeared within {seconds:g} s")
        if len({(it.hostname(), it.source_id()) for it in found}) > 1:
            raise ValueError(f"{len(found)} streams are called {stream!r}, expected one")
        inlet = pylsl.StreamInlet(found[0], recover=False)
        try:
            order = _order(inlet.info(timeout=seconds), list(inner.action_names), stream)
            inlet.open_stream(timeout=seconds)
        except (pylsl.util.LostError, pylsl.util.TimeoutError):
            raise TimeoutError(f"the stream {stream!r} ended before it could be read") from None
        self._inlet, self._order, self._lost, self._name = inlet, order, pylsl.util.LostError, stream
        self._latest: Optional[NDArray[np.float32]] = None
        self._have(time=None)

    def latest(self) -> Optional[NDArray[np.float32]]:
        """The newest actions that have arrived; None before the first, which leaves the motors as they are.

        Raises ConnectionError when the stream has ended.
        """
        try:
            while True:
                samples, times = self._inlet.pull_chunk(timeout=0.0, max_samples=1024)
                if not times:
                    return self._latest
                self._latest = np.asarray(samples[-1], np.float32)[self._order]
                self._have(time=float(times[-1]))
        except self._lost:
            raise ConnectionError(f"the stream {self._name!r} has ended") from None


def _order(info: Any, actions: List[str], stream: str) -> NDArray[np.intp]:
    """For each action the number of its channel."""
    labels, count = info.get_channel_labels() or [], info.channel_count()
    if any(labels):
        missing = [name for name in actions if name not in labels]
        unknown = [label for label in labels if label not in actions]
        if missing or unknown or len(set(labels)) < len(labels):
            told = f"lacks {', '.join(missing)}" if missing else f"has {', '.join(unknown) or 'a label twice'}"
            raise ValueError(f"the stream {stream!r} {told}; expected the labels {', '.join(actions)}")
        return np.array([labels.index(name) for name in actions], np.intp)
    if count != len(actions):
        raise ValueError(f"the stream {stream!r} has {count} channels, expected {len(actions)}, one per action")
    return np.arange(count)


def _run(asked: argparse.Namespace) -> None:
    options: Dict[str, Any] = {} if asked.age is None else {"age": asked.age}
    fields = None if asked.fields is None else asked.fields.split(",")
    with World(asked.scene, vision=any("vision" in it for it in fields or []), **options) as world:
        world.reset(seed=asked.seed)
        actions = None if asked.actions is None else Actions(world, asked.actions, asked.wait)
        with Streams(world, fields, asked.name, asked.clock) as streams:
            print(f"streams {', '.join(f'{asked.name}/{it}' for it in streams.names)}", flush=True)
            step, begun = world.layout.step_seconds, time.monotonic()
            for number in range(round(asked.seconds / step)):
                world.step(None if actions is None else actions.latest())
                streams.push()
                time.sleep(max(0.0, begun + (number + 1) * step - time.monotonic()))


def main(given: Optional[List[str]] = None) -> int:
    """Streams a scene in real time."""
    parser = argparse.ArgumentParser(prog="python -m mimo.lsl", description="Streams a scene's senses in real time.")
    parser.add_argument("--scene", default="benchmark", help=f"one of {', '.join(scenes())}")
    parser.add_argument("--seed", type=int, default=0, help="of the start (0)")
    parser.add_argument("--age", type=float, help="of the infants, months")
    parser.add_argument("--seconds", type=float, default=60.0, help="how long (60)")
    parser.add_argument("--fields", metavar="LIST", help=f"senses and names of fields ({','.join(USUAL)})")
    parser.add_argument("--name", default="mimo", help="first part of the streams' names (mimo)")
    parser.add_argument("--clock", choices=CLOCKS, default="real", help="time stamps (real)")
    parser.add_argument("--actions", metavar="STREAM", help="name of a stream of actions; default: none")
    parser.add_argument("--wait", type=float, default=30.0, metavar="S", help="how long to wait for it, s (30)")
    try:
        _run(parser.parse_args(given))
    except (Error, OSError, ValueError) as error:
        print(f"python -m mimo.lsl: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
