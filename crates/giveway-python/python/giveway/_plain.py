"""What people hand over as JSON can hold it."""

from __future__ import annotations

import math
from collections.abc import KeysView, Mapping, Sequence, ValuesView
from typing import Any

from giveway._misfit import Misfit, described


def plain(value: Any) -> Any:
    """A value as JSON can hold it; where it cannot, ``Misfit`` is raised."""
    if value is None or isinstance(value, str):
        return value if value is None else _text(value)
    if isinstance(value, (int, float)):
        return _number(value)
    if hasattr(type(value), "_plain"):
        return value._plain()
    if isinstance(value, Mapping):
        return {_key(name): _within(name, item) for name, item in value.items()}
    if isinstance(value, (Sequence, KeysView, ValuesView)) and not isinstance(value, (bytes, bytearray, memoryview)):
        items: list[Any] = []
        try:
            items.extend(map(plain, value))  # where it fails it has come to the index
        except Misfit as misfit:
            raise misfit.within(len(items)) from None
        return items
    if hasattr(value, "tolist"):  # numbers and arrays of NumPy, which need not be there
        return plain(value.tolist())
    raise Misfit(described(value), "data that JSON can hold")


def _number(value: float) -> float:
    # JSON has no others; a larger whole number is no number of anything here.
    if isinstance(value, float) and not math.isfinite(value):
        raise Misfit(f"the number {value}", "a finite number")
    if isinstance(value, int) and value.bit_length() > 1024:
        raise Misfit(f"a number of {value.bit_length()} bits", "a smaller one")
    return value


def _text(value: str) -> str:
    if not value.isascii() and any("\ud800" <= sign <= "\udfff" for sign in value):
        raise Misfit(f"the text {value!r}", "one that is Unicode")
    return value


def _key(name: Any) -> str:
    if not isinstance(name, str):
        raise Misfit(f"the key {name!r}", "a text as key")
    return _text(name)


def _within(name: str, item: Any) -> Any:
    try:
        return plain(item)
    except Misfit as misfit:
        raise misfit.within(name) from None
