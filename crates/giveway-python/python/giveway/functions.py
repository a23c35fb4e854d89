"""What can be asked: each function takes records or plain data, and gives a record."""

from __future__ import annotations

import shlex
from collections.abc import Mapping, Sequence
from os import PathLike
from pathlib import Path
from typing import Any, Union, overload

from giveway import _bundle
from giveway._door import OnProgress, ShouldStop, call, data, without_none
from giveway._limits import limits
from giveway.answers import (
    Answer, AuditAnswer, Certificate, Certificates, ChangeAnswer, Converted, Explanation, Freedom, FreedomPart, Front, Planner,
    PlannerAnswer, Report, Together, Verdict, on,
)
from giveway.errors import BadInput, Fault
from giveway.plan import Plan
from giveway.scene import Cost, Scene

AnyScene = Union[Scene, Mapping[str, Any]]
AnyPlan = Union[Plan, Mapping[str, Any]]
#: Costs, the most important first; a text may have several, with commas.
Objective = Union[str, Sequence[Cost]]


def _objective(objective: Objective | None) -> list[str] | None:
    return objective.split(",") if isinstance(objective, str) else None if objective is None else list(objective)


def _scene(scene: AnyScene) -> Scene | None:
    return scene if isinstance(scene, Scene) else None


def _words(question: str) -> list[str]:
    try:
        return shlex.split(question)
    except ValueError as error:
        fault = Fault(repr(question), f"words ({error})", place="question")
        raise BadInput((fault,)) from error


@overload
def solve(
    scene: AnyScene, *, objective: Objective | None = None, planner: None = None, within: int | None = None,
    start: AnyPlan | None = None, trace: bool = False, time_limit: float | None = None,
    conflict_limit: int | None = None, memory_limit: int | None = None, on_progress: OnProgress | None = None,
    should_stop: ShouldStop | None = None,
) -> Answer: ...
@overload
def solve(
    scene: AnyScene, *, objective: Objective | None = None, planner: Planner, within: int | None = None,
    order: Sequence[str] | None = None, trace: bool = False, time_limit: float | None = None,
    memory_limit: int | None = None, on_progress: OnProgress | None = None, should_stop: ShouldStop | None = None,
) -> PlannerAnswer: ...
def solve(
    scene: AnyScene, *, objective: Objective | None = None, planner: Planner | None = None, within: int | None = None,
    start: AnyPlan | None = None, order: Sequence[str] | None = None, trace: bool = False,
    time_limit: float | None = None, conflict_limit: int | None = None, memory_limit: int | None = None,
    on_progress: OnProgress | None = None, should_stop: ShouldStop | None = None,
) -> Answer | PlannerAnswer:
    """Finds and proves the best plan, or finds one with a planner of the textbook.

    Limits: wall seconds, conflicts of the SAT solver, bytes. Ctrl-C raises
    ``KeyboardInterrupt``; ``should_stop`` ends the search in what is known by then.

    >>> from giveway import Agent, Scene
    >>> scene = Scene(map=("...",), agents=(Agent("A", (0, 0), (2, 0)),))
    >>> answer = solve(scene, objective="sum-of-costs", time_limit=10)
    >>> answer.status, answer.costs.sum_of_costs, answer.plan.paths["A"]
    ('optimal', 2, ((0, 0), (1, 0), (2, 0)))
    """
    request = without_none(scene=data(scene), objective=_objective(objective), within=within)
    request["limits"] = limits(time_limit, conflict_limit, memory_limit)
    if planner is None:
        request |= without_none(start=start, trace=trace)
        solved = call("solve", request, on_progress, should_stop)
        return on(_scene(scene), Answer.from_dict(solved))
    request |= without_none(planner=planner, order=order, trace=trace)
    planned = call("plan", request, on_progress, should_stop)
    return on(_scene(scene), PlannerAnswer.from_dict(planned))


def pareto(
    scene: AnyScene, objective: Objective, *, within: int | None = None, time_limit: float | None = None,
    conflict_limit: int | None = None, memory_limit: int | None = None, on_progress: OnProgress | None = None,
    should_stop: ShouldStop | None = None,
) -> Front:
    """All non-dominated costs of two or three, a plan each."""
    request = without_none(scene=scene, objective=_objective(objective), within=within, pareto=True)
    request["limits"] = limits(time_limit, conflict_limit, memory_limit)
    return on(_scene(scene), Front.from_dict(call("solve", request, on_progress, should_stop)))


def check(scene: AnyScene, plan: AnyPlan, changes: Mapping[str, Any] | None = None) -> Verdict:
    """Judges a plan: every rule that it breaks.

    >>> from giveway import Agent, Plan, Scene
    >>> scene = Scene(map=("...",), agents=(Agent("A", (0, 0), (2, 0)),))
    >>> [violation.rule for violation in check(scene, Plan({"A": ((0, 0), (2, 0))})).violations]
    ['move']
    """
    return Verdict.from_dict(call("check", without_none(scene=scene, plan=plan, changes=changes)))


def explain(
    scene: AnyScene, question: str | Mapping[str, Any], plan: AnyPlan | None = None, *,
    changes: Mapping[str, Any] | None = None, at: int | None = None, objective: Objective | None = None,
    within: int | None = None, time_limit: float | None = None, conflict_limit: int | None = None,
    memory_limit: int | None = None, on_progress: OnProgress | None = None, should_stop: ShouldStop | None = None,
) -> Explanation:
    """Answers a question about a plan, or about there being none.

    The question is plain data, such as ``{"kind": "wait", "agent": "A1"}``, or in the words
    of the command: ``"wait A1 --at 3,1"``. Without a plan the scene is solved first.
    """
    if isinstance(question, str):
        question = call("read-question", {"words": _words(question)})
    request = without_none(
        scene=scene, question=question, plan=plan, changes=changes, at=at, objective=_objective(objective), within=within)
    request["limits"] = limits(time_limit, conflict_limit, memory_limit)
    return on(_scene(scene), Explanation.from_dict(call("explain", request, on_progress, should_stop)))


def change(
    scene: AnyScene, plan: AnyPlan, changes: Mapping[str, Any], *, since: int | None = None,
    methods: Sequence[str] = ("revise", "replan"), objective: Objective | None = None, within: int | None = None,
    time_limit: float | None = None, conflict_limit: int | None = None, memory_limit: int | None = None,
    on_progress: OnProgress | None = None, should_stop: ShouldStop | None = None,
) -> ChangeAnswer:
    """Goes on with a plan around which the world changes, by each method, compared."""
    request = without_none(
        scene=scene, plan=plan, changes=changes, since=since, methods=methods,
        objective=_objective(objective), within=within)
    request["limits"] = limits(time_limit, conflict_limit, memory_limit)
    return on(_scene(scene), ChangeAnswer.from_dict(call("change", request, on_progress, should_stop)))


def audit(
    scene: AnyScene, plan: AnyPlan, *, objective: Objective | None = None, within: int | None = None,
    time_limit: float | None = None, conflict_limit: int | None = None, memory_limit: int | None = None,
    on_progress: OnProgress | None = None, should_stop: ShouldStop | None = None,
) -> AuditAnswer:
    """Judges any plan, and tells how far it is from the best."""
    request = without_none(scene=scene, plan=plan, objective=_objective(objective), within=within)
    request["limits"] = limits(time_limit, conflict_limit, memory_limit)
    return on(_scene(scene), AuditAnswer.from_dict(call("audit", request, on_progress, should_stop)))


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
        scene=scene, plan=plan, parts=parts, count=count, objective=_objective(objective), within=within)
    request["limits"] = limits(time_limit, conflict_limit, memory_limit)
    return on(_scene(scene), Freedom.from_dict(call("freedom", request, on_progress, should_stop)))


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
    return on(_scene(scene), Together.from_dict(call("together", request, on_progress, should_stop)))


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
    told: dict[str, Any] = data(answer)
    kind = "explain" if "verdict" in told else "freedom" if "about" in told else "solve"
    request = without_none(scene=scene, objective=_objective(objective), answer={kind: told}, plan=plan)
    request["limits"] = limits(time_limit, None, memory_limit)
    return Certificates.from_dict(call("export", request, on_progress, should_stop))


def convert(
    files: Mapping[str, str] | Sequence[str | PathLike[str]] | Scene, to: str, agents: int | None = None
) -> Converted:
    """Writes instances and plans in another format: ``giveway``, ``movingai``, ``tracker``,
    ``paths.txt``, ``result.txt``, ``multi-robot``, ``lorr``, ``asprilo`` or ``mapfw``.

    Files are texts by their names, or paths; a scene stands for its file.

    >>> from giveway import Agent, Scene
    >>> sorted(convert(Scene(map=("...",), agents=(Agent("A", (0, 0), (2, 0)),)), "movingai").files)
    ['scene.map', 'scene.scen']
    """
    if isinstance(files, Scene):
        files = {f"{files.name or 'scene'}.json": files.to_json()}
    elif not isinstance(files, Mapping):
        paths = [files] if isinstance(files, (str, PathLike)) else files
        files = {Path(path).name: Path(path).read_text(encoding="utf-8") for path in paths}
    return Converted.from_dict(call("convert", without_none(files=files, to=to, agents=agents)))


def verify(
    certificate: Mapping[str, str] | Certificate | str | PathLike[str], *, time_limit: float | None = None,
    on_progress: OnProgress | None = None, should_stop: ShouldStop | None = None,
) -> Report:
    """Checks a certificate again: its folder, or the texts of its files by their names.

    One that does not hold is no error: its report says so.
    """
    if isinstance(certificate, Certificate):
        certificate = certificate.files
    files = certificate if isinstance(certificate, Mapping) else _bundle.of_folder(certificate)
    request = {"files": files, "limits": limits(time_limit, None, None)}
    return Report.from_dict(call("verify", request, on_progress, should_stop))


def verify_archive(
    archive: str | PathLike[str] | bytes, *, time_limit: float | None = None,
    on_progress: OnProgress | None = None, should_stop: ShouldStop | None = None,
) -> dict[str, Report]:
    """Checks the certificates of one zip archive, by its path or its bytes: a report for each name.

    The time limit is for each of them.

    >>> from giveway import Agent, Scene
    >>> scene = Scene(map=("...",), agents=(Agent("A", (0, 0), (2, 0)),))
    >>> reports = verify_archive(export(scene, solve(scene)).to_zip())
    >>> {name: report.certified for name, report in reports.items()}
    {'solved': 'proved'}
    """
    return {
        name: verify(files, time_limit=time_limit, on_progress=on_progress, should_stop=should_stop)
        for name, files in sorted(_bundle.of_archive(archive).items())
    }


def schema() -> dict[str, Any]:
    """The JSON Schema of all data: ``$defs`` has one of each."""
    read: dict[str, Any] = call("schema", "")
    return read
