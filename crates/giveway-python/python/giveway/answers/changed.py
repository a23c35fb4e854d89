"""The answer of ``change``."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

from giveway._record import Record, optional
from giveway.answers.costs import Costs, Ended, Stats, Status
from giveway.plan import Plan
from giveway.scene import Cost


@dataclass(frozen=True)
class MethodAnswer(Record):
    """What a method makes of a change, with the names of the agents that it keeps, retimes ..."""

    document: ClassVar[bool] = True

    status: Status
    costs: Costs | None
    bounds: Mapping[Cost, int]
    within: int | None
    complete: bool
    plan: Plan | None
    stats: Stats
    kept: tuple[str, ...]
    retimed: tuple[str, ...]
    rerouted: tuple[str, ...]
    added: tuple[str, ...]
    freed: tuple[str, ...]
    fewest: bool
    closest: bool
    cause: dict[str, Any] | None
    fewest_within: int | None = optional()
    ended: Ended | None = optional()
    reason: str | None = optional()


@dataclass(frozen=True)
class ChangeStep(Record):
    """The changes of one time, and how to go on."""

    at: int | None
    before: Costs | None
    methods: Mapping[str, MethodAnswer]
    adopted: str | None

    @property
    def plan(self) -> Plan | None:
        """The plan that is followed."""
        return None if self.adopted is None else self.methods[self.adopted].plan


@dataclass(frozen=True)
class ChangeAnswer(ChangeStep):
    """The answer of ``change``: of the last time; those before it are the history."""

    document: ClassVar[bool] = True

    history: tuple[ChangeStep, ...]
