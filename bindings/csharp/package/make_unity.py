"""Makes a Unity package (a folder for the package manager, as a .tgz): the sources, and the library as plugins.

make_unity.py VERSION OUT.tgz RID=FOLDER...: RID is NuGet's name of a system, whose FOLDER has libraries/ and licences/.

Unity reads a file of a package only if it has a .meta file with a unique identity. The identity is made of the path, so
it is the same in all versions.
"""

import hashlib
import json
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT))
from tools.pack import below, write_tar  # noqa: E402

NAME = "org.libmimo.mimo"

# RID: the names of the player, the processor and the editor's system in Unity's plugin importer. Unity has no player
# for Linux on ARM.
PLATFORMS = {
    "linux-x64": ("Linux64", "x86_64", "Linux"),
    "win-x64": ("Win64", "x86_64", "Windows"),
    "osx-arm64": ("OSXUniversal", "ARM64", "OSX"),
    "osx-x64": ("OSXUniversal", "x86_64", "OSX"),
}

META = "fileFormatVersion: 2\nguid: {guid}\n"
FOLDER = "folderAsset: yes\nDefaultImporter:\n  externalObjects: {}\n"
PLUGIN = """PluginImporter:
  serializedVersion: 2
  isPreloaded: 0
  isOverridable: 0
  platformData:
  - first:
      Any:
    second:
      enabled: 0
      settings:
        Exclude Editor: 0
  - first:
      Editor: Editor
    second:
      enabled: 1
      settings:
        CPU: {cpu}
        OS: {os}
  - first:
      Standalone: {platform}
    second:
      enabled: 1
      settings:
        CPU: {cpu}
"""


def manifest(version):
    """The manifest for Unity's package manager."""
    return {
        "name": NAME,
        "version": version,
        "displayName": "MIMo, the multimodal infant model",
        "description": "A simulated infant with touch, vision, proprioception, balance and hearing.",
        "unity": "2021.3",
        "license": "MIT",
        "author": {"name": "libmimo contributors"},
        "keywords": ["infant", "simulation", "mujoco", "learning"],
    }


def put_libraries(folder, to):
    """Copies the libraries. Unity knows plugins by their ending, so MuJoCo's library gets a name without a version."""
    to.mkdir(parents=True)
    for file in sorted((folder / "libraries").iterdir()):
        numbered = file.suffix not in {".dll", ".dylib"}
        name = file.name.split(".so")[0] + ".so" if numbered else file.name
        shutil.copyfile(file, to / name)
        if numbered and name.startswith("libmujoco"):
            subprocess.run(["patchelf", "--set-soname", name, to / name], check=True)
            subprocess.run(["patchelf", "--replace-needed", file.name, name, to / "libmimo.so"], check=True)


def write_meta(path, root):
    """Writes the .meta file of a file or folder."""
    inside = path.relative_to(root)
    text = META.format(guid=hashlib.md5(f"{NAME}/{inside}".encode()).hexdigest())
    rid = inside.parts[2] if inside.parts[:2] == ("Runtime", "Plugins") and len(inside.parts) == 4 else None
    if path.is_dir():
        text += FOLDER
    elif rid:
        platform, cpu, system = PLATFORMS[rid]
        text += PLUGIN.format(cpu=cpu, os=system, platform=platform)
    path.with_name(path.name + ".meta").write_text(text)


def fill(root, version, systems):
    """Fills the folder of the package."""
    scripts = root / "Runtime/Scripts"
    shutil.copytree(ROOT / "bindings/csharp/src", scripts)
    assembly = {"name": "MimoSharp", "rootNamespace": "Mimo", "allowUnsafeCode": False, "autoReferenced": True}
    (scripts / "MimoSharp.asmdef").write_text(json.dumps(assembly, indent=2) + "\n")
    (root / "package.json").write_text(json.dumps(manifest(version), indent=2) + "\n")
    shutil.copyfile(ROOT / "bindings/csharp/package/README.md", root / "README.md")
    shutil.copyfile(ROOT / "CHANGELOG.md", root / "CHANGELOG.md")
    shutil.copyfile(ROOT / "LICENSE", root / "LICENSE.md")
    for rid, folder in systems.items():
        put_libraries(folder, root / "Runtime/Plugins" / rid)
        shutil.copytree(folder / "licences", root / "Licences~" / rid)  # Unity ignores folders that end with ~
    for path in sorted(root.rglob("*")):
        if "Licences~" not in path.parts:
            write_meta(path, root)


def main(version, out, *systems):
    """Writes the package."""
    named = dict(system.split("=", 1) for system in systems)
    named = {rid: Path(folder) for rid, folder in named.items() if rid in PLATFORMS}
    with tempfile.TemporaryDirectory() as work:
        root = Path(work) / "package"  # npm's name of the folder, which Unity's registries use, too
        root.mkdir()
        fill(root, version, named)
        write_tar(out, below(root, "package"))


if __name__ == "__main__":
    main(*sys.argv[1:])
