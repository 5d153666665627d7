#!/usr/bin/env python3
"""Reads the kept states by docs/state-format.md, without the library, and compares them with what was written down.

Beside each NAME.state lies NAME.txt: the positions of all joints and the time as the library told them when it saved.
"""

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


def check(path):
    sections = read(path.read_bytes())
    numbers = [float(line) for line in path.with_suffix(".txt").read_text().split()]
    for name in ("episode", "random", "overrides", "physics"):
        assert sections[name][1], f"{name} is not essential"
    steps, _noise = struct.unpack("<2Q", sections["episode"][2])
    assert steps == 30, steps
    assert len(sections["random"][2]) == 32
    # The file has positions, time and the sum of what was sensed, twice: at once, and 20 steps later.
    positions, time = numbers[: len(numbers) // 2 - 2], numbers[len(numbers) // 2 - 2]
    physics = sections["physics"][2]
    read_time, *read_positions = struct.unpack_from(f"<{1 + len(positions)}d", physics)
    assert read_time == time, (read_time, time)
    assert read_positions == positions, "other positions"
    return sections


def damaged(state):
    """A state with one bit turned, which the checksum has to tell."""
    changed = bytearray(state)
    changed[len(changed) // 2] ^= 4
    return bytes(changed)


def main():
    folder = Path(sys.argv[1])
    states = sorted(folder.glob("*.state"))
    assert states, f"{folder} has no states"
    for path in states:
        sections = check(path)
        try:
            read(damaged(path.read_bytes()))
        except AssertionError:
            pass
        else:
            raise AssertionError(f"{path}: the checksum tells no damage")
        print(f"{path.name}: {', '.join(f'{name} {len(content)}' for name, (_, _, content) in sections.items())}")


if __name__ == "__main__":
    main()
