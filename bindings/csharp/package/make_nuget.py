"""Makes a NuGet package: the classes, and the library for each system below runtimes/, where .NET searches for it.

make_nuget.py VERSION CLASSES OUT.nupkg RID=FOLDER...: CLASSES has MimoSharp.dll and MimoSharp.xml; RID is NuGet's
name of a system, whose FOLDER has libraries/ and licences/.
"""

import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT))
from tools.pack import write_zip  # noqa: E402

ASKED_FOR = {"libmimo.so.1": "libmimo.so"}  # by DllImport("mimo")

NUSPEC = """<?xml version="1.0" encoding="utf-8"?>
<package xmlns="http://schemas.microsoft.com/packaging/2013/05/nuspec.xsd">
  <metadata>
    <id>Mimo</id>
    <version>{version}</version>
    <authors>libmimo contributors</authors>
    <description>MIMo, the multimodal infant model: a simulated infant with touch, vision, proprioception, balance and
hearing. The package contains the native library.</description>
    <license type="file">LICENSE</license>
    <readme>README.md</readme>
    <tags>infant simulation robotics mujoco reinforcement-learning</tags>
    <dependencies>
      <group targetFramework=".NETStandard2.0" />
    </dependencies>
  </metadata>
</package>
"""

# The parts that make a zip file an Open Packaging archive, which NuGet's tools expect.
TYPES = """<?xml version="1.0" encoding="utf-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
{types}
</Types>
"""
RELATIONS = """<?xml version="1.0" encoding="utf-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
  <Relationship Type="http://schemas.microsoft.com/packaging/2010/07/manifest" Target="/Mimo.nuspec" Id="R1" />
</Relationships>
"""


def content_types(names):
    """One entry per file ending, and one per file without an ending."""
    kinds = {"rels": "application/vnd.openxmlformats-package.relationships+xml"}
    rows = {}
    for name in names:
        ending = Path(name).suffix[1:]
        kind = kinds.get(ending, "application/octet")
        attribute = f'Default Extension="{ending}"' if ending else f'Override PartName="/{name}"'
        rows[attribute] = f'  <{attribute} ContentType="{kind}" />'
    return TYPES.format(types="\n".join(rows.values()))


def files(version, classes, systems):
    """The contents of the package: name and bytes of each file."""
    found = {
        "Mimo.nuspec": NUSPEC.format(version=version).encode(),
        "_rels/.rels": RELATIONS.encode(),
        "LICENSE": (ROOT / "LICENSE").read_bytes(),
        "README.md": (ROOT / "bindings/csharp/package/README.md").read_bytes(),
    }
    for name in ("MimoSharp.dll", "MimoSharp.xml"):
        found[f"lib/netstandard2.0/{name}"] = (classes / name).read_bytes()
    for rid, folder in systems.items():
        for file in sorted((folder / "libraries").iterdir()):
            found[f"runtimes/{rid}/native/{ASKED_FOR.get(file.name, file.name)}"] = file.read_bytes()
        for file in sorted((folder / "licences").rglob("*")):
            if file.is_file():
                found[f"licences/{rid}/{file.relative_to(folder / 'licences')}"] = file.read_bytes()
    return found


def main(version, classes, out, *systems):
    """Writes the package."""
    named = dict(system.split("=", 1) for system in systems)
    found = files(version, Path(classes), {rid: Path(folder) for rid, folder in named.items()})
    write_zip(out, {"[Content_Types].xml": content_types(found).encode(), **found})


if __name__ == "__main__":
    main(*sys.argv[1:])
