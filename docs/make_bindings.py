#!/usr/bin/env python3
"""Writes the table of docs/bindings.md: which language reaches which function of the C interface.

Functions are read out of the headers, in their order, and what reaches them out of the bindings' sources. With --check
nothing is written: fails where the page differs, where a function is reached by a language from nowhere and the list of
reasons below does not say why, and where it gives a reason for one that is reached.
"""

import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs/bindings.md"
BEGIN, END = "<!-- made by make_bindings.py -->", "<!-- end -->"

# Where a language calls the library: files, and what stands before the function's name.
LANGUAGES = {
    "C++": ("include/mimo/hpp/*.hpp", r"\b"),
    "Python": ("bindings/python/src/mimo/[!_]*.py bindings/python/src/mimo/_library.py", r"LIB\."),
    "Rust": ("bindings/rust/mimo/src/*.rs", r"\bsys::"),
    "C#": ("bindings/csharp/src/*.cs", r"Native\."),
    "MATLAB": ("bindings/matlab/*.c", r"\b"),
}

# Why a language does not reach a function: one reason for all whose names match.
REASONS = [
    (
        "MATLAB",
        "mimo_task_init|mimo_task_field_init|mimo_scene_set_task|mimo_fail",
        "MATLAB runs its code on one thread only, and the library asks a task from its own threads while it steps:"
        " rewards are computed after the step, from named access.",
    ),
    (
        "C++ Python Rust C# MATLAB",
        "mimo_last_error_of",
        "A call of the wrapper ends with its error on the thread that failed, where mimo_last_error is its own.",
    ),
    (
        "Python",
        "mimo_status_name",
        "Each status is an exception class with a name of its own.",
    ),
    (
        "Python",
        "mimo_env_make",
        "mimo.World(name) makes the scene itself, so that worlds can be copied and pickled.",
    ),
    (
        "MATLAB",
        "mimo_env_(create|make|destroy|layout|reset|step|observe|set|state_size|state_save|state_load|clone)",
        "A number stands for a batch, if only of one world, and the batch's functions do it; a clone is a second one"
        " that loads the state.",
    ),
    (
        "MATLAB",
        "mimo_(env|batch)_get_float",
        "MATLAB's numbers are double.",
    ),
    (
        "MATLAB",
        "mimo_agent_config_init",
        "An agent starts from what its scene gives (mimo_scene_default_agent).",
    ),
    (
        "MATLAB",
        "mimo_recording_(size|read)",
        "h5read reads the file.",
    ),
    (
        "MATLAB",
        "mimo_senses_.*",
        "MATLAB has no MuJoCo data of a host that they could look at.",
    ),
]


def header(chapter):
    return re.sub(r"/\*.*?\*/", "", (ROOT / "include/mimo" / chapter).read_text(), flags=re.DOTALL)


def chapters():
    """The functions of each chapter, in the order of mimo.h."""
    for chapter in re.findall(r'#include "(\w+\.h)"', header("mimo.h")):
        yield chapter, re.findall(r"MIMO_API[^;]*?\b(mimo_\w+)\(", header(chapter))


def reached(language):
    files, before = LANGUAGES[language]
    paths = [path for pattern in files.split() for path in sorted(ROOT.glob(pattern))]
    return {name for path in paths for name in re.findall(before + r"(mimo_[a-z_0-9]+)\b", path.read_text())}


def reason(language, function):
    for index, (languages, pattern, _) in enumerate(REASONS):
        if language in languages.split() and re.fullmatch(pattern, function):
            return index
    return None


def table():
    """The table, and what is wrong with it."""
    has = {language: reached(language) for language in LANGUAGES}
    lines, wrong, used = [], [], set()
    for chapter, functions in chapters():
        if functions:
            lines += ["", f"| `mimo/{chapter}` | {' | '.join(LANGUAGES)} |", "|---|" + ":-:|" * len(LANGUAGES)]
        for function in functions:
            cells = []
            for language, names in has.items():
                why = reason(language, function)
                if (function in names) == (why is not None):
                    what = "reached, and has a reason not to be" if why is not None else "not reached, without a reason"
                    wrong.append(f"{language}: {function} is {what}")
                used.add(why)
                cells.append("yes" if function in names else f"({why + 1})" if why is not None else "no")
            lines.append(f"| `{function}` | {' | '.join(cells)} |")
    unused = [pattern for i, (_, pattern, _) in enumerate(REASONS) if i not in used]
    wrong += [f"nothing is left of the reason for {pattern}" for pattern in unused]
    lines += ["", "## Reasons", ""] + [f"{i + 1}. {text}" for i, (_, _, text) in enumerate(REASONS)]
    return "\n".join(lines).strip(), wrong


def main():
    made, wrong = table()
    page = PAGE.read_text()
    before, rest = page.split(BEGIN)
    new = f"{before}{BEGIN}\n\n{made}\n\n{END}{rest.split(END)[1]}"
    if sys.argv[1:] != ["--check"]:
        PAGE.write_text(new)
    elif new != page:
        wrong.append("docs/bindings.md is not what docs/make_bindings.py writes")
    sys.exit("\n".join(wrong) or None)


main()
