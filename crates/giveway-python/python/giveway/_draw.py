"""Scenes and plans as SVG."""

from __future__ import annotations

import re
from xml.sax.saxutils import escape

from giveway.plan import Plan
from giveway.scene import Cell, Scene

#: Colours that are told apart by most people (Okabe and Ito 2008).
COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#8c6d00", "#444444")
FLOOR = {".": "#ffffff", "#": "#555555", "~": "#dbe7f3", "+": "#ffffff", "*": "#dbe7f3"}
#: Pixels of a cell.
SIZE = 28


def _point(cell: Cell) -> tuple[float, float]:
    return (cell[0] + 0.5) * SIZE, (cell[1] + 0.5) * SIZE


def _sheet(scene: Scene, inner: list[str]) -> str:
    width, height = scene.width * SIZE, scene.height * SIZE
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width + 2}" height="{height + 2}" '
        f'viewBox="-1 -1 {width + 2} {height + 2}" font-family="sans-serif" font-size="10">'
    ]
    for y, row in enumerate(scene.map):
        for x, sign in enumerate(row):
            parts.append(
                f'<rect x="{x * SIZE}" y="{y * SIZE}" width="{SIZE}" height="{SIZE}" '
                f'fill="{FLOOR.get(sign, "#ffffff")}" stroke="#cccccc"/>')
            if sign in "+*":
                px, py = _point((x, y))
                parts.append(f'<text x="{px}" y="{py + 4}" text-anchor="middle" fill="#777777">+</text>')
    return "".join([*parts, *inner, "</svg>"])


def _around(plan: Plan) -> Scene:
    """The scene of a plan, or an empty floor that holds it."""
    if plan.scene is not None:
        return plan.scene
    cells = [cell for path in plan.paths.values() for cell in path if cell is not None]
    width = max((x for x, _ in cells), default=0) + 1
    height = max((y for _, y in cells), default=0) + 1
    return Scene(map=("." * width,) * height)


def _text(name: str) -> str:
    """A name in XML, which has no place for control characters and halves of others."""
    return escape(re.sub("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]", "\ufffd", name))


def _robot(name: str, colour: str, inner: str = "") -> str:
    return (
        f'<g><title>{_text(name)}</title><circle r="{SIZE * 0.36}" fill="{colour}"/>'
        f'<text y="3.5" text-anchor="middle" fill="#ffffff">{_text(name[:3])}</text>{inner}</g>')


def _goal(cell: Cell, colour: str) -> str:
    x, y = cell[0] * SIZE + 5, cell[1] * SIZE + 5
    return f'<rect x="{x}" y="{y}" width="{SIZE - 10}" height="{SIZE - 10}" fill="none" stroke="{colour}" stroke-width="2"/>'


def scene(of: Scene) -> str:
    """The map with starts and goals."""
    inner = []
    for number, agent in enumerate(of.agents):
        colour = COLOURS[number % len(COLOURS)]
        x, y = _point(agent.start)
        if agent.goal is not None:
            inner.append(_goal(agent.goal, colour))
        inner.append(f'<g transform="translate({x} {y})">{_robot(agent.name, colour)}</g>')
    return _sheet(of, inner)


def plan(of: Plan) -> str:
    """The map with all paths, each robot at its start."""
    inner = []
    for number, (name, path) in enumerate(of.paths.items()):
        cells = [cell for cell in path if cell is not None]
        if not cells:
            continue
        colour = COLOURS[number % len(COLOURS)]
        points = " ".join(f"{x:g},{y:g}" for x, y in map(_point, cells))
        x, y = _point(cells[0])
        inner.append(f'<polyline points="{points}" fill="none" stroke="{colour}" stroke-width="2.5" opacity="0.7"/>')
        inner.append(_goal(cells[-1], colour))
        inner.append(f'<g transform="translate({x} {y})">{_robot(name, colour)}</g>')
    return _sheet(_around(of), inner)


def animation(of: Plan, seconds_per_step: float) -> str:
    """The map on which the robots move, again and again."""
    steps = max(of.makespan, 1)
    inner = []
    for number, (name, path) in enumerate(of.paths.items()):
        cells = [cell for cell in path if cell is not None]
        if not cells:
            continue
        colour = COLOURS[number % len(COLOURS)]
        begin = of.start_times.get(name, 0)
        # In transit a robot is on the straight line between two cells, so no place is named.
        times = [(begin + index, cell) for index, cell in enumerate(path) if cell is not None]
        times = [(0, cells[0])] * (begin > 0) + times
        if times[-1][0] < steps:
            times.append((steps, cells[-1]))
        places = [(time, "{:g} {:g}".format(*_point(cell))) for time, cell in times]
        seconds = steps * seconds_per_step
        move = _over_time('animateTransform attributeName="transform" type="translate"', places, steps, seconds)
        shown = _presence(begin, of._last(name), steps)
        if len(shown) > 2:
            move += _over_time('animate attributeName="opacity"', shown, steps, seconds)
        inner.append(_goal(cells[-1], colour))
        inner.append(_robot(name, colour, move))
    return _sheet(_around(of), inner)


def _presence(begin: int, last: int | None, steps: int) -> list[tuple[int, str]]:
    """How much of a robot is seen: it fades in before it comes, and out where it goes."""
    shown = [(0, "0"), (begin - 1, "0"), (begin, "1")] if begin > 0 else [(0, "1")]
    if last is None or last >= steps:
        return [*shown, (steps, "1")]
    gone = max(last, begin) + 1
    return [*shown, (gone - 1, "1"), (gone, "0"), (steps, "0")]


def _over_time(element: str, values: list[tuple[int, str]], steps: int, seconds: float) -> str:
    """Values of an attribute by their times, from 0 to the last step, again and again."""
    key_times = ";".join(f"{time / steps:.6g}" for time, _ in values)
    every = ";".join(value for _, value in values)
    return f'<{element} values="{every}" keyTimes="{key_times}" dur="{seconds:g}s" repeatCount="indefinite"/>'
