"""Sweeps: benchmarks of many instances, as ``giveway sweep`` does them.

A spec (a file of TOML) says what is combined with what; :func:`tasks` lists it, :func:`run` does
one task, :class:`Results` keeps the rows, one line of JSON each, and :func:`table` makes tables and
plots of them. :mod:`giveway.sweep.dask` and :mod:`giveway.sweep.ray` do the tasks on a cluster.
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterable
from dataclasses import dataclass
from os import PathLike
from pathlib import Path
from types import TracebackType
from typing import Any, Literal, Union

from giveway._door import call

__all__ = ["AnyPath", "Results", "Row", "Show", "Sweep", "Task", "run", "skipped", "table", "tasks"]

AnyPath = Union[str, "PathLike[str]"]
#: One result, in the shape of its line.
Row = dict[str, Any]
Show = Literal["summary", "rows", "optima", "success", "cactus", "planners"]
Written = Literal["markdown", "csv", "svg", "html"]


@dataclass(frozen=True)
class Task:
    """One thing to do. It can be sent to another process or machine that sees the same files."""

    #: What tells it from all other tasks.
    name: str
    #: What it has in common with tasks of other numbers of agents.
    series: str
    #: The folder of the spec, from which the path of the instance starts.
    folder: str
    #: What is to be done, in the shape of ``giveway sweep --list``.
    data: dict[str, Any]


@dataclass(frozen=True)
class Sweep:
    """The tasks of a spec, easy ones first."""

    tasks: tuple[Task, ...]
    #: After so many tasks of a series in a row without success, larger ones are skipped.
    skip_after: int | None

    def series(self) -> dict[str, list[Task]]:
        """The tasks by their series."""
        series: dict[str, list[Task]] = {}
        for task in self.tasks:
            series.setdefault(task.series, []).append(task)
        return series


def tasks(spec: AnyPath, files: AnyPath | None = None) -> Sweep:
    """Reads a spec, and lists its tasks; its paths start from its own folder, or from ``files``."""
    place = None if files is None else os.fspath(files)
    listed = call("sweep-tasks", {"spec": os.fspath(spec), "files": place})
    folder = str(Path(listed["folder"]).absolute())
    named = (Task(task["name"], task["series"], folder, task["task"]) for task in listed["tasks"])
    return Sweep(tuple(named), listed["skip_after"])


def run(task: Task) -> Row:
    """Does a task in this process."""
    row: Row = call("sweep-run", {"folder": task.folder, "task": task.data})
    return row


def skipped(task: Task) -> Row:
    """The row of a task that is not tried."""
    row: Row = call("sweep-skipped", {"folder": task.folder, "task": task.data})
    return row


def is_success(row: Row) -> bool:
    """Whether a planner did what it promises: a proof, or a plan of one that proves nothing."""
    proves = row["planner"] in ("search", "cbs")
    return row["status"] in ("optimal", "impossible") or (row["status"] == "feasible" and not proves)


class Results:
    """A folder of rows, as ``giveway sweep`` writes it; this one appends to a file of its own.

    A row is appended whole. What a process that was killed left of a row is cut off.
    """

    def __init__(self, folder: AnyPath, name: str) -> None:
        """Opens a folder, made if there is none; nobody else may append under the same name."""
        self.folder = Path(folder)
        self.folder.mkdir(parents=True, exist_ok=True)
        rows: list[Row] = call("sweep-rows", {"results": [str(self.folder)]})
        #: The rows of the folder by their tasks' names, whoever wrote them.
        self.done = {row["task"]: row for row in rows}
        path = self.folder / f"results-{name}.jsonl"
        self._file = path.open("ab+")
        self._file.seek(0)
        self._file.truncate(self._file.read().rfind(b"\n") + 1)

    def add(self, row: Row) -> None:
        """Appends a row. When it returns, the row has reached the disk, but for one that was skipped."""
        self._file.write(json.dumps(row, separators=(",", ":")).encode() + b"\n")
        self._file.flush()
        if row["status"] != "skipped":
            os.fsync(self._file.fileno())
        self.done[row["task"]] = row

    def __enter__(self) -> Results:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None,
    ) -> None:
        self._file.close()


def table(results: AnyPath | Iterable[AnyPath], show: Show = "summary", to: Written = "markdown") -> str:
    """A table or a plot of folders or files of results."""
    paths = [results] if isinstance(results, (str, PathLike)) else list(results)
    text: str = call("sweep-table", {"results": [os.fspath(path) for path in paths], "show": show, "to": to})
    return text
