"""The viewer's door: only who has the address comes in, and nothing that comes from there ends anything."""

import math
import socket
import time
import urllib.error
import urllib.request

import numpy as np
import pytest

import mimo
from mimo import view

viser = pytest.importorskip("viser", reason="viser is not installed")
msgpack = pytest.importorskip("msgspec").msgpack
exceptions = pytest.importorskip("websockets.exceptions")
client = pytest.importorskip("websockets.sync.client")

HERE = "the page's own"
CAMERA = {  # what a page sends first
    "type": "ViewerCameraMessage",
    "wxyz": [1, 0, 0, 0],
    "position": [1, 1, 1],
    "look_at": [0, 0, 0],
    "up_direction": [0, 0, 1],
    "fov": 0.7,
    "near": 0.01,
    "far": 1000,
    "image_height": 600,
    "image_width": 800,
}


@pytest.fixture(scope="module")
def viewer():
    with view.open("playdate", vision=False) as opened:
        yield opened


def connect(viewer, path=None, origin=HERE, **more):
    """As a browser would from a page of that origin; None: as a program without one."""
    place = viewer.url.split("/")[2]
    token = viewer.url.split("/")[3] if path is None else path
    origin = f"http://{place}" if origin is HERE else origin
    version = [f"viser-v{viser.__version__}"]
    return client.connect(f"ws://{place}/{token}", origin=origin, subprotocols=version, max_size=None, **more)


def status_of(viewer, path):
    try:
        return urllib.request.urlopen("/".join(viewer.url.split("/")[:3]) + path).status
    except urllib.error.HTTPError as error:
        return error.code


def test_the_page_needs_the_token(viewer):
    token = viewer.url.split("/")[3]
    assert len(token) >= 32  # 24 random bytes, as base64
    assert status_of(viewer, f"/{token}/") == status_of(viewer, f"/{token}") == 200
    for path in ("/", "/index.html", f"/{token[:-1]}/", f"/{token}x/", f"/?token={token}", "/..%2f", f"/{token}/../"):
        assert status_of(viewer, path) == 403, path
    with socket.create_connection(tuple(viewer.url.split("/")[2].split(":"))) as line:  # a path that is no ASCII
        line.sendall(b"GET /\xff HTTP/1.1\r\nHost: a\r\n\r\n")
        assert line.recv(100).startswith(b"HTTP/1.1 403")
    page = urllib.request.urlopen(viewer.url)
    assert b"<title>MIMo</title>" in page.read()
    assert page.headers["Referrer-Policy"] == "no-referrer"
    with view.open("reach", vision=False) as other:
        assert other.url.split("/")[3] != token


@pytest.mark.parametrize(
    "origin", ["http://evil.example", "null", "http://127.0.0.1:1", "https://evil.example:80", "http://[bad", ""]
)
def test_other_pages_are_refused(viewer, origin):
    for path in (None, "", "wrong"):
        with pytest.raises(exceptions.InvalidStatus, match="403"):
            connect(viewer, path, origin).close()
    with pytest.raises(exceptions.InvalidStatus, match="403"):
        connect(viewer, "wrong").close()
    with pytest.raises(exceptions.InvalidStatus, match="403"):
        connect(viewer, "wrong", None).close()


def test_the_page_itself_may_connect(viewer):
    for origin in (HERE, None):
        with connect(viewer, origin=origin) as connection:
            assert len(connection.recv(timeout=20)) > 100


def control(viewer, label):
    handles = viewer._server.gui._gui_input_handle_from_uuid.values()
    return next(handle for handle in handles if handle.label == label)


def update(handle, value, name="value"):
    return msgpack.encode({"type": "GuiUpdateMessage", "uuid": handle._impl.uuid, "updates": {name: value}})


def eventually(what, seconds=20):
    deadline = time.monotonic() + seconds
    while not what():
        assert time.monotonic() < deadline
        time.sleep(0.02)


def wrong_values(handle):
    """Of other kinds for all, and what lies beyond its ends."""
    wrong = ["nonsense", None, [], {}, [1, 2], {"a": 1}, b"x", math.nan, math.inf, -math.inf, 2**63, "x" * 10_000]
    if getattr(handle, "max", None) is not None:
        wrong += [handle.max + 1, handle.min - 1, True]
    return wrong


def test_no_message_ends_anything(viewer):
    """All controls get all wrong values, and the scene wrong messages; the page goes on, and nothing has changed."""
    viewer._page.sound._switch.value = True
    handles = list(viewer._server.gui._gui_input_handle_from_uuid.values())
    assert len(handles) > 100
    assert {"ears", "speed", "seed", "sound", "scene", "age (months)"} <= {handle.label for handle in handles}
    paused, viewer.clock.paused = viewer.clock.paused, True
    time.sleep(0.2)
    before = [(handle.label, handle.value) for handle in handles]
    with connect(viewer) as connection:
        connection.send(msgpack.encode(CAMERA))
        eventually(viewer._server.get_clients)
        for handle in handles:
            for value in wrong_values(handle):
                connection.send(update(handle, value))
            for name in ("update_cb", "removed", "props", "sync_cb", "gui_api", "__class__"):
                connection.send(update(handle, True, name))
        for message in wrong_messages(viewer):
            connection.send(message)
        connection.send(update(control(viewer, "speed"), 2.0))  # the last one; a good one
        eventually(lambda: viewer.clock.speed == 2.0)
    assert viewer._thread.is_alive()
    now = [(handle.label, handle.value) for handle in handles]
    assert now == [(label, 2.0 if label == "speed" else value) for label, value in before]
    viewer.clock.paused, reached = False, viewer._source.world.time
    eventually(lambda: viewer._source.world.time > reached)
    control(viewer, "speed").value, viewer.clock.speed, viewer.clock.paused = 1.0, 1.0, paused
    viewer._page.sound._switch.value = False


def wrong_messages(viewer):
    """Nothing that the page would send."""
    yield from (b"", b"\xc1", b"\x81", b"\x91" * 5000, "a text", msgpack.encode(3), msgpack.encode([]))
    drag = {"type": "TransformControlsUpdateMessage", "name": viewer._page._handle._axes.name, "wxyz": [1, 0, 0, 0]}
    upload = {"source_component_uuid": "a", "transfer_uuid": "b", "size_bytes": 2**40}
    for message in (
        {},
        {"type": None},
        {"type": ["GuiUpdateMessage"]},
        {"type": "ShareUrlRequest"},
        {"type": "FileTransferStartUpload", **upload},
        {"type": "GuiUpdateMessage"},
        {"type": "GuiUpdateMessage", "uuid": 3, "updates": {"value": 1}},
        {"type": "GuiUpdateMessage", "uuid": "none", "updates": {"value": 1}},
        {**drag, "position": [math.nan, 0, 0]},
        {**drag, "position": [1e300, 0, 0]},
        {**drag, "position": ["a", 0, 0]},
        {**drag, "position": [0, 0]},
        {**CAMERA, "position": [math.inf, 0, 0]},
        {**CAMERA, "image_width": "wide"},
        {**CAMERA, 1: 2},
        {**CAMERA, b"fov": 1},
        {**CAMERA, "nothing_of_it": 1},
        {"type": CAMERA["type"]},
        {**CAMERA, "fov": None},
        {**CAMERA, "image_height": 0},
    ):
        yield msgpack.encode(message)


def test_a_pull_from_far_away_is_bounded(viewer):
    """The page can only be that far; a pull from there is at most 300 N."""
    page = viewer._page
    place = viewer._source.world.bodies().names.index("toy")
    with connect(viewer) as connection:
        connection.send(msgpack.encode(CAMERA))
        eventually(viewer._server.get_clients)
        connection.send(update(control(viewer, "pull at"), "toy"))
        eventually(lambda: page.pull.body == "toy")
        axes = {"type": "TransformControlsUpdateMessage", "name": page._handle._axes.name, "wxyz": [1, 0, 0, 0]}
        connection.send(msgpack.encode({**axes, "position": [9e4, 0, 0]}))
        eventually(lambda: page.pull.target is not None)
        viewer.clock.paused = False
        eventually(lambda: np.linalg.norm(page.pull.force) > 1)
        assert np.linalg.norm(page.pull.force) <= 300 * (1 + 1e-9)
    viewer.ask(page.pull.release)
    eventually(lambda: page.pull.target is None)
    assert np.isfinite(viewer._source.world.poses("body").positions[place]).all()
    assert viewer._thread.is_alive()


def test_a_server_that_cannot_be_guarded_does_not_start(monkeypatch):
    """As with a viser that starts its server in another way."""
    from mimo.view import door

    monkeypatch.setattr(door.Door, "stands", property(lambda _: False, lambda *_: None), raising=False)
    with pytest.raises(mimo.UnsupportedError, match="cannot be guarded"):
        view.open("reach", vision=False)
