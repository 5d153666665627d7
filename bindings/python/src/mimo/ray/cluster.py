"""The connection to a Ray cluster."""

from __future__ import annotations

import os
import socket
import sys
import warnings
from typing import Any, Optional

import ray

ANSWER_WITHIN = 5.0  # seconds, for an existing cluster


def connect(address: Optional[str] = None, **options: Any) -> None:
    """Connects to a Ray cluster: at `address`, else an existing one (RAY_ADDRESS), else a new one on this machine.

    `address` is HOST:PORT, ray://HOST:PORT or "auto", which never starts one; options are those of ray.init.
    """
    if ray.is_initialized():
        return
    if " " in (sys.executable or ""):
        warnings.warn(
            f"Ray starts workers of Tune by a shell that splits the path of Python, {sys.executable!r}, at the space,"
            " and waits for them without an end: make the environment on a path without spaces",
            stacklevel=2,
        )
    given = address or os.environ.get("RAY_ADDRESS")
    if given and given not in ("auto", "local"):
        _check_there(given)
    try:
        ray.init(address=address, **{"log_to_driver": False, **options})
    except ConnectionError:
        raise ConnectionError(f"address is {given!r}: {NOBODY}") from None


NOBODY = "no Ray cluster is there; start one with `ray start --head`, or omit the address"


def _check_there(address: str) -> None:
    """Checks the address first: Ray would try for a minute, and then end the process."""
    host, _, port = address.rpartition("://")[2].rpartition(":")
    if not host or not port.isdigit():
        raise ValueError(f"address is {address!r}, expected HOST:PORT, ray://HOST:PORT or auto")
    try:
        socket.create_connection((host, int(port)), ANSWER_WITHIN).close()
    except (OSError, OverflowError):
        raise ConnectionError(f"address is {address!r}: {NOBODY}") from None
