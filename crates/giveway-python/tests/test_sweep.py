"""Sweeps: the same rows as the command, in one process and on a cluster of which a part is killed."""

from __future__ import annotations

import os
import shutil
import signal
import sys
from pathlib import Path

import pytest
from conftest import DATA

from giveway import BadText, sweep

SPEC = """
objectives = ["sum-of-costs,makespan", "makespan,sum-of-costs", "sum-of-costs", "makespan", "moves"]
planners = ["search", "prioritised"]
conflict-limit = 2000
[[instances]]
files = ["empty-8-8-*.scen"]
agents = { from = 1, to = 25 }
"""


@pytest.fixture
def spec(tmp_path: Path) -> Path:
    for file in (DATA / "movingai").glob("empty-8-8*"):
        shutil.copy(file, tmp_path)
    path = tmp_path / "spec.toml"
    path.write_text(SPEC)
    return path


def rows(results: Path) -> list[str]:
    """Every row, but for the last column, which is time."""
    lines = sweep.table(results, "rows", "csv").splitlines()
    return [line.rsplit(",", 1)[0] for line in lines]


def run_here(spec: Path, results: Path) -> None:
    with sweep.Results(results, "here") as kept:
        for task in sweep.tasks(spec).tasks:
            if task.name not in kept.done:
                kept.add(sweep.run(task))


def test_tasks_are_listed_done_and_shown(spec: Path) -> None:
    spec.write_text(SPEC.replace("to = 25", "to = 2"))
    assert len(sweep.tasks(spec).tasks) == 40
    results = spec.parent / "results"
    run_here(spec, results)
    assert len(rows(results)) == 41
    assert sweep.table(results).startswith("| map |")
    assert sweep.table([results], "cactus", "svg").startswith("<svg")
    spec.write_text("[[instances]]\nfile = []")
    with pytest.raises(BadText, match="line 2"):
        sweep.tasks(spec)


def test_a_row_that_was_cut_off_is_written_again(spec: Path) -> None:
    spec.write_text(SPEC.replace("to = 25", "to = 1"))
    results = spec.parent / "results"
    run_here(spec, results)
    whole = rows(results)
    file = results / "results-here.jsonl"
    file.write_bytes(file.read_bytes()[:-9])
    assert len(rows(results)) == len(whole) - 1
    run_here(spec, results)
    assert rows(results) == whole


def test_what_is_no_row_is_told_with_its_file_and_line(tmp_path: Path) -> None:
    with pytest.raises(BadText) as raised:
        sweep.table(tmp_path / "nowhere")
    assert raised.value.place.endswith("nowhere") and str(raised.value).count("found ") == 1
    for line in ("rows", "3", "{}"):
        (tmp_path / "results-a.jsonl").write_text(line + "\n")
        for read in (lambda: sweep.Results(tmp_path, "b"), lambda: sweep.table(tmp_path)):
            with pytest.raises(BadText, match="found what is no row") as raised:
                read()
            [fault] = raised.value.faults
            assert (fault.place, fault.line) == (str(tmp_path / "results-a.jsonl"), 1)
            assert fault.expected.startswith("a row of a sweep")


def test_rows_are_known_as_the_command_knows_them(spec: Path) -> None:
    spec.write_text(SPEC.replace("to = 25", "to = 1"))
    results = spec.parent / "results"
    task = sweep.tasks(spec).tasks[0]
    with sweep.Results(results, "a") as kept:
        kept.add(sweep.run(task))
    with sweep.Results(results, "b") as kept:
        kept.add(sweep.skipped(task))
    (results / "._results-b.jsonl").write_bytes(b"\0\n")
    with sweep.Results(results, "c") as kept:
        assert kept.done[task.name]["status"] == "optimal", "what was tried stays"


def test_what_could_not_be_read_is_tried_again_and_is_no_miss(spec: Path) -> None:
    from giveway.sweep._chains import chains

    spec.write_text("skip-after = 1\n" + SPEC.replace("to = 25", "to = 2"))
    every = sweep.tasks(spec)
    with sweep.Results(spec.parent / "results", "here") as kept:
        chain = chains(every, kept, None)[0]
        first = chain.next()
        assert first is not None
        row = sweep.run(first)
        chain.keep({**row, "status": "error"})
        second = chain.next()
        assert second is not None and second.series == first.series, "not skipped"
        assert chains(every, kept, None)[0].next() == first
        kept.add(row)
        assert chains(every, kept, None)[0].next() == second


def test_a_cluster_of_which_a_worker_is_killed_has_the_table_of_one_process(spec: Path) -> None:
    distributed = pytest.importorskip("distributed")
    from giveway.sweep import dask

    results = spec.parent / "results"
    killed: list[int] = []
    with (
        distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster,
        distributed.Client(cluster) as client,
    ):
        count = 0

        def kill_half_way(_: sweep.Row) -> None:
            nonlocal count
            count += 1
            if count == 250:
                pid = sorted(client.run(os.getpid).values())[0]
                os.kill(pid, signal.SIGKILL)
                killed.append(pid)

        assert dask.run(spec, client, results, on_row=kill_half_way) == 500
        assert dask.run(spec, client, results) == 0, "all of it is done"
    assert len(killed) == 1
    alone = spec.parent / "alone"
    run_here(spec, alone)
    assert rows(results) == rows(alone)
    summary = [line.split("|")[:-2] for line in sweep.table(results).splitlines()]
    assert summary == [line.split("|")[:-2] for line in sweep.table(alone).splitlines()]


def test_a_ray_cluster_of_which_a_worker_is_killed_has_the_table_of_one_process(spec: Path) -> None:
    ray = pytest.importorskip("ray", reason="pip install ray: without it sweeps on a Ray cluster are not tested")
    from giveway.sweep import ray as on_ray

    spec.write_text(SPEC.replace("to = 25", "to = 5"))
    results = spec.parent / "results"
    count = 0

    def own_pid() -> int:
        return os.getpid()

    def kill_half_way(_: sweep.Row) -> None:
        nonlocal count
        count += 1
        if count == 50:
            os.kill(ray.get(ray.remote(own_pid).remote()), signal.SIGKILL)

    ray.init(num_cpus=2, include_dashboard=False, configure_logging=False, log_to_driver=False)
    try:
        assert on_ray.run(spec, results, on_row=kill_half_way) == 100
        assert on_ray.run(spec, results) == 0, "all of it is done"
    finally:
        ray.shutdown()
    assert count == 100
    alone = spec.parent / "alone"
    run_here(spec, alone)
    assert rows(results) == rows(alone)


def test_files_are_found_where_they_are_and_a_certificate_comes_with_its_fingerprint(spec: Path) -> None:
    elsewhere = spec.parent / "specs"
    elsewhere.mkdir()
    own = elsewhere / "own.toml"
    own.write_text("""
        objectives = ["sum-of-costs"]
        clock = "cpu"
        time-limit = 30
        [certificates]
        [[instances]]
        files = ["empty-8-8-even-*.scen"]
        agents = { from = 5, step = 14 }
    """)
    with pytest.raises(BadText, match="which is no file"):
        sweep.tasks(own)
    tasks = sweep.tasks(own, spec.parent).tasks
    assert [task.data["agents"] for task in tasks] == [5, 19], "as many as the scenario has"
    first = sweep.run(tasks[0])
    assert first["certificate"]["certified"] == "proved" and len(first["certificate"]["manifest"]) == 64
    assert sweep.run(tasks[0])["certificate"] == first["certificate"], "the same again"


def test_a_series_that_became_too_hard_is_given_up(spec: Path) -> None:
    distributed = pytest.importorskip("distributed")
    from giveway.sweep import dask

    # CBS has no method for moves.
    text = SPEC[SPEC.index("conflict-limit"):].replace("to = 25", "to = 5")
    spec.write_text('skip-after = 2\nobjectives = ["moves"]\nplanners = ["cbs", "prioritised"]\n' + text)
    with distributed.Client(processes=False, dashboard_address=None) as client:
        dask.run(spec, client, spec.parent / "results")
        assert dask.run(spec, client, spec.parent / "results") == 0
    found = [line.split(",") for line in sweep.table(spec.parent / "results", "rows", "csv").splitlines()[1:]]
    assert len(found) == 2 * 5 * 2
    # Of five tasks of a series two are tried; prioritised planning finds plans, and goes on.
    assert sum("skipped" in row for row in found) == 2 * 3
    # With more patience what was skipped is tried.
    spec.write_text(spec.read_text().replace("skip-after = 2", "skip-after = 4"))
    with distributed.Client(processes=False, dashboard_address=None) as client:
        assert dask.run(spec, client, spec.parent / "results") == 2 * 2
    assert sweep.table(spec.parent / "results", "rows", "csv").count("skipped") == 2


STRAIGHT = """
import sys
line = open(sys.argv[1]).read().splitlines()[1].split("\\t")
x, y, goal_x, goal_y = map(int, line[4:8])
cells = [(y, x)]
while (x, y) != (goal_x, goal_y):
    if x != goal_x:
        x += 1 if x < goal_x else -1
    else:
        y += 1 if y < goal_y else -1
    cells.append((y, x))
open(sys.argv[2], "w").write("Agent 0: " + "".join(f"({a},{b})->" for a, b in cells) + "\\n")
"""


@pytest.mark.skipif(os.name != "posix", reason="planners of others run on Unix only")
def test_planners_of_others_are_judged_and_set_beside_the_proof(spec: Path) -> None:
    distributed = pytest.importorskip("distributed")
    from giveway.sweep import dask

    (spec.parent / "straight.py").write_text(STRAIGHT)
    spec.write_text(f"""
        objectives = ["sum-of-costs"]
        clock = "cpu"
        time-limit = 100
        [[instances]]
        files = ["empty-8-8-even-1.scen"]
        agents = 1
        [[planner]]
        name = "straight"
        command = "'{sys.executable}' straight.py {{scen}} {{out}}"
        [[planner]]
        name = "crashes"
        command = "sh -c 'exit 4' {{map}} {{out}}"
    """)
    results = spec.parent / "results"
    with distributed.Client(processes=False, dashboard_address=None) as client:
        assert dask.run(spec, client, results) == 3
        assert dask.run(spec, client, results) == 0
    here = spec.parent / "here"
    run_here(spec, here)
    for place in (results, here):
        found = [line.split(",") for line in sweep.table(place, "planners", "csv").splitlines()[1:]]
        assert [(row[1], row[3], row[4]) for row in found] == [
            ("search", "1", "1"), ("crashes", "0", "1"), ("straight", "1", "1"),
        ]
    with sweep.Results(here, "other") as kept:
        failed = [row for row in kept.done.values() if row["status"] == "failed"]
    assert [(row["failure"], row["reason"][:6]) for row in failed] == [("crashed", "exit 4")]
    assert sweep.table(results, "planners", "html").startswith("<!doctype html>")
