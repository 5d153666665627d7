"""Pages of the documentation, whose numbers are compared with what the library gives.

A claim is a piece of a page with {} in place of its numbers: `says` compares these with numbers that were just
computed, `tested` looks them up in a test of another language that compares them. A claim fails where page and library
part, and where a page says it in other words. `python tests/python/guide.py` lists the numbers that no claim concerns.
"""

import math
import re
import sys
from collections import defaultdict
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
NUMBER = r"-?\d+(?:,\d{3})*(?:\.\d+)?"
CLAIMED = defaultdict(set)  # by page: where its numbers begin that a claim concerns


def _pattern(piece):
    """Words may stand in another line, rows of tables begin with one."""
    rows = [r"\s+".join(re.escape(word) for word in re.split(r"\s+", row)) for row in piece.split("\n|")]
    return r"\n\|".join(rows)


class Page:
    """A page of docs, by its path from there."""

    def __init__(self, name):
        self.name = name
        self.text = (ROOT / "docs" / name).read_text(encoding="utf-8")

    def numbers(self, claim):
        """What stands in place of each {} of a claim, as text."""
        pieces = [_pattern(piece) for piece in claim.split("{}")]
        found = list(re.finditer(f"({NUMBER})".join(pieces), self.text))
        assert found, f"docs/{self.name} does not say {claim!r} any more: make the claim say what the page says"
        assert len(found) == 1, f"docs/{self.name} says {claim!r} {len(found)} times: make the claim longer"
        groups = range(1, len(pieces))
        CLAIMED[self.name] |= {found[0].start(group) for group in groups}
        return [found[0].group(group).replace(",", "") for group in groups]

    def says(self, claim, *values, within=0.0):
        """Each number is this value, to its last digit or so far."""
        written = self.numbers(claim)
        assert len(written) == len(values), f"{claim!r} has {len(written)} numbers, and {len(values)} values are given"
        for text, value in zip(written, values, strict=True):
            last_digit = 10.0 ** -len(text.partition(".")[2])
            allowed = max(within, 0.505 * last_digit)
            assert abs(float(text) - value) <= allowed, (
                f"docs/{self.name} says {text} in {claim!r}, and the library gives {value:.6g}"
            )

    def tested(self, claim, test):
        """Each number stands, rounded or not, in a test, which compares it with what the library gives."""
        self._stands(claim, [f"tests/{test}"], lambda number, known: number - known)

    def coded(self, claim, *sources):
        """Each number is a constant of a law, and stands so in the code, in whatever unit."""
        self._stands(
            claim,
            [f"src/{source}" for source in sources],
            lambda number, known: number - known * _power_to(number, known),
        )

    def _stands(self, claim, files, difference):
        source = "\n".join((ROOT / file).read_text(encoding="utf-8") for file in files)
        # 241e4 is the number of a square metre, 241 that of a square centimetre.
        found = re.findall(rf"(?<![\w.])({NUMBER})(e-?\d+)?F?(?!\w|\.\d)", source)
        known = [float(text) for digits, power in found for text in (digits, digits + power)]
        for text in self.numbers(claim):
            last_digit = 10.0 ** -len(text.partition(".")[2])
            there = any(abs(difference(float(text), number)) <= 0.505 * last_digit for number in known)
            assert there, f"docs/{self.name} says {text} in {claim!r}, and {files[0]} nothing of it"


def _power_to(number, known):
    """The power of ten that brings one to the size of the other."""
    if number == 0 or known == 0:
        return 1.0
    return 10.0 ** round(math.log10(abs(number / known)))


def unclaimed(name):
    """Lines of a page with numbers that no claim concerns, those marked; without code, links and headings."""
    text = Page(name).text
    skipped = [
        match.span() for match in re.finditer(r"```.*?```|`[^`]*`|\]\([^)]*\)|^#.*?$|^    .*?$", text, re.S | re.M)
    ]
    left = [
        match
        for match in re.finditer(rf"(?<![\w.]){NUMBER}", text)
        if match.start() not in CLAIMED[name] and not any(a <= match.start() < b for a, b in skipped)
    ]
    by_line = defaultdict(list)
    for match in left:
        by_line[text.count("\n", 0, match.start()) + 1].append(match.group())
    return by_line


def main():
    import pytest

    here = Path(__file__).resolve().parent
    sys.modules["guide"] = sys.modules["__main__"]  # the claims' pages are these
    result = pytest.main(["-q", "-p", "no:cacheprovider", *map(str, sorted(here.glob("test_numbers*.py")))])
    for path in sorted((ROOT / "docs").rglob("*.md")):
        name = path.relative_to(ROOT / "docs").as_posix()
        if name.startswith("adr/"):
            continue
        lines = unclaimed(name)
        print(f"\n{name}: {len(CLAIMED[name])} numbers claimed, {sum(map(len, lines.values()))} not")
        for line, numbers in lines.items():
            print(f"  {line}: {', '.join(numbers)}")
    return result


if __name__ == "__main__":
    sys.exit(main())
