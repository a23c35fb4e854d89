"""What a plan costs, and how much work it took to find it."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

from giveway._record import Record, optional

Status = Literal["optimal", "feasible", "impossible", "unknown"]
#: What ended a search. Only time, memory and a person end the same search elsewhere each time.
Ended = Literal["proof", "work", "conflicts", "time", "memory", "cancelled", "size", "fault",
    "assumptions",
]


@dataclass(frozen=True)
class Costs(Record):
    """The costs of a plan; a penalty only where rules of the scene make one."""

    makespan: int
    sum_of_costs: int = field(metadata={"key": "sum-of-costs"})
    charges: int
    moves: int
    waits: int
    penalty: int | None = optional()


@dataclass(frozen=True)
class Stats(Record):
    """How much work it took."""

    cpu_seconds: float
    solver_calls: int
    variables: int
    clauses: int
    conflicts: int
    #: Units of work, as ``work_limit`` counts them.
    work: int = 0
