"""A value that does not fit, with the keys and indices on the way to it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from giveway.errors import BadInput


class Misfit(Exception):
    """What was found and expected. Whoever reads what is around it adds a step of the way."""

    def __init__(self, found: str, expected: str) -> None:
        super().__init__(found, expected)
        self.found = found
        self.expected = expected
        self._place = ""

    def within(self, step: str | int) -> Misfit:
        """The same, seen from what has it under a key or an index."""
        inner = self._place
        outer = f"[{step}]" if isinstance(step, int) else step
        self._place = outer + (inner if not inner or inner.startswith("[") else f".{inner}")
        return self

    def refusal(self) -> BadInput:
        """What the caller of the package is told."""
        from giveway.errors import refusal  # faults are records themselves

        return refusal(self._place, self.found, self.expected)


def described(value: Any) -> str:
    """A value in the words of the other faults."""
    if value is None or isinstance(value, bool):
        return "null" if value is None else str(value).lower()
    if isinstance(value, str):
        return f"the text {value!r}" if len(value) < 60 else f"a text of {len(value)} characters"
    if isinstance(value, (int, float)):
        return f"the number {value}"
    if isinstance(value, (list, tuple)):
        return "a list"
    return "an object" if isinstance(value, Mapping) else f"a value of the type {type(value).__name__}"
