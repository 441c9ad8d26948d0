"""A cell of a notebook can be a node in C++."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from pygments.token import Comment, Keyword, Token

from rosspin.cpp import CompileError
from rosspin.run.kinds import written_in
from rosspin.site.checks import _line_of
from rosspin.site.pages import CellLexer
from tests.helpers.shells import ipython_shell
from tests.helpers.tree import ROOT

NODES = {
    1: ROOT / "examples/my_robotics_pkg/src/spinner_cpp_node.cpp",
    2: ROOT / "examples/my_robotics_pkg_ros2_cpp/src/spinner_cpp_node.cpp",
}
TEXTS = {ros: path.read_text(encoding="utf-8") for ros, path in NODES.items()}


@pytest.fixture
def shell(tmp_path: Path) -> Iterator[Any]:
    with ipython_shell(tmp_path) as shell:
        yield shell


@pytest.mark.parametrize("ros", NODES)
def test_a_cell_runs_and_is_drawn(shell: Any, capsys: pytest.CaptureFixture[str], ros: int) -> None:
    assert shell.run_cell(f"%%simulate 1 --name mine\n{TEXTS[ros]}").success
    run = shell.user_ns["mine"]
    assert capsys.readouterr() == ((run.console, "") if ros == 1 else ("", run.console))
    assert [line.partition("counter = ")[2][:1] for line in run.console.splitlines() if "counter" in line] == ["1", "2"]
    assert [tick.real for tick in run.ticks] == [0.5, 1.0]
    shell.run_cell("from rosspin import plots\nfrom rosspin.plots import pictures")
    said = shell.run_cell("pictures.alternative(plots.timeline(mine).figure)").result
    assert "2 ticks from 0.500 s to 1.000 s. All 2 ticks were on time." in said


def test_arguments_are_the_nodes(shell: Any) -> None:
    shell.run_cell(f"%%simulate 1 --quiet -- __ns:=/mrp\n{TEXTS[1]}")
    assert "namespace of nh = /mrp/spinner_cpp_node" in shell.user_ns["run"].console


@pytest.mark.parametrize("ros", NODES)
def test_what_does_not_compile_is_told_with_the_lines_of_the_cell(
    shell: Any, capsys: pytest.CaptureFixture[str], ros: int
) -> None:
    cell = f"%%simulate 1\n{TEXTS[ros].replace('++;', '+++;')}"
    result = shell.run_cell(cell)
    [wrong] = [number for number, line in enumerate(cell.splitlines(), 1) if "+++" in line]
    said = capsys.readouterr().out
    assert isinstance(result.error_in_exec, CompileError)
    assert said.startswith(f"<cell 1>:{wrong}:") and "rosspin" not in said
    assert _line_of(said.splitlines()) == wrong
    assert "run" not in shell.user_ns


def test_a_cell_is_compiled_once_whatever_its_number_is(shell: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    cell = f"%%simulate 1 --quiet\n{TEXTS[1]}"
    assert shell.run_cell(cell).success
    monkeypatch.setattr("rosspin.cpp.building._compile", None)
    assert shell.run_cell(cell, store_history=True).success and shell.run_cell(cell).success


def test_a_cell_may_include_what_lies_beside_the_notebook(
    shell: Any, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    (tmp_path / "period.h").write_text("const double period = 0.25;\n")
    monkeypatch.chdir(tmp_path)
    changed = TEXTS[1].replace("= 0.5", "= period")
    assert shell.run_cell(f'%%simulate 1 --quiet\n#include "period.h"\n{changed}').success
    assert len(shell.user_ns["run"].ticks) == 4


def test_what_includes_a_header_of_ros_is_in_cpp() -> None:
    assert written_in("\n// A node\n  #  include <rclcpp/rclcpp.hpp>\n") and written_in('#include "ros/node_handle.h"')
    assert not written_in("# includes ros/ros.h\nimport rospy\n") and not written_in("#include <iostream>\n")


def test_a_cell_is_highlighted_in_its_language() -> None:
    lexer = CellLexer()
    tokens = [*lexer.get_tokens('%%simulate 2.0\n#include "ros/ros.h"\n// Count\nint main() {}\n')]
    assert "".join(text for _, text in tokens).startswith('%%simulate 2.0\n#include "ros/ros.h"\n// Count\n')
    assert (Comment.PreprocFile, '"ros/ros.h"') in tokens and (Comment.Single, "// Count\n") in tokens
    assert (Keyword.Type, "int") in tokens and not [text for kind, text in tokens if kind is Token.Error]
    assert (Keyword.Namespace, "import") in [*lexer.get_tokens("%%simulate 2.0\nimport rospy\n")]
