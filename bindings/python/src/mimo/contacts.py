"""Contacts of one world, whose number differs from step to step."""

from __future__ import annotations

import ctypes
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._handle import Native
from ._library import LIB, check, result
from .constants import Quantity, Status
from .errors import ArgumentError, make_error
from .results import Numbers
from .selections import WIDTHS, Contacts, StepContacts


def contacts_of(handle: Native) -> Contacts:
    """The contacts in a world of this handle."""
    contacts: Contacts = _table(handle, Contacts, "CONTACT")
    return contacts


def step_contacts_of(handle: Native) -> StepContacts:
    """The contacts during the last step of a world of this handle."""
    contacts: StepContacts = _table(handle, StepContacts, "STEP_CONTACT")
    return contacts


def _table(handle: Native, kind: Any, prefix: str) -> Any:
    columns = [_column(handle, Quantity[f"{prefix}_{name.upper()}"]) for name in kind._fields]
    return kind(*columns)


def _column(handle: Native, quantity: Quantity) -> NDArray[Any]:
    """A quantity of all contacts, with its shape and type."""
    values = _all_of(handle, quantity, WIDTHS[quantity])
    if quantity.name.endswith(("_GEOMS", "_BODIES")):
        return values.astype(np.int32)
    if WIDTHS[quantity] == 1:
        return values.ravel()
    return values.reshape(-1, 3, 3) if WIDTHS[quantity] == 9 else values  # rows of a frame


def _all_of(handle: Native, quantity: Quantity, width: int) -> Numbers:
    """A quantity of all contacts: a row of `width` numbers for each."""
    values = np.empty((_numbers_of(handle, quantity) // width, width))
    try:
        check(LIB.mimo_env_get(handle, quantity, None, 0, values.ctypes.data, values.size))
    except ArgumentError:
        if _numbers_of(handle, quantity) == values.size:
            raise
        message = "another thread is using this world: its contacts changed while they were read"
        raise make_error(Status.BUSY, message) from None
    return values


def _numbers_of(handle: Native, quantity: Quantity) -> int:
    return int(result(ctypes.c_size_t, LIB.mimo_env_width, handle, quantity, None, 0))
