"""What C++ nodes share is compiled once; who has to wait for it says so. Nodes of pages are compiled together."""

from __future__ import annotations

import os
import signal
from collections.abc import Callable, Mapping, Sequence
from contextlib import ExitStack
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from rosspin.__main__ import main
from rosspin.cpp import CompileError, build, build_together, building
from rosspin.cpp.building import alone
from rosspin.site import compiling
from rosspin.site.compiling import _begin, _nodes
from rosspin.site.packing import pack
from tests.helpers.tree import ROOT

NODE = ROOT / "examples/my_robotics_pkg/src/spinner_cpp_node.cpp"


def test_whoever_waits_for_another_to_compile_says_so(tmp_path: Path) -> None:
    """A run that did not would seem to stand still."""
    first = ExitStack()
    first.enter_context(alone(tmp_path, lambda: None))
    said: list[str] = []

    def waiting() -> None:
        said.append("waiting")
        if len(said) == 2:
            first.close()

    with alone(tmp_path, waiting):
        assert len(said) == 2


def test_only_who_compiles_for_many_is_waited_for(tmp_path: Path) -> None:
    first = ExitStack()
    first.enter_context(alone(tmp_path, lambda: None))
    with alone(tmp_path, first.close, shared=True), alone(tmp_path, pytest.fail, shared=True):
        pass


def test_a_program_is_the_same_wherever_it_is_compiled(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    names = []
    for folder in "one", "two":
        building.stand_in.cache_clear()
        monkeypatch.setattr(building, "_KEPT", tmp_path / folder)
        names.append(building._planned(NODE, None, tmp_path).program.name)
    building.stand_in.cache_clear()
    assert names[0] == names[1]


@pytest.fixture
def asked(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> list[Sequence[Mapping[str, Any]]]:
    """What a compiler is asked for that makes empty programs, one list of steps each time."""
    found = []

    def compile_(steps: Sequence[Mapping[str, Any]], waiting: Callable[[], object]) -> tuple[str, int]:
        found.append(steps)
        for step in steps:
            for file in step["outputs"].values():
                Path(file).touch()
        return "", 0

    building._made(1, lambda: None)  # the real one
    monkeypatch.setattr(building, "_programs", tmp_path)
    monkeypatch.setattr(building, "_compile", compile_)
    return found


def test_nodes_are_compiled_together_and_found_one_by_one(asked: list[Any], tmp_path: Path) -> None:
    text = NODE.read_text(encoding="utf-8")
    nodes = [(str(NODE), None), ("cell", text), ("cell", text), (str(tmp_path / "lost.cpp"), None), ("cell", "int i;")]
    build_together(nodes)
    assert [len(steps) for steps in asked] == [4]
    assert {build(NODE).program, build("<cell 7>", text=text).program} == {*tmp_path.glob("*.wasm")}
    build_together(nodes)
    assert len(asked) == 1


def test_without_the_compiler_one_line_says_what_to_do(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """As where rosspin was installed from a wheel, which has no compiler."""
    building.stand_in.cache_clear()
    monkeypatch.setattr(building, "_CLANG", ROOT / "nowhere")
    assert main(["run", str(NODE), "--simulated", "--seconds", "1"]) == 1
    said = capsys.readouterr().err
    assert said.startswith("rosspin: C++ nodes need clang for WebAssembly, which is only in the source of rosspin: ")
    assert said.endswith("run `make html` there\n") and said.count("\n") == 1


def test_a_compiler_is_asked_again_and_another_if_it_has_ended() -> None:
    def asked() -> int:
        with pytest.raises(CompileError, match="expected"):
            build("node.cpp", text="#include <ros/ros.h>\nint main( {")
        pid: int = building.IDLE[-1].pid
        return pid

    first = asked()
    assert asked() == first
    os.kill(first, signal.SIGKILL)
    assert asked() != first


def test_what_a_page_runs_is_found() -> None:
    assert list(_nodes((ROOT / "docs/tutorial-timer.rst").read_text(encoding="utf-8"), ROOT)) == [
        (str(NODE), None),
        (str(ROOT / "examples/steps/2_callback.cpp"), None),
    ]
    [(_, cell)] = _nodes((ROOT / "notebooks/timer.md").read_text(encoding="utf-8"), ROOT)
    assert cell == f"\n{NODE.read_text(encoding='utf-8')}"
    assert not list(_nodes((ROOT / "notebooks/drift.md").read_text(encoding="utf-8"), ROOT))


def test_pages_with_cpp_nodes_are_read_last_and_compiled_meanwhile(monkeypatch: pytest.MonkeyPatch) -> None:
    started: list[Any] = []

    def process(target: object, args: tuple[Any], daemon: bool) -> Any:
        named = target is build_together
        started.append((target, [Path(name).name for name, _ in args[0]] if named else args[0]))
        return SimpleNamespace(start=lambda: None)

    monkeypatch.setattr(compiling, "get_context", lambda kind: SimpleNamespace(Process=process))
    names = {"docs/tutorial-timer": "rst", "notebooks/drift": "md", "notebooks/timer": "md"}
    app: Any = SimpleNamespace(
        srcdir=ROOT, confdir=ROOT, connect=lambda *args: None, builder=SimpleNamespace(format="html")
    )
    env: Any = SimpleNamespace(doc2path=lambda page: ROOT / f"{page}.{names[page]}")
    pages = list(names)
    _begin(app, env, pages)
    assert pages == ["notebooks/drift", "notebooks/timer", "docs/tutorial-timer"]
    assert started == [(build_together, ["cell", NODE.name, "2_callback.cpp"]), (pack, ROOT)]
    _begin(app, env, ["notebooks/drift"])
    assert len(started) == 2
    app.builder.format = ""  # the builder doctest has no pages
    _begin(app, env, ["docs/tutorial-timer"])
    assert [target for target, _ in started[2:]] == [build_together]
