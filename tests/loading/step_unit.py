"""step_unit.py UNIT.fmu: loads the library of a unit of FMI and steps it, with nothing but Python, on any system.

It prints a line with what it did, and ends with an error if the unit does something else than FMI says.
"""

import ctypes
import math
import os
import sys
import tempfile
import zipfile
from ctypes import byref, c_bool, c_char_p, c_double, c_float, c_int, c_size_t, c_uint32, c_void_p
from pathlib import Path
from xml.etree import ElementTree

STEPS, SECONDS = 5, 0.01  # of the scene reach
ACTION, OUTPUT = "act:right_elbow", "proprioception/position"
LOG_2 = ctypes.CFUNCTYPE(None, c_void_p, c_char_p, c_int, c_char_p, c_char_p)
LOG_3 = ctypes.CFUNCTYPE(None, c_void_p, c_int, c_char_p, c_char_p)


class Callbacks(ctypes.Structure):
    _fields_ = [("log", LOG_2), ("allocate", c_void_p), ("free", c_void_p), ("finished", c_void_p), ("own", c_void_p)]


def fail(why):
    sys.exit(f"{sys.argv[1]}: {why}")


class Unit:
    def __init__(self, folder):
        told = ElementTree.parse(folder / "modelDescription.xml").getroot()
        self.three = told.get("fmiVersion") == "3.0"
        self.token = told.get("instantiationToken" if self.three else "guid").encode()
        variables = list(told.find("ModelVariables"))
        self.action = next(int(it.get("valueReference")) for it in variables if it.get("name") == ACTION)
        named = [it for it in variables if it.get("name").startswith(OUTPUT)]
        self.outputs = [int(it.get("valueReference")) for it in named]
        self.count = math.prod(int(it.get("start")) for it in named[0]) if self.three else len(named)
        windows = sys.platform == "win32"
        system = ("x86_64-windows", "win64") if windows else ("x86_64-linux", "linux64")
        name = told.find("CoSimulation").get("modelIdentifier") + (".dll" if windows else ".so")
        self.module = ctypes.CDLL(str(folder / "binaries" / system[0 if self.three else 1] / name))
        self.log = (LOG_3 if self.three else LOG_2)(lambda *told: print(told[-1].decode()))
        self.made = self.make(folder / "resources")
        if not self.made:
            fail("it is not instantiated")

    def make(self, resources):
        make = self.function("InstantiateCoSimulation" if self.three else "Instantiate")
        make.restype = c_void_p
        if self.three:
            place = str(resources) + os.sep
            last = (None, c_size_t(0), None, self.log, None)
            return make(b"infant", self.token, place.encode(), c_bool(False), c_bool(True), c_bool(False), False, *last)
        self.callbacks = Callbacks(self.log)
        return make(b"infant", 1, self.token, resources.as_uri().encode(), byref(self.callbacks), 0, 1)

    def function(self, name):
        return getattr(self.module, f"fmi{3 if self.three else 2}{name}")

    def call(self, name, *arguments):
        status = self.function(name)(c_void_p(self.made), *arguments)
        if status != 0:
            fail(f"{name} gives status {status}")

    def start(self):
        if self.three:
            self.call("EnterInitializationMode", c_bool(False), c_double(0), c_double(0), c_bool(False), c_double(0))
        else:
            self.call("SetupExperiment", 0, c_double(0), c_double(0), 0, c_double(0))
            self.call("EnterInitializationMode")
        self.call("ExitInitializationMode")

    def act(self, value):
        number, given = byref(c_uint32(self.action)), byref(c_double(value))
        if self.three:
            self.call("SetFloat64", number, c_size_t(1), given, c_size_t(1))
        else:
            self.call("SetReal", number, c_size_t(1), given)

    def step(self, time):
        if self.three:
            flags, last = [byref(c_bool()) for _ in range(3)], byref(c_double())
            self.call("DoStep", c_double(time), c_double(SECONDS), c_bool(True), *flags, last)
        else:
            self.call("DoStep", c_double(time), c_double(SECONDS), 1)

    def joints(self):
        numbers = (c_uint32 * len(self.outputs))(*self.outputs)
        if self.three:
            values = (c_float * self.count)()
            self.call("GetFloat32", numbers, c_size_t(1), values, c_size_t(self.count))
        else:
            values = (c_double * self.count)()
            self.call("GetReal", numbers, c_size_t(self.count), values)
        return list(values)


def main():
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        with zipfile.ZipFile(sys.argv[1]) as file:
            file.extractall(folder)
        unit = Unit(Path(folder).resolve())
        unit.start()
        first = unit.joints()
        unit.act(0.5)
        for i in range(STEPS):
            unit.step(i * SECONDS)
        later, state = unit.joints(), c_void_p()
        if not all(map(math.isfinite, later)) or later == first:
            fail(f"joints are {later} after {STEPS} steps")
        get, put, free = (
            ("GetFMUState", "SetFMUState", "FreeFMUState")
            if unit.three
            else (
                "GetFMUstate",
                "SetFMUstate",
                "FreeFMUstate",
            )
        )
        unit.call(get, byref(state))
        unit.step(STEPS * SECONDS)
        further = unit.joints()
        unit.call(put, state)
        if unit.joints() != later:
            fail("the state does not bring the joints back")
        unit.step(STEPS * SECONDS)
        if unit.joints() != further:
            fail("the step after the state is another one")
        unit.call(free, byref(state))
        unit.call("Terminate")
        unit.function("FreeInstance")(c_void_p(unit.made))
        print(f"{STEPS} steps by FMI {3 if unit.three else 2}, and back to a state")
        sys.stdout.flush()
        os._exit(0)  # Windows keeps the library's file busy, so the folder stays there


if __name__ == "__main__":
    main()
