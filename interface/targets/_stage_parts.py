"""Structs of stage.h that are made of arrays: which member holds the length of which array. Their comments begin with
it: "count: ...", "vertex_total x 3, m." Languages whose arrays know their length fill the lengths in themselves.
"""

from __future__ import annotations

import re

PARTS = [
    *("mimo_stage_shapes", "mimo_stage_meshes", "mimo_stage_fields", "mimo_stage_textures", "mimo_stage_materials"),
    *("mimo_stage_surfaces", "mimo_stage_tendons", "mimo_stage_lights", "mimo_stage_poses"),
]


def arrays(struct):
    """Each array of a part: the member, the one that holds its length, and how many numbers belong to one."""
    lengths = {member.name for member in struct.members if member.type == "size_t"}
    for member in struct.members:
        if "*" not in member.type:
            continue
        found = re.match(r"(\w+)(?: x (\d+))?", member.doc)
        if found[1] not in lengths:
            raise ValueError(f"{struct.name}.{member.name}: its comment does not begin with the member of its length")
        yield member, found[1], int(found[2] or 1)


def pointers(api):
    """The members of a stage's config that point to its parts and air, with the structs that these are."""
    for member in api.struct("mimo_stage_config").members:
        struct = member.type.removeprefix("const ").removesuffix(" *")
        if struct.startswith("mimo_stage_"):
            yield member, struct


def lengths(struct):
    """Each length of a part, with the arrays that have it: the member's name, and [(array, width)]."""
    found = {}
    for member, length, width in arrays(struct):
        found.setdefault(length, []).append((member, width))
    return found


def scalars(struct):
    """The members that programs set as they are."""
    return [
        one
        for one in struct.members
        if "*" not in one.type and one.type != "size_t" and one.name not in ("struct_size", "reserved")
    ]
