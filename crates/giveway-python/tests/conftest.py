"""Where the tests find the clone."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

CLONE = Path(__file__).resolve().parents[3]
DATA = CLONE / "tests/data"
RECORDED = CLONE / "crates/giveway-wasm/tests/data"


def read(path: Path) -> Any:
    """The JSON of a file."""
    return json.loads(path.read_text(encoding="utf-8"))


def scene(name: str) -> Any:
    """A scene of the tests' data as plain data."""
    return read(DATA / f"{name}.json")
