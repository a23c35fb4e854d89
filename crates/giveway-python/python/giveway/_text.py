"""Texts of files and of JSON: what is none is refused with its line and column."""

from __future__ import annotations

import json
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from giveway.errors import BadText


def of_file(path: str | PathLike[str], place: str = "") -> str:
    """The text of a file."""
    return decoded(Path(path).read_bytes(), place)


def decoded(text: str | bytes, place: str = "") -> str:
    """A text, also where it comes as the bytes of a file."""
    if isinstance(text, str):
        for at, sign in enumerate(() if text.isascii() else text):
            if "\ud800" <= sign <= "\udfff":
                raise _refusal(text[:at], repr(sign), "text that is Unicode", place)
        return text
    if not isinstance(text, (bytes, bytearray)):
        raise TypeError(f"expected a text or its bytes, found {type(text).__name__}")
    try:
        return text.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        good = text[:error.start].decode("utf-8", errors="replace")
        raise _refusal(good, f"the byte 0x{text[error.start]:02X}", "text in UTF-8", place) from None


def parsed(text: str) -> Any:
    """Plain data of JSON."""
    try:
        return json.loads(text)
    except json.JSONDecodeError as error:
        raise _refusal(text[:error.pos], f"no JSON ({error.msg})", "well-formed JSON", "") from None


def _refusal(before: str, found: str, expected: str, place: str) -> BadText:
    from giveway.errors import BadText, Fault  # faults are records themselves

    line, column = before.count("\n") + 1, len(before) - before.rfind("\n")
    return BadText((Fault(found, expected, place=place, line=line, column=column),))
