"""Answers whose plans have their scene, to be drawn with."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping
from typing import TypeVar

from giveway._record import Record
from giveway.plan import Plan
from giveway.scene import Scene

R = TypeVar("R")


def on(scene: Scene | None, value: R) -> R:
    """An answer whose plans have the scene, to be drawn with."""
    if isinstance(value, Plan):
        return dataclasses.replace(value, scene=scene)
    if isinstance(value, Record) and not isinstance(value, Scene):
        parts = {one.name: getattr(value, one.name) for one in dataclasses.fields(value)}  # type: ignore[arg-type]
        changed = {name: on(scene, part) for name, part in parts.items() if isinstance(part, (Record, tuple, Mapping))}
        return dataclasses.replace(value, **changed)  # type: ignore[type-var]
    if isinstance(value, tuple) and value and isinstance(value[0], Record):
        return tuple(on(scene, part) for part in value)  # type: ignore[return-value]
    if isinstance(value, dict) and value and isinstance(next(iter(value.values())), Record):
        return {name: on(scene, part) for name, part in value.items()}  # type: ignore[return-value]
    return value
