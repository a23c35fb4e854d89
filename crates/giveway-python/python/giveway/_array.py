"""Paths out of an array ``[agent, time, 2]``."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from giveway._misfit import described
from giveway.errors import BadInput, refusal
from giveway.scene import Cell

Paths = dict[str, tuple["Cell | None", ...]]

#: The largest number of a cell that a plan can have.
_MOST = 2**32 - 1


def read(array: Any, agents: Iterable[str]) -> tuple[Paths, dict[str, int]]:
    """The paths by the names of the agents, and when those begin who come later."""
    import numpy

    agents = list(agents)
    for name in agents:
        if not isinstance(name, str):
            raise refusal("agents", described(name), "a text, the name of an agent")
    try:
        given = numpy.asarray(array)
    except ValueError as error:
        raise _bad(str(error), "one shape, [agent, time, 2]") from error
    if given.ndim != 3 or given.shape[1] == 0 or given.shape[2] != 2:
        raise _bad(f"the shape {list(given.shape)}", "[agent, time, 2]")
    if len(given) != len(agents) or len(set(agents)) != len(agents):
        raise _bad(f"the paths of {len(given)} and the names {agents}", "a name of its own for each path")
    if given.dtype.kind not in "iu" and not (given.dtype.kind == "f" and bool(numpy.all(given == given.round()))):
        raise _bad(f"numbers of the type {given.dtype} that are not all whole", "whole numbers")
    outside = ((given < 0) | (given > _MOST)).any(axis=2) & ~(given == -1).all(axis=2)
    if outside.any():
        number, time = numpy.argwhere(outside)[0].tolist()
        raise _bad(f"the cell {given[number, time].tolist()} of {agents[number]} at {time}", "numbers from 0, or -1 twice")
    paths: Paths = {}
    start_times: dict[str, int] = {}
    for name, rows in zip(agents, given.astype("int64").tolist()):
        cells = [None if x < 0 else (x, y) for x, y in rows]
        start = next((time for time, cell in enumerate(cells) if cell is not None), None)
        if start is None:
            raise _bad(f"no cell of {name}", "at least one")
        if start > 0:
            start_times[name] = start
        paths[name] = _cut(cells[start:])
    return paths, start_times


def _cut(path: list[Cell | None]) -> tuple[Cell | None, ...]:
    """A path up to its arrival: behind it an agent stays, or is gone."""
    while path[-1] is None:
        path.pop()
    while len(path) > 1 and path[-1] == path[-2]:
        path.pop()
    return tuple(path)


def _bad(found: str, expected: str) -> BadInput:
    return refusal("array", found, expected)
