"""What the comment of a member says in words that can be relied on: its range and its unit."""

from __future__ import annotations

import re

NUMBER = r"(-?\d[\d.]*(?<!\.)(?:e\d+)?)"
RANGE = re.compile(rf"{NUMBER}(?: \([^)]*\))? to {NUMBER}")
UNITS = {
    "bytes": "byte",
    "celsius": "degree Celsius",
    "cycles per degree": "cycles per degree",
    "degrees": "degree",
    "hz": "Hz",
    "kg": "kg",
    "kilograms": "kg",
    "m": "m",
    "m/s": "m/s",
    "metres": "m",
    "milliseconds": "ms",
    "months": "month",
    "n": "N",
    "nm": "Nm",
    "percent": "percent",
    "pixels": "pixel",
    "rad": "rad",
    "radians": "rad",
    "s": "s",
    "seconds": "s",
}
# A unit by itself, not behind a number ("at 6 months") nor within a name.
UNIT = re.compile(rf"(?<![\w/.'-])(?<!\d )({'|'.join(sorted(UNITS, key=len, reverse=True))})(?![\w/'-])", re.IGNORECASE)


def is_number(member):
    return "*" not in member["type"] and not member["type"].endswith("_fn")


def is_switch(member):
    return member["doc"].startswith("1: ")


def number(text):
    value = float(text)
    return int(value) if value.is_integer() and abs(value) < 2**53 else value


def range_of(member):
    """Lowest and highest value; 0 may also stand for a default, which the comment then says."""
    if not is_number(member) or member["enum"]:
        return None
    if is_switch(member):
        return [0, 1]
    found = RANGE.search(member["doc"])
    return [number(found[1]), number(found[2])] if found else None


def unit_of(member):
    if not is_number(member) or member["enum"] or is_switch(member):
        return None
    found = UNIT.search(member["doc"])
    return UNITS[found[1].lower()] if found else None
