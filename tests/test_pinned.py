"""The test that a run is copied as."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from rosspin import simulate
from rosspin.pinned import as_test


@pytest.mark.parametrize("text", ["quotes ''' and \"\"\"", "a\\b\ttab", "ä\u2028\x0b", "no end", "\r\n"])
def test_texts_are_kept(tmp_path: Path, text: str) -> None:
    source = f"import sys\nassert sys.argv[1:] == ['a b']\nprint({text!r}, end='')"
    path = tmp_path / "2 nodes.py"
    path.write_text(source, encoding="utf-8")
    run = simulate(path, 1.0, ["a b"])
    names: dict[str, Any] = {}
    exec(as_test(source, path.name, 1.0, ["a b"], run.console, run.ticks), names)
    names["test_2_nodes"](tmp_path)
    with pytest.raises(AssertionError):
        exec(as_test(source, path.name, 1.0, ["a b"], run.console + "x", run.ticks), names)
        names["test_2_nodes"](tmp_path)
