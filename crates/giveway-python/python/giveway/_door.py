"""The door to the part in Rust: requests as JSON, errors raised."""

from __future__ import annotations

import json
import threading
from collections.abc import Callable, Mapping
from typing import Any

from giveway import _native
from giveway._misfit import Misfit
from giveway._plain import plain
from giveway.errors import CODES, Fault

#: An event on the way to an answer, in the shapes of the JSON: its ``event`` is ``bound``,
#: ``plan``, ``size``, ``explained`` or ``certifying``.
Progress = dict[str, Any]
OnProgress = Callable[[Progress], object]
ShouldStop = Callable[[], bool]


def call(
    function: str,
    request: Mapping[str, Any] | str,
    on_progress: OnProgress | None = None,
    should_stop: ShouldStop | None = None,
) -> Any:
    """Calls a function of the part in Rust; other threads run meanwhile. A text is JSON already."""
    hear = None
    if on_progress is not None:
        listener = on_progress

        def hear(text: str) -> object:
            return listener(json.loads(text))

    text = request if isinstance(request, str) else as_json(request)
    in_main = threading.current_thread() is threading.main_thread()
    answered, answer = _native.call(function, text, hear, should_stop, in_main)
    if answered:
        return json.loads(answer)
    failure = json.loads(answer)
    raise CODES[failure["code"]](tuple(Fault.from_dict(fault) for fault in failure["faults"]))


def as_json(value: Any) -> str:
    """JSON of records and plain data."""
    try:
        return json.dumps(plain(value), separators=(",", ":"))
    except Misfit as misfit:
        raise misfit.refusal() from None


def without_none(**values: Any) -> dict[str, Any]:
    """What is given."""
    return {name: value for name, value in values.items() if value is not None}
