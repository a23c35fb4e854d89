"""The files of certificates: from a folder, or from one zip archive."""

from __future__ import annotations

import io
import zipfile
from collections.abc import Mapping
from os import PathLike
from pathlib import Path

from giveway.errors import BadText, Fault, GivewayError, refusal

#: The most bytes that the files of an archive have unpacked: what is exported is far smaller.
MOST = 512 << 20

Files = dict[str, str]


def of_folder(path: str | PathLike[str]) -> Files:
    """The texts of a folder. What is no regular file counts as an empty one, and is refused
    by its fingerprint."""
    folder = Path(path)
    if folder.is_file():
        raise refusal("certificate", f"the file {folder.name}", "a folder; an archive is for verify_archive")
    return {
        entry.name: entry.read_bytes().decode("utf-8", errors="replace")
        if entry.is_file() and not entry.is_symlink() else ""
        for entry in sorted(folder.iterdir())
    }


def of_archive(archive: str | PathLike[str] | bytes) -> Mapping[str, Files]:
    """The texts of an archive by the folders that they are in."""
    content = archive if isinstance(archive, bytes) else Path(archive).read_bytes()
    certificates: dict[str, Files] = {}
    try:
        with zipfile.ZipFile(io.BytesIO(content)) as files:
            entries = [entry for entry in files.infolist() if not entry.is_dir()]
            if sum(entry.file_size for entry in entries) > MOST:
                raise _no_archive(f"more than {MOST >> 20} MB of files")
            for entry in entries:
                folder, _, name = entry.filename.rpartition("/")
                texts = certificates.setdefault(folder, {})
                if name in texts:
                    raise _no_archive(f"two files {entry.filename}")
                texts[name] = files.read(entry).decode("utf-8", errors="replace")
    except GivewayError:
        raise
    except Exception as error:  # of what is damaged: zipfile lets through what its decompressors raise
        raise _no_archive(f"what cannot be unpacked ({error})") from error
    if not certificates:
        raise _no_archive("an archive without files")
    return certificates


def _no_archive(found: str) -> BadText:
    return BadText((Fault(found, "a zip archive of certificates", place="archive"),))
