"""Visits all models of a folder of packages with zoo_visit, each in a process of its own, and tells how it went.

What may be refused is listed in refused.txt, with a part of the message. Everything else has to go well, and what is
listed there has to be refused: the list then stays true.
"""

import argparse
import collections
import os
import re
import resource
import signal
import subprocess
import sys
import time
from dataclasses import dataclass, field
from pathlib import Path
from xml.etree import ElementTree

HERE = Path(__file__).resolve().parent
SIGNALS = {-number: number.name for number in signal.Signals}


def tree(path):
    """The root of an XML file; None for what is no XML."""
    try:
        return ElementTree.parse(path).getroot()
    except (ElementTree.ParseError, OSError):
        return None


def has_body(path, seen=()):
    """Whether a file has something in its world, or includes a file that has."""
    root = tree(path)
    if root is None or path in seen:
        return False
    if any(part.find(".//body") is not None or part.find(".//geom") is not None for part in root.iter("worldbody")):
        return True
    files = [path.parent / include.get("file", "") for include in root.iter("include")]
    return any(has_body(file, (*seen, path)) for file in files)


def is_model(path):
    """A whole model, as far as one can tell from outside: MJCF with something in its world."""
    root = tree(path)
    return root is not None and root.tag == "mujoco" and has_body(path)


def read_refused(path):
    """{name: (heading, part of the message)} out of lines "# heading" and "name: part"."""
    expected, heading = {}, ""
    for line in path.read_text().splitlines():
        if line.startswith("# "):
            heading = line[2:]
        elif line.strip():
            name, part = line.split(": ", 1)
            expected[name] = (heading, part)
    return expected


@dataclass
class Visit:
    """What became of one model."""

    name: str
    outcome: str  # ok, refused, crash, timeout, wrong
    words: dict = field(default_factory=dict)  # the last of each that zoo_visit told
    message: str = ""
    seconds: float = 0

    @property
    def package(self):
        return self.name.split("/")[0]


def is_sanitized(program):
    return b"__asan_init" in program.read_bytes()


def limits(program, gigabytes):
    """The environment and what the child does first, so that it has so much memory and no core files."""
    environment = dict(os.environ)
    options = f"hard_rss_limit_mb={gigabytes * 1024}:detect_leaks=1:allocator_may_return_null=1"
    environment["ASAN_OPTIONS"] = options
    environment["UBSAN_OPTIONS"] = "print_stacktrace=1"
    environment["LSAN_OPTIONS"] = f"suppressions='{HERE.parent}/support/lsan.supp':print_suppressions=0"
    sanitized = is_sanitized(program)  # its shadow memory has terabytes of addresses

    def prepare():
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        if not sanitized:
            resource.setrlimit(resource.RLIMIT_AS, (gigabytes << 30, gigabytes << 30))

    return environment, prepare


def judge(name, code, output, errors):
    words = dict(line.split(" ", 1) for line in output.splitlines() if " " in line)
    stage = words.get("stage", "start")
    report = re.search(r"(ERROR: \w+Sanitizer: .*|runtime error: .*)", errors)
    if report or code < 0 or code not in (0, 1, 3):
        what = report.group(1) if report else SIGNALS.get(code, f"exit status {code}")
        return Visit(name, "crash", words, f"{what}, in stage {stage}")
    if code == 3:
        return Visit(name, "refused", words, words.get("refused", "?"))
    if code == 1 or "wrong" in words or "done" not in words:
        return Visit(name, "wrong", words, words.get("wrong", words.get("refused", f"ended in stage {stage}")))
    if errors.strip():
        return Visit(name, "wrong", words, f"wrote to stderr: {errors.strip().splitlines()[0]}")
    return Visit(name, "ok", words)


def visit(program, path, name, seconds, steps, child):
    environment, prepare = child
    start = time.monotonic()
    try:
        run = subprocess.run(
            [program, path, str(steps)],
            capture_output=True,
            timeout=seconds,
            env=environment,
            preexec_fn=prepare,
            text=True,
            errors="replace",
        )
        result = judge(name, run.returncode, run.stdout, run.stderr)
    except subprocess.TimeoutExpired as error:
        told = (error.stdout or b"").decode(errors="replace")
        stages = re.findall(r"^stage (.*)$", told, re.MULTILINE)
        result = Visit(name, "timeout", {}, f"more than {seconds} s, in stage {stages[-1] if stages else 'start'}")
    result.seconds = time.monotonic() - start
    return result


def line_of(result):
    words = result.words
    told = [f"{word} {words[word]}" for word in ("sensors", "contacts", "touched", "diverged") if word in words]
    notes = [f"{word}: {words[word]}" for word in ("no_rays", "infant") if words.get(word, "ok") != "ok"]
    said = "; ".join([", ".join(told), result.message, *notes])
    return f"{result.outcome:8}{result.seconds:6.1f} s  {result.name}  {said}"


def problems(visits, expected):
    """One line for each thing that is not as it should be."""
    for result in visits:
        part = expected.get(result.name, ("", None))[1]
        if result.outcome in ("crash", "timeout", "wrong"):
            yield f"{result.outcome}: {result.name}: {result.message}"
        elif result.outcome == "refused" and part is None:
            yield f"refused: {result.name}: {result.message}"
        elif result.outcome == "refused" and part not in result.message:
            yield f"refused otherwise than expected: {result.name}: {result.message}"
        elif result.outcome == "ok" and part is not None:
            yield f"not refused any more: {result.name}"


def number(result, word):
    return int(result.words.get(word, 0))


def packages_table(visits, versions):
    rows = collections.defaultdict(list)
    for result in visits:
        rows[result.package].append(result)
    yield "| package | models | run | touched | diverged | refused | drawn by OSMesa | with an infant |"
    yield "|---|--:|--:|--:|--:|--:|--:|--:|"
    rows = sorted(rows.items())
    for package, results in [*rows, ("all", list(visits))]:
        good = [result for result in results if result.outcome == "ok"]
        cells = [
            f"`{package}` {versions.get(package, '')}".strip() if package != "all" else "all",
            len(results),
            len(good),
            sum(number(result, "touched") > 0 for result in good),
            sum(number(result, "diverged") > 0 for result in good),
            sum(result.outcome == "refused" for result in results),
            sum("no_rays" in result.words for result in good),
            sum(result.words.get("infant") == "ok" for result in good),
        ]
        yield "| " + " | ".join(map(str, cells)) + " |"


def grouped(pairs):
    """Rows "| text | count | examples |" of (text, name), the most frequent first."""
    groups = collections.defaultdict(list)
    for text, name in pairs:
        groups[text].append(name)
    for text, names in sorted(groups.items(), key=lambda group: (-len(group[1]), group[0])):
        yield f"| {text} | {len(names)} | `{names[0]}` |"


def shortened(message):
    """A message as code, without what differs from file to file, so that equal reasons are one row."""
    message = re.sub(r"^MIMO_E_\w+: |^Error: |Object name = .*", "", message)
    message = re.sub(r"(/[^/:]*)*/packages/\S*/", "", message)  # a path may have spaces
    message = re.sub(r"^\S+\.xml, line \d+: (\w*\s?Error: )?", "", message)
    text = message.strip()[:150].replace("|", "\\|").replace("'", '"')  # doxygen ends code at an apostrophe
    return f"`{text}`"


def tables(visits, expected, versions):
    yield from packages_table(visits, versions)
    refused = [(expected[v.name][0], v.name) for v in visits if v.outcome == "refused" and v.name in expected]
    yield from ["", "## Refused models", "", "| reason | models | for example |", "|---|--:|---|", *grouped(refused)]
    yield from ["", "| file | message |", "|---|---|"]
    yield from (f"| `{v.name}` | {shortened(v.message)} |" for v in visits if v.outcome == "refused")
    drawn = [(shortened(v.words["no_rays"]), v.name) for v in visits if v.outcome == "ok" and "no_rays" in v.words]
    if drawn:
        yield from ["", "## Models that rays do not draw", "", "| message | models | for example |", "|---|--:|---|"]
        yield from grouped(drawn)
    infants = [(shortened(v.words["infant"]), v.name) for v in visits if v.words.get("infant", "ok") != "ok"]
    if infants:
        yield from [
            "",
            "## Models that cannot have an infant",
            "",
            "| message | models | for example |",
            "|---|--:|---|",
        ]
        yield from grouped(infants)


def write_tables(path, text):
    """Replaces the text after the mark on the page."""
    mark = "<!-- What follows is written by ./dev zoo --write -->\n"
    before = path.read_text().split(mark)[0]
    path.write_text(before + mark + "\n" + text + "\n")


def read_versions(path):
    lines = [line.split("==") for line in path.read_text().splitlines() if "==" in line]
    return {name.replace("-", "_"): version for name, version in lines}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", type=Path, help="zoo_visit")
    parser.add_argument("packages", type=Path, help="folder of unpacked packages")
    parser.add_argument("--only", default="", metavar="REGEX", help="models whose name matches")
    parser.add_argument("--write", action="store_true", help="writes the tables of docs/zoo.md anew")
    parser.add_argument("--seconds", type=float, default=300, help="time that one model has")
    parser.add_argument("--steps", type=int, default=100, help="that one model makes; a few for a quick look at all")
    parser.add_argument("--gigabytes", type=int, default=8, help="memory that one model has")
    options = parser.parse_args()

    child = limits(options.program, options.gigabytes)
    expected = read_refused(HERE / "refused.txt")
    paths = {path.relative_to(options.packages).as_posix(): path for path in options.packages.rglob("*.xml")}
    names = sorted(name for name, path in paths.items() if re.search(options.only, name) and is_model(path))
    visits = []
    for name in names:
        visits.append(visit(options.program, paths[name], name, options.seconds, options.steps, child))
        print(line_of(visits[-1]), flush=True)

    wrong = list(problems(visits, expected))
    text = "\n".join(tables(visits, expected, read_versions(HERE / "packages.txt")))
    if options.write:
        write_tables(HERE.parents[1] / "docs/zoo.md", text)
    else:
        print(text)
    print(f"{len(visits)} models, {sum(v.outcome == 'ok' for v in visits)} ran, {len(wrong)} not as they should be")
    print("\n".join(wrong))
    return 1 if wrong or not visits else 0


if __name__ == "__main__":
    sys.exit(main())
