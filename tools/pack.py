"""Packs files so that the same files give the same bytes: with one time and no owner.

The time is that of SOURCE_DATE_EPOCH, as reproducible-builds.org defines it.
"""

import gzip
import io
import os
import tarfile
import time
import zipfile
from pathlib import Path

EARLIEST = 315532800  # 1980, before which a zip file knows no times


def moment():
    """The time of all files, in seconds since 1970."""
    return max(int(os.environ["SOURCE_DATE_EPOCH"]), EARLIEST)


def write_zip(out, files):
    """Writes names and bytes or paths, in their order; a path that can be run stays so."""
    date = time.gmtime(moment())[:6]
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as package:
        for name, content in files.items():
            runs = isinstance(content, Path) and os.access(content, os.X_OK)
            entry = zipfile.ZipInfo(name, date)
            entry.create_system = 3  # Unix, whose permissions these are
            entry.external_attr = (0o100755 if runs else 0o100644) << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            package.writestr(entry, content.read_bytes() if isinstance(content, Path) else content)


def without_origin(entry):
    """Reduces what a file in a tar archive says besides its name and content."""
    entry.uid = entry.gid = 0
    entry.uname = entry.gname = ""
    entry.mtime = moment()
    entry.mode = 0o755 if entry.mode & 0o100 else 0o644
    return entry


def write_tar(out, files):
    """Writes names and paths, in their order; links stay links."""
    archive = io.BytesIO()
    with tarfile.open(fileobj=archive, mode="w", format=tarfile.PAX_FORMAT) as package:
        for name, path in files.items():
            package.add(path, name, recursive=False, filter=without_origin)
    with open(out, "wb") as file, gzip.GzipFile("", "wb", fileobj=file, mtime=0) as packed:
        packed.write(archive.getvalue())


def below(folder, prefix):
    """Names and paths of the files below a folder."""
    paths = sorted(path for path in Path(folder).rglob("*") if path.is_symlink() or path.is_file())
    return {f"{prefix}/{path.relative_to(folder).as_posix()}": path for path in paths}
