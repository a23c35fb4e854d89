"""What does not fit is refused with its place, however it comes: as data, as a text, as a file."""

from __future__ import annotations

import datetime
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import giveway
from giveway import Agent, BadInput, BadScene, BadText, Plan, Scene

A: Any = {"name": "A", "start": [0, 0], "goal": [1, 0]}
SCENE: Any = {"giveway": 1, "map": [".."], "agents": [A]}


@pytest.mark.parametrize(("part", "at", "found"), [
    ({"start": [0, float("nan")]}, "start[1]", "the number nan"),
    ({"start": [0, -float("inf")]}, "start[1]", "the number -inf"),
    ({"start": [0, 10**5000]}, "start[1]", "bits"),
    ({"start": {0, 1}}, "start", "a value of the type set"),
    ({"start": [0, datetime.date.min]}, "start[1]", "a value of the type date"),
    ({"name": b"A"}, "name", "a value of the type bytes"),
    ({"name": Path("A")}, "name", "Path"),
    ({"name": "\ud800"}, "name", "Unicode"),
    ({5: 6}, "", "the key 5"),
])
def test_what_json_cannot_hold_has_its_place(part: Any, at: str, found: str) -> None:
    wrong = {**SCENE, "agents": [{**A, **part}]}
    for place, ask in (("scene.", giveway.solve), ("", Scene.from_dict)):
        with pytest.raises(BadInput) as raised:
            ask(wrong)
        assert raised.value.place == f"{place}agents[0]" + (at and f".{at}")
        assert found in str(raised.value)


def test_data_has_no_line_and_is_told_from_a_scene_that_is_none() -> None:
    cases: list[tuple[Any, type[giveway.GivewayError], str]] = [
        ({**SCENE, "map": 3}, BadInput, "map"), ({**SCENE, "map": ["#."]}, BadScene, "agents[0].start"), (None, BadInput, ""),
    ]
    for wrong, error, place in cases:
        with pytest.raises(error) as raised:
            Scene.from_dict(wrong)
        [fault] = raised.value.faults
        assert (fault.place, fault.line, fault.column) == (place, None, None)
    with pytest.raises(BadInput) as input_raised:
        Plan.from_dict({"giveway": 1, "paths": {"A": [[0, -1]]}})
    assert input_raised.value.place == "paths.A[0][1]" and input_raised.value.faults[0].line is None


@pytest.mark.parametrize(("wrong", "at"), [
    ({}, ""), ([], ""), ({"version": 1}, ""), ({"giveway": 2}, "giveway"), ({"statistics": {}}, ""), ({"stats": None}, "stats"),
    ({"costs": {"makespan": 1}}, "costs"), ({"plan": {"paths": 3}}, "plan.paths"),
    ({"plan": {"paths": {"A": [[0, 0], [1]]}}}, "plan.paths.A[1]"),
])
def test_answers_are_read_strictly(wrong: Any, at: str) -> None:
    answer = giveway.solve(SCENE).to_dict()
    with pytest.raises(BadInput) as raised:
        giveway.Answer.from_dict({**answer, **wrong} if wrong else wrong)
    assert raised.value.place == at
    # A key that is misspelt would be another task.
    with pytest.raises(BadInput, match='unknown key "waypoint"'):
        Agent.from_dict({**A, "waypoint": [[0, 0]]})


def test_texts_have_the_line_of_what_is_none(tmp_path: Path) -> None:
    path = tmp_path / "scene.json"
    path.write_bytes(b'{ "giveway": 1,\r\n "name": "\xff" }')
    readers: list[Callable[[], object]] = [
        lambda: Scene.from_file(path), lambda: Scene.from_json(path.read_bytes()), lambda: Plan.from_json(path.read_bytes()),
        lambda: giveway.Answer.from_json(path.read_bytes()), lambda: giveway.convert(path, "giveway"),
        lambda: Scene.from_movingai(path, path),
    ]
    for read in readers:
        # The byte is a letter of Windows-1252, which is said; what is wrong is the rest.
        with pytest.raises((BadText, giveway.BadInput)) as raised, pytest.warns(UserWarning, match="Windows-1252"):
            read()
        assert "0xFF" not in str(raised.value)
    for text in ("{", "\ud800", '{\n"giveway": }'):
        for record in (Scene, Plan, giveway.Answer):
            with pytest.raises(BadText):
                record.from_json(text)
    with pytest.raises(TypeError):
        Scene.from_json(path)  # type: ignore[arg-type]
    path.write_bytes(b"\xef\xbb\xbf" + Scene.from_dict(SCENE).to_json().encode())
    assert Scene.from_file(path) == Scene.from_json(path.read_bytes()) == Scene.from_dict(SCENE)


def test_what_would_not_be_heeded_is_refused() -> None:
    plan = giveway.solve(SCENE).plan
    wrong: Any
    for wrong in ({"order": ["A"]}, {"planner": "cbs", "conflict_limit": 9}, {"planner": "lns", "start": plan}):
        with pytest.raises(BadInput) as raised:
            giveway.solve(SCENE, **wrong)
        assert raised.value.place == list(wrong)[-1]
    for wrong in (5, ["wait", "A"]):
        with pytest.raises(BadInput) as raised:
            giveway.explain(SCENE, wrong, plan)
        assert raised.value.place == "question"
    with pytest.raises(BadInput) as raised:
        giveway.solve(SCENE, objective=5)  # type: ignore[call-overload]
    assert raised.value.place == "objective"


def test_a_class_is_no_record() -> None:
    with pytest.raises(BadInput, match="a value of the type type"):
        giveway.solve(Scene)  # type: ignore[call-overload]


def test_two_files_of_one_name_are_refused(tmp_path: Path) -> None:
    paths = [tmp_path / name / "a.json" for name in "bc"]
    for path in paths:
        path.parent.mkdir()
        path.write_text(Scene.from_dict(SCENE).to_json())
    with pytest.raises(BadInput) as raised:
        giveway.convert(paths, "movingai")
    assert raised.value.place == "files" and "a.json" in str(raised.value)
    assert list(giveway.convert(paths[0], "movingai").files) == ["a.map", "a.scen"]
    for wrong in (giveway.solve(SCENE).plan, 5, None, b"a.json"):
        with pytest.raises(BadInput) as raised:
            giveway.convert(wrong, "movingai")  # type: ignore[arg-type]
        assert raised.value.place == "files"


def test_an_archive_is_not_taken_for_a_folder(tmp_path: Path) -> None:
    path = tmp_path / "answer.zip"
    path.write_bytes(giveway.export(SCENE, giveway.solve(SCENE)).to_zip())
    with pytest.raises(BadInput, match="verify_archive"):
        giveway.verify(path)
