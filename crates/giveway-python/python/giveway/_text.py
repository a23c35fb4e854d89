"""Texts of files and of JSON: what is none is refused with its line and column."""

from __future__ import annotations

import json
import warnings
from dataclasses import replace
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
    if b"\0" not in text:
        try:
            return text.decode("utf-8-sig")
        except UnicodeDecodeError:
            pass  # another encoding, or no text
    return _of_bytes(bytes(text), place)


def _of_bytes(raw: bytes, place: str) -> str:
    """Bytes that are not UTF-8, by the decoder that all parts of Giveway share."""
    from giveway._door import call  # the door needs texts itself
    from giveway.errors import BadText

    try:
        read = call("decode", {"bytes": raw.decode("latin-1"), "file": place or "the file"})
    except BadText as error:
        raise BadText(tuple(replace(fault, place=place) for fault in error.faults)) from None
    if read["note"]:
        warnings.warn(read["note"], stacklevel=3)
    return str(read["text"])


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
