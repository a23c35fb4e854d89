"""A sweep on a Ray cluster: Ray schedules, this module only says what and keeps the rows.

Connect with ``ray.init`` before, or it starts Ray on this machine. Workers must see the files under
the same paths as the driver. A worker that is lost loses the task that it was at, which Ray gives to
another one; a driver that is lost loses no row that was kept.
"""

from __future__ import annotations

from itertools import islice
from typing import Any

import ray

from giveway import sweep
from giveway.sweep import AnyPath, Results
from giveway.sweep._chains import Chain, OnRow, chains

__all__ = ["run"]

#: Tasks that are given to Ray at once, so that waiting for one of them is quick.
_AT_ONCE = 1000


def run(
    spec: AnyPath,
    results: AnyPath,
    *,
    files: AnyPath | None = None,
    name: str = "ray",
    on_row: OnRow | None = None,
) -> int:
    """Does the tasks of a spec that have no row yet, one on each CPU; gives how many were done.

    Rows go into the folder ``results``. Where the spec says ``skip-after``, the next task of a series
    is given out when the one before is done.
    """
    every = sweep.tasks(spec, files)
    do: Any = ray.remote(num_cpus=1, max_retries=-1)(sweep.run)
    with Results(results, name) as kept:
        waiting = iter(chains(every, kept, on_row))
        running: dict[Any, Chain] = {}

        def go_on(chain: Chain) -> None:
            task = chain.next()
            if task is not None:
                running[do.remote(task)] = chain

        count = 0
        while True:
            for chain in islice(waiting, max(0, _AT_ONCE - len(running))):
                go_on(chain)
            if not running:
                return count
            done, _ = ray.wait(list(running))
            for reference in done:
                chain = running.pop(reference)
                chain.keep(ray.get(reference))
                count += 1
                go_on(chain)
