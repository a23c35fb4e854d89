"""Plain data: dataclasses from and to the project's JSON."""

from __future__ import annotations

import dataclasses
import json
import types
import typing
from collections.abc import Callable, Mapping, Sized
from typing import TYPE_CHECKING, Any, ClassVar

if TYPE_CHECKING:
    from typing_extensions import Self

Reader = Callable[[Any], Any]


def optional(name: str | None = None, **options: Any) -> Any:
    """A field that is left out of JSON where it has its default."""
    if "default_factory" not in options:
        options.setdefault("default", None)
    return dataclasses.field(metadata={"key": name, "optional": True}, **options)


class Record:
    """Base of all data: frozen dataclasses in the shapes of the JSON Schema."""

    #: Whether it stands by itself in a file, and so carries the format's version.
    document: ClassVar[bool] = False

    @classmethod
    def from_dict(cls, data: Mapping[str, Any]) -> Self:
        """Reads plain data, as ``json.loads`` gives it."""
        return cls(**{name: read(data[at]) for name, at, read, _ in _fields(cls) if at in data})

    @classmethod
    def from_json(cls, text: str) -> Self:
        """Reads JSON."""
        return cls.from_dict(json.loads(text))

    def to_dict(self) -> dict[str, Any]:
        """Plain data in the shape of the JSON Schema."""
        data: dict[str, Any] = {"giveway": 1} if self.document else {}
        for name, at, _, is_optional in _fields(type(self)):
            value = getattr(self, name)
            if not is_optional or not (value is None or isinstance(value, Sized) and len(value) == 0):
                data[at] = plain(value)
        return data

    def to_json(self) -> str:
        """JSON on one line."""
        return json.dumps(self.to_dict(), separators=(",", ":"))


def plain(value: Any) -> Any:
    """A value as JSON can hold it."""
    if isinstance(value, Record):
        return value.to_dict()
    if isinstance(value, Mapping):
        return {name: plain(item) for name, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(item) for item in value]
    # Numbers and arrays of NumPy, which need not be there.
    return value.tolist() if hasattr(value, "tolist") else value


Field = tuple[str, str, Reader, bool]
_known: dict[type, list[Field]] = {}


def _fields(cls: type) -> list[Field]:
    """Of each field its name, its key, its reader, and whether it may be left out."""
    if cls not in _known:
        _known[cls] = _found(cls)
    return _known[cls]


def _found(cls: type) -> list[Field]:
    hints = typing.get_type_hints(cls)
    return [
        (field.name, field.metadata.get("key") or field.name, _reader(hints[field.name]),
         bool(field.metadata.get("optional")))
        for field in dataclasses.fields(cls)
        if not field.metadata.get("hidden")
    ]


def _same(value: Any) -> Any:
    return value


def _freeze(value: Any) -> Any:
    return tuple(value) if isinstance(value, list) else value


def _reader(hint: Any) -> Reader:
    """What makes a value of a type out of plain data."""
    origin, arguments = typing.get_origin(hint), typing.get_args(hint)
    if origin in (typing.Union, types.UnionType):
        inner = _reader(next(part for part in arguments if part is not type(None)))
        return lambda value: None if value is None else inner(value)
    if origin is tuple and arguments[-1] is Ellipsis:
        item = _reader(arguments[0])
        return lambda value: tuple([item(one) for one in value])
    if origin is tuple:
        readers = [_reader(part) for part in arguments]
        if all(read is _same for read in readers):
            return _freeze
        return lambda value: tuple(read(one) for read, one in zip(readers, value))
    if origin in (dict, Mapping):
        item = _reader(arguments[1])
        return lambda value: {name: item(one) for name, one in value.items()}
    if isinstance(hint, type) and issubclass(hint, Record):
        return getattr(hint, "_of", hint.from_dict)  # what Rust gave is not checked again
    return _same
