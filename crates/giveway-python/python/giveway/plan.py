"""Plans: where each agent is at each time."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, ClassVar

from giveway._door import as_json, call
from giveway._misfit import described
from giveway._record import Record, optional
from giveway._text import decoded
from giveway.errors import refusal
from giveway.scene import Cell, Scene

if TYPE_CHECKING:
    import numpy
    import numpy.typing


@dataclass(frozen=True)
class Plan(Record):
    """Where each agent is at each time up to its arrival.

    >>> plan = Plan({"A": ((0, 0), (1, 0))})
    >>> plan.paths["A"][-1], plan.makespan, plan.at(9)
    ((1, 0), 1, {'A': (1, 0)})
    """

    document: ClassVar[bool] = True

    #: By the names of the agents; ``None`` in transit on a slow move.
    paths: Mapping[str, tuple[Cell | None, ...]]
    charges: Mapping[str, tuple[int, ...]] = field(default_factory=dict)
    #: The time of an agent's first entry, where it is not 0.
    start_times: Mapping[str, int] = optional("from", default_factory=dict)
    #: The time from which a removed agent is gone.
    until: Mapping[str, int] = optional(default_factory=dict)
    #: The last time whose changes the plan takes into account.
    knows: int | None = optional()
    #: What agents slept through at their goals before a change made them go on.
    slept: Mapping[str, tuple[tuple[int, int], ...]] = optional(default_factory=dict)
    #: The scene that it was made for, to be drawn with; plans of answers have it.
    scene: Scene | None = field(default=None, compare=False, repr=False, metadata={"hidden": True})

    def __hash__(self) -> int:
        """Equal plans have the same, so that they can be counted in sets and be keys."""
        return hash(tuple(sorted(self.paths.items())))

    @classmethod
    def from_dict(cls, data: Mapping[str, Any]) -> Plan:
        """Reads plain data; it is not judged."""
        return cls._of(call("plan-of-object", as_json(data)))

    @classmethod
    def from_json(cls, text: str | bytes) -> Plan:
        """Reads JSON; a fault has its line and column. The plan is not judged."""
        return cls._of(call("read-plan", decoded(text)))

    @classmethod
    def from_numpy(cls, array: Any, agents: Iterable[str], scene: Scene | None = None) -> Plan:
        """The plan of an array ``[agent, time, 2]``, as ``to_numpy`` makes it: whole numbers, both -1
        where an agent is at no cell. Where it is at no cell in the beginning it comes later; what it
        repeats at the end is cut. An array has no charges.

        >>> Plan.from_numpy([[[0, 0], [1, 0], [1, 0]]], ["A"]).paths["A"]
        ((0, 0), (1, 0))
        """
        from giveway import _array

        paths, start_times = _array.read(array, agents)
        return cls(paths, start_times=start_times, scene=scene)

    def to_numpy(self) -> numpy.typing.NDArray[numpy.int32]:
        """The paths as ``[agent, time, 2]``, agents in the order of ``paths``, from time 0 to
        the makespan. After its arrival an agent stays where it is, or is gone where the rules
        say so. Where it is at no cell, in transit or not there, both numbers are -1."""
        import numpy

        times = range(self.makespan + 1)
        rows = [[self.cell(name, time) or (-1, -1) for time in times] for name in self.paths]
        return numpy.array(rows, dtype=numpy.int32).reshape(len(rows), len(times), 2)

    def arrival(self, agent: str) -> int:
        """When the path of an agent ends."""
        return self.start_times.get(agent, 0) + len(self.paths[agent]) - 1

    @property
    def makespan(self) -> int:
        """When the last path ends."""
        return max((self.arrival(agent) for agent, path in self.paths.items() if path), default=0)

    def cell(self, agent: str, time: int) -> Cell | None:
        """Where an agent is; ``None`` in transit, before it comes and after it has gone."""
        path, index = self.paths[agent], time - self.start_times.get(agent, 0)
        last = self._last(agent)
        if index < 0 or not path or last is not None and time > last:
            return None
        return path[min(index, len(path) - 1)]

    def _last(self, agent: str) -> int | None:
        """The last time at which an agent is on the map; ``None`` where it stays for ever."""
        if agent in self.until:
            return self.until[agent] - 1
        if self.scene is None or self.scene.rules.at_goal == "stay":
            return None
        goalless = any(one.name == agent and one.goal is None for one in self.scene.agents)
        return None if goalless else self.arrival(agent)

    def at(self, time: int) -> dict[str, Cell | None]:
        """Where everyone is."""
        return {agent: self.cell(agent, time) for agent in self.paths}

    def on(self, scene: Scene) -> Plan:
        """The same plan with a scene to be drawn with."""
        return dataclasses.replace(self, scene=scene)

    def animate(self, seconds_per_step: float = 0.5) -> Animation:
        """A picture that moves."""
        return Animation(self, seconds_per_step)

    def _repr_svg_(self) -> str:
        from giveway import _draw

        return _draw.plan(self)


@dataclass(frozen=True)
class Animation:
    """A plan that a notebook plays."""

    plan: Plan
    seconds_per_step: float = 0.5

    def __post_init__(self) -> None:
        if not isinstance(self.seconds_per_step, (int, float)) or not 0 < self.seconds_per_step < math.inf:
            found = described(self.seconds_per_step)
            raise refusal("seconds_per_step", found, "seconds, more than 0")

    def _repr_svg_(self) -> str:
        from giveway import _draw

        return _draw.animation(self.plan, self.seconds_per_step)
