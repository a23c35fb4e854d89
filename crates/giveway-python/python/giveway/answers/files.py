"""Scenes and plans of files, in this and other formats."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Literal

from giveway._record import Record
from giveway.plan import Plan
from giveway.scene import Cost, Scene

Format = Literal[
    "giveway", "movingai", "tracker", "paths.txt", "result.txt", "multi-robot", "lorr", "asprilo", "mapfw",
    "class-project", "grid"]


@dataclass(frozen=True)
class Converted(Record):
    """Texts by file names, and what the other format cannot say."""

    files: dict[str, str]
    notes: tuple[str, ...]


@dataclass(frozen=True)
class ForeignPlan(Record):
    """The plan of another program, read; it may break any rule."""

    #: The name of its file.
    file: str
    format: Format
    #: How it was read, where that is a matter of convention: what it is about, and how.
    words: tuple[tuple[str, str], ...]
    #: The same as data.
    conventions: dict[str, str]
    #: Why it was read so.
    why: str
    #: The other ways to read it, and what does not fit then.
    alternatives: tuple[dict[str, Any], ...]
    #: How well it fits the scene.
    fit: dict[str, Any]
    #: What its file says that it costs.
    claimed: Mapping[Cost, int]
    #: What it would cost if every step that its file writes counted.
    written: Mapping[Cost, int]
    #: Where agents that turn look at each time.
    headings: Mapping[str, tuple[str, ...]]
    notes: tuple[str, ...]
    plan: Plan
    #: What its file says that every plan costs at least (``loss`` is of the plan itself).
    bounds: Mapping[str, int]


@dataclass(frozen=True)
class Files(Record):
    """What ``read_files`` gives: a scene and its plans, in the order of the names of their files."""

    scene: Scene
    plans: tuple[ForeignPlan, ...]
    #: What a person should know of the scene.
    notes: tuple[str, ...]
