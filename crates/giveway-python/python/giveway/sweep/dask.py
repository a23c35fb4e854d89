"""A sweep on a Dask cluster: Dask schedules, this module only says what and keeps the rows.

Workers must see the files under the same paths as the client. A worker that is lost loses the task
that it was at, which Dask gives to another one; a client that is lost loses no row that was kept.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from distributed import as_completed

from giveway import sweep
from giveway.sweep import AnyPath, Results
from giveway.sweep._chains import Chain, OnRow, chains

if TYPE_CHECKING:
    from distributed import Client

__all__ = ["run"]


def run(
    spec: AnyPath,
    client: Client,
    results: AnyPath,
    *,
    files: AnyPath | None = None,
    name: str = "dask",
    on_row: OnRow | None = None,
) -> int:
    """Does the tasks of a spec that have no row yet; gives how many were done.

    Rows go into the folder ``results``. Where the spec says ``skip-after``, the next task of a series
    is given out when the one before is done.
    """
    every = sweep.tasks(spec, files)
    with Results(results, name) as kept:
        owners = {}
        completed = as_completed()

        def go_on(chain: Chain) -> None:
            task = chain.next()
            if task is not None:
                future = client.submit(sweep.run, task, pure=False)
                owners[future.key] = chain
                completed.add(future)

        for chain in chains(every, kept, on_row):
            go_on(chain)
        count = 0
        for future in completed:
            chain = owners.pop(future.key)
            chain.keep(future.result())
            count += 1
            go_on(chain)
        return count
