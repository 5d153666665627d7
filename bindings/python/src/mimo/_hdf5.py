"""Finds an HDF5 library for recordings."""

from __future__ import annotations

import importlib.util
import os
from pathlib import Path
from typing import Any, Optional

from .errors import UnsupportedError


def with_hdf5(call: Any, library: Optional[bytes]) -> None:
    """Calls with the path of the requested HDF5 library, or of h5py's if the system has none."""
    try:
        call(library)
    except UnsupportedError as error:
        own = None if library is not None or os.environ.get("MIMO_HDF5") else _library_of_h5py()
        if own is None or "libhdf5-103-1" not in str(error):
            raise
        call(own)


def _library_of_h5py() -> Optional[bytes]:
    found = importlib.util.find_spec("h5py")
    if found is None or found.origin is None:
        return None
    beside = Path(found.origin).parent.parent / "h5py.libs"
    return next((os.fsencode(path) for path in sorted(beside.glob("libhdf5-*.so*"))), None)
