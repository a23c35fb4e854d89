"""The part in Rust."""

from collections.abc import Callable

VERSION: str

def call(
    function: str,
    request: str,
    on_progress: Callable[[str], object] | None,
    should_stop: Callable[[], object] | None,
    signals: bool,
) -> tuple[bool, str]: ...
