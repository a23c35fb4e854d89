"""What people hand over in more ways than one, as the part in Rust takes it."""

from __future__ import annotations

import shlex
from collections.abc import Iterable, Mapping
from os import PathLike
from pathlib import Path
from typing import Any

from giveway._door import as_json
from giveway._misfit import Misfit, described
from giveway._record import Record
from giveway._text import of_file
from giveway.answers import Answer, Explanation, Freedom
from giveway.errors import refusal
from giveway.scene import Scene


def costs(objective: Any) -> Any:
    """The costs of an objective, of a text with commas too; what is neither is refused later, with its place."""
    if isinstance(objective, str):
        return [cost.strip() for cost in objective.split(",")]
    return list(objective) if isinstance(objective, Iterable) and not isinstance(objective, (bytes, Mapping)) else objective


def words(question: str) -> list[str]:
    """The words of a question, as a shell takes them apart."""
    try:
        return shlex.split(question)
    except ValueError as error:
        raise refusal("question", repr(question), f"words ({error})") from error


def by_kind(answer: Any) -> dict[str, Any]:
    """An answer under its kind, which plain data show by their keys."""
    kinds: dict[str, type[Record]] = {"explain": Explanation, "freedom": Freedom, "solve": Answer}
    if isinstance(answer, Mapping):
        kind = "explain" if "verdict" in answer else "freedom" if "about" in answer else "solve"
        try:
            return {kind: kinds[kind]._of(answer)}
        except Misfit as misfit:
            raise misfit.within("answer").refusal() from None
    for kind, shape in kinds.items():
        if isinstance(answer, shape):
            return {kind: answer}
    raise refusal("answer", described(answer), "the answer of solve, explain or freedom")


def texts(files: Any) -> Mapping[str, Any]:
    """The texts of files by their names, of a scene as one file, or of what is at some paths."""
    if isinstance(files, Mapping) and not isinstance(files.get("map"), (list, tuple)):
        return files
    if isinstance(files, (Scene, Mapping)):
        name = files.name if isinstance(files, Scene) else files.get("name")
        return {f"{_file_name(name)}.json": as_json(files)}
    if not isinstance(files, (str, PathLike, Iterable)) or isinstance(files, bytes):
        raise refusal("files", described(files), "a scene, texts by the names of their files, or paths")
    read: dict[str, str] = {}
    for path in [files] if isinstance(files, (str, PathLike)) else files:
        name = Path(path).name
        if name in read:
            raise refusal("files", f"two files of the name {name}", "a name of its own for each, as they are told apart by it")
        read[name] = of_file(path, name)
    return read


def _file_name(name: Any) -> str:
    """The name of a scene as that of a file, in this folder and no other."""
    safe = "".join(sign if sign.isalnum() or sign in " ._-" else "-" for sign in name) if isinstance(name, str) else ""
    return safe.strip(" .-") or "scene"
