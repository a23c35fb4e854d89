"""The answers of ``explain``, ``freedom``, ``price``, ``delays``, ``sizing`` and ``together``."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar, Literal

from giveway._record import Record, optional
from giveway.answers.costs import Costs, Stats, Status
from giveway.answers.judged import Violation
from giveway.answers.solved import Answer
from giveway.plan import Plan
from giveway.scene import Cost, Scene

FreedomPart = Literal["backbone", "slack", "plans", "critical", "farthest"]


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
    #: Facts that alone make it impossible; others may make it so, too. A fact's ``helps`` says
    #: whether leaving out this one alone gives the whole scene a plan, ``None`` where it is not
    #: known. Where none helps, ``further`` has the next sets, if any were found.
    core: dict[str, Any] | None
    repairs: tuple[dict[str, Any], ...]
    #: How many more repairs help than are told.
    further_repairs: int
    exhaustive: bool
    words: str
    stats: Stats
    #: Of ``costly``: whether the first of the ``deltas`` that is not 0 is only an upper bound.
    at_most: bool = optional(default=False)
    #: Of ``needless``: how the other plan does without it; ``free`` is there only alone.
    how: tuple[Literal["others", "other-way", "elsewhere", "free"], ...] = optional(default=())
    #: The robots that the other plan moves differently; who arrives later by most is the first.
    pays: tuple[dict[str, Any], ...] = optional(default=())
    #: What sets of robots alone need, proved: for a question about a cost of the whole plan, or
    #: where no small set of facts was found.
    alone: tuple[dict[str, Any], ...] = optional(default=())
    #: What the plan shows, and small variations of it, where these layers are asked for.
    here: dict[str, Any] | None = optional()
    near: dict[str, Any] | None = optional()
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
class RulePrice(Record):
    """A rule of the scene's own, with its price."""

    #: Its number in the scene, from 0.
    index: int
    kind: str
    name: str | None
    #: ``decides``: there is a plan without it, and none with it; ``none``: there is none without it, either.
    price: Literal["free", "costs", "decides", "none", "unknown"]
    #: Both sides are proved: optimal or impossible.
    exact: bool
    #: The costs of the best plan without it.
    without: Mapping[Cost, int] = optional(default_factory=dict)
    #: With it minus without it; a later cost may be negative.
    difference: Mapping[Cost, int] = optional(default_factory=dict)
    #: The cost of the two below, where it is not the first: in those before it both sides are proved equal.
    range_of: Cost | None = optional()
    #: The least and the most that it costs in the first cost, where the price is unknown.
    at_least: int | None = optional()
    at_most: int | None = optional()


@dataclass(frozen=True)
class Prices(Record):
    """The answer of ``price``; ``words`` is the whole of it in sentences."""

    document: ClassVar[bool] = True

    #: What is known of the scene with all rules that are in force.
    status: Status
    objective: tuple[Cost, ...]
    costs: Costs | None
    plan: Plan | None
    complete: bool
    within: int | None
    prices: tuple[RulePrice, ...]
    #: Rules and facts that exclude each other, where there is no plan.
    conflict: dict[str, Any] | None
    #: All sets of the fewest rules whose switching off leaves a plan.
    switch_off: tuple[tuple[int, ...], ...]
    #: Whether these are all of them for sure.
    switch_off_settled: bool
    words: str
    stats: Stats
    #: How many prices are still to come.
    pending: int = 0
    #: How the rule can be loosened that was asked about.
    loosened: dict[str, Any] | None = optional()
    #: Why there is no plan or no proof.
    reason: str | None = optional()


@dataclass(frozen=True)
class AgentDelay(Record):
    """A robot's delay against its best way alone."""

    agent: str
    arrival: int
    #: Its least arrival alone: its waypoints, battery and own rules kept.
    alone: int
    delay: int
    #: Even parts by whom it lets pass: ``because`` is ``agent``, ``rule`` or ``nobody``, ``steps`` a
    #: ``numerator`` and a ``denominator``.
    because: tuple[dict[str, Any], ...]
    #: Where it loses steps: each with ``cell`` and ``steps``.
    lost: tuple[dict[str, Any], ...]


@dataclass(frozen=True)
class Delays(Record):
    """The answer of ``delays``; ``words`` is the whole of it in sentences."""

    document: ClassVar[bool] = True

    objective: tuple[Cost, ...]
    costs: Costs | None
    #: The sum of costs if each robot arrived as early as alone.
    alone: int
    #: The sum of costs less that.
    delay: int
    #: Who loses most is the first.
    agents: tuple[AgentDelay, ...]
    #: Who costs others how much; ``steps`` is ``None`` where the fraction has too large numbers.
    because: tuple[dict[str, Any], ...]
    #: The steps lost at each cell, row by row.
    lost: tuple[dict[str, Any], ...]
    #: The three places at which most is lost, the worst first.
    places: tuple[dict[str, Any], ...]
    #: How many steps each plan loses that has no more of the costs in ``given``.
    proof: dict[str, Any] | None
    words: str
    stats: Stats
    #: The time of the last change.
    since: int | None = optional()
    #: The plan that was found, where none was handed in.
    plan: Plan | None = optional()
    #: The calm plan by which delays are split, where it is not the plan itself.
    calm: Plan | None = optional()
    #: Why there is no ledger.
    reason: str | None = optional()
    #: Whether the proof is still to come.
    pending: bool = False


@dataclass(frozen=True)
class Order(Record):
    """The answer of ``order``; ``words`` is the whole of it in sentences."""

    document: ClassVar[bool] = True

    costs: Costs | None
    #: ``agents`` with their visits, ``links``, ``rotations``, and moves that begin ``later`` than planned.
    order: dict[str, Any] | None
    #: How many links have no slack: there one robot follows the other in the same step.
    without_slack: int
    #: What robots may break though they keep to the order.
    losses: tuple[dict[str, Any], ...]
    words: str
    stats: Stats
    #: Moves that would wait for each other, where no order alone keeps the plan safe.
    none: dict[str, Any] | None = optional()
    #: What follows from the lateness that was asked for.
    late: dict[str, Any] | None = optional()
    #: The order in the formats that were asked for: each with ``format`` and ``text``.
    files: tuple[dict[str, Any], ...] = optional(default=())
    #: The plan that was found, where none was handed in.
    plan: Plan | None = optional()
    #: Why there is no plan.
    reason: str | None = optional()


@dataclass(frozen=True)
class SizingPoint(Record):
    """The best plan of so many robots."""

    robots: int
    status: Status
    costs: Costs | None
    bounds: dict[Cost, int]
    complete: bool
    within: int | None
    #: The sum of costs if each robot arrived as early as alone; ``None`` where one cannot.
    alone: int | None
    #: The robot that needs the most steps alone.
    slowest: dict[str, Any] | None
    plan: Plan | None
    #: Why there is no plan or no proof.
    reason: str | None = optional()


@dataclass(frozen=True)
class Sizing(Record):
    """The answer of ``sizing``; ``words`` is the whole of it in sentences."""

    document: ClassVar[bool] = True

    objective: tuple[Cost, ...]
    points: tuple[SizingPoint, ...]
    words: str
    stats: Stats
    #: The plans of the floor that is compared.
    beside: tuple[SizingPoint, ...] = ()
    #: How many plans were not begun.
    pending: int = 0


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
