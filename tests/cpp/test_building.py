"""What C++ nodes share is compiled by one process; the others wait, and say so."""

from __future__ import annotations

from contextlib import ExitStack
from pathlib import Path

from rosspin.cpp.building import _alone


def test_whoever_waits_for_another_to_compile_says_so(tmp_path: Path) -> None:
    """A run that did not would seem to stand still."""
    first = ExitStack()
    first.enter_context(_alone(tmp_path, lambda: None))
    said: list[str] = []

    def waiting() -> None:
        said.append("waiting")
        if len(said) == 2:
            first.close()

    with _alone(tmp_path, waiting):
        assert len(said) == 2
