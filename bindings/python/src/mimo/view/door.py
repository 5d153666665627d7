"""Guards the page: who may connect, and which messages may arrive.

viser accepts connections from every page in the user's browser, and trusts their messages. Here the address holds a
token, like a notebook's; a browser's connection must come from the page itself; and a message must be one that the page
can send, with a value that its control can have.
"""

from __future__ import annotations

import hmac
import http
import math
import secrets
from contextlib import contextmanager
from typing import Any, Callable, Dict, Iterator
from urllib.parse import urlsplit

from .front import front_page

FARTHEST = 1e5  # m and other units of a page
LONGEST_TEXT = 1000
TEXTS = ("type", "name", "owner", "phase", "button", "modifier")
ABSENT = ("instance_index", "modifier")  # may be null
SIZES = ("fov", "near", "far", "image_height", "image_width")
VECTORS = {
    "wxyz": 4,
    "position": 3,
    "look_at": 3,
    "up_direction": 3,
    "start_position": 3,
    "end_position": 3,
    "start_screen_pos": 2,
    "end_screen_pos": 2,
}
MESSAGES = (  # the page sends only these of viser's; not, for example, the one that shares it on the internet
    "GuiUpdateMessage",
    "ViewerCameraMessage",
    "SceneNodeDragMessage",
    "TransformControlsDragStartMessage",
    "TransformControlsUpdateMessage",
    "TransformControlsDragEndMessage",
)
TURNED_AWAY = b"This page opens with the whole address that the viewer has printed, with the token in it.\n"
Controls = Callable[[str], Any]  # the control of an id, or None


class Door:
    """Lets clients with the token in."""

    def __init__(self) -> None:
        self.token = secrets.token_urlsafe(24)
        self.stands = False  # whether viser's server uses it
        self.controls: Controls = lambda _: None
        self._page = front_page()

    # ---- Connections -------------------------------------------------------------------------------------------------

    def answer(self, connection: Any, request: Any) -> Any:
        """The response to a request; None: it becomes a connection."""
        path = request.path.partition("?")[0].strip("/")
        if not hmac.compare_digest(path.encode(errors="replace"), self.token.encode()):
            return _response(http.HTTPStatus.FORBIDDEN, "text/plain", TURNED_AWAY)
        if request.headers.get("Upgrade", "").lower() != "websocket":
            return _response(http.HTTPStatus.OK, "text/html; charset=utf-8", self._page)
        if not _own(request.headers.get_all("Origin"), request.headers.get_all("Host")):
            return _response(http.HTTPStatus.FORBIDDEN, "text/plain", b"Another page's connection is refused.\n")
        return None

    # ---- Messages ----------------------------------------------------------------------------------------------------

    def takes(self, raw: Any) -> bool:
        """Whether a message is one that the page can send."""
        import msgspec

        try:
            message = msgspec.msgpack.decode(raw)
        except (msgspec.DecodeError, TypeError, ValueError, RecursionError):
            return False
        if not isinstance(message, dict) or message.get("type") not in MESSAGES:
            return False
        if message["type"] == "GuiUpdateMessage":
            return self._fits(message)
        return all(isinstance(name, str) and _plain(name, value) for name, value in message.items()) and _whole(raw)

    def _fits(self, message: Dict[str, Any]) -> bool:
        updates, uuid = message.get("updates"), message.get("uuid")
        if set(message) != {"type", "uuid", "updates"} or not isinstance(uuid, str):
            return False
        if not isinstance(updates, dict) or list(updates) != ["value"]:
            return False
        control = self.controls(uuid)
        return control is not None and can_be(control, updates["value"])

    # ---- Installation ------------------------------------------------------------------------------------------------

    @contextmanager
    def put_up(self) -> Iterator[None]:
        """Guards the viser server that is made in the block.

        viser calls websockets' serve() without options, so the block replaces serve().
        """
        from websockets.asyncio import server as web

        usual = web.serve

        def serve(handler: Any, *where: Any, **options: Any) -> Any:
            if getattr(handler, "__module__", "").split(".")[0] != "viser":
                return usual(handler, *where, **options)
            self.stands = True
            options.update(process_request=self.answer, create_connection=self._connection(web), logger=_silent())
            return usual(handler, *where, **options)

        web.serve = serve
        try:
            yield
        finally:
            web.serve = usual

    def _connection(self, web: Any) -> Any:
        takes = self.takes

        class Checked(web.ServerConnection):  # type: ignore[misc]
            async def recv(self, *how: Any, **more: Any) -> Any:
                while True:
                    raw = await super().recv(*how, **more)
                    if takes(raw):
                        return raw

        return Checked


def can_be(control: Any, value: Any) -> bool:
    """Whether a control of the page can have a value."""
    options = getattr(control, "options", None)
    if options is not None:
        return isinstance(value, str) and value in options
    if isinstance(control.value, bool):
        return isinstance(value, bool)
    if isinstance(control.value, (int, float)) and _finite(value):
        low, high = getattr(control, "min", None), getattr(control, "max", None)
        slack = 1e-6 * max(1.0, abs(value))  # added steps are inexact
        return (low is None or value >= low - slack) and (high is None or value <= high + slack)
    return False


def _plain(name: str, value: Any) -> bool:
    """Whether a part of a message is small, and its numbers are finite."""
    if name in VECTORS:
        return isinstance(value, list) and len(value) == VECTORS[name] and all(map(_finite, value))
    if value is None:
        return name in ABSENT
    if name in TEXTS:
        return isinstance(value, str) and len(value) < LONGEST_TEXT
    return _finite(value) and (name not in SIZES or value > 0)


def _whole(raw: Any) -> bool:
    """Whether a message has exactly the parts that viser takes: a TypeError there would end the connection."""
    from viser._messages import Message

    try:
        Message.deserialize(raw)
    except (KeyError, TypeError, ValueError):
        return False
    return True


def _finite(value: Any) -> bool:
    number = isinstance(value, (int, float)) and not isinstance(value, bool)
    return number and math.isfinite(value) and abs(value) <= FARTHEST


def _own(origins: Any, hosts: Any) -> bool:
    """Whether a connection comes from this page, or not from a browser."""
    if len(origins) == 0:
        return True
    try:
        places = [urlsplit(origin).netloc.lower() for origin in origins]
    except ValueError:
        return False  # not an address
    return len(hosts) == 1 and places == [hosts[0].lower()]


def _response(status: http.HTTPStatus, kind: str, body: bytes) -> Any:
    from websockets.datastructures import Headers
    from websockets.http11 import Response

    headers = Headers()
    for name, value in (
        ("Content-Type", kind),
        ("Content-Length", str(len(body))),
        ("Cache-Control", "no-store"),
        ("Referrer-Policy", "no-referrer"),
        ("X-Content-Type-Options", "nosniff"),
    ):
        headers[name] = value
    return Response(status.value, status.phrase, headers, body)


def _silent() -> Any:
    """A silent log: refused clients are not reported on the user's terminal."""
    import logging

    quiet = logging.getLogger("mimo.view.web")
    quiet.propagate, quiet.disabled = False, True
    return quiet
