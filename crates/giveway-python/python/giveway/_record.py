"""Plain data: dataclasses from and to the project's JSON."""

from __future__ import annotations

import dataclasses
import json
import typing
from collections.abc import Mapping, Sized
from typing import TYPE_CHECKING, Any, ClassVar, NamedTuple

from giveway._misfit import Misfit, described
from giveway._plain import plain
from giveway._reader import Reader, reader
from giveway._text import decoded, parsed

if TYPE_CHECKING:
    from typing_extensions import Self


def optional(name: str | None = None, **options: Any) -> Any:
    """A field that is left out of JSON where it is ``None`` or empty."""
    if "default_factory" not in options:
        options.setdefault("default", None)
    return dataclasses.field(metadata={"key": name, "optional": True}, **options)


class Record:
    """Base of all data: frozen dataclasses in the shapes of the JSON Schema."""

    #: Whether it stands by itself in a file, and so carries the format's version.
    document: ClassVar[bool] = False

    @classmethod
    def from_dict(cls, data: Mapping[str, Any]) -> Self:
        """Reads plain data, as ``json.loads`` gives it; what is not in its shape has its place."""
        try:
            return cls._of(data)
        except Misfit as misfit:
            raise misfit.refusal() from None

    @classmethod
    def from_json(cls, text: str | bytes) -> Self:
        """Reads JSON."""
        return cls.from_dict(parsed(decoded(text)))

    @classmethod
    def _of(cls, data: Any) -> Self:
        if not isinstance(data, Mapping):
            raise Misfit(described(data), "an object")
        values: dict[str, Any] = {}
        for field in _fields(cls):
            if field.key in data:
                try:
                    values[field.name] = field.read(data[field.key])
                except Misfit as misfit:
                    raise misfit.within(field.key) from None
            elif field.is_required:
                raise Misfit(f'no key "{field.key}"', "one here")
        if len(values) < len(data):
            _judge_others(cls, data)
        return cls(**values)

    def to_dict(self) -> dict[str, Any]:
        """Plain data in the shape of the JSON Schema."""
        try:
            return self._plain()
        except Misfit as misfit:
            raise misfit.refusal() from None

    def to_json(self) -> str:
        """JSON on one line."""
        return json.dumps(self.to_dict(), separators=(",", ":"))

    def _plain(self) -> dict[str, Any]:
        data: dict[str, Any] = {"giveway": 1} if self.document else {}
        for name, key, _, is_optional, _ in _fields(type(self)):
            value = getattr(self, name)
            if not is_optional or not (value is None or isinstance(value, Sized) and len(value) == 0):
                try:
                    data[key] = plain(value)
                except Misfit as misfit:
                    raise misfit.within(key) from None
        return data


def _judge_others(cls: type[Record], data: Mapping[Any, Any]) -> None:
    """Refuses keys that are none of a record's: a misspelt one would be lost in silence."""
    known = [field.key for field in _fields(cls)]
    for key, value in data.items():
        if key == "giveway" and cls.document:
            if value != 1:
                raise Misfit(f"version {value} of the format", "version 1, the only one known here").within(key)
        elif key not in known:
            raise Misfit(f'the unknown key "{key}"', f"one of {', '.join(known)}")


class Field(NamedTuple):
    """A field of a record, and how it is read and written."""

    name: str
    key: str
    read: Reader
    #: Whether it is left out of JSON where it is empty.
    is_optional: bool
    #: Whether there is no record without it.
    is_required: bool


_known: dict[type, list[Field]] = {}


def _fields(cls: type) -> list[Field]:
    """The fields that are in JSON."""
    if cls not in _known:
        _known[cls] = _found(cls)
    return _known[cls]


def _found(cls: type) -> list[Field]:
    hints = typing.get_type_hints(cls)
    return [
        Field(
            field.name, field.metadata.get("key") or field.name, reader(hints[field.name]),
            bool(field.metadata.get("optional")),
            field.default is dataclasses.MISSING and field.default_factory is dataclasses.MISSING)
        for field in dataclasses.fields(cls)
        if not field.metadata.get("hidden")
    ]
