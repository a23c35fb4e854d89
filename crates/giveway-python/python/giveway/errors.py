"""What is raised where the input is wrong."""

from __future__ import annotations

from dataclasses import dataclass

from giveway._record import Record, optional


@dataclass(frozen=True)
class Fault(Record):
    """What was found at a place, and what was expected."""

    found: str
    expected: str
    #: Keys and indices, such as ``scene.agents[1].goal``; empty for the whole.
    place: str = optional(default="")
    #: From 1, where the input was text.
    line: int | None = optional()
    column: int | None = optional()

    def __str__(self) -> str:
        at = ""
        if self.line is not None:
            at = f"line {self.line}, column {self.column}: " if self.column else f"line {self.line}: "
        if self.place:
            at += f"{self.place}: "
        return f"{at}found {self.found}, expected {self.expected}"


class GivewayError(ValueError):
    """The input is wrong; ``faults`` has every fault, ``place`` where the first one is."""

    def __init__(self, faults: tuple[Fault, ...]) -> None:
        self.faults = faults
        more = len(faults) - 1
        rest = "" if more < 1 else f" (and {more} more fault{'s' if more > 1 else ''})"
        super().__init__(f"{faults[0]}{rest}")

    @property
    def place(self) -> str:
        """Where the first fault is."""
        return self.faults[0].place

    def __reduce__(self) -> tuple[type[GivewayError], tuple[tuple[Fault, ...]]]:
        return type(self), (self.faults,)


class BadInput(GivewayError):
    """A request is not of the type that it should be, or asks for what does not exist."""


def refusal(place: str, found: str, expected: str) -> BadInput:
    """Why one thing of a request is refused."""
    return BadInput((Fault(found, expected, place=place),))


class BadScene(GivewayError):
    """A scene is no instance of the problem."""


class BadText(GivewayError):
    """A text is not of its format."""


class Broken(GivewayError):
    """This program has a fault."""


CODES: dict[str, type[GivewayError]] = {
    "bad-input": BadInput, "bad-scene": BadScene, "bad-text": BadText, "broken": Broken,
}
