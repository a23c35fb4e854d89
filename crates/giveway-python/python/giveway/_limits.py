"""The budget of a request, judged before it is sent."""

from __future__ import annotations

import math
import operator
from typing import Any

from giveway.errors import refusal


def limits(
    time_limit: float | None, conflict_limit: int | None, memory_limit: int | None, work_limit: int | None = None,
) -> dict[str, Any]:
    """The limits that are given; an infinite time is none."""
    given = {
        "seconds": _seconds(time_limit),
        "conflicts": _count("conflict_limit", conflict_limit),
        "work": _count("work_limit", work_limit),
        "memory_bytes": _count("memory_limit", memory_limit),
    }
    return {name: value for name, value in given.items() if value is not None}


def _seconds(value: Any) -> float | None:
    if value is None:
        return None
    try:
        seconds = math.nan if isinstance(value, (str, bytes)) or not hasattr(value, "__float__") else float(value)
    except OverflowError:
        seconds = math.inf if value > 0 else math.nan
    if not seconds >= 0:
        raise refusal("time_limit", repr(value), "seconds, 0 or more")
    return None if math.isinf(seconds) else seconds


def _count(name: str, value: Any) -> int | None:
    if value is None:
        return None
    try:
        count = operator.index(value)
    except TypeError:
        count = -1
    if not 0 <= count < 2**64:
        raise refusal(name, repr(value), "a whole number, 0 or more")
    return count
