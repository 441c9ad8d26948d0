"""The test that a run is copied as."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pytest

from rosspin import simulate
from rosspin.pinned import as_test


def pinned(monkeypatch: pytest.MonkeyPatch, folder: Path, source: str, more: str = "") -> None:
    """Run a node, and the test that it is copied as in another folder."""
    path = folder / "2 nodes.py"
    path.write_text(re.sub("latin-1|ascii", "utf-8", source), encoding="utf-8")
    monkeypatch.chdir(folder)
    run = simulate(path.name, 1.0, ["a b"])
    assert run.status == 0
    names: dict[str, Any] = {}
    exec(as_test(source, path.name, 1.0, ["a b"], run.console + more, run.ticks), names)
    (folder / "other").mkdir(exist_ok=True)
    names["test_2_nodes"](folder / "other", monkeypatch)


@pytest.mark.parametrize("text", ["quotes ''' and \"\"\"", "a\\b\ttab", "ä\u2028\x0b", "no end", "\r\n"])
def test_texts_are_kept(monkeypatch: pytest.MonkeyPatch, tmp_path: Path, text: str) -> None:
    source = f"import sys\nassert sys.argv[1:] == ['a b']\nprint({text!r}, end='')"
    pinned(monkeypatch, tmp_path, source)
    with pytest.raises(AssertionError):
        pinned(monkeypatch, tmp_path, source, "x")


def test_the_node_has_its_name_and_no_folder(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    error = "import traceback\ntry:\n    1 / 0\nexcept ZeroDivisionError:\n    traceback.print_exc()\n"
    pinned(monkeypatch, tmp_path, f"import sys\nprint(__file__, sys.argv)\n{error}")


@pytest.mark.parametrize(
    "first",
    [
        "# -*- coding: latin-1 -*-\n",
        "#!/usr/bin/env python3\n# vim: set fileencoding=ascii :\n",
        "\n# coding=latin-1\n# coding=ascii\n",
        "print('''\n# coding: kept\n''')\n",
    ],
)
def test_the_text_is_not_in_the_encoding_that_it_tells_of(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, first: str
) -> None:
    pinned(monkeypatch, tmp_path, f"{first}print('ä → ß')\n")
