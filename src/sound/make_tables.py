#!/usr/bin/env python3
"""Writes sphere_table.cpp and mode_tables.cpp out of the tables in original/."""

import csv
from itertools import groupby
from pathlib import Path

HERE = Path(__file__).resolve().parent
HEAD = "// Made by make_tables.py. Do not edit.\n"
LARGEST_SIZE = 5


def rows(name: str) -> list[dict[str, str]]:
    with (HERE / "original" / name).open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def sphere() -> str:
    lines = [f"    {{{r['b1']}, {r['b2']}, {r['a1']}, {r['a2']}}}," for r in rows("sphere_filter.csv")]
    return (
        f'{HEAD}#include "sound/sphere.h"\n\nnamespace mimo::sound {{\n\n'
        "const std::array<SphereFilter, kSphereAngles> kSphereTable = {{\n" + "\n".join(lines) + "\n}};\n\n}\n"
    )


def modes() -> str:
    sets, materials = [], {}
    for (material, sizes), group in groupby(rows("modes.csv"), lambda r: (r["material"], r["size_buckets"])):
        first, last = int(sizes[0]), int(sizes[-1])
        materials.setdefault(material, {}).update(dict.fromkeys(range(first, last + 1), len(sets)))
        # Levels in dB become gains, milliseconds seconds.
        each = [
            f"{{{r['frequency_hz']}, {10 ** (float(r['level_db_rel']) / 20):.4f}, {float(r['t60_ms']) / 1e3:.4f}}}"
            for r in group
        ]
        sets.append(f"    {{{len(each)}, {{{{{', '.join(each)}}}}}}},  // {material}, size {sizes}")
    rungs = []
    for material, by_size in materials.items():
        numbers = ", ".join(str(by_size[size]) for size in range(LARGEST_SIZE + 1))
        rungs.append(f'    {{"{material}", {{{{{numbers}}}}}}},')
    return (
        f'{HEAD}#include "sound/mode_tables.h"\n\nnamespace mimo::sound {{\n\n'
        f"const std::array<ModeSet, kModeSets> kModeTable = {{{{\n" + "\n".join(sets) + "\n}};\n\n"
        f"const std::array<Timbre, kTimbres> kTimbreTable = {{{{\n" + "\n".join(rungs) + "\n}};\n\n}\n"
    ), len(sets), len(materials)


if __name__ == "__main__":
    (HERE / "sphere_table.cpp").write_text(sphere(), encoding="utf-8")
    text, count, names = modes()
    (HERE / "mode_tables.cpp").write_text(text, encoding="utf-8")
    print(f"{count} sets of modes of {names} materials")
