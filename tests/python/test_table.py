"""The generated table of ctypes: structs, functions and enumerations."""

import ctypes
import json

import numpy as np
import pytest

import mimo
from mimo import _abi, errors, selections
from mimo.selection import Selection, Values


@pytest.fixture(scope="module")
def interface(root):
    return json.loads((root / "interface/interface.json").read_text())


def test_ctypes_lays_structs_out_as_c_does(interface):
    for told in interface["structs"]:
        struct = getattr(_abi, "".join(part.capitalize() for part in told["name"].split("_")[1:]))
        places = [(name, getattr(struct, name).offset, getattr(struct, name).size) for name, _ in struct._fields_]
        assert places == [(it["name"], it["offset"], it["size"]) for it in told["members"]], told["name"]
        assert ctypes.sizeof(struct) == told["size"], told["name"]


def test_every_failure_has_its_exception():
    assert set(errors.BY_STATUS) == set(mimo.Status) - {mimo.Status.OK}
    with pytest.raises(mimo.NotFoundError) as caught:
        mimo.Scene("nowhere")
    assert caught.value.status is mimo.Status.NOT_FOUND
    newer = errors.make_error(-99, "only a newer library knows it")
    assert type(newer) is mimo.Error
    assert newer.status == -99


SELECTIONS = [kind for kind in vars(selections).values() if isinstance(kind, type) and kind.__base__ is Selection]


def test_attributes_are_writable_where_the_library_writes():
    with mimo.World("reach", vision=False, touch=False) as world:
        for kind in SELECTIONS:
            one = kind(world, np.array([1 if kind is selections.Bodies else 0], np.int32))
            for quantity, writable in ((it.quantity, hasattr(it, "writable")) for it in attributes(kind)):
                message = ""
                try:
                    one._set(quantity, one._get(quantity), None)
                except mimo.Error as error:
                    message = str(error)
                assert writable != ("can only be read" in message), (quantity, message)


def attributes(kind):
    return [value for value in vars(kind).values() if isinstance(value, Values)]
