"""The answers are those that were recorded of the command and of the package for JavaScript."""

from __future__ import annotations

import io
import json
import zipfile
from typing import Any

import pytest
from conftest import CLONE, DATA, RECORDED, read, scene

import giveway

CASES = [
    ("warehouse", "seed/warehouse", {}),
    ("warehouse-charges", "seed/warehouse", {"objective": "charges,makespan"}),
    ("scenario-1", "seed/scenario-1", {}),
    ("scenario-6", "seed/scenario-6", {}),
    ("dynamic-3x3", "seed/dynamic-3x3", {}),
    ("A05", "mmapf/A05_mm_10x10_o10_a10", {}),
    ("A10", "mmapf/A10_mm_15x15_o15_a16", {}),
    ("B09", "mmapf/B09_cl_16x16_e_a30", {"objective": ["sum-of-costs"]}),
    ("A05-cut-short", "mmapf/A05_mm_10x10_o10_a10", {"conflict_limit": 100}),
]


def timeless(answer: Any) -> Any:
    """The answer with all its seconds 0, as they were recorded."""
    text = json.dumps(answer)
    return json.loads(text, object_hook=lambda data: {**data, "cpu_seconds": 0.0} if "cpu_seconds" in data else data)


@pytest.mark.parametrize(("name", "of", "options"), CASES, ids=[name for name, _, _ in CASES])
def test_solve(name: str, of: str, options: dict[str, Any]) -> None:
    answer = giveway.solve(giveway.Scene.from_file(DATA / f"{of}.json"), **options)
    assert timeless(answer.to_dict()) == timeless(read(RECORDED / f"{name}.json"))
    # Plain data is taken as well, and gives the same.
    assert giveway.solve(scene(of), **options).plan == answer.plan


def test_pareto() -> None:
    front = giveway.pareto(scene("seed/warehouse"), "makespan,charges")
    assert timeless(front.to_dict()) == timeless(read(RECORDED / "front.json"))


@pytest.mark.parametrize(("name", "plan"), [
    ("change-3x3", "dynamic-3x3.plan"), ("change-3x3-later", "dynamic-3x3.plan-t1"),
])
def test_change(name: str, plan: str) -> None:
    answer = giveway.change(
        scene("seed/dynamic-3x3"), scene(f"seed/{plan}"), scene("seed/dynamic-3x3.changes"),
        methods=["revise", "tunnel=1", "replan"])
    assert timeless(answer.to_dict()) == timeless(read(RECORDED / f"{name}.json"))
    assert answer.plan == answer.methods[str(answer.adopted)].plan


def test_random_instances() -> None:
    rows = read(RECORDED / "random.json")
    assert len(rows) > 40
    for row in rows:
        limits = {f"{key[:-1] if key == 'conflicts' else key}_limit": most for key, most in row["limits"].items()}
        answer = giveway.solve(row["scene"], **limits)
        plan = None if answer.plan is None else answer.plan.to_json()
        kept = json.dumps(json.loads(row["plan"]), separators=(",", ":"))
        assert (answer.status, answer.ended, plan or "null") == (row["status"], row["ended"], kept)


def test_other_functions() -> None:
    warehouse = giveway.Scene.from_file(DATA / "seed/warehouse.json")
    plan = giveway.solve(warehouse).plan
    assert plan is not None and plan.scene is warehouse
    assert giveway.check(warehouse, plan).valid
    audited = giveway.audit(warehouse, plan)
    assert (audited.legal, audited.status, audited.gap) == (True, "optimal", 0.0)
    by_words = giveway.explain(warehouse, "charges A1", plan)
    by_data = giveway.explain(warehouse, {"kind": "charges", "agent": "A1"}, plan)
    assert by_words.words == by_data.words and by_words.verdict == by_data.verdict
    assert giveway.Explanation.from_dict(by_words.to_dict()) == by_words
    assert not giveway.verify(DATA / "wrong/f2-conclusion").accepted


def test_certificates_are_made_of_every_kind_of_answer_and_hold() -> None:
    pocket = {
        "giveway": 1, "map": ["....", "#.##"],
        "agents": [{"name": "a", "start": [0, 0], "goal": [3, 0]}, {"name": "b", "start": [3, 0], "goal": [0, 0]}],
    }
    answer = giveway.solve(pocket, objective="sum-of-costs")
    asked = giveway.explain(pocket, "arrival a", answer.plan, objective="sum-of-costs")
    free = giveway.freedom(pocket, answer.plan, objective="sum-of-costs")
    cases: list[tuple[Any, set[str] | None]] = [
        (answer, {"solved"}), (answer.to_dict(), {"solved"}), (asked, {"explained"}), (free, None),
    ]
    for told, names in cases:
        made = giveway.export(pocket, told, answer.plan, objective="sum-of-costs")
        assert made.missing == 0 and (names is None or set(made.certificates) == names)
        assert names is not None or len(made.certificates) > 3
        for one in made.certificates.values():
            assert one.report.accepted
            assert giveway.verify(one.files) == one.report
        with zipfile.ZipFile(io.BytesIO(made.to_zip())) as archive:
            texts = {name: archive.read(name).decode() for name in archive.namelist()}
        assert texts == {f"{name}/{file}": text for name, one in made.certificates.items() for file, text in one.files.items()}
        assert made.to_zip() == made.to_zip()
    solved = giveway.export(pocket, answer, objective="sum-of-costs").certificates["solved"]
    assert solved.report.certified == "proved" and solved.report.concluded is not None
    assert giveway.export(pocket, answer, time_limit=0).missing == 1
    audited = giveway.audit(pocket, answer.plan or {})
    for other in ({"status": "optimal"}, audited, audited.to_dict(), None):
        with pytest.raises(giveway.BadInput) as raised:
            giveway.export(pocket, other)  # type: ignore[arg-type]
        assert raised.value.place == "answer"


def test_together_looks_at_a_step_of_a_proof() -> None:
    a05 = scene("mmapf/A05_mm_10x10_o10_a10")
    trace = giveway.solve(a05, objective="sum-of-costs", trace=True).trace
    assert trace is not None
    cores = [event for event in trace["events"] if event["event"] == "core" and not event.get("sums")]
    small = min(cores, key=lambda core: len(core["limits"]))
    answer = giveway.together(a05, small["cost"], small["limits"])
    assert answer.alone is not None and answer.alone.refuted is True
    assert [region["agent"] for region in answer.regions] == [limit["agent"] for limit in small["limits"]]
    assert [agent.name for agent in answer.alone.scene.agents] == [limit["agent"] for limit in small["limits"]]
    with pytest.raises(giveway.BadInput) as raised:
        giveway.together(a05, "sum-of-costs", [{"agent": "nobody", "least": 1, "at_most": 1}])
    assert raised.value.place == "agents[0].agent"


@pytest.mark.parametrize("planner", ["prioritised", "cbs", "pibt", "lacam", "lns"])
def test_planners(planner: Any) -> None:
    answer = giveway.solve(scene("seed/dynamic-3x3"), planner=planner, time_limit=20)
    assert answer.planner == planner and answer.plan is not None
    assert giveway.check(scene("seed/dynamic-3x3"), answer.plan).valid
    assert answer.status == ("optimal" if planner == "cbs" else "feasible")


def test_files_as_people_bring_them_are_read() -> None:
    folder = CLONE / "crates/giveway-formats/tests/data/brought"
    expected = {"utf16.map": ("....",), "bare.txt": ("...", ".#.", "..#"), "rows.txt": ("...", ".#."), "clingo.txt": ("..",)}
    for name, rows in expected.items():
        assert giveway.read_files([folder / name]).scene.map == rows
    lane = giveway.read_files([folder / "lane.json", folder / "solve-result.json"])
    assert giveway.check(lane.scene, lane.plans[0].plan).valid
    with pytest.raises(giveway.BadText, match="PNG"):
        giveway.read_files([CLONE / "docs/playground.png"])


def test_plans_of_other_programs_are_read_and_compared() -> None:
    folder = CLONE / "crates/giveway-formats/tests/data/plans"
    read = giveway.read_files([folder / name for name in ("small.map", "small.scen", "small-paths.txt")])
    [foreign] = read.plans
    assert (foreign.format, foreign.fit["misfits"], foreign.plan.scene) == ("paths.txt", 0, read.scene)
    assert giveway.check(read.scene, foreign.plan).valid and foreign.why
    assert giveway.Files.from_json(read.to_json()) == read
    other = dict(foreign.conventions, cells="column, row")
    texts = {path.name: path.read_text() for path in (folder / "small.map", folder / "small.scen", folder / "small-paths.txt")}
    assert giveway.read_files(texts, conventions=other).plans[0].plan != foreign.plan
    best = giveway.solve(read.scene).plan
    assert best is not None
    compared = giveway.compare(read.scene, foreign.plan, best.to_dict())
    assert [agent.agent for agent in compared.agents] == list(foreign.plan.paths) and None not in compared.costs
    assert giveway.Comparison.from_dict(compared.to_dict()) == compared
    with pytest.raises(giveway.BadInput) as raised:
        giveway.compare(read.scene, {"paths": {}}, best)
    assert raised.value.place == "plans[0]"


def test_files() -> None:
    folder = DATA / "movingai"
    map, scen = folder / "empty-8-8.map", folder / "empty-8-8-random-1.scen"
    scene_of_files = giveway.Scene.from_movingai(map, scen, agents=3)
    assert (scene_of_files.width, len(scene_of_files.agents)) == (8, 3)
    converted = giveway.convert([map, scen], "giveway", agents=3)
    assert giveway.Scene.from_json(next(iter(converted.files.values()))).agents == scene_of_files.agents


def test_records_have_the_keys_of_the_schema() -> None:
    definitions = giveway.schema()["$defs"]
    shapes: dict[str, type[Any]] = {
        "instance": giveway.Scene, "agent": giveway.Agent, "battery": giveway.Battery, "rules": giveway.Rules,
        "plan": giveway.Plan, "costs": giveway.Costs, "stats": giveway.Stats, "solveResult": giveway.Answer,
        "paretoResult": giveway.Front, "planResult": giveway.PlannerAnswer, "checkResult": giveway.Verdict,
        "witness": giveway.Violation, "explainResult": giveway.Explanation, "changeResult": giveway.ChangeAnswer,
        "freedomResult": giveway.Freedom, "priceResult": giveway.Prices, "rulePrice": giveway.RulePrice,
        "delaysResult": giveway.Delays, "orderResult": giveway.Order, "agentDelay": giveway.AgentDelay,
        "sizingResult": giveway.Sizing, "sizingPoint": giveway.SizingPoint,
    }
    from giveway._record import _fields

    for name, shape in shapes.items():
        keys = {field.key for field in _fields(shape)} | ({"giveway"} if shape.document else set())
        # What the command says of its input is no part of an answer here.
        said = {"assumptions", "notes"} - keys
        assert keys == set(definitions[name]["properties"]) - said, name
