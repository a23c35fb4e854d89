"""What makes the fields of records out of plain data, by their types."""

from __future__ import annotations

import types
import typing
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from giveway._misfit import Misfit, described

Reader = Callable[[Any], Any]


def reader(hint: Any) -> Reader:
    """What makes a value of a type out of plain data."""
    origin, arguments = typing.get_origin(hint), typing.get_args(hint)
    if origin in (typing.Union, types.UnionType):
        inner = reader(next(part for part in arguments if part is not type(None)))
        return lambda value: None if value is None else inner(value)
    if origin is tuple and arguments[-1] is Ellipsis:
        return _list_reader(reader(arguments[0]))
    if origin is tuple:
        return _pair_reader(len(arguments))
    if origin in (dict, Mapping):
        return _object_reader(reader(arguments[1]))
    if hasattr(hint, "_of"):
        read: Reader = hint._of  # of a record; what Rust gave is not checked again
        return read
    return _same


def _list_reader(item: Reader) -> Reader:
    def read(value: Any) -> Any:
        items: list[Any] = []
        try:
            items.extend(map(item, _list(value)))  # where it fails it has come to the index
        except Misfit as misfit:
            raise misfit.within(len(items)) from None
        return tuple(items)

    return read


def _pair_reader(length: int) -> Reader:
    """Of cells and other tuples of numbers."""

    def read(value: Any) -> Any:
        items = _list(value)
        if len(items) != length:
            raise Misfit(f"a list of {len(items)}", f"one of {length}")
        return tuple(items)

    return read


def _object_reader(item: Reader) -> Reader:
    def read(value: Any) -> Any:
        if not isinstance(value, Mapping):
            raise Misfit(described(value), "an object")
        items: dict[str, Any] = {}
        for name, one in value.items():
            try:
                items[name] = item(one)
            except Misfit as misfit:
                raise misfit.within(str(name)) from None
        return items

    return read


def _list(value: Any) -> Sequence[Any]:
    if isinstance(value, (list, tuple)):
        return value
    listed = value.tolist() if hasattr(value, "tolist") else None
    if not isinstance(listed, list):
        raise Misfit(described(value), "a list")
    return listed


def _same(value: Any) -> Any:
    return value
