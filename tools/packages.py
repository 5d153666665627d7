"""Packages: Debian's and the sources, and what users of all systems get. Made twice, they are the same files.

Each holds libmimo, its MuJoCo, and the licences of all that is inside.
"""

import email.utils
import hashlib
import json
import os
import re
import shutil
from pathlib import Path

from . import bill, pack, systems
from .build import PROGRAM, build
from .csharp import MADE, build_csharp, dotnet
from .javascript import pack_javascript
from .need import need
from .page import page_for_packages
from .pins import environment, tool
from .python import WHEELS, date_packages
from .rust import CRATES
from .shell import BUILD, PYTHON, ROOT, copy, fail, fresh, must, run, run_quietly, sources, version
from .wheels import RELEASE, wheel_for, wheel_for_mujoco4

PACKAGE = BUILD / "package"
# Debian wants an address, and there is none yet: .invalid is the domain that stands for that (RFC 6761).
CONTACT = "libmimo contributors <contributors@libmimo.invalid>"
CHANGELOG = """libmimo ({}-1) unstable; urgency=medium

  * Release {}; the changelog of libmimo says what is new.

 -- {}  {}
"""
DEPENDENCY = """
[target.'cfg({})'.dependencies]
{name} = {{ path = "../{name}", version = "={}", optional = true }}
"""


def package_sources():
    name = f"libmimo-{version()}"
    pack.write_tar(PACKAGE / f"{name}.tar.gz", {f"{name}/{file}": ROOT / file for file in sorted(sources())})


def put_page(folder, page):
    """Lets CMake install the page for recordings out of a build folder, or none."""
    shutil.rmtree(folder / "web", ignore_errors=True)
    if page:
        copy([page], folder / "web")


def package_debian(page):
    """Makes the packages of cmake/debian/control. They are compiled like the release build, so ccache has all."""
    build("debian", *PROGRAM)
    put_page(ROOT / "build-debian", page)
    folder = fresh(BUILD / "debian")
    tree, debian = folder / "tree", folder / "tree/debian"
    shutil.copytree(ROOT / "cmake/debian", debian)
    shutil.copy(ROOT / "CHANGELOG.md", tree)
    shutil.copy(ROOT / "LICENSE", debian / "copyright")
    if page:
        with (debian / "mimo.install").open("a") as installed:
            installed.write("usr/share/mimo/web\n")
    control, date = (
        debian / "control",
        email.utils.formatdate(int(os.environ["SOURCE_DATE_EPOCH"])).replace("-0000", "+0000"),
    )
    control.write_text(control.read_text().replace("@MIMO_CONTACT@", CONTACT))
    (debian / "changelog").write_text(CHANGELOG.format(version().replace("-", "~"), version(), CONTACT, date))
    options = {"MIMO_BUILD": ROOT / "build-debian", "DEB_BUILD_OPTIONS": "noautodbgsym"}
    command = ("dpkg-buildpackage", "--build=binary", "--no-sign", "--no-check-builddeps")
    must("the Debian packages could not be made", *command, cwd=tree, env=options)
    copy(folder.glob("*.deb"), PACKAGE)


def package_archive(system, page):
    """Packs what `cmake --install` installs, with MuJoCo and the licences beside it: unpacked anywhere it works."""
    name = f"libmimo-{version()}-{system.nuget}"
    root, mujoco = fresh(RELEASE / name), Path(system.libraries[1])
    put_page(system.folder, page)
    run_quietly("cmake", "--install", system.folder, "--prefix", root)
    shutil.copy(system.folder / mujoco, root / mujoco.parent, follow_symlinks=False)
    shutil.copytree(RELEASE / system.name / "licences", root / "licences")
    ending, write = ("zip", pack.write_zip) if system.name == "windows" else ("tar.gz", pack.write_tar)
    write(PACKAGE / f"{name}.{ending}", pack.below(root, name))
    shutil.rmtree(root)


def package_csharp():
    """Makes the packages for NuGet and Unity."""
    need("patchelf")
    build_csharp()
    folder, named = (
        ROOT / "bindings/csharp/package",
        [f"{system.nuget}={RELEASE / system.name}" for system in systems.ALL],
    )
    run(PYTHON, folder / "make_nuget.py", version(), MADE, PACKAGE / f"Mimo.{version()}.nupkg", *named)
    run(PYTHON, folder / "make_unity.py", version(), PACKAGE / f"org.libmimo.mimo-{version()}.tgz", *named)


def native_crate(system, crates):
    """Makes the crate of a system's library, on which mimo-sys depends for its target; returns its name."""
    name, template = f"mimo-native-{system.nuget}", CRATES / "native"
    crate = crates / name
    shutil.copytree(template, crate, ignore=shutil.ignore_patterns("*.in"))
    shutil.copy(ROOT / "LICENSE", crate)
    for folder in ("libraries", "licences"):
        shutil.copytree(RELEASE / system.name / folder, crate / folder)
    if system.name == "windows":
        copy([system.folder / "lib/libmimo.dll.a", system.folder / "lib/mimo.lib"], crate / "libraries")
    text = (template / "Cargo.toml.in").read_text().replace("SYSTEM", system.nuget).replace("VERSION", version())
    (crate / "Cargo.toml").write_text(text.replace("LINKS", system.nuget.replace("-", "_")))
    with (crates / "mimo-sys/Cargo.toml").open("a") as manifest:
        manifest.write(DEPENDENCY.format(system.rust, version(), name=name))
    return name


def package_rust():
    """Makes the crates as a registry gets them: the library comes along with `bundled`; the examples stay here."""
    need("rust")
    crates = fresh(RELEASE / "crates")
    for crate in ("mimo-sys", "mimo"):
        shutil.copytree(CRATES / crate, crates / crate)
    # A registry shows the page alone, so its relative links would lead nowhere.
    page, manifest, sys_manifest = (
        (CRATES / "README.md").read_text(),
        crates / "mimo/Cargo.toml",
        crates / "mimo-sys/Cargo.toml",
    )
    (crates / "mimo/README.md").write_text(re.sub(r"\[([^\]]*)\]\(\.\./[^)]*\)", r"\1", page))
    text = re.sub(r"^\[\[example.*", "", manifest.read_text(), flags=re.MULTILINE | re.DOTALL)
    manifest.write_text(re.sub(r"^readme = .*", 'readme = "README.md"', text, flags=re.MULTILINE))
    names = [native_crate(system, crates) for system in systems.ALL]
    sys_manifest.write_text(sys_manifest.read_text().replace("bundled = []", f"bundled = {json.dumps(names)}"))
    (crates / "Cargo.toml").write_text('[workspace]\nmembers = ["mimo*"]\nresolver = "2"\n')
    names.append("mimo-sys")
    patches = [word for name in names for word in ("--config", f"patch.crates-io.{name}.path='{name}'")]
    for name in [*names, "mimo"]:
        options = ("-q", "--offline", "--no-verify", "--allow-dirty", "-p", name, *patches)
        must(f"the crate {name} cannot be packaged", "cargo", "package", *options, cwd=crates)
    copy(crates.glob("target/package/*.crate"), PACKAGE)


def make_packages(for_all=False, with_page=False):
    """Makes Debian's packages and the sources; for_all: and what users of all systems get.

    Whether they hold the page of `mimo export --html` does not depend on what was made before.
    """
    need("package")
    date_packages()
    page = page_for_packages() if for_all or with_page else None
    fresh(PACKAGE)
    package_debian(page)
    package_sources()
    if for_all:
        fresh(WHEELS)  # may have a wheel for this system alone
        for system in systems.ALL:
            wheel_for(system, page)
        wheel_for_mujoco4()
        for system in systems.ALL:
            package_archive(system, page)
        copy(WHEELS.glob("mimo*.whl"), PACKAGE)
        package_csharp()
        package_rust()
        copy([pack_javascript()], PACKAGE)
    if not page:
        print("These packages are without the page of mimo export --html; ./dev package --page puts it into them")
    listed = PACKAGE / f"libmimo-{version()}.spdx.json"
    bill.write(version(), PACKAGE, BUILD / "cross/sources.txt", listed, with_page=bool(page))
    write_notes()
    sums = [f"{hashlib.sha256(file.read_bytes()).hexdigest()}  {file.name}\n" for file in sorted(PACKAGE.iterdir())]
    (PACKAGE / "SHA256SUMS").write_text("".join(sums))


def write_notes():
    """Writes what users of this release read first, the summary of the changelog."""
    text = (ROOT / "CHANGELOG.md").read_text()
    short = text[text.index("### What is new for you") : text.index("\n## [")]
    notes = re.sub(r"\[([^\]]*)\]\((?!https?:)[^)]*\)", r"\1", short).strip()  # the links lead into the sources
    notes = f"# libmimo {version()}\n\n{notes}\n\nCHANGELOG.md in the sources has every change.\n"
    (PACKAGE / "RELEASE-NOTES.md").write_text(notes)


def check_made_twice(for_all=False):
    first = (PACKAGE / "SHA256SUMS").read_text().splitlines()
    make_packages(for_all)
    differ = {*first} ^ {*(PACKAGE / "SHA256SUMS").read_text().splitlines()}
    if differ:
        fail(f"made twice, packages differ: {' '.join(sorted({line.split()[1] for line in differ}))}")
    print("Made twice, the packages are the same")


def test_package():
    make_packages()
    print("Tests of the packages")
    run("tests/package/check_deb", *sorted(PACKAGE.glob("*.deb")))
    run("tests/package/check_source", *PACKAGE.glob("*.tar.gz"), tool("pip"))
    check_made_twice()


def test_release():
    """Tries the packages for all systems, each in an empty place."""
    need("release")
    make_packages(for_all=True)
    print("Tests of the packages for all systems")
    checks = [
        ("check_archive", f"libmimo-{version()}-linux-x64.tar.gz"),
        ("check_page", f"libmimo-{version()}-linux-x64.tar.gz"),
        ("check_msvc", f"libmimo-{version()}-win-x64.zip"),
        ("check_macos", f"libmimo-{version()}-osx-arm64.tar.gz", "arm64"),
        ("check_macos", f"libmimo-{version()}-osx-x64.tar.gz", "x86_64"),
        ("check_nuget", f"Mimo.{version()}.nupkg", dotnet("linux")[0]),
        ("check_unity", f"org.libmimo.mimo-{version()}.tgz"),
        ("check_crates", f"mimo-{version()}.crate", PACKAGE),
        ("check_conan", f"libmimo-{version()}.tar.gz", environment("conan", "conan") / "conan"),
    ]
    debs = sorted(PACKAGE.glob("*.deb"))
    for check in ("check_deb", "check_page"):
        run(f"tests/package/{check}", *debs)
    for check, package, *further in checks:
        run(f"tests/package/{check}", PACKAGE / package, *further)
    check_made_twice(for_all=True)
