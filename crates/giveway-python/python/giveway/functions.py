"""What can be asked: each function takes records or plain data, and gives a record."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, TypeVar, Union, overload

from giveway._door import OnProgress, ShouldStop, call, without_none
from giveway._limits import limits
from giveway._misfit import described
from giveway._plain import plain
from giveway._record import Record
from giveway._request import by_kind, costs, words
from giveway.answers import (
    Answer, AuditAnswer, Certificates, ChangeAnswer, Comparison, Delays, Explanation, Freedom, FreedomPart, Front, Order, Planner,
    PlannerAnswer, Prices, Sizing, Together, Verdict, on,
)
from giveway.errors import refusal
from giveway.plan import Plan
from giveway.scene import Cost, Scene

AnyScene = Union[Scene, Mapping[str, Any]]
AnyPlan = Union[Plan, Mapping[str, Any]]
#: Costs, the most important first; a text may have several, with commas.
Objective = Union[str, Sequence[Cost]]

R = TypeVar("R", bound=Record)


def _ask(
    shape: type[R], function: str, request: dict[str, Any], on_progress: OnProgress | None, should_stop: ShouldStop | None,
) -> R:
    """An answer whose plans have the scene of the request, which is a good one if there is an answer."""
    answer = call(function, request, on_progress, should_stop)
    scene = request["scene"]
    return on(scene if isinstance(scene, Scene) else Scene._of(plain(scene)), shape._of(answer))


@overload
def solve(
    scene: AnyScene, *, objective: Objective | None = None, planner: None = None, within: int | None = None,
    start: AnyPlan | None = None, trace: bool = False, time_limit: float | None = None,
    conflict_limit: int | None = None, work_limit: int | None = None, memory_limit: int | None = None,
    on_progress: OnProgress | None = None, should_stop: ShouldStop | None = None,
) -> Answer: ...
@overload
def solve(
    scene: AnyScene, *, objective: Objective | None = None, planner: Planner, within: int | None = None,
    order: Sequence[str] | None = None, trace: bool = False, time_limit: float | None = None,
    work_limit: int | None = None, memory_limit: int | None = None, on_progress: OnProgress | None = None,
    should_stop: ShouldStop | None = None,
) -> PlannerAnswer: ...
def solve(
    scene: AnyScene, *, objective: Objective | None = None, planner: Planner | None = None, within: int | None = None,
    start: AnyPlan | None = None, order: Sequence[str] | None = None, trace: bool = False,
    time_limit: float | None = None, conflict_limit: int | None = None, work_limit: int | None = None,
    memory_limit: int | None = None, on_progress: OnProgress | None = None, should_stop: ShouldStop | None = None,
) -> Answer | PlannerAnswer:
    """Finds and proves the best plan, or finds one with a planner of the textbook.

    Limits: wall seconds, conflicts of the SAT solver, units of work, bytes.
    The same question has the same answer, on every machine, where a proof or ``work_limit`` ends the
    search (``answer.ended``); where time or memory ends it, how far it came decides. Ctrl-C raises
    ``KeyboardInterrupt``; ``should_stop`` ends the search in what is known by then.

    >>> from giveway import Agent, Scene
    >>> scene = Scene(map=("...",), agents=(Agent("A", (0, 0), (2, 0)),))
    >>> answer = solve(scene, objective="sum-of-costs", time_limit=10)
    >>> answer.status, answer.costs.sum_of_costs, answer.plan.paths["A"]
    ('optimal', 2, ((0, 0), (1, 0), (2, 0)))
    """
    request = without_none(scene=scene, objective=costs(objective), within=within, trace=trace)
    request["limits"] = limits(time_limit, conflict_limit, memory_limit, work_limit)
    if planner is None:
        if order is not None:
            raise refusal("order", "an order for a search that has none", "one with planner=\"prioritised\" only")
        request |= without_none(start=start)
        return _ask(Answer, "solve", request, on_progress, should_stop)
    for place, given in {"start": start, "conflict_limit": conflict_limit}.items():
        if given is not None:
            raise refusal(place, f"one for the planner {planner!r}", "none, as only the search without a planner has it")
    request |= without_none(planner=planner, order=order)
    return _ask(PlannerAnswer, "plan", request, on_progress, should_stop)


def pareto(
    scene: AnyScene, objective: Objective, *, within: int | None = None, time_limit: float | None = None,
    conflict_limit: int | None = None, work_limit: int | None = None, memory_limit: int | None = None,
    on_progress: OnProgress | None = None, should_stop: ShouldStop | None = None,
) -> Front:
    """All non-dominated costs of two or three, a plan each."""
    request = without_none(scene=scene, objective=costs(objective), within=within, pareto=True)
    request["limits"] = limits(time_limit, conflict_limit, memory_limit, work_limit)
    return _ask(Front, "solve", request, on_progress, should_stop)


def check(scene: AnyScene, plan: AnyPlan, changes: Mapping[str, Any] | None = None) -> Verdict:
    """Judges a plan: every rule that it breaks.

    >>> from giveway import Agent, Plan, Scene
    >>> scene = Scene(map=("...",), agents=(Agent("A", (0, 0), (2, 0)),))
    >>> [violation.rule for violation in check(scene, Plan({"A": ((0, 0), (2, 0))})).violations]
    ['move']
    """
    return Verdict.from_dict(call("check", without_none(scene=scene, plan=plan, changes=changes)))


def compare(scene: AnyScene, one: AnyPlan, other: AnyPlan) -> Comparison:
    """Compares two plans of a scene: what each costs, and which agents go elsewhere or at other times.

    >>> from giveway import Agent, Plan, Scene
    >>> scene = Scene(map=("..",), agents=(Agent("A", (0, 0), (1, 0)),))
    >>> later = Plan({"A": ((0, 0), (0, 0), (1, 0))})
    >>> compare(scene, Plan({"A": ((0, 0), (1, 0))}), later).agents[0].difference
    'retimed'
    """
    return Comparison._of(call("compare", {"scene": scene, "plans": [one, other]}))


def explain(
    scene: AnyScene, question: str | Mapping[str, Any], plan: AnyPlan | None = None, *,
    changes: Mapping[str, Any] | None = None, at: int | None = None, objective: Objective | None = None,
    within: int | None = None, layers: Sequence[str] | None = None, time_limit: float | None = None,
    conflict_limit: int | None = None, memory_limit: int | None = None, on_progress: OnProgress | None = None,
    should_stop: ShouldStop | None = None,
) -> Explanation:
    """Answers a question about a plan, or about there being none.

    The question is plain data, such as ``{"kind": "wait", "agent": "A1"}``, or in the words
    of the command: ``"wait A1 --at 3,1"``. Without a plan the scene is solved first. ``layers``
    names those of the answer: ``here``, ``near``, ``whole``, ``reason``, ``help``; without any the
    last three.
    """
    if isinstance(question, str):
        question = call("read-question", {"words": words(question)})
    elif not isinstance(question, Mapping):
        raise refusal("question", described(question), "a text, or an object with its kind")
    request = without_none(
        scene=scene, question=question, plan=plan, changes=changes, at=at, objective=costs(objective), within=within,
        layers=None if layers is None else list(layers))
    request["limits"] = limits(time_limit, conflict_limit, memory_limit)
    return _ask(Explanation, "explain", request, on_progress, should_stop)


def change(
    scene: AnyScene, plan: AnyPlan, changes: Mapping[str, Any], *, since: int | None = None,
    methods: Sequence[str] = ("revise", "replan"), objective: Objective | None = None, within: int | None = None,
    time_limit: float | None = None, conflict_limit: int | None = None, memory_limit: int | None = None,
    on_progress: OnProgress | None = None, should_stop: ShouldStop | None = None,
) -> ChangeAnswer:
    """Goes on with a plan around which the world changes, by each method, compared."""
    request = without_none(
        scene=scene, plan=plan, changes=changes, since=since, methods=methods,
        objective=costs(objective), within=within)
    request["limits"] = limits(time_limit, conflict_limit, memory_limit)
    return _ask(ChangeAnswer, "change", request, on_progress, should_stop)


def audit(
    scene: AnyScene, plan: AnyPlan, *, objective: Objective | None = None, within: int | None = None,
    time_limit: float | None = None, conflict_limit: int | None = None, memory_limit: int | None = None,
    on_progress: OnProgress | None = None, should_stop: ShouldStop | None = None,
) -> AuditAnswer:
    """Judges any plan, and tells how far it is from the best."""
    request = without_none(scene=scene, plan=plan, objective=costs(objective), within=within)
    request["limits"] = limits(time_limit, conflict_limit, memory_limit)
    return _ask(AuditAnswer, "audit", request, on_progress, should_stop)


def freedom(
    scene: AnyScene, plan: AnyPlan | None = None, *, parts: Sequence[FreedomPart] = (), count: int | None = None,
    objective: Objective | None = None, within: int | None = None, time_limit: float | None = None,
    conflict_limit: int | None = None, memory_limit: int | None = None, on_progress: OnProgress | None = None,
    should_stop: ShouldStop | None = None,
) -> Freedom:
    """Tells what every best plan has in common, how many there are (up to ``count``), how late each
    agent could be, what closing each cell would cost, and another best plan as different as can be.

    Without a plan the scene is solved first; without ``parts`` all of them are told.

    >>> from giveway import Agent, Scene
    >>> scene = Scene(map=("..", ".."), agents=(Agent("A", (0, 0), (1, 1)),))
    >>> freedom(scene).plans["count"]
    2
    """
    request = without_none(
        scene=scene, plan=plan, parts=parts, count=count, objective=costs(objective), within=within)
    request["limits"] = limits(time_limit, conflict_limit, memory_limit)
    return _ask(Freedom, "freedom", request, on_progress, should_stop)


def price(
    scene: AnyScene, *, objective: Objective | None = None, within: int | None = None, start: AnyPlan | None = None,
    loosen: int | None = None, time_limit: float | None = None, conflict_limit: int | None = None,
    memory_limit: int | None = None, on_progress: OnProgress | None = None, should_stop: ShouldStop | None = None,
) -> Prices:
    """Tells what each rule of the scene's own costs: the best plan without it beside the best with all of
    them. Where they leave no plan, it tells which exclude each other, and the fewest to switch off.
    With ``loosen``, the number of a rule from 0, it tells the price of that rule alone, and the least looser
    form of it that changes the costs, or with which there is a plan.

    >>> from giveway import Agent, Scene
    >>> scene = Scene(map=("...",), agents=(Agent("A", (0, 0), (2, 0)),), constraints=({"kind": "depart", "from": 3},))
    >>> price(scene).prices[0].difference["makespan"]
    3
    >>> price(scene, loosen=0).loosened["looser"][0]["rule"]["from"]
    2
    """
    request = without_none(scene=scene, objective=costs(objective), within=within, start=start, loosen=loosen)
    request["limits"] = limits(time_limit, conflict_limit, memory_limit)
    return _ask(Prices, "price", request, on_progress, should_stop)


def delays(
    scene: AnyScene, plan: AnyPlan | None = None, *, changes: Mapping[str, Any] | None = None, at: int | None = None,
    objective: Objective | None = None, within: int | None = None, ledger_only: bool = False,
    time_limit: float | None = None, conflict_limit: int | None = None, memory_limit: int | None = None,
    on_progress: OnProgress | None = None, should_stop: ShouldStop | None = None,
) -> Delays:
    """Tells who costs whom in a plan: each robot's delay against its best way alone, split by whom it lets
    pass, where steps are lost, and how many every plan loses. Without a plan the scene is solved first.

    >>> from giveway import Agent, Scene
    >>> agents = (Agent("A", (0, 0), (2, 0)), Agent("B", (2, 0), (0, 0)))
    >>> delays(Scene(map=("...", "#.#"), agents=agents)).delay
    3
    """
    request = without_none(
        scene=scene, plan=plan, changes=changes, at=at, objective=costs(objective), within=within,
        ledger_only=ledger_only)
    request["limits"] = limits(time_limit, conflict_limit, memory_limit)
    return _ask(Delays, "delays", request, on_progress, should_stop)


def order(
    scene: AnyScene, plan: AnyPlan | None = None, *, changes: Mapping[str, Any] | None = None,
    late: Sequence[Mapping[str, Any]] | None = None, to: Sequence[str] | None = None, objective: Objective | None = None,
    within: int | None = None, time_limit: float | None = None, conflict_limit: int | None = None,
    memory_limit: int | None = None, on_progress: OnProgress | None = None, should_stop: ShouldStop | None = None,
) -> Order:
    """Tells in which order robots pass each cell, and who is pushed if some are ``late``: each has an
    ``agent``, a ``cell`` and ``steps``. ``to`` names formats in which it is written, too: ``dot``, ``csv``,
    ``waypoints``, ``vda5050``. Without a plan the scene is solved first.

    >>> from giveway import Agent, Scene
    >>> scene = Scene(map=("....",), agents=(Agent("A", (1, 0), (3, 0)), Agent("B", (0, 0), (2, 0))))
    >>> found = order(scene, late=[{"agent": "A", "cell": [2, 0], "steps": 3}], to=["dot"])
    >>> found.without_slack, found.late["arrivals"][1]["now"], found.files[0]["text"][:7]
    (2, 5, 'digraph')
    """
    request = without_none(
        scene=scene, plan=plan, changes=changes, late=late, to=to, objective=costs(objective), within=within)
    request["limits"] = limits(time_limit, conflict_limit, memory_limit)
    return _ask(Order, "order", request, on_progress, should_stop)


def sizing(
    scene: AnyScene, counts: Sequence[int], *, beside: AnyScene | None = None, objective: Objective | None = None,
    within: int | None = None, time_limit: float | None = None, conflict_limit: int | None = None,
    memory_limit: int | None = None, on_progress: OnProgress | None = None, should_stop: ShouldStop | None = None,
) -> Sizing:
    """Tells how many robots a floor bears: the best plan of the first robots of a scene, for ascending numbers
    of them, and beside it on another floor. Each limit is of one solve.

    >>> from giveway import Agent, Scene
    >>> agents = (Agent("A", (0, 0), (2, 0)), Agent("B", (2, 0), (0, 0)))
    >>> [point.costs.makespan for point in sizing(Scene(map=("...", "#.#"), agents=agents), [1, 2]).points]
    [2, 4]
    """
    request = without_none(scene=scene, counts=counts, beside=beside, objective=costs(objective), within=within)
    request["limits"] = limits(time_limit, conflict_limit, memory_limit)
    return _ask(Sizing, "sizing", request, on_progress, should_stop)


def together(
    scene: AnyScene, cost: Cost, agents: Sequence[Mapping[str, Any]], *, more: int | None = None,
    within: int | None = None, time_limit: float | None = None, conflict_limit: int | None = None,
    memory_limit: int | None = None, on_progress: OnProgress | None = None, should_stop: ShouldStop | None = None,
) -> Together:
    """Tells why some agents cannot all keep their limits: a step of a proof, looked at closely.

    Each agent has a name, the ``least`` that it needs alone, and the ``at_most`` that it may have, as
    the ``limits`` of a core in a trace (``solve(scene, trace=True)``) have them. ``more`` limits what
    they may have together beyond the least of each.

    >>> from giveway import Agent, Scene
    >>> agents = Agent("A", (0, 0), (2, 0)), Agent("B", (2, 0), (0, 0))
    >>> on_time = [{"agent": name, "least": 2, "at_most": 2} for name in "AB"]
    >>> together(Scene(map=("...", "..."), agents=agents), "sum-of-costs", on_time).meetings[0]["cell"]
    [1, 0]
    """
    request = without_none(scene=scene, cost=cost, agents=agents, more=more, within=within)
    request["limits"] = limits(time_limit, conflict_limit, memory_limit)
    return _ask(Together, "together", request, on_progress, should_stop)


def export(
    scene: AnyScene, answer: Answer | Explanation | Freedom | Mapping[str, Any], plan: AnyPlan | None = None, *,
    objective: Objective | None = None, time_limit: float | None = None, memory_limit: int | None = None,
    on_progress: OnProgress | None = None, should_stop: ShouldStop | None = None,
) -> Certificates:
    """Proves again what was answered, as files that anyone can check, and checks them.

    ``answer`` is that of ``solve``, ``explain`` (with the ``plan`` that was asked about) or ``freedom``, and
    ``objective`` the one that it was asked with. What has no proof within the limits says so in its report.

    >>> from giveway import Agent, Scene
    >>> scene = Scene(map=("...",), agents=(Agent("A", (0, 0), (2, 0)),))
    >>> made = export(scene, solve(scene, objective="makespan"), objective="makespan")
    >>> made.certificates["solved"].report.certified, made.to_zip()[:2]
    ('proved', b'PK')
    """
    request = without_none(scene=scene, objective=costs(objective), answer=by_kind(answer), plan=plan)
    request["limits"] = limits(time_limit, None, memory_limit)
    return Certificates.from_dict(call("export", request, on_progress, should_stop))


def schema() -> dict[str, Any]:
    """The JSON Schema of all data: ``$defs`` has one of each."""
    read: dict[str, Any] = call("schema", "")
    return read
