"""What packages hold of other projects, as an SPDX 2.3 document. bill.py prints the licence of what holds all."""

import datetime
import hashlib
import json
import os
import subprocess

OURS = "MIT"

# Name, licence, where the version is found: a Debian package, or the name of sources.
COMPILED = [
    ("Eigen", "MPL-2.0", "libeigen3-dev"),
    ("fmt", "MIT", "libfmt-dev"),
    ("Highway", "Apache-2.0", "highway"),
    ("JSON for Modern C++", "MIT", "nlohmann-json3-dev"),
    ("pugixml", "MIT", "pugixml"),
    ("zlib", "Zlib", "zlib"),
]
IN_PROGRAM = [
    ("CLI11", "BSD-3-Clause", "libcli11-dev"),
    ("FMI headers", "BSD-2-Clause", "3.0.2"),  # src/fmi/standard
    ("libpng", "libpng-2.0", "libpng1.6"),
]
MUJOCO = ("MuJoCo", "Apache-2.0", "2.2.2")
IN_MUJOCO = [
    ("LodePNG", "Zlib", ""),
    ("Qhull", "Qhull", ""),
    ("libccd", "BSD-3-Clause", ""),
    ("TinyXML-2", "Zlib", ""),
]
# In the page of mimo export --html, which has a MuJoCo and the library besides.
IN_PAGE = [
    ("HDF5", "BSD-3-Clause", ""),
    ("musl", "MIT", ""),
    ("three.js", "MIT", ""),
    ("tinyobjloader", "MIT", ""),
]
RUNTIMES = [
    ("LLVM libc++", "Apache-2.0 WITH LLVM-exception", ""),
    ("GCC runtime library", "GPL-3.0-or-later WITH GCC-exception-3.1", ""),  # Windows' files only
]
EVERYTHING = [*COMPILED, *IN_PROGRAM, MUJOCO, *IN_MUJOCO, *IN_PAGE, *RUNTIMES]


def licence(components):
    """The licence of something that holds these and ours."""
    return " AND ".join([OURS, *sorted({one for _, one, _ in components if one != OURS})])


def inside(name, with_page):
    """What a package of that file name holds of others; with_page: those with the program hold the page, too."""
    of_page = [MUJOCO, *IN_MUJOCO, *IN_PAGE, RUNTIMES[0]] if with_page else []
    if name.startswith("mimo_") and name.endswith(".deb"):
        return [*COMPILED, *IN_PROGRAM, *of_page]
    if name.endswith(".deb"):
        return COMPILED if name.startswith("libmimo1_") else []
    if name.startswith("mimo_mujoco4-"):
        return [*COMPILED, RUNTIMES[0]]
    systems = ("-x64", "-arm64", ".whl", ".nupkg", ".tgz")
    if not any(system in name for system in systems):
        return []  # sources
    windows = [RUNTIMES[1]] if "win" in name else RUNTIMES if name.endswith((".nupkg", ".tgz")) else [RUNTIMES[0]]
    program = [] if name.endswith((".nupkg", ".tgz", ".crate")) else [*IN_PROGRAM, *of_page]
    return list(dict.fromkeys([*COMPILED, *program, MUJOCO, *IN_MUJOCO, *windows]))


def version_of(place, sources):
    """A component's version; NOASSERTION where MuJoCo or a compiler brought it along."""
    for folder in sources:
        if folder.rsplit("-", 1)[0] in (place, place.rstrip("0123456789.")):
            return folder.rsplit("-", 1)[1]
    if place[:1].isdigit():
        return place
    asked = subprocess.run(["dpkg-query", "-W", "-f", "${Version}", place], capture_output=True, text=True)
    return asked.stdout if place and asked.returncode == 0 and asked.stdout else "NOASSERTION"


def identifier(text):
    """The document's name of something."""
    return "SPDXRef-" + "".join(c if c.isalnum() or c in ".-" else "-" for c in text)


def entry(name, version, one, **further):
    """A package of the document."""
    return {
        "SPDXID": identifier(name),
        "name": name,
        "versionInfo": version,
        "downloadLocation": "NOASSERTION",
        "filesAnalyzed": False,
        "licenseConcluded": one,
        "licenseDeclared": one,
        "copyrightText": "NOASSERTION",
        **further,
    }


def document(version, folder, sources, with_page):
    """The whole document."""
    date = datetime.datetime.fromtimestamp(int(os.environ["SOURCE_DATE_EPOCH"]), datetime.timezone.utc)
    packages = [entry(name, version_of(place, sources), one) for name, one, place in EVERYTHING]
    relations = []
    for path in sorted(folder.iterdir()):
        if path.suffix == ".json" or path.name == "SHA256SUMS":
            continue
        held = inside(path.name, with_page)
        content = hashlib.sha256(path.read_bytes()).hexdigest()
        checksum = [{"algorithm": "SHA256", "checksumValue": content}]
        packages.append(entry(path.name, version, licence(held), packageFileName=path.name, checksums=checksum))
        relations.append(("SPDXRef-DOCUMENT", "DESCRIBES", identifier(path.name)))
        relations += [(identifier(path.name), "CONTAINS", identifier(name)) for name, _, _ in held]
    names = ("spdxElementId", "relationshipType", "relatedSpdxElement")
    return {
        "spdxVersion": "SPDX-2.3",
        "dataLicense": "CC0-1.0",
        "SPDXID": "SPDXRef-DOCUMENT",
        "name": f"libmimo-{version}",
        "documentNamespace": f"urn:libmimo:{version}",
        "creationInfo": {
            "created": date.strftime("%Y-%m-%dT%H:%M:%SZ"),
            "creators": ["Organization: libmimo contributors"],
        },
        "packages": packages,
        "relationships": [dict(zip(names, relation)) for relation in relations],
    }


def write(version, folder, sources, out, with_page):
    """Writes the document for the packages in a folder, with or without the page of mimo export --html.

    SOURCES lists the sources that were compiled, a folder's name each (pugixml-1.13); headers have the versions of the
    installed Debian packages.
    """
    listed = sources.read_text().split() if sources.is_file() else []
    out.write_text(json.dumps(document(version, folder, listed, with_page), indent=1) + "\n")


if __name__ == "__main__":
    print(licence([one for one in EVERYTHING if one != RUNTIMES[1]]))
