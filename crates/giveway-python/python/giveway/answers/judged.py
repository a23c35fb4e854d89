"""The answers of ``check``, ``audit`` and ``compare``."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar, Literal

from giveway._record import Record, optional
from giveway.answers.costs import Costs, Stats, Status
from giveway.plan import Plan
from giveway.scene import Cell, Cost


@dataclass(frozen=True)
class Violation(Record):
    """A rule that is broken."""

    rule: str
    agents: tuple[str, ...]
    time: int
    message: str
    cell: Cell | None = optional()
    edge: tuple[Cell, ...] = optional(default=())
    #: Of what an answer shows to be unsolvable: which rules were soft.
    kind: str | None = optional("class")
    #: Of a rule of the scene's own: its kind, its number from 0, its name, and where.
    constraint: str | None = optional("kind")
    index: int | None = optional()
    name: str | None = optional()
    cells: tuple[Cell, ...] = optional(default=())


@dataclass(frozen=True)
class Verdict(Record):
    """The answer of ``check``."""

    document: ClassVar[bool] = True

    valid: bool
    costs: Costs | None
    violations: tuple[Violation, ...]


@dataclass(frozen=True)
class AuditAnswer(Record):
    """The answer of ``audit``."""

    document: ClassVar[bool] = True

    legal: bool
    violations: tuple[Violation, ...]
    objective: tuple[Cost, ...]
    costs: Costs | None
    bounds: Mapping[Cost, int]
    within: int | None
    complete: bool
    status: Literal["optimal", "feasible", "illegal", "unknown"]
    #: How far the first cost of a legal plan is above its bound, as a part of the bound.
    gap: float | None
    better: Plan | None
    better_costs: Costs | None
    search: Status
    stats: Stats
    reason: str | None = optional()


@dataclass(frozen=True)
class AgentComparison(Record):
    """What became of one agent from one plan to another."""

    agent: str
    #: ``retimed``: the same cells at other times; ``rerouted``: other cells.
    difference: Literal["same", "retimed", "rerouted"]
    #: In each plan; ``None`` where it has no path.
    arrivals: tuple[int | None, ...]
    #: Where the plans part: a time, and a cell of each.
    first: dict[str, Any] | None


@dataclass(frozen=True)
class Comparison(Record):
    """The answer of ``compare``."""

    document: ClassVar[bool] = True

    #: Of each plan; ``None`` where an agent has no path.
    costs: tuple[Costs | None, ...]
    #: How much more the second one has of each cost.
    deltas: Mapping[Cost, int]
    agents: tuple[AgentComparison, ...]
