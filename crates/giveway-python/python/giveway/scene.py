"""Scenes: a map, and agents with their tasks."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from os import PathLike
from pathlib import Path
from typing import Any, ClassVar, Literal

from giveway._door import as_json, call
from giveway._record import Record, optional
from giveway._text import decoded, of_file

#: ``(x, y)``, from (0, 0) at the top left, y down.
Cell = tuple[int, int]
Cost = Literal["makespan", "sum-of-costs", "charges", "moves", "waits", "penalty"]


@dataclass(frozen=True)
class Battery(Record):
    """A battery, in time steps."""

    capacity: int
    initial: int


@dataclass(frozen=True)
class Agent(Record):
    """An agent and its task; without a battery it moves without limit, and without a goal
    it may rest at any cell, where it stays."""

    name: str
    start: Cell
    goal: Cell | None = optional()
    waypoints: tuple[Cell, ...] = optional(default=())
    battery: Battery | None = optional()
    #: Where it faces at first, which matters where turns take time.
    heading: Literal["north", "east", "south", "west"] | None = optional()


@dataclass(frozen=True)
class Rules(Record):
    """The rules; by default agents stay at their goals, and the floor is 0."""

    at_goal: Literal["stay", "vanish"] = "stay"
    battery_floor: int = 0


@dataclass(frozen=True)
class Assumption(Record):
    """Something that a scene takes for granted: whatever is said of it is said under that.

    ``goals-chosen``: goals or tasks were chosen out of those that the file leaves open.
    ``moving-obstacle``: its ``name``, and its cell at each time from 0 as ``path``; ``closed`` where
    rules of the scene close the cells where it is. ``rule-left-out``: a ``rule`` of the file's
    problem (``turning``, ``long-moves``, ``errand-order``, ``handling``) that scenes do not
    have; bounds hold with it, too, and a plan that is found may break it. ``unknown-key``: a
    ``key`` of the file that is not heeded and may change the problem.
    """

    assumes: Literal["goals-chosen", "moving-obstacle", "rule-left-out", "unknown-key"]
    name: str | None = optional()
    path: tuple[Cell, ...] = optional(default=())
    closed: bool | None = optional()
    key: str | None = optional()
    rule: str | None = optional()


@dataclass(frozen=True)
class Zone(Record):
    """A named part of the map: its ``cells``, or a ``rect`` of first and last column and row."""

    name: str
    cells: tuple[Cell, ...] | None = optional()
    rect: tuple[int, int, int, int] | None = optional()


@dataclass(frozen=True)
class Units(Record):
    """The side of a ``cell`` in metres, and the length of a ``step`` in seconds."""

    cell: float
    step: float


@dataclass(frozen=True)
class Scene(Record):
    """An instance of the problem.

    >>> scene = Scene(map=("...",), agents=(Agent("A", (0, 0), (2, 0)),))
    >>> scene.width, scene.height
    (3, 1)
    """

    document: ClassVar[bool] = True

    #: Rows from the top: ``.`` free, ``#`` obstacle, ``~`` slow zone, ``+`` charger, ``*`` both.
    map: tuple[str, ...]
    agents: tuple[Agent, ...] = ()
    name: str = optional(default="")
    rules: Rules = optional(default=Rules())
    #: The most important cost first.
    objective: tuple[Cost, ...] = optional(default=("makespan", "sum-of-costs", "charges"))
    #: What it takes for granted, where it was read from a file of another maker.
    assumptions: tuple[Assumption, ...] = optional(default=())
    #: Named parts of the map.
    zones: tuple[Zone, ...] = optional(default=())
    #: Rules of its own: ``{"kind": "capacity", "zone": "aisle 3", "most": 1}``.
    constraints: tuple[dict[str, Any], ...] = optional(default=())
    #: What a cell and a time step are in the world; no claim is about them.
    units: Units | None = optional()

    @property
    def width(self) -> int:
        """Cells in a row."""
        return len(self.map[0]) if self.map else 0

    @property
    def height(self) -> int:
        """Rows."""
        return len(self.map)

    @classmethod
    def from_dict(cls, data: Mapping[str, Any]) -> Scene:
        """Reads and checks plain data."""
        return cls._of(call("scene-of-object", as_json(data)))

    @classmethod
    def from_json(cls, text: str | bytes) -> Scene:
        """Reads and checks JSON; a fault has its line and column."""
        return cls._of(call("read-scene", decoded(text)))

    @classmethod
    def from_file(cls, path: str | PathLike[str]) -> Scene:
        """Reads and checks a file of JSON."""
        return cls.from_json(of_file(path))

    @classmethod
    def from_movingai(
        cls, map: str | PathLike[str], scen: str | PathLike[str], agents: int | None = None
    ) -> Scene:
        """The scene of a MovingAI ``.map`` and the first agents of a ``.scen``, by their paths."""
        request = {
            "map": of_file(map, "map"), "scenario": of_file(scen, "scenario"),
            "name": Path(scen).stem, "agents": agents,
        }
        return cls._of(call("read-movingai", request))

    def to_networkx(self) -> Any:
        """The map as a ``networkx.Graph``: nodes are cells with ``slow`` and ``charger``,
        edges have the ``steps`` that a move takes."""
        import networkx

        graph = networkx.Graph()
        for y, row in enumerate(self.map):
            for x, sign in enumerate(row):
                if sign != "#":
                    graph.add_node((x, y), slow=sign in "~*", charger=sign in "+*")
        for x, y in list(graph):
            for other in ((x + 1, y), (x, y + 1)):
                if other in graph:
                    slow = graph.nodes[x, y]["slow"] and graph.nodes[other]["slow"]
                    graph.add_edge((x, y), other, steps=2 if slow else 1)
        return graph

    def _repr_svg_(self) -> str:
        from giveway import _draw

        return _draw.scene(self)
