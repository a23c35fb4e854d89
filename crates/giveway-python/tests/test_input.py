"""What people hand over: numbers of NumPy, limits, arrays, questions, archives."""

from __future__ import annotations

import dataclasses
import io
import zipfile
from pathlib import Path
from typing import Any

import pytest
from conftest import CLONE, scene

import giveway
from giveway import Agent, Plan, Scene

TWO = Scene(map=("...", "..."), agents=(Agent("A", (0, 0), (2, 0)), Agent("B", (2, 0), (0, 0))))


def place(raised: pytest.ExceptionInfo[giveway.GivewayError]) -> str:
    return raised.value.place


def test_numbers_and_arrays_of_numpy_are_numbers_and_cells() -> None:
    numpy = pytest.importorskip("numpy")
    start: Any = numpy.array([0, 0])
    waypoints: Any = numpy.array([[1, 0], [1, 1]])
    agent = Agent("A", start, (numpy.int64(2), numpy.int32(0)), waypoints=waypoints)
    answer = giveway.solve(
        Scene(map=TWO.map, agents=(agent,)), within=numpy.int64(9), time_limit=numpy.float32(60),
        conflict_limit=numpy.uint8(200))
    assert answer.status == "optimal" and answer.costs is not None and answer.costs.moves == 4
    assert Scene.from_dict(Scene(map=TWO.map, agents=(agent,)).to_dict()).agents[0].waypoints == ((1, 0), (1, 1))


@pytest.mark.parametrize("limit", [
    {"time_limit": -1}, {"time_limit": float("nan")}, {"time_limit": "3"}, {"conflict_limit": -1},
    {"conflict_limit": 1.5}, {"memory_limit": "1 GB"}, {"memory_limit": 2**64}, {"time_limit": -10**400},
])
def test_limits_are_judged(limit: Any) -> None:
    with pytest.raises(giveway.BadInput) as raised:
        giveway.solve(TWO, **limit)
    assert [place(raised)] == list(limit)


def test_an_infinite_time_is_no_limit() -> None:
    for endless in (float("inf"), 10**400):
        assert giveway.solve(TWO, time_limit=endless, memory_limit=8_000_000_000).status == "optimal"
    assert giveway.solve(TWO, time_limit=0).status == "unknown"


def test_costs_can_have_spaces_and_lists_of_any_kind_are_lists() -> None:
    assert set(giveway.solve(TWO, objective=" moves, waits ").bounds) == {"moves", "waits"}
    names = dict.fromkeys(("B", "A"))
    answer = giveway.solve(TWO, planner="prioritised", order=names.keys())  # type: ignore[call-overload]
    assert answer.status == "feasible"


@pytest.mark.parametrize(("array", "agents"), [
    ([[[0, 0], [1, 0]]], ["A", "B"]),
    ([[[0, 0]], [[1, 0]]], ["A"]),
    ([[[0, 0]], [[1, 0]]], ["A", "A"]),
    ([[[0], [1]]], ["A"]),
    ([[0, 0], [1, 0]], ["A"]),
    ([[[0, 0], [1, 0]], [[1, 0]]], ["A", "B"]),
    ([[[0.5, 0], [1, 0]]], ["A"]),
    ([[[float("nan"), 0], [1, 0]]], ["A"]),
    ([[[-1, -1], [-1, -1]]], ["A"]),
    ([[[float("inf"), 0], [1, 0]]], ["A"]),
    ([[[1e300, 1e300], [1, 0]]], ["A"]),
    ([[[2**63, 2**63], [1, 0]]], ["A"]),
    ([[[-5, -7], [1, 0]]], ["A"]),
    ([[[-1, 3], [1, 0]]], ["A"]),
    ([[]], ["A"]),
])
def test_arrays_that_are_no_plan_are_refused(array: Any, agents: list[str]) -> None:
    pytest.importorskip("numpy")
    with pytest.raises(giveway.BadInput) as raised:
        Plan.from_numpy(array, agents)
    assert place(raised) == "array"


def test_agents_have_names() -> None:
    pytest.importorskip("numpy")
    with pytest.raises(giveway.BadInput) as raised:
        Plan.from_numpy([[[0, 0]]], [0])  # type: ignore[list-item]
    assert place(raised) == "agents"


def test_an_array_comes_back_as_the_plan_that_it_was() -> None:
    pytest.importorskip("numpy")
    rules = giveway.Rules(at_goal="vanish")
    for one in (TWO, Scene(map=TWO.map, agents=TWO.agents, rules=rules), Scene.from_dict(scene("seed/warehouse"))):
        plan = giveway.solve(one).plan
        assert plan is not None
        again = Plan.from_numpy(plan.to_numpy(), list(plan.paths))
        assert again.paths == plan.paths
    late = Plan({"A": ((0, 0), (1, 0))}, start_times={"A": 2})
    assert Plan.from_numpy(late.to_numpy().astype(float), ["A"]) == late


@pytest.mark.parametrize(("question", "at", "expected"), [
    ("sing", "question", "one of wait, charge"),
    ("wait", "question", "giveway explain"),
    ("wait 'A", "question", "No closing quotation"),
    ("wait Z", "question.agent", "one of A, B"),
    ("wait A", "question", "what is so, such as \"arrival A\""),
])
def test_a_question_that_cannot_be_asked_has_one_fault_with_its_place(question: str, at: str, expected: str) -> None:
    plan = giveway.solve(TWO).plan
    with pytest.raises(giveway.BadInput) as raised:
        giveway.explain(TWO, question, plan)
    [fault] = raised.value.faults
    assert fault.place == at and expected in fault.expected
    assert str(fault).count("found ") == 1 and str(fault).count(", expected ") == 1


def test_an_archive_is_verified_by_its_names(tmp_path: Path) -> None:
    reports = giveway.verify_archive(CLONE / "docs/optima/certificates.zip")
    assert len(reports) == 6 and {report.certified for report in reports.values()} == {"proved"}
    made = giveway.export(TWO, giveway.solve(TWO))
    assert giveway.verify(made.certificates["solved"]).accepted
    packed = made.to_zip()
    path = tmp_path / "answer.zip"
    path.write_bytes(packed)
    with zipfile.ZipFile(path) as archive:
        archive.extractall(tmp_path / "out")
    assert giveway.verify(tmp_path / "out/solved").accepted
    changed = io.BytesIO()
    with zipfile.ZipFile(path) as archive, zipfile.ZipFile(changed, "w") as other:
        for name in archive.namelist():
            other.writestr(name, archive.read(name).replace(b'"optimal"', b'"Optimal"').replace(b"2", b"1"))
    assert not giveway.verify_archive(changed.getvalue())["solved"].accepted
    methods = {b"\x0c": "bzip2", b"\x0e": "LZMA", b"\x63": "none that is known"}
    # Damaged here and there, also in the method of its packing: in the head of a file and of the list.
    at = [packed.index(b"PK\x03\x04") + 8, packed.index(b"PK\x01\x02") + 10]
    damaged = [packed[:at[0]] + one + packed[at[0] + 1:at[1]] + one + packed[at[1] + 1:] for one in methods]
    for wrong in (b"", packed[:100], b"PK" + packed[5:], *damaged):
        with pytest.raises(giveway.BadText) as raised:
            giveway.verify_archive(wrong)
        assert place(raised) == "archive"


def test_a_scene_is_converted_without_a_file() -> None:
    one = Scene(map=("...",), agents=(Agent("A", (0, 0), (2, 0)),), name="aisle")
    files = giveway.convert(one, "movingai").files
    assert files.keys() == {"aisle.map", "aisle.scen"}
    assert giveway.convert(one.to_dict(), "movingai").files == files
    # A name is no path, wherever the files are written.
    astray = dataclasses.replace(one, name="../a/b")
    assert all("/" not in name and not name.startswith(".") for name in giveway.convert(astray, "movingai").files)


def test_a_scene_comes_back_as_it_was() -> None:
    own = dataclasses.replace(TWO, rules=giveway.Rules(at_goal="vanish"), objective=("moves",))
    for one in (TWO, own):
        assert Scene.from_json(one.to_json()) == Scene.from_dict(one.to_dict()) == one
        assert hash(Scene.from_dict(one.to_dict())) == hash(one)


def test_equal_plans_are_one_in_a_set() -> None:
    plan, again = giveway.solve(TWO).plan, giveway.solve(TWO.to_dict()).plan
    assert plan is not None and again is not None
    assert len({plan, again, Plan({"A": ((0, 0),)})}) == 2
    assert plan.scene == again.scene == TWO, "plain data is a scene to be drawn with, too"


def test_agents_that_vanish_are_gone_whatever_the_scene_was_given_as() -> None:
    gone = dataclasses.replace(TWO, rules=giveway.Rules(at_goal="vanish"))
    for given in (gone, gone.to_dict()):
        plan = giveway.solve(given).plan
        assert plan is not None and plan.at(9) == {"A": None, "B": None}
