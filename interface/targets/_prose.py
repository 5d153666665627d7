"""The header's comments in the words of a language."""

from __future__ import annotations

import re


class Prose:
    """Replaces C's names by a language's. `name_of` takes a name of C, or a prefix of constants (MIMO_TOUCH_), and
    returns the language's name."""

    def __init__(self, api, name_of):
        self.api = api
        self.name_of = name_of
        self.constants = {constant.name for constant in api.constants}

    def text(self, doc: str, enum: str | None = None) -> str:
        """A comment; of something that takes constants of an enumeration, their short names in it are names, too."""
        if enum:
            words = {self.api.enum(enum).word(name): name for name in self.api.enum(enum).constants}
            doc = re.sub(r"(?<!\w)_?([A-Z][A-Z0-9_]+)\b", lambda match: words.get(match[1], match[0]), doc)
        doc = re.sub(r"(?<!\w)_[A-Z][A-Z0-9_]+\b", lambda match: self.constant(f"MIMO{match[0]}", match[0]), doc)
        return re.sub(r"\b(?:MIMO|mimo)_\w+", lambda match: self.name_of(match[0]), doc)

    def constant(self, full: str, short: str) -> str:
        return full if full in self.constants else short


def described(thing) -> str:
    """A comment that says of what is experimental that it is."""
    return f"{thing.doc}\n\nExperimental." if thing.stability == "experimental" else thing.doc


def without_null(doc: str) -> str:
    """A member's comment for languages in which NULL is what nobody has set."""
    doc = re.sub(r"\bNULL or (?=\"\")|, or NULL|, and NULL(?=\))", "", doc)
    doc = re.sub(r"(^|\. )NULL(?: \(default\))?:", r"\1Unless set:", doc)
    return re.sub(r"\bNULL(?: \(default\))?:", "unless set:", doc)


def switch(member) -> bool:
    """Whether a member is on or off. The header then begins with what 1 means: "1: ..."."""
    return member.type == "uint32_t" and member.range == [0, 1]
