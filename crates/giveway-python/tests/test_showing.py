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


def test_what_is_empty_can_be_looked_at() -> None:
    empty = giveway.Scene(map=())
    assert (empty.width, empty.height) == (0, 0)
    for plan in (giveway.Plan({}), giveway.Plan({"A": ()}), giveway.Plan({"A": (None,)})):
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
