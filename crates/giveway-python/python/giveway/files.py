"""Files of scenes, plans and certificates: read, written in other formats, checked again."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from os import PathLike
from typing import Any, Literal, Union

from giveway import _bundle
from giveway._door import OnProgress, ShouldStop, call, without_none
from giveway._limits import limits
from giveway._request import texts
from giveway.answers import Certificate, Converted, Files, Format, Report, on
from giveway.scene import Scene

#: Texts by the names of their files, or paths.
AnyFiles = Union[Mapping[str, str], str, "PathLike[str]", Sequence[Union[str, "PathLike[str]"]]]


def read_files(
    files: AnyFiles, *, agents: int | None = None, conventions: Mapping[str, str] | None = None,
    at_goal: Literal["stay", "vanish"] | None = None, battery_floor: int | None = None,
) -> Files:
    """Reads files that belong together, of any planner: a scene, and the plans for it.

    What a format leaves open (rows or columns first, from 0 or 1, up or down) is read as it fits best;
    the plan says how, and why. ``agents`` takes the first of a scenario; ``conventions`` says how to read:
    ``cells``, ``origin`` and ``up``, as an alternative of a plan has them. ``at_goal`` and ``battery_floor``
    set the rules instead of the files.

    >>> read = read_files({
    ...     "a.map": "type octile\\nheight 1\\nwidth 3\\nmap\\n...\\n",
    ...     "a.scen": "version 1\\n0 a.map 3 1 0 0 2 0 2\\n",
    ...     "paths.txt": "Agent 0: (0,0)->(0,1)->(0,2)->\\n",
    ... })
    >>> read.plans[0].conventions["cells"], list(read.plans[0].plan.paths.values())
    ('row, column', [((0, 0), (1, 0), (2, 0))])
    """
    read = call("read-files", without_none(
        files=texts(files), agents=agents, conventions=conventions,
        at_goal=at_goal, battery_floor=battery_floor,
    ))
    gathered = Files._of(read)
    return on(gathered.scene, gathered)


def convert(
    files: AnyFiles | Scene | Mapping[str, Any], to: Format, agents: int | None = None,
) -> Converted:
    """Writes instances and plans in another format: ``giveway``, ``movingai``, ``tracker``,
    ``paths.txt``, ``result.txt``, ``multi-robot``, ``lorr``, ``asprilo``, ``mapfw``,
    ``class-project`` or ``grid``.

    Files are texts by their names, or paths; a scene stands for its file.

    >>> from giveway import Agent, Scene
    >>> sorted(convert(Scene(map=("...",), agents=(Agent("A", (0, 0), (2, 0)),)), "movingai").files)
    ['scene.map', 'scene.scen']
    """
    request = without_none(files=texts(files), to=to, agents=agents)
    return Converted.from_dict(call("convert", request))


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

    >>> from giveway import Agent, Scene, export, solve
    >>> scene = Scene(map=("...",), agents=(Agent("A", (0, 0), (2, 0)),))
    >>> reports = verify_archive(export(scene, solve(scene)).to_zip())
    >>> {name: report.certified for name, report in reports.items()}
    {'solved': 'proved'}
    """
    return {
        name: verify(files, time_limit=time_limit, on_progress=on_progress, should_stop=should_stop)
        for name, files in sorted(_bundle.of_archive(archive).items())
    }
