"""Where members of structs lie on wasm32, where pointers have four bytes; interface.json is for 64-bit."""

from __future__ import annotations

SIZES = {"char": 1, "uint8_t": 1, "int32_t": 4, "uint32_t": 4, "float": 4, "size_t": 4}
SIZES |= {"int64_t": 8, "uint64_t": 8, "double": 8}
POINTER = 4


def size_of(api, c_type: str) -> int:
    """The size of a number or pointer, which is its alignment, too."""
    if "*" in c_type or api.is_a("callbacks", c_type):
        return POINTER
    own = next((one.c_type for one in api.typedefs if one.name == c_type), c_type)
    return SIZES[own]


def rounded(offset: int, to: int) -> int:
    return -(-offset // to) * to


def layout(api, struct) -> tuple[int, list[int]]:
    """The size of a struct, and the offset of each member."""
    offset, widest, offsets = 0, 1, []
    for member in struct.members:
        size = size_of(api, member.type)
        widest = max(widest, size)
        offsets.append(rounded(offset, size))
        offset = offsets[-1] + size * max(member.array, 1)
    return rounded(offset, widest), offsets
