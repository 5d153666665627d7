"""Plays the sound at an infant's ears on the page.

viser plays no sound. A picture of one pixel carries the last samples; when the page has loaded it, a script passes the
new ones to the browser's Web Audio, without gaps and without repetitions.
"""

from __future__ import annotations

import base64
from typing import Any, List

import numpy as np
from numpy.typing import NDArray

from ..drawing import EARS, prefixes
from ..world import World
from .clock import Clock

OVERLAP = 1.0  # s of sound that are sent again, because messages to a slow page replace each other
USUAL, LOUDEST = 20, 60  # dB above 1 Pa at full scale
PIXEL = "data:image/gif;base64,R0lGODlhAQABAIAAAAAAAP///yH5BAEAAAAALAAAAAABAAEAAAIBRAA7"
# `at` is the time of the next samples, `done` the number of the first one that was not passed on yet. A queue of more
# than 3 s of the infant's time begins anew.
PLAYER = (
    "const given=this.dataset,rate=+given.rate,speed=+given.speed,first=+given.first;"
    "const it=window.mimoSound??={context:new AudioContext({sampleRate:rate}),at:0,done:first,run:given.run};"
    "if(it.run!==given.run){it.run=given.run;it.done=first}"
    "it.context.resume();"
    "const bytes=Uint8Array.from(atob(given.samples),c=>c.charCodeAt(0)),both=new Int16Array(bytes.buffer);"
    "const skip=Math.max(0,it.done-first),count=both.length/2-skip;"
    "if(count>0){const piece=it.context.createBuffer(2,count,rate);"
    "for(let ear=0;ear<2;ear++){const to=piece.getChannelData(ear);"
    "for(let i=0;i<count;i++)to[i]=both[2*(skip+i)+ear]/32768}"
    "const player=it.context.createBufferSource();player.buffer=piece;player.playbackRate.value=speed;"
    "player.connect(it.context.destination);const now=it.context.currentTime;"
    "if(it.at<now||it.at>now+3/speed)it.at=now+0.3;"
    "player.start(it.at);it.at+=count/rate/speed;it.done=first+skip+count}"
)


class Sound:
    """A switch, the volume and the choice of an infant. At half speed sound is an octave deeper."""

    def __init__(self, server: Any, world: World, clock: Clock) -> None:
        self._world, self._clock = world, clock
        hearing = [name for name in prefixes(world) if name + EARS[0] in world.layout.fields]
        self._switch: Any = None
        self._run = 0
        self._forget()
        if not hearing:
            return
        self._rate = world.layout.fields[hearing[0] + EARS[0]].sample_rate
        self._switch = server.gui.add_checkbox("sound", False, hint="what an infant's ears hear")
        self._volume = server.gui.add_slider("volume (dB)", min=0, max=LOUDEST, step=1, initial_value=USUAL)
        names = [name.rstrip("/") for name in hearing]
        self._whose = server.gui.add_dropdown("ears", names, initial_value=names[0], visible=len(names) > 1)
        self._player = server.gui.add_html("")
        self._switch.on_update(lambda _: self._forget())
        self._whose.on_update(lambda _: self._forget())

    def _forget(self) -> None:
        self._heard: List[NDArray[np.float32]] = []  # samples x 2
        self._first, self._sent = 0, 0  # number of the first kept sample, and of the first new one
        self._run += 1

    @property
    def on(self) -> bool:
        """Whether every step needs observations."""
        return self._switch is not None and bool(self._switch.value)

    def hear(self) -> None:
        """Adds the sound of a step."""
        if self.on:
            prefix = self._whose.value + "/" if self._whose.value else ""
            self._heard.append(np.stack([self._world.observation[prefix + ear] for ear in EARS], axis=1))

    def update(self) -> None:
        """Sends new samples."""
        if not self.on or not self._heard:
            return
        waiting = np.concatenate(self._heard)
        end = self._first + len(waiting)
        if end > self._sent:
            self._player.content = self._page_of(waiting)
            self._sent = end
        kept = min(len(waiting), round(OVERLAP * self._rate))
        self._heard, self._first = [waiting[len(waiting) - kept :]], end - kept

    def _page_of(self, samples: NDArray[np.float32]) -> str:
        loud = samples * 10 ** (self._volume.value / 20)
        data = base64.b64encode(np.rint(np.clip(loud, -1, 1) * 32767).astype("<i2").tobytes()).decode()
        return (
            f'<img src="{PIXEL}" width="1" height="1" alt="" data-rate="{self._rate:g}" data-run="{self._run}"'
            f' data-first="{self._first}" data-speed="{self._clock.speed:g}" data-samples="{data}" onload="{PLAYER}">'
        )
