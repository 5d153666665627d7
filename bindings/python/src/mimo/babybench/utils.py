"""Functions that scripts import from the competition's module of this name."""

from __future__ import annotations

from typing import Any, Iterable, List, Optional, Tuple

import numpy as np
from numpy.typing import NDArray

from ..constants import Kind
from ..frames import placed
from .baselines import FELT, to_grayscale
from .making import make as make_env

__all__ = [
    "evaluation_img",
    "evaluation_video",
    "make_env",
    "render",
    "to_grayscale",
    "view_binocular",
    "view_touches",
]

Picture = NDArray[np.uint8]
MAIN, SMALL = 480, 240  # pixels of a frame's large picture and of both small ones
FRAME, RATE = (MAIN + SMALL, MAIN), 60  # of videos: width and height, frames per second
ACROSS = 0.9  # m that view_touches shows from side to side
TOUCHES, EYES = "touches_with_hands", "binocular"  # pictures that are not a camera's
# What belongs in the upper corner of a frame, by behaviour; for all others a camera's picture.
CORNERS = {"self_touch": TOUCHES, "hand_regard": EYES, "none": "side2"}
PAPER, SKIN, FORCE, HANDS = (255, 255, 255), (217, 217, 217), (255, 0, 0), (255, 255, 0)


def render(env: Any, camera: str = "corner") -> Picture:
    """A picture from one of the scene's cameras: corner, top, side1, side2, closeup, eye_left, eye_right."""
    picture: Picture = env.unwrapped.mujoco_renderer.render("rgb_array", camera_name=camera)
    return picture


def view_binocular(env: Any, pixels: Optional[int] = None) -> Picture:
    """Both eyes' pictures in one: brightness of the left in red, of the right in green and blue."""
    pictures = [render(env, eye) if pixels is None else _drawn(env, eye, pixels) for eye in ("eye_left", "eye_right")]
    left, right = (to_grayscale(picture).astype(np.uint8) for picture in pictures)
    return np.stack([left, right, right], axis=-1)


def view_touches(env: Any, focus_body: str = "hip", contact_with: Optional[str] = None) -> Picture:
    """The skin from above, around a body: sensors in grey, those that feel a force in red, larger for larger forces.

    With contact_with="hands" contacts of the palms with the infant's body are yellow. 240 x 240 pixels, 0.9 m.
    """
    if contact_with not in (None, "hands"):
        raise ValueError(f"contact_with is {contact_with!r}, expected 'hands' or None")
    of = env.unwrapped
    if of.touch is None:
        raise ValueError("view_touches shows touch, which the configuration switches off: set touch_active and groups")
    middle = of.world.bodies(focus_body).position[0, :2]
    picture = np.full((SMALL, SMALL, 3), PAPER, np.uint8)
    points, force = _sensors(of)
    felt = force > FELT
    _dots(picture, points[~felt] - middle, np.zeros(int(np.sum(~felt)), int), SKIN)
    shares = force[felt] / np.max(force, initial=FELT)
    order = np.argsort(shares)
    _dots(picture, points[felt][order] - middle, np.rint(1 + 2 * shares[order]).astype(int), FORCE)
    if contact_with == "hands":
        touched = _of_hands(of)
        _dots(picture, touched - middle, np.full(len(touched), 2), HANDS)
    return picture


def evaluation_img(env: Any, up: str = "side2", down: str = "top") -> Picture:
    """A frame of an evaluation's video, 480 x 720: the corner camera, and two small pictures at its right.

    `up` and `down` name a camera, "binocular" (view_binocular) or "touches_with_hands" (view_touches).
    """
    frame = np.empty((MAIN, MAIN + SMALL, 3), np.uint8)
    frame[:, :MAIN] = _drawn(env, "corner", MAIN)
    frame[:SMALL, MAIN:] = _small(env, up)
    frame[SMALL:, MAIN:] = _small(env, down)
    return frame


def evaluation_video(
    images: Iterable[Picture], save_name: Any = None, frame_rate: int = RATE, resolution: Tuple[int, int] = FRAME
) -> None:
    """Writes pictures into a video, one of mimo.video.FORMATS. Needs the extra [video]."""
    from ..video import write  # needs PyAV

    if save_name is None:
        raise ValueError("save_name is None, expected the path of a video")
    write(str(save_name), images, frame_rate, resolution)


def _small(env: Any, what: str) -> Picture:
    if what == EYES:
        return view_binocular(env, SMALL)
    return view_touches(env, contact_with="hands") if what == TOUCHES else _drawn(env, what, SMALL)


def _drawn(env: Any, camera: str, pixels: int) -> Picture:
    picture: Picture = env.unwrapped.world.render(camera=camera, width=pixels, height=pixels)
    return picture


def _sensors(env: Any) -> Tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Places of all sensors, world, x and y, and how much each feels."""
    poses = env.world.poses(Kind.BODY)
    outputs, places, force = env.touch.sensor_outputs, [], []
    for body, points in env.touch.sensor_positions.items():
        bodies = np.full(len(points), body)
        places.append(placed(poses.positions[bodies], poses.rotations[bodies], points)[:, :2])
        force.append(np.linalg.norm(outputs[body], axis=-1))
    return np.concatenate(places), np.concatenate(force)


def _of_hands(env: Any) -> NDArray[np.float64]:
    """Contacts of the palms with the infant's body, x and y."""
    contacts = env.world.contacts()
    palms, body = [*env.right_hand_geoms, *env.left_hand_geoms], env.mimo_geoms
    is_palm, is_body = np.isin(contacts.geoms, palms), np.isin(contacts.geoms, body)
    chosen = (is_palm & is_body[:, ::-1]).any(axis=1)
    places: NDArray[np.float64] = contacts.position[chosen, :2]
    return places


def _dots(picture: Picture, points: NDArray[Any], sizes: NDArray[np.intp], color: Tuple[int, int, int]) -> None:
    """Draws squares of 1 + 2 x size pixels; points outside are left out."""
    columns = np.floor((points[:, 0] / ACROSS + 0.5) * SMALL).astype(int)
    rows = np.floor((0.5 - points[:, 1] / ACROSS) * SMALL).astype(int)
    inside = (columns >= 0) & (columns < SMALL) & (rows >= 0) & (rows < SMALL)
    spots: List[Tuple[int, int, int]] = list(zip(rows[inside], columns[inside], sizes[inside]))
    for row, column, size in spots:
        picture[max(row - size, 0) : row + size + 1, max(column - size, 0) : column + size + 1] = color
