"""docs/bindings.md: which language reaches which function. One that a language lacks without a reason is named."""

import fnmatch
import re
from pathlib import Path

import notes

ROOT = Path(__file__).resolve().parents[2]
PAGE = "docs/bindings.md"
BEGIN, END = "<!-- made by ./dev interface -->", "<!-- end -->"

# Where a language calls the library: files, and what stands before the function's name.
LANGUAGES = {
    "C++": ("include/mimo/hpp/*.hpp", r"\b"),
    "Python": ("bindings/python/src/mimo/[!_]*.py bindings/python/src/mimo/_[al]*.py", r'(?:LIB\.|init = ")'),
    "Rust": ("bindings/rust/mimo/src/*.rs", r"\bsys::"),
    "C#": ("bindings/csharp/src/*.cs", r"Native\."),
    "MATLAB": ("bindings/matlab/*.c", r"\b"),
    "JavaScript": (
        "bindings/javascript/src/*.js bindings/javascript/src/generated/*.js",
        r'(?:wasm\(\)\.|made\.|init: ")',
    ),
}


def files(api):
    before, rest = (ROOT / PAGE).read_text(encoding="utf-8").split(BEGIN)
    return {PAGE: f"{before}{BEGIN}\n\n{table(api)}\n\n{END}{rest.split(END)[1]}"}


def reached(language, made):
    """The functions that a language calls, by its files and by those that were made of the interface just now."""
    patterns, before = LANGUAGES[language]
    paths = {str(path.relative_to(ROOT)) for pattern in patterns.split() for path in ROOT.glob(pattern)}
    paths |= {path for path in made if any(fnmatch.fnmatch(path, pattern) for pattern in patterns.split())}
    texts = [made.get(path) or (ROOT / path).read_text("utf-8") for path in paths]
    return {name for text in texts for name in re.findall(before + r"(mimo_[a-z_0-9]+)\b", text)}


class Cells:
    """Whether a language reaches a function, or why not; remembers what is wrong."""

    def __init__(self, made):
        self.reasons = notes.read()["unreached"]
        self.has = {language: reached(language, made) for language in LANGUAGES}
        self.wrong, self.used = [], set()

    def reason(self, language, function):
        for number, one in enumerate(self.reasons, 1):
            if language in one["languages"] and re.fullmatch(one["functions"], function):
                return number
        return None

    def cell(self, language, function):
        why = self.reason(language, function)
        self.used.add(why)
        if function in self.has[language]:
            if why is not None:
                self.wrong.append(f"{language} reaches {function}, and notes.toml has a reason not to")
            return "yes"
        if why is None:
            self.wrong.append(f"{language} lacks {function}, and notes.toml has no reason for that")
        return f"({why})"

    def row(self, function):
        return f"| `{function}` | {' | '.join(self.cell(language, function) for language in LANGUAGES)} |"


def table(api):
    cells, lines = Cells(api.made), []
    for header in api.headers:
        functions = [one.name for one in api.functions if one.header == header.name]
        if functions:
            lines += ["", f"| `mimo/{header.name}` | {' | '.join(LANGUAGES)} |", "|---|" + ":-:|" * len(LANGUAGES)]
            lines += map(cells.row, functions)
    lines += ["", "## Reasons", ""]
    for number, one in enumerate(cells.reasons, 1):
        lines.append(f"{number}. {' '.join(one['reason'].split())}")
        if number not in cells.used:
            cells.wrong.append(f"notes.toml has a reason for {one['functions']}, which is no function")
    if cells.wrong:
        raise notes.Undescribable("\n".join(cells.wrong))
    return "\n".join(lines).strip()
