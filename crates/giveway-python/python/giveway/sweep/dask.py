"""A sweep on a Dask cluster: Dask schedules, this module only says what and keeps the rows.

Workers must see the files under the same paths as the client. A worker that is lost loses the task
that it was at, which Dask gives to another one; a client that is lost loses no row that was kept.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from distributed import as_completed

from giveway import sweep
from giveway.sweep import AnyPath, Results, Row, Sweep, Task

if TYPE_CHECKING:
    from distributed import Client

__all__ = ["run"]


def run(
    spec: AnyPath, client: Client, results: AnyPath, *, name: str = "dask", on_row: Callable[[Row], object] | None = None,
) -> int:
    """Does the tasks of a spec that have no row yet; gives how many were done.

    Rows go into the folder ``results``. Where the spec says ``skip-after``, the next task of a series
    is given out when the one before is done.
    """
    every = sweep.tasks(spec)
    with Results(results, name) as kept:
        chains = [_Chain(chain, every.skip_after, kept) for chain in _chains(every)]
        owners = {}
        completed = as_completed()

        def go_on(chain: _Chain) -> None:
            task = chain.next(on_row)
            if task is not None:
                future = client.submit(sweep.run, task, pure=False)
                owners[future.key] = (chain, task)
                completed.add(future)

        for chain in chains:
            go_on(chain)
        count = 0
        for future in completed:
            chain, task = owners.pop(future.key)
            row = future.result()
            kept.add(row)
            chain.note(row)
            count += 1
            if on_row is not None:
                on_row(row)
            go_on(chain)
        return count


def _chains(every: Sweep) -> list[list[Task]]:
    """Tasks that are done one after the other."""
    return list(every.series().values()) if every.skip_after is not None else [[task] for task in every.tasks]


class _Chain:
    """The tasks of a series that are left."""

    def __init__(self, tasks: list[Task], skip_after: int | None, kept: Results) -> None:
        self._left = list(reversed(tasks))
        self._skip_after = skip_after
        self._kept = kept
        self._misses = 0

    def note(self, row: Row) -> None:
        self._misses = 0 if sweep.is_success(row) else self._misses + 1

    def next(self, on_row: Callable[[Row], object] | None) -> Task | None:
        """The next task to be done; those that have a row, or are skipped, are passed over."""
        while self._left:
            task = self._left.pop()
            known = self._kept.done.get(task.name)
            if known is None and self._skip_after is not None and self._misses >= self._skip_after:
                known = sweep.skipped(task)
                self._kept.add(known)
                if on_row is not None:
                    on_row(known)
            if known is None:
                return task
            self.note(known)
        return None
