"""The test that a run is copied as."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pytest

from rosspin import Tick, simulate
from rosspin.results.pinned import as_test
from tests.helpers.tree import EXAMPLES


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
    pinned(monkeypatch, tmp_path, f"import sys\nprint(sys.argv)\n{error}")


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


@pytest.mark.parametrize(
    "node",
    [
        *("my_robotics_pkg/src/spinner_rate_py_node.py", "my_robotics_pkg_ros2/my_robotics_pkg/spinner_py_node.py"),
        *("my_robotics_pkg/src/spinner_cpp_node.cpp", "my_robotics_pkg_ros2_cpp/src/spinner_cpp_node.cpp"),
    ],
)
def test_another_period_is_found(monkeypatch: pytest.MonkeyPatch, tmp_path: Path, node: str) -> None:
    path = EXAMPLES / node
    run, source = simulate(path, 2), path.read_text(encoding="utf-8")
    names: dict[str, Any] = {}
    console = re.sub(r"\x1b\[[\d;]*m", "", run.console)  # as a page shows it
    exec(as_test(source, path.name, 2.0, [], console, run.ticks), names)
    test = names[f"test_{path.stem}"]
    test(tmp_path, monkeypatch)
    names["NODE"] = re.sub(r"((?:timer_delta_t_in_seconds|loop_frequency_in_hz)(?: = |\())[\d.]+", r"\g<1>0.25", source)
    assert names["NODE"] != source
    with pytest.raises(AssertionError):
        test(tmp_path, monkeypatch)


def ticks_of(text: str) -> str:
    """What such a test says of the ticks."""
    _, _, said = text.partition("in run.ticks] == ")
    return said.partition("\n    assert run.console")[0]


@pytest.mark.parametrize(
    ("period", "grid"),
    [
        (0.5, "[('f', n, 0.5 * n, 0.5 * n) for n in range(1, 9)]"),
        (0.1, "[('f', n, round(0.1 * n, 9), round(0.1 * n, 9)) for n in range(1, 9)]"),
    ],
)
def test_ticks_on_a_grid_are_an_expression(period: float, grid: str) -> None:
    ticks = [Tick("f", n, round(period * n, 9), round(period * n, 9), 0.0) for n in range(1, 9)]
    said = ticks_of(as_test("", "a.py", 4.0, [], "", ticks))
    assert said == grid
    assert eval(said) == [tick[:4] for tick in ticks]


@pytest.mark.parametrize("change", [{"real": 1.6}, {"expected": 1.4}, {"source": "g"}, {"number": 7}])
def test_ticks_off_the_grid_are_a_list(change: dict[str, Any]) -> None:
    ticks = [Tick("f", n, 0.5 * n, 0.5 * n, 0.0) for n in range(1, 9)]
    ticks[2] = ticks[2]._replace(**change)
    said = ticks_of(as_test("", "a.py", 4.0, [], "", ticks))
    assert " for n in " not in said and eval(said) == [tick[:4] for tick in ticks]
