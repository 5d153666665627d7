"""Contacts of one world, whose number differs from step to step."""

from __future__ import annotations

import ctypes
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ._handle import Native
from ._library import LIB, check
from .constants import Quantity
from .errors import ArgumentError, make_error
from .results import Numbers

BUSY = -15  # MIMO_E_BUSY


class Contacts(NamedTuple):
    """Contacts, one a row; frames, forces and torques as mimo.h explains at MIMO_CONTACT_FRAME."""

    geoms: NDArray[np.int32]  # n x 2
    bodies: NDArray[np.int32]  # n x 2
    position: Numbers  # n x 3, world, m
    frame: Numbers  # n x 3 x 3, rows: normal from geom 1 to geom 2, two tangents
    distance: Numbers  # n, negative: overlap
    force: Numbers  # n x 3, on body 2, in the contact's frame, N
    torque: Numbers  # n x 3


class StepContacts(NamedTuple):
    """Pairs of geoms that touched during the last step, one a row; needs the option step_contacts=True."""

    geoms: NDArray[np.int32]  # n x 2
    bodies: NDArray[np.int32]  # n x 2
    start: Numbers  # n, s since the step began
    end: Numbers  # n
    impulse: Numbers  # n x 3, on body 2, world, N s
    peak_force: Numbers  # n x 3, on body 2, world, N
    peak_position: Numbers  # n x 3, world, m


def contacts_of(handle: Native) -> Contacts:
    """The contacts in a world of this handle."""
    return Contacts(
        geoms=_all_of(handle, Quantity.CONTACT_GEOMS, 2).astype(np.int32),
        bodies=_all_of(handle, Quantity.CONTACT_BODIES, 2).astype(np.int32),
        position=_all_of(handle, Quantity.CONTACT_POSITION, 3),
        frame=_all_of(handle, Quantity.CONTACT_FRAME, 9).reshape(-1, 3, 3),
        distance=_all_of(handle, Quantity.CONTACT_DISTANCE, 1).ravel(),
        force=_all_of(handle, Quantity.CONTACT_FORCE, 3),
        torque=_all_of(handle, Quantity.CONTACT_TORQUE, 3),
    )


def step_contacts_of(handle: Native) -> StepContacts:
    """What touched what during the last step of a world of this handle."""
    return StepContacts(
        geoms=_all_of(handle, Quantity.STEP_CONTACT_GEOMS, 2).astype(np.int32),
        bodies=_all_of(handle, Quantity.STEP_CONTACT_BODIES, 2).astype(np.int32),
        start=_all_of(handle, Quantity.STEP_CONTACT_START, 1).ravel(),
        end=_all_of(handle, Quantity.STEP_CONTACT_END, 1).ravel(),
        impulse=_all_of(handle, Quantity.STEP_CONTACT_IMPULSE, 3),
        peak_force=_all_of(handle, Quantity.STEP_CONTACT_PEAK_FORCE, 3),
        peak_position=_all_of(handle, Quantity.STEP_CONTACT_PEAK_POSITION, 3),
    )


def _all_of(handle: Native, quantity: Quantity, width: int) -> Numbers:
    """A quantity of all that a world has: a row of `width` numbers for each."""
    values = np.empty((_numbers_of(handle, quantity) // width, width))
    try:
        check(LIB.mimo_env_get(handle, quantity, None, 0, values.ctypes.data, values.size))
    except ArgumentError:
        if _numbers_of(handle, quantity) == values.size:
            raise
        message = "another thread is using this world: its contacts changed while they were read"
        raise make_error(BUSY, message) from None
    return values


def _numbers_of(handle: Native, quantity: Quantity) -> int:
    count = ctypes.c_size_t()
    check(LIB.mimo_env_width(handle, quantity, None, 0, count))
    return count.value
