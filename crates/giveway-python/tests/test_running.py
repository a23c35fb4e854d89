"""What happens while a request is served: threads, callbacks, limits, signals, errors."""

from __future__ import annotations

import os
import pickle
import signal
import threading
import time
from typing import Any

import pytest
from conftest import scene

import giveway

HARD = "mmapf/A17_mm_20x20_o15_a30"


def test_another_thread_runs_meanwhile() -> None:
    counted = 0
    worker = threading.Thread(target=lambda: giveway.solve(scene(HARD), time_limit=1))
    worker.start()
    while worker.is_alive():
        time.sleep(0.01)
        counted += 1
    assert counted > 20


def test_limits_end_in_what_is_known() -> None:
    begin = time.monotonic()
    answer = giveway.solve(scene(HARD), time_limit=0.5)
    assert answer.status in ("feasible", "unknown") and answer.reason
    assert time.monotonic() - begin < 20


def test_progress_is_told_and_a_caller_can_stop() -> None:
    events: list[Any] = []
    answer = giveway.solve(scene(HARD), on_progress=events.append, should_stop=lambda: len(events) > 3)
    assert answer.status in ("feasible", "unknown")
    assert len(events) > 3 and all("event" in event for event in events)


def test_what_a_callback_raises_is_raised() -> None:
    def listen(event: giveway.Progress) -> None:
        raise LookupError("enough")

    with pytest.raises(LookupError, match="enough"):
        giveway.solve(scene(HARD), on_progress=listen)


def test_control_c_is_heard() -> None:
    # A shell that runs this in the background has it ignored.
    signal.signal(signal.SIGINT, signal.default_int_handler)
    timer = threading.Timer(0.5, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        giveway.solve(scene(HARD), time_limit=60)


def test_errors_have_their_place() -> None:
    wrong = scene("seed/warehouse")
    wrong["agents"][1]["goal"] = [2, 1]
    with pytest.raises(giveway.BadScene) as raised:
        giveway.solve(wrong)
    assert raised.value.place == "scene.agents[1].goal"
    assert "found the obstacle (2, 1)" in str(raised.value)
    assert pickle.loads(pickle.dumps(raised.value)).faults == raised.value.faults
    with pytest.raises(giveway.BadInput) as input_raised:
        giveway.solve(scene("seed/warehouse"), objective="time")
    assert input_raised.value.place == "objective[0]"
    with pytest.raises(giveway.BadText) as text_raised:
        giveway.Scene.from_json('{ "giveway": 1,\n "mapp": [] }')
    assert text_raised.value.faults[0].line == 2


def test_python_takes_little_time() -> None:
    a05 = giveway.Scene.from_dict(scene("mmapf/A05_mm_10x10_o10_a10"))

    def overhead() -> float:
        begin = time.thread_time()
        answer = giveway.solve(a05)
        return time.thread_time() - begin - answer.stats.cpu_seconds

    assert min(overhead() for _ in range(3)) < 0.005
