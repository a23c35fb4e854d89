"""Answers, in the shapes of the JSON Schema."""

from __future__ import annotations

import dataclasses
import io
import zipfile
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, ClassVar, Literal, TypeVar

from giveway._record import Record, optional
from giveway.plan import Plan
from giveway.scene import Cell, Cost, Scene

Status = Literal["optimal", "feasible", "impossible", "unknown"]
FreedomPart = Literal["backbone", "slack", "plans", "critical", "farthest"]
Planner = Literal["prioritised", "cbs", "pibt", "lacam", "lns"]


@dataclass(frozen=True)
class Costs(Record):
    """All five costs of a plan."""

    makespan: int
    sum_of_costs: int = field(metadata={"key": "sum-of-costs"})
    charges: int
    moves: int
    waits: int


@dataclass(frozen=True)
class Stats(Record):
    """How much work it took."""

    cpu_seconds: float
    solver_calls: int
    variables: int
    clauses: int
    conflicts: int


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


@dataclass(frozen=True)
class Verdict(Record):
    """The answer of ``check``."""

    document: ClassVar[bool] = True

    valid: bool
    costs: Costs | None
    violations: tuple[Violation, ...]


@dataclass(frozen=True)
class Explanation(Record):
    """The answer of ``explain``; ``words`` is the whole of it in sentences."""

    document: ClassVar[bool] = True

    question: dict[str, Any]
    verdict: Literal["needless", "improvable", "costly", "necessary", "unknown"]
    costs: Costs | None
    deltas: Mapping[Cost, int]
    within: int | None
    complete: bool
    alternative: Plan | None
    closest: bool
    witness: tuple[Violation, ...]
    core: dict[str, Any] | None
    repairs: tuple[dict[str, Any], ...]
    exhaustive: bool
    words: str
    stats: Stats
    since: int | None = optional()
    plan: Plan | None = optional()
    valid: bool | None = optional()
    violations: tuple[Violation, ...] = optional(default=())
    optimal: bool | None = optional()
    excess: tuple[dict[str, Any], ...] = optional(default=())
    pending: tuple[str, ...] = optional(default=())


@dataclass(frozen=True)
class Freedom(Record):
    """The answer of ``freedom``: what every best plan has in common, and what is free to choose.

    ``True`` is proved, ``False`` is shown by a best plan, ``None`` is open.
    """

    document: ClassVar[bool] = True

    #: What is known of the plan; the parts are there only where it is ``optimal``.
    status: Status
    objective: tuple[Cost, ...]
    #: Which plan it is about.
    about: Literal["given", "found", "better"]
    costs: Costs | None
    plan: Plan | None
    complete: bool
    within: int | None
    stats: Stats
    #: The entries of each agent's path: whether every best plan has them, or only this one.
    backbone: Mapping[str, tuple[dict[str, Any], ...]] | None = optional()
    #: How many best plans there are, and the ways that each agent can choose from.
    plans: dict[str, Any] | None = optional()
    #: Another best plan, as different as can be.
    farthest: dict[str, Any] | None = optional()
    #: How late each agent could be.
    slack: Mapping[str, dict[str, Any]] | None = optional()
    #: What closing each free cell would cost.
    critical: tuple[dict[str, Any], ...] | None = optional()
    #: The parts that are not finished.
    pending: tuple[str, ...] = optional(default=())
    #: Why something is open.
    reason: str | None = optional()


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
class Report(Record):
    """What came of checking a certificate."""

    document: ClassVar[bool] = True

    accepted: bool
    certified: Literal["proved", "proved-and-searched", "not-certified"]
    conclusion: str | None
    concluded: dict[str, Any] | None
    reason: str | None
    stopped: bool
    claims: tuple[dict[str, Any], ...]


@dataclass(frozen=True)
class Certificate(Record):
    """A certificate: the texts of its files by their names, and what came of checking them."""

    files: Mapping[str, str]
    report: Report


@dataclass(frozen=True)
class Certificates(Record):
    """What ``export`` gives: certificates by their names."""

    certificates: Mapping[str, Certificate]
    #: How many there was no time for.
    missing: int

    def to_zip(self) -> bytes:
        """One file with a folder for each, as ``giveway verify`` reads it; the same bytes each time."""
        packed = io.BytesIO()
        with zipfile.ZipFile(packed, "w") as archive:
            for name, certificate in sorted(self.certificates.items()):
                for file, text in sorted(certificate.files.items()):
                    entry = zipfile.ZipInfo(f"{name}/{file}")
                    entry.compress_type = zipfile.ZIP_DEFLATED
                    entry.external_attr = 0o644 << 16
                    archive.writestr(entry, text)
        return packed.getvalue()


@dataclass(frozen=True)
class Alone(Record):
    """The search for some agents by themselves."""

    #: With these agents only, and the cost as its objective.
    scene: Scene
    solved: Answer
    #: Whether they cannot keep their limits even by themselves; ``None`` where that is open.
    refuted: bool | None


@dataclass(frozen=True)
class Together(Record):
    """The answer of ``together``."""

    document: ClassVar[bool] = True

    #: Where each can be, and from when to when, while it keeps its limit.
    regions: tuple[dict[str, Any], ...]
    #: Where an agent has to be at a time, as far as that explains the meetings.
    passes: tuple[dict[str, Any], ...]
    #: Where two of them collide whichever ways they take.
    meetings: tuple[dict[str, Any], ...]
    #: The same agents by themselves; ``None`` where they are more than four.
    alone: Alone | None


@dataclass(frozen=True)
class Converted(Record):
    """Texts by file names, and what the other format cannot say."""

    files: dict[str, str]
    notes: tuple[str, ...]


R = TypeVar("R")


def on(scene: Scene | None, value: R) -> R:
    """An answer whose plans have the scene, to be drawn with."""
    if isinstance(value, Plan):
        return dataclasses.replace(value, scene=scene)
    if isinstance(value, Record) and not isinstance(value, Scene):
        parts = {one.name: getattr(value, one.name) for one in dataclasses.fields(value)}  # type: ignore[arg-type]
        changed = {name: on(scene, part) for name, part in parts.items() if isinstance(part, (Record, tuple, Mapping))}
        return dataclasses.replace(value, **changed)  # type: ignore[type-var]
    if isinstance(value, tuple) and value and isinstance(value[0], Record):
        return tuple(on(scene, part) for part in value)  # type: ignore[return-value]
    if isinstance(value, dict) and value and isinstance(next(iter(value.values())), Record):
        return {name: on(scene, part) for name, part in value.items()}  # type: ignore[return-value]
    return value
