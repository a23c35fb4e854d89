"""The answers of ``solve`` and ``pareto``."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar, Literal

from giveway._record import Record, optional
from giveway.answers.costs import Costs, Ended, Stats, Status
from giveway.plan import Plan
from giveway.scene import Cost

Planner = Literal["prioritised", "cbs", "pibt", "lacam", "lns"]


@dataclass(frozen=True)
class Answer(Record):
    """The answer of ``solve``. Running out of a limit is ``feasible`` or ``unknown``."""

    document: ClassVar[bool] = True

    status: Status
    costs: Costs | None
    #: The proved lower bound of each cost reached so far.
    bounds: Mapping[Cost, int]
    #: The makespan up to which the claim was proved; ``None`` where it holds for all plans.
    within: int | None
    complete: bool
    plan: Plan | None
    stats: Stats
    #: What ended the search.
    ended: Ended | None = optional()
    #: Why there is no plan or no proof.
    reason: str | None = optional()
    #: How it was found and proved, where that was asked for.
    trace: dict[str, Any] | None = optional()


@dataclass(frozen=True)
class Front(Record):
    """All non-dominated costs, an answer a point."""

    document: ClassVar[bool] = True

    status: Status
    complete: bool
    within: int | None
    front: tuple[Answer, ...]
    #: What ended the search for its points.
    ended: Ended | None = optional()


@dataclass(frozen=True)
class PlannerStats(Record):
    """How much work a planner of the textbook had; what a step is depends on it."""

    cpu_seconds: float
    steps: int


@dataclass(frozen=True)
class PlannerAnswer(Record):
    """The answer of ``solve`` with a planner of the textbook."""

    document: ClassVar[bool] = True

    planner: Planner
    objective: tuple[Cost, ...]
    #: How it ended; ``ended["how"]`` is best, found, no-order-works, stopped, horizon,
    #: refused or alone.
    ended: dict[str, Any]
    costs: Costs | None
    bounds: Mapping[Cost, int]
    plan: Plan | None
    stats: PlannerStats
    trace: dict[str, Any] | None = optional()

    @property
    def status(self) -> Status:
        """What is known, in the words of the other answers."""
        known: dict[str, Status] = {"best": "optimal", "found": "feasible", "alone": "impossible"}
        status = known.get(self.ended["how"], "unknown")
        return "feasible" if self.plan is not None and status == "unknown" else status
