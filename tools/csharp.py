"""Building and testing the C# classes, on Mono and on .NET."""

import os
import platform
import re
import shutil
import sys

from .build import build_program
from .need import need
from .pins import fetch_package
from .rust import follow
from .shell import BUILD, ROOT, fail, must, run, try_run, version

MADE = BUILD / "csharp"
MCS = ("mcs", "-nologo", "-langversion:7", "-warnaserror")
CLASSES = sorted(ROOT.glob("bindings/csharp/src/*.cs"))
LIBRARY = {"LD_LIBRARY_PATH": BUILD / "lib"}
ATTRIBUTE = '[assembly: System.Reflection.Assembly{}("{}")]\n'
OTHER = 'unsigned mimo_abi_version(void) {{ return {}; }}\nconst char *mimo_version(void) {{ return "{}"; }}\n'


def build_tests(program, *options):
    need("csharp")
    MADE.mkdir(parents=True, exist_ok=True)
    tests = sorted(ROOT.glob("bindings/csharp/tests/*.cs"))
    run(*MCS, "-nowarn:1591", *options, f"-out:{MADE / program}", *CLASSES, *tests)


def build_csharp():
    """Builds tests, library and examples. A public member without documentation is an error of the library."""
    build_tests("Tests.exe")
    file, library, text = MADE / "Version.cs", MADE / "MimoSharp.dll", version()
    file.write_text(
        ATTRIBUTE.format("Version", text.split("-")[0] + ".0") + ATTRIBUTE.format("InformationalVersion", text)
    )
    run(*MCS, "-target:library", f"-doc:{MADE}/MimoSharp.xml", f"-out:{library}", file, *CLASSES)
    for example in [*ROOT.glob("examples/csharp/*.cs"), *ROOT.glob("tests/same/*.cs")]:
        run(*MCS, f"-r:{library}", f"-out:{MADE / example.stem}.exe", example)


def dotnet(system):
    """The command of Microsoft's .NET for linux or windows."""
    folder, unpacked = BUILD / "dotnet" / system, BUILD / "dotnet/unpacked"
    program = folder / ("dotnet.exe" if system == "windows" else "dotnet")
    if not program.is_file():
        fetch_package("dotnet", system, unpacked)
        shutil.rmtree(folder, ignore_errors=True)
        (unpacked / "dotnetcore2/bin").rename(folder)
        program.chmod(0o755)
    return (program, "exec", "--runtimeconfig", "tests/package/dotnet.json")


def check_runner(*runner):
    """Runs the tests by Mono or .NET, and programs that end while everything is alive."""
    tests, file = (*runner, MADE / "Tests.exe"), MADE / "recorded.h5"
    run(*tests, "--all", env=LIBRARY)
    must(f"C# does not end ({runner[0]})", "timeout", "60", *tests, "--end", file, env=LIBRARY)
    must(f"C# leaves half a recording ({runner[0]})", *tests, "--ended", file, env=LIBRARY)


def check_refusal(message, source=""):
    """Checks what each way into a library says that is missing, or is another one, made of a C source."""
    folder = MADE / "future"
    if source:
        folder.mkdir(parents=True, exist_ok=True)
        compiler = os.environ.get("CC", "cc")
        must(
            "no library for C#", compiler, "-shared", "-fPIC", "-x", "c", "-", "-o", folder / "libmimo.so", give=source
        )
    status, said = try_run("mono", MADE / "Tests.exe", env={"LD_LIBRARY_PATH": folder if source else ""})
    if status != 0 or len(re.findall(message, said)) != 3:
        fail(f"C# that has to say '{message}' says: {said}")


def test_csharp():
    build_program()
    build_csharp()
    print("Tests of the C# classes")
    check_runner("mono")
    if (sys.platform, platform.machine()) == ("linux", "x86_64"):
        check_runner(*dotnet("linux"))
    check_refusal("libmimo was not found")
    check_refusal("libmimo 9.8.7 has ABI version 99, expected 1", OTHER.format(99, "9.8.7"))
    check_refusal("libmimo 1.0.0 has no mimo_[a-z_]*, which", OTHER.format(1, "1.0.0"))
    check_refusal("has no mimo_abi_version", "int other;\n")
    run("mono", MADE / "Game.exe", "1", env=LIBRARY)
    run("mono", MADE / "OwnGoal.exe", env=LIBRARY)
    follow("csharp")
