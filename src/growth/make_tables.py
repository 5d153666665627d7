#!/usr/bin/env python3
"""Writes who_tables.cpp out of who_lms.csv, the WHO's child growth standards by month."""

import csv
from pathlib import Path

HERE = Path(__file__).resolve().parent
SOURCE = HERE / "who_lms.csv"
MEASURES = [("length", "kLength"), ("weight", "kWeight"), ("head_circumference", "kHead")]
SEXES = [("f", "Female"), ("m", "Male")]


def table(rows, measure, sex, name):
    mine = sorted((r for r in rows if (r["measure"], r["sex"]) == (measure, sex)), key=lambda r: int(r["age_months"]))
    assert [int(r["age_months"]) for r in mine] == list(range(25)), (measure, sex)
    lines = [f"const LmsTable {name} = {{{{"]
    for column in "LMS":
        numbers = ", ".join(str(float(r[column])) for r in mine)
        lines.append(f"    {{{{{numbers}}}}},")
    return "\n".join([*lines, "}};"])


def main():
    with SOURCE.open() as stream:
        rows = list(csv.DictReader(stream))
    text = ["// Made by make_tables.py. Do not edit.", '#include "growth/who.h"', "", "namespace mimo::growth {", ""]
    for measure, name in MEASURES:
        text += [table(rows, measure, sex, name + suffix) + "\n" for sex, suffix in SEXES]
    text += ["}  // namespace mimo::growth", ""]
    (HERE / "who_tables.cpp").write_text("\n".join(text))


if __name__ == "__main__":
    main()
