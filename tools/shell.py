"""Running programs, and saying what went wrong."""

import os
import re
import shlex
import shutil
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
BUILD = ROOT / "build"
CORES = os.cpu_count() or 1
PYTHON = sys.executable  # ./dev prefers Debian's own, which Debian's packages for Python belong to


class Failure(Exception):
    """Ends a command of ./dev; the message says why."""


def fail(message):
    raise Failure(message)


def say_and_do(*steps):
    """Does steps one after another: what each does, how long that usually takes, and the function."""
    for number, (what, usually, do) in enumerate(steps, 1):
        print(f"==== {number} of {len(steps)}: {what} (usually {usually})")
        begun = time.monotonic()
        do()
        print(f"==== {number} of {len(steps)} done in {time.monotonic() - begun:.0f} s")


def start(command, env=None, cwd=ROOT, **options):
    """Runs a program to its end; env: further environment variables."""
    words = [str(word) for word in command]
    env = {**os.environ, **{name: str(value) for name, value in (env or {}).items()}}
    try:
        return subprocess.run(words, env=env, cwd=cwd, text=True, **options)
    except FileNotFoundError:
        fail(f"there is no program {words[0]}")


def run(*command, cwd=ROOT, env=None, stdout=None):
    """Runs a program that has to succeed; returns what it prints where stdout is subprocess.PIPE."""
    done = start(command, env, cwd, stdout=stdout)
    if done.returncode != 0:
        text = shlex.join(str(word) for word in command)
        fail(f"this failed ({done.returncode}): {text if len(text) < 400 else text[:400] + ' ...'}")
    return (done.stdout or "").rstrip("\n")


def run_quietly(*command, **options):
    run(*command, stdout=subprocess.DEVNULL, **options)


def output(*command, **options):
    return run(*command, stdout=subprocess.PIPE, **options)


def try_run(*command, cwd=ROOT, env=None, give=""):
    """Runs a program that may fail; returns its exit status, and all it printed."""
    done = start(command, env, cwd, input=give, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    return done.returncode, done.stdout.rstrip("\n")


def must(complaint, *command, **options):
    """Runs a program whose output matters only if it fails."""
    status, said = try_run(*command, **options)
    if status != 0:
        fail(f"{complaint} ({status}): {said}")


def fresh(folder):
    """An empty folder in the place of whatever was there."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    return folder


def copy(files, folder):
    """Copies files, and what links point to, into a folder, which is made."""
    folder.mkdir(parents=True, exist_ok=True)
    for file in files:
        shutil.copy(file, folder)


def only(folder, pattern):
    """The one file of that pattern in a folder."""
    found = sorted(folder.glob(pattern))
    if len(found) != 1:
        fail(f"expected one {pattern} in {folder}, found {len(found)}")
    return found[0]


def sources(*patterns):
    """Files that git tracks or would track."""
    files = output("git", "ls-files", "--cached", "--others", "--exclude-standard", *patterns).splitlines()
    return [file for file in files if (ROOT / file).is_file()]


def changed_sources(*patterns):
    """Files that differ from the last commit."""
    changed = output("git", "diff", "--name-only", "--diff-filter=d", "HEAD", "--", *patterns)
    return sorted(
        changed.splitlines() + output("git", "ls-files", "--others", "--exclude-standard", *patterns).splitlines()
    )


def version(which="VERSION"):
    """The library's version, as 1.0.0-rc1, or that of the API, as 1.0: include/mimo/status.h alone has them."""
    text = (ROOT / "include/mimo/status.h").read_text()
    numbers = dict(re.findall(rf'^#define MIMO_{which}_([A-Z]+) +"?([^" \n]*)', text, re.MULTILINE))
    parts = [numbers[part] for part in ("MAJOR", "MINOR", "PATCH") if part in numbers]
    return ".".join(parts) + numbers.get("LABEL", "")
