"""The documentation and the notebook run, and the types are strict."""

from __future__ import annotations

import ast
import contextlib
import doctest
import io
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
from conftest import CLONE, read

import giveway

OPTIONS = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE | doctest.IGNORE_EXCEPTION_DETAIL


def test_the_documentation(monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("numpy")
    pytest.importorskip("networkx")
    monkeypatch.chdir(CLONE)
    result = doctest.testfile(str(CLONE / "docs/python.md"), module_relative=False, optionflags=OPTIONS)
    assert result.attempted > 12 and result.failed == 0


def test_the_examples_of_the_functions() -> None:
    from giveway import files, functions, plan, scene

    results = [doctest.testmod(module, optionflags=OPTIONS) for module in (files, functions, plan, scene)]
    assert sum(result.attempted for result in results) > 8
    assert sum(result.failed for result in results) == 0


def run(cell: str, names: dict[str, Any]) -> Any:
    """Runs a cell of a notebook; gives what its last line is."""
    tree = ast.parse(cell)
    last = tree.body.pop() if isinstance(tree.body[-1], ast.Expr) else None
    exec(compile(tree, "cell", "exec"), names)
    return eval(compile(ast.Expression(last.value), "cell", "eval"), names) if isinstance(last, ast.Expr) else None


def test_the_notebook() -> None:
    pytest.importorskip("numpy")
    names: dict[str, Any] = {}
    printed, shown = io.StringIO(), []
    with contextlib.redirect_stdout(printed):
        for cell in read(CLONE / "crates/giveway-python/examples/warehouse.ipynb")["cells"]:
            if cell["cell_type"] == "code":
                assert cell["outputs"] == [], "a notebook is kept without what it printed"
                shown.append(run("".join(cell["source"]), names))
    assert printed.getvalue().startswith("optimal Costs(makespan=18")
    assert [type(value).__name__ for value in shown] == ["Scene", "Plan", "Animation", "NoneType", "ndarray"]
    assert "animateTransform" in shown[2]._repr_svg_()


@pytest.mark.parametrize("part", ["python/giveway", "tests"])
def test_types_are_strict(part: str) -> None:
    pytest.importorskip("mypy")
    # The tests are a program that uses the package as it is installed.
    assert (Path(giveway.__file__).parent / "py.typed").is_file()
    folder = CLONE / "crates/giveway-python" / part
    command = [sys.executable, "-m", "mypy", "--strict", "--config-file", str(CLONE / "pyproject.toml"), str(folder)]
    checked = subprocess.run(command, capture_output=True, text=True, check=False)
    assert checked.returncode == 0, checked.stdout
