"""Texts in other formats."""

from __future__ import annotations

from dataclasses import dataclass

from giveway._record import Record


@dataclass(frozen=True)
class Converted(Record):
    """Texts by file names, and what the other format cannot say."""

    files: dict[str, str]
    notes: tuple[str, ...]
