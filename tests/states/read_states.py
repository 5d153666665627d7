#!/usr/bin/env python3
"""Reads the kept states by docs/state-format.md, byte by byte and without the library.

Beside each NAME.state lies NAME.txt: the sizes of the model, then what the library told when it saved, in the order of
kept_states.c: the positions of all joints, the time and the sum of what is sensed, of each world.
"""

import math
import struct
import sys
from pathlib import Path

MASK = (1 << 64) - 1
HEADER = struct.Struct("<8s5Q")
SECTION = struct.Struct("<3I2Q")


def fingerprint(*parts):
    value = 0xCBF29CE484222325
    for part in parts:
        padded = part + bytes(-len(part) % 8)
        for word in (*struct.unpack(f"<{len(padded) // 8}Q", padded), len(part)):
            value = (value ^ word) * 0x9E3779B97F4A7C15 & MASK
            value ^= value >> 32
    z = (value ^ (value >> 33)) * 0xFF51AFD7ED558CCD & MASK
    z = (z ^ (z >> 33)) * 0xC4CEB9FE1A85EC53 & MASK
    return z ^ (z >> 33)


def read(state):
    """Sections of a state by name: version, whether it is essential, content."""
    magic, version, length, _model, count, checksum = HEADER.unpack_from(state)
    assert (magic, version) == (b"MIMOSTAT", 2)
    assert length == len(state), (length, len(state))
    assert checksum == fingerprint(state[: HEADER.size - 8], state[HEADER.size :]), "the checksum is wrong"
    sections, at = {}, HEADER.size
    for _ in range(count):
        name_bytes, section_version, flags, _kind, bytes_ = SECTION.unpack_from(state, at)
        at += SECTION.size
        name = state[at : at + name_bytes].decode()
        at += name_bytes
        sections[name] = section_version, bool(flags & 1), state[at : at + bytes_]
        at += bytes_
    assert at == length, f"{length - at} bytes follow the last section"
    return sections


# By the name of a state: the number of terms of its task's reward (docs/tasks.md), and the task's memory. Other states
# are of worlds without a task.
TASKS = {
    "reach": (2, "<?3d"),
    "standup": (2, "<"),
    "selfbody": (3, "<Q??"),
    "catch": (4, "<?Q3d2Q"),
    "rollover": (2, "<?"),
    "selftouch": (1, "<144I"),  # 36 geoms, four times
    "handregard": (1, "<8QQ"),
    "behaviour": (3, "<5d"),  # of the scene head-lift: two values, nothing remembered, three times
    "own_task": (1, "<??f3I"),
}
SIZES = ("nq", "nv", "nu", "na", "nbody", "ngeom", "neq", "ntendon", "nlight", "nmocap", "nuserdata")
WORLDS = 3  # of the batch


class Bytes:
    """Takes numbers from a section's content, to its last byte."""

    def __init__(self, content):
        self.content, self.at = content, 0

    def take(self, kind, count=1):
        numbers = struct.unpack_from(f"<{count}{kind}", self.content, self.at)
        self.at += struct.calcsize(f"<{count}{kind}")
        return numbers

    def end(self, name):
        assert self.at == len(self.content), f"{name}: {len(self.content) - self.at} bytes are left over"


def read_physics(content, size):
    lengths = {"time": 1, "qpos": size["nq"], "qvel": size["nv"], "act": size["na"], "qacc_warmstart": size["nv"]}
    lengths |= {"ctrl": size["nu"], "qfrc_applied": size["nv"], "xfrc_applied": 6 * size["nbody"]}
    lengths |= {"mocap_pos": 3 * size["nmocap"], "mocap_quat": 4 * size["nmocap"], "userdata": size["nuserdata"]}
    return take_all(content, [(name, "d", length) for name, length in lengths.items()])


def read_overrides(content, size):
    bodies, geoms, lights = size["nbody"], size["ngeom"], size["nlight"]
    return take_all(
        content,
        [
            *[("active", "B", size["neq"]), ("material", "i", geoms), ("eq_data", "d", size["neq"])],
            *[("gear", "d", size["nu"]), ("geom_size", "d", 3 * geoms), ("geom_rbound", "d", geoms)],
            *[("friction", "d", 3 * geoms), ("rgba", "f", 4 * geoms), ("mass", "d", bodies)],
            *[("subtreemass", "d", bodies), ("inertia", "d", 3 * bodies), ("invweight", "d", 2 * bodies)],
            *[("dof_invweight", "d", size["nv"]), ("M0", "d", size["nv"]), ("tendon", "d", size["ntendon"])],
            *[("acc0", "d", size["nu"]), ("damping", "d", size["nv"]), ("body_pos", "d", 3 * bodies)],
            *[("body_quat", "d", 4 * bodies), ("light_pos", "d", 3 * lights), ("light_dir", "d", 3 * lights)],
            *[("light_diffuse", "f", 3 * lights), ("gravity", "d", 3)],
        ],
    )


def take_all(content, arrays):
    taken = Bytes(content)
    numbers = {name: taken.take(kind, count) for name, kind, count in arrays}
    taken.end("content")
    assert all(math.isfinite(number) for array in numbers.values() for number in array)
    return numbers


def check_task(name, content):
    terms, memory = TASKS.get(name, (0, "<"))
    taken = Bytes(content)
    assert all(map(math.isfinite, taken.take("d", terms)))
    assert set(taken.take("B", 2)) <= {0, 1}
    remembered = struct.unpack_from(memory, content, taken.at)
    taken.at += struct.calcsize(memory)
    taken.end("task")
    return remembered


def check_memory(name, content, motors):
    """Memories of senses and motors."""
    taken = Bytes(content)
    if name.endswith("motor delay"):
        rows = taken.take("f", len(content) // 4)
        assert len(rows) in range(motors, len(rows) + 1, motors), name
    elif name.startswith("sight/"):
        (step,), (held,), light = taken.take("Q"), taken.take("B"), taken.take("f", (len(content) - 9) // 4)
        assert (step > 0, held) == (True, 1), name
        assert all(0 <= each <= 65535 for each in light), name
    else:
        assert taken.take("B") == (1,), f"{name} holds no values"
        taken.at = len(content)  # rows of the field's type; or numbers of models, which may change
    taken.end(name)


def check_sections(name, sections, size):
    """All of a state; returns what the physics holds, where it has any."""
    physics = None
    for section, (version, essential, content) in sections.items():
        assert version == 1, (section, version)
        kind = section.rsplit("/", 1)[-1]
        memory = section.startswith(("receptors/", "delay/", "sight/")) or kind == "motor delay"
        assert essential != memory, section
        if section == "episode":
            steps, _noise = struct.unpack("<2Q", content)
            assert steps == 30, steps
        elif section == "random":
            assert any(struct.unpack("<4Q", content))
        elif section == "overrides":
            told = read_overrides(content, size)
            assert told["gravity"] == ((0, 1, -5) if name == "overrides" else told["gravity"])
            for array, value in (("mass", 2), ("damping", 0.7), ("gear", 3)):
                assert name != "overrides" or value in told[array], array
        elif section == "physics":
            physics = read_physics(content, size)
        elif kind == "task":
            remembered = check_task(name, content)
            assert name != "own_task" or remembered[2:4] == (30, 30), remembered  # it counts its steps
        elif kind == "actuation":
            pairs = struct.unpack(f"<{len(content) // 8}d", content)
            assert all(map(math.isfinite, pairs)), section
            assert len(pairs) == (4 * size["nu"] if pairs else 0), section
            assert bool(pairs) == (name in ("catch", "muscle", "mujoco_muscle")), section
        else:
            check_memory(section, content, size["nu"])
    return physics


def states_of(path):
    """The states in a file: one, or rows of equal length, in which zeros follow shorter ones."""
    content = path.read_bytes()
    rows = WORLDS if path.stem == "batch" else 1
    length, rest = divmod(len(content), rows)
    assert rest == 0
    for row in (content[i * length : (i + 1) * length] for i in range(rows)):
        (own,) = struct.unpack_from("<Q", row, 16)
        assert not any(row[own:])
        yield row[:own]


def check(path):
    first, _further, *told = path.with_suffix(".txt").read_text().splitlines()
    size = dict(zip(SIZES, map(int, first.split())))
    numbers, found = [float(line) for line in told], []
    for state in states_of(path):
        sections = read(state)
        physics = check_sections(path.stem, sections, size)
        if physics is not None:
            positions, time = numbers[: size["nq"]], numbers[size["nq"]]
            assert physics["time"] == (time,), (physics["time"], time)
            assert list(physics["qpos"]) == positions, "other positions"
            numbers = numbers[size["nq"] + 2 :]
        found += [f"{name} {len(content)}" for name, (_, _, content) in sections.items()]
        try:
            read(damaged(state))
        except AssertionError:
            continue
        raise AssertionError(f"{path}: the checksum tells no damage")
    print(f"{path.name}: {', '.join(found)}")


def damaged(state):
    """A state with one bit turned, which the checksum has to tell."""
    changed = bytearray(state)
    changed[len(changed) // 2] ^= 4
    return bytes(changed)


def main():
    states = sorted(Path(sys.argv[1]).glob("*.state"))
    assert states, f"{sys.argv[1]} has no states"
    for path in states:
        check(path)


if __name__ == "__main__":
    main()
