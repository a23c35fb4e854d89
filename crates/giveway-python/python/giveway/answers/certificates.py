"""What ``export`` and ``verify`` give."""

from __future__ import annotations

import io
import zipfile
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar, Literal

from giveway._record import Record


@dataclass(frozen=True)
class Report(Record):
    """What came of checking a certificate."""

    document: ClassVar[bool] = True

    accepted: bool
    certified: Literal["proved", "proved-and-searched", "not-certified"]
    conclusion: str | None
    concluded: dict[str, Any] | None
    reason: str | None
    stopped: bool
    claims: tuple[dict[str, Any], ...]


@dataclass(frozen=True)
class Certificate(Record):
    """A certificate: the texts of its files by their names, and what came of checking them."""

    files: Mapping[str, str]
    report: Report


@dataclass(frozen=True)
class Certificates(Record):
    """What ``export`` gives: certificates by their names."""

    certificates: Mapping[str, Certificate]
    #: How many there was no time for.
    missing: int

    def to_zip(self) -> bytes:
        """One file with a folder for each, as ``giveway verify`` reads it; the same bytes each time."""
        packed = io.BytesIO()
        with zipfile.ZipFile(packed, "w") as archive:
            for name, certificate in sorted(self.certificates.items()):
                for file, text in sorted(certificate.files.items()):
                    entry = zipfile.ZipInfo(f"{name}/{file}")
                    entry.compress_type = zipfile.ZIP_DEFLATED
                    entry.external_attr = 0o644 << 16
                    archive.writestr(entry, text)
        return packed.getvalue()
