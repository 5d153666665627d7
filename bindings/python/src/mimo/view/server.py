"""The web server of a viewer's page."""

from __future__ import annotations

import contextlib
import io
import socket
import threading
from typing import Any, Tuple

from ..errors import UnsupportedError
from .door import Door
from .front import NAME

WIDTH = 290  # of the controls, pixels
_starting = threading.Lock()


def free_port(host: str, port: int) -> int:
    """The port, or a free one for 0; refuses a used one, instead of which viser would silently take the next."""
    if not 0 <= port <= 65535:
        raise ValueError(f"port is {port}, expected 0 to 65535")
    with socket.socket() as probe:
        probe.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            probe.bind((host, port))
        except OSError as error:
            raise OSError(f"port {port} of {host} cannot be used ({error.strerror}); give another port") from None
        taken: int = probe.getsockname()[1]
        return taken


def silence() -> Any:
    """Keeps viser's output from the user's terminal."""
    return contextlib.redirect_stdout(io.StringIO())


def start(host: str, port: int) -> Tuple[Any, Door]:
    """A silent viser server, and its door."""
    try:
        import viser
    except ImportError:
        raise UnsupportedError("the viewer needs viser: pip install 'mimo[view]'") from None
    found, door = free_port(host, port), Door()
    with silence(), _starting, door.put_up():
        server = viser.ViserServer(host=host, port=found, verbose=False, label=NAME)
    if not door.stands:
        with silence():
            server.stop()
        raise UnsupportedError(f"viser {viser.__version__} starts its server in a way that cannot be guarded")
    door.controls = server.gui._gui_input_handle_from_uuid.get
    server.gui.configure_theme(show_logo=False, show_share_button=False)
    server.gui.main_panel.dock_right()
    server.gui.main_panel.set_width(WIDTH)
    return server, door
