"""Pictures, arrays and graphs of plans."""

from __future__ import annotations

import xml.dom.minidom
from typing import Any

import pytest
from conftest import DATA

import giveway


def warehouse() -> giveway.Plan:
    plan = giveway.solve(giveway.Scene.from_file(DATA / "seed/warehouse.json")).plan
    assert plan is not None
    return plan


def test_pictures_are_svg() -> None:
    plan = warehouse()
    assert plan.scene is not None
    for picture in (plan.scene._repr_svg_(), plan._repr_svg_(), plan.animate()._repr_svg_()):
        drawn = xml.dom.minidom.parseString(picture)
        assert len(drawn.getElementsByTagName("rect")) >= 30
        assert len(drawn.getElementsByTagName("circle")) == 2
    moves = xml.dom.minidom.parseString(plan.animate()._repr_svg_()).getElementsByTagName("animateTransform")
    for move in moves:
        times = [float(time) for time in move.getAttribute("keyTimes").split(";")]
        assert times == sorted(times) and (times[0], times[-1]) == (0, 1)
        assert len(times) == len(move.getAttribute("values").split(";"))
    alone = giveway.Plan({"<&>\x00\ud800": ((0, 0), (1, 0))})
    for picture in (alone._repr_svg_(), alone.animate()._repr_svg_()):
        xml.dom.minidom.parseString(picture.encode())


def test_robots_that_come_later_or_go_are_seen_while_they_are_there() -> None:
    scene = giveway.Scene(map=("....",), rules=giveway.Rules(at_goal="vanish"))
    never = giveway.Plan({"A": ((0, 0), (1, 0))}, until={"A": 0}).animate()._repr_svg_()
    assert 'keyTimes="0;0;1;1"' in never
    short, long = ((0, 0), (1, 0)), ((3, 0), (2, 0), (1, 0), (0, 0))
    plan = giveway.Plan({"A": short, "B": long, "C": long}, start_times={"C": 2}, until={"C": 5})
    assert [plan.on(scene).cell("A", time) for time in (1, 2)] == [(1, 0), None]
    assert [plan.cell("C", time) for time in (1, 2, 4, 5)] == [None, (3, 0), (1, 0), None]

    def seen(one: giveway.Plan) -> list[tuple[str, str]]:
        animated = xml.dom.minidom.parseString(one.animate()._repr_svg_()).getElementsByTagName("animate")
        return [(animate.getAttribute("keyTimes"), animate.getAttribute("values")) for animate in animated]

    comes_and_goes = ("0;0.2;0.4;0.8;1;1", "0;0;1;1;0;0")
    assert seen(plan) == [comes_and_goes], "without a scene they stay at their goals"
    assert seen(plan.on(scene)) == [("0;0.2;0.4;1", "1;1;0;0"), ("0;0.6;0.8;1", "1;1;0;0"), comes_and_goes]


def test_what_is_empty_can_be_looked_at() -> None:
    empty = giveway.Scene(map=())
    assert (empty.width, empty.height) == (0, 0)
    nowhere = giveway.Plan({"A": ((0, 0),)}, until={"A": 0})
    for plan in (giveway.Plan({}), giveway.Plan({"A": ()}), giveway.Plan({"A": (None,)}), nowhere):
        assert plan.makespan == 0
        for picture in (empty._repr_svg_(), plan._repr_svg_(), plan.animate()._repr_svg_(), plan.on(empty)._repr_svg_()):
            xml.dom.minidom.parseString(picture)


@pytest.mark.parametrize("seconds", [0, -1, float("nan"), float("inf"), "1", None])
def test_time_goes_on_in_an_animation(seconds: Any) -> None:
    with pytest.raises(giveway.BadInput) as raised:
        giveway.Plan({}).animate(seconds)
    assert raised.value.place == "seconds_per_step"


def test_arrays_and_back() -> None:
    pytest.importorskip("numpy")
    plan = warehouse()
    array = plan.to_numpy()
    assert array.shape == (2, 19, 2)
    assert array[0, 0].tolist() == [0, 0] and array[0, 3].tolist() == [-1, -1] and array[0, -1].tolist() == [9, 2]
    assert giveway.Plan.from_numpy(array, list(plan.paths)).paths == plan.paths


def test_graphs() -> None:
    pytest.importorskip("networkx")
    scene = warehouse().scene
    assert scene is not None
    graph = scene.to_networkx()
    assert graph.number_of_nodes() == sum(row.count(sign) for row in scene.map for sign in ".~+*")
    assert graph.edges[(2, 0), (3, 0)]["steps"] == 2 and graph.edges[(0, 0), (1, 0)]["steps"] == 1
    assert graph.nodes[3, 2]["charger"]
