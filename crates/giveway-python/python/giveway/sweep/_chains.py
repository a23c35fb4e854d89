"""What a cluster is given next: the tasks of a sweep as chains, each done one after the other.

Where a spec says ``skip-after``, a chain is a series; else it is one task.
"""

from __future__ import annotations

from collections.abc import Callable

from giveway import sweep
from giveway.sweep import Results, Row, Sweep, Task

OnRow = Callable[[Row], object]


class Chain:
    """Tasks of which the next is given out when the one before is done."""

    def __init__(self, tasks: list[Task], skip_after: int | None, kept: Results, on_row: OnRow | None) -> None:
        self._left = list(reversed(tasks))
        self._skip_after = skip_after
        self._kept = kept
        self._on_row = on_row
        self._misses = 0

    def keep(self, row: Row) -> None:
        """Keeps the row of the task that was given out last, or was skipped."""
        self._kept.add(row)
        self._note(row)
        if self._on_row is not None:
            self._on_row(row)

    def next(self) -> Task | None:
        """The next task to be done; those that have a row, or are skipped, are passed over."""
        while self._left:
            task = self._left.pop()
            skips = self._skip_after is not None and self._misses >= self._skip_after
            known = self._kept.done.get(task.name)
            # What was skipped, or could not be read, may be worth trying now.
            if known is not None and (skips or known["status"] not in ("skipped", "error")):
                self._note(known)
            elif skips:
                self.keep(sweep.skipped(task))
            else:
                return task
        return None

    def _note(self, row: Row) -> None:
        if row["status"] != "error":  # without an instance no planner missed anything
            self._misses = 0 if sweep.is_success(row) else self._misses + 1


def chains(every: Sweep, kept: Results, on_row: OnRow | None) -> list[Chain]:
    """The chains of a sweep, easy ones first."""
    series = every.series().values() if every.skip_after is not None else ([task] for task in every.tasks)
    return [Chain(list(tasks), every.skip_after, kept, on_row) for tasks in series]
