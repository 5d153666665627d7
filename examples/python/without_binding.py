"""The library with ctypes alone, by interface.json: without the package mimo, as from any other language.

python without_binding.py /usr/lib/x86_64-linux-gnu/libmimo.so /usr/share/mimo/interface.json
"""

import ctypes
import json
import math
import re
import sys

library = ctypes.CDLL(sys.argv[1])
with open(sys.argv[2], encoding="utf-8") as file:
    interface = json.load(file)

NUMBERS = {"float": ctypes.c_float, "double": ctypes.c_double, "size_t": ctypes.c_size_t, "char": ctypes.c_char}
NUMBERS |= {f"{sign}int{bits}_t": getattr(ctypes, f"c_{sign}int{bits}") for sign in ("", "u") for bits in (8, 32, 64)}
NUMBERS |= {own["name"]: NUMBERS[own["c_type"]] for own in interface["typedefs"]}
CONSTANTS = {one["name"]: one["value"] for one in interface["constants"]}


def ctype(name):
    """Pointers stay addresses; ctypes itself passes Python's numbers as int, which is too short for size_t."""
    if re.fullmatch(r"const char \*", name):
        return ctypes.c_char_p
    return NUMBERS.get(name, ctypes.c_void_p)


def struct(name):
    """A struct with its size, and the library's defaults where it has any."""
    told = next(one for one in interface["structs"] if one["name"] == name)
    fields = [
        (one["name"], ctype(one["type"]) * one["array"] if one["array"] else ctype(one["type"]))
        for one in told["members"]
    ]
    made = type(name, (ctypes.Structure,), {"_fields_": fields})()
    assert ctypes.sizeof(made) == told["size"]
    made.struct_size = told["size"]
    if told["init"]:
        call(told["init"], ctypes.byref(made), told["size"])
    return made


for one in interface["functions"]:
    function = getattr(library, one["name"])
    function.argtypes = [ctype(parameter["type"]) for parameter in one["parameters"]]
    function.restype = None if one["returns"] == "void" else ctype(one["returns"])


def call(name, *arguments):
    """Calls a function that returns a status."""
    if getattr(library, name)(*arguments) != CONSTANTS["MIMO_OK"]:
        raise RuntimeError(library.mimo_last_error().decode())


env, layout, info = ctypes.c_void_p(), ctypes.c_void_p(), struct("mimo_layout_info")
call("mimo_env_make", b"reach", ctypes.byref(env))
call("mimo_env_layout", env, ctypes.byref(layout))
call("mimo_layout_describe", layout, ctypes.byref(info))
block = (ctypes.c_uint8 * info.block_bytes)()
action, reward = (ctypes.c_float * info.actions)(), ctypes.c_double()
results = struct("mimo_env_results")
results.reward, results.agent_count = ctypes.addressof(reward), info.agents
start = struct("mimo_reset_config")
start.seeded, start.seed = 1, 7
call("mimo_env_reset", env, ctypes.byref(start), ctypes.byref(block), info.block_bytes)
for step in range(100):
    for i in range(info.actions):
        action[i] = 0.3 * math.sin(step * info.step_seconds * 6 + i)
    call("mimo_env_step", env, action, info.actions, ctypes.byref(block), info.block_bytes, ctypes.byref(results))
print(f"after {100 * info.step_seconds:g} s the reward is {reward.value:.4f}, and {info.fields} fields were sensed")
library.mimo_env_destroy(env)
