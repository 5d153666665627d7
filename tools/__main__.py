"""The commands of ./dev."""

import argparse
import signal
import sys

from . import build, cross, lint, packages, page, pins, python, site, web, wheels
from . import tests as parts
from .interface import freeze, interface
from .shell import Failure, fail
from .systems import SYSTEMS, chosen

EPILOG = (
    "./dev COMMAND --help says more. As root on Debian 12, a command installs what it needs; otherwise it names it."
)
TESTS = "Parts are run after each other, whatever fails. Without a part: {}. The others take long or need more."


def build_command(options):
    if options.web:
        web.build_web()
    elif options.system:
        cross.build_for(SYSTEMS[options.system], *build.PROGRAM)
    elif options.mujoco:
        build.build_mujoco4()
    else:
        build.build_program()
        build.use_mujoco(options.avx)


def wheel_command(options):
    if options.page and not options.platform:
        fail("--page goes with --platform; a wheel for this system has the page that ./dev web has made")
    if options.platform:
        inside = page.page_for_packages() if options.page else None
        for system in chosen(options.platform):
            wheels.wheel_for(system, inside)
    elif options.mujoco:
        wheels.wheel_for_mujoco4()
    else:
        python.wheel()
    show(python.WHEELS)


def package_command(options):
    packages.make_packages(options.all, options.page)
    show(packages.PACKAGE)


def show(folder):
    print("\n".join(sorted(file.name for file in folder.iterdir())))


class Commands:
    def __init__(self):
        self.parser = argparse.ArgumentParser("./dev", epilog=EPILOG, allow_abbrev=False)
        self.commands = self.parser.add_subparsers(dest="command", metavar="COMMAND", title="commands", required=True)

    def add(self, name, do, about, more="", arguments_of=""):
        """Adds a command. One with arguments of something else hands on the others, as options.rest."""
        text = f"{about}. {more}" + (f" Other arguments are those of {arguments_of}." if arguments_of else "")
        command = self.commands.add_parser(name, help=about, description=text, allow_abbrev=False)
        command.set_defaults(do=do, hands_on=bool(arguments_of))
        return command


def add_builds(commands):
    command = commands.add("build", build_command, "build/lib/libmimo.so and build/bin/mimo")
    which = command.add_mutually_exclusive_group()
    which.add_argument("--avx", action="store_true", help="with the faster build of the same MuJoCo beside the library")
    which.add_argument("--mujoco", choices=["4"], help="on MuJoCo 4, not 2.2.2, until something is built there again")
    which.add_argument("--web", action="store_true", help="WebAssembly: build-web/lib/mimo.wasm, docs/web.md")
    for name in SYSTEMS:
        text = f"for another system, in build-{name}: docs/platforms.md"
        which.add_argument(f"--{name}", dest="system", action="store_const", const=name, help=text)
    about = "ten seconds of an infant's random movements; pictures of it go to demo/"
    commands.add("demo", lambda o: build.demo(o.rest), about, arguments_of="mimo run")
    commands.add("bench", lambda o: build.bench(o.rest), "how fast it runs here", arguments_of="mimo-bench")
    more = "--write keeps today's, after a change that was meant."
    commands.add(
        "ratios", lambda o: build.ratios(o.rest), "is it as fast as it was, in ratios", more, "tests/bench/ratios.py"
    )
    about = "learns to reach for 20000 steps; results go to runs/"
    commands.add("train", lambda o: python.train(o.rest), about, arguments_of="examples/python/train.py")


def add_checks(commands):
    more = TESTS.format(" ".join(f"--{name}" for name in parts.USUAL))
    command = commands.add("test", lambda o: parts.run_tests(o.parts), "all tests, or parts of them", more)
    for name, (_, about) in parts.PARTS.items():
        command.add_argument(f"--{name}", dest="parts", action="append_const", const=name, help=about)
    about, more = "visits hundreds of models of other people's packages", "It takes an hour."
    command = commands.add("zoo", lambda o: build.zoo(o.asan, o.rest), about, more, "tests/zoo/zoo.py")
    command.add_argument("--asan", action="store_true", help="with sanitizers")
    about = "format, clang-tidy, documentation and its links, Python"
    command = commands.add("lint", lambda o: lint.lint(o.quick, o.changed), about)
    command.add_argument("--quick", action="store_true", help="without clang-tidy")
    command.add_argument("--changed", action="store_true", help="only sources that differ from HEAD")
    commands.add("format", lambda _: lint.format_sources(), "rewrites all sources in the common format")


def add_products(commands):
    about = "renews what is made of the public headers: interface/interface.json, parts of library, bindings and pages"
    commands.add("interface", lambda o: interface(*o.rest), about, arguments_of="interface/generate.py")
    command = commands.add("package", package_command, "build/package: Debian packages, and the sources as a tarball")
    text = "and what users of all systems get: tarballs, wheels, a NuGet and a Unity package, crates"
    command.add_argument("--all", action="store_true", help=text)
    with_page = "with the page of mimo export --html, which first takes ten minutes of a processor"
    command.add_argument("--page", action="store_true", help=f"{with_page}; --all has it always")
    command = commands.add("wheel", wheel_command, "build/wheel/mimo-*.whl, the Python package")
    which = command.add_mutually_exclusive_group()
    which.add_argument("--platform", metavar="SYSTEM", help=f"for another system: {', '.join(SYSTEMS)}, or all of them")
    which.add_argument("--mujoco", choices=["4"], help="the library for programs that use the Python package mujoco")
    command.add_argument("--page", action="store_true", help=f"{with_page}; only with --platform")
    commands.add("docs", lambda _: site.docs(), "the documentation as a site, build/docs/html/README.html")
    commands.add("web", lambda _: page.web(), "the page with the infant, build/web, for any server of files")
    about = "takes the newest versions of the Python packages that ./dev installs into tools/pins, with their hashes"
    command = commands.add("pins", lambda o: pins.renew(o.keep), about)
    command.add_argument("--keep", action="store_true", help="only adds packages that are missing")
    about = "keeps the interface as it is now as that of its version: interface/frozen, tests/abi, tests/states"
    commands.add("freeze", lambda _: freeze(), about)
    commands.add("clean", lambda _: build.clean(), "removes everything that was built")
    commands.add("help", lambda _: commands.parser.print_help(), "shows this")


def main():
    sys.stdout.reconfigure(line_buffering=True)  # in order with what programs print
    commands = Commands()
    for add in (add_builds, add_checks, add_products):
        add(commands)
    options, rest = commands.parser.parse_known_args(sys.argv[1:] or ["help"])
    if rest and not options.hands_on:
        commands.parser.error(f"{options.command} does not take {' '.join(repr(word) for word in rest)}")
    options.rest = rest
    try:
        options.do(options)
    except Failure as failure:
        print(f"dev: {failure}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        return 128 + signal.SIGINT
    return 0


sys.exit(main())
