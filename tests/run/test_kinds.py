"""A third ROS and a second language need an object each, and a place in a list."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Mapping
from importlib import import_module
from pathlib import Path
from types import ModuleType
from typing import Any, ClassVar

import pytest

from rosspin import simulate
from rosspin.run import kinds
from rosspin.run.kinds.language import Language
from rosspin.run.kinds.ros import Ros, Words
from rosspin.world.world import current_world


class Beats(Language):
    """Texts such as "every 0.5 say tick", which are nodes of ROS 1; who says "on" does not heed Ctrl-C."""

    name = "text"
    suffixes = (".beats",)
    words = {1: Words("whether to stop", "wait", "spin")}

    def recognises(self, text: str) -> bool:
        return text.startswith("every ")

    def named_in(self, text: str) -> set[int]:
        return {1}

    def program(
        self, path: str, waiting: Callable[[], object], text: str | None = None, closed: bool = False
    ) -> _Beating:
        return _Beating(path, Path(path).read_text())


class _Beating:
    ros = 1
    warnings = ""

    def __init__(self, path: str, text: str) -> None:
        self.path = path
        _, period, _, *words = text.split()
        self._period, self._said = float(period), " ".join(words)

    def __call__(self) -> None:
        rospy: Any = import_module("rospy")

        rospy.init_node("beats")
        rate = rospy.Rate(1 / self._period)
        while self._said == "on" or not rospy.is_shutdown():
            print(self._said)
            rate.sleep()


@pytest.fixture
def beats(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(kinds, "LANGUAGES", [*kinds.LANGUAGES, Beats()])


@pytest.mark.usefixtures("beats")
def test_a_node_in_another_language(tmp_path: Path) -> None:
    node = tmp_path / "node.beats"
    node.write_text("every 0.5 say tick")
    run = simulate(node, 1.6)
    assert (run.status, run.console) == (0, "tick\n" * 4)


@pytest.mark.usefixtures("beats")
def test_it_is_spoken_of_in_its_own_words(tmp_path: Path) -> None:
    node = tmp_path / "node.beats"
    node.write_text("every 0.5 say on")
    run = simulate(node, 1.0)
    assert run.status == 137
    assert "Does its loop check whether to stop?" in run.console


class Toy(Ros):
    number = 3
    roots = ("toyros",)
    beside: ClassVar[Mapping[str, str]] = {}
    needed = frozenset({"toyros"})
    name_key = "name"
    raises = True
    in_terminals = True
    timers_are_threads = False
    words = Words("toyros.ok()", "toyros.sleep(0.1)", "toyros.spin()")
    spins = "toyros.spin()"

    def home(self, package: str) -> str:
        return "stand_in_of_toyros"


def _stand_in() -> Any:
    toyros: Any = ModuleType("toyros")
    toyros.name = lambda: current_world().argv[1]
    toyros.wait = lambda seconds: time.sleep(seconds)
    made: Any = ModuleType("stand_in_of_toyros")
    made.MODULES = {"toyros": toyros}
    made.AT_EXIT = []
    made.for_process = lambda: toyros
    made.brought_by = lambda name: ()
    return made


def test_a_node_of_another_ros(monkeypatch: pytest.MonkeyPatch, write: Any) -> None:
    monkeypatch.setitem(kinds.ROS, 3, Toy())
    monkeypatch.setitem(sys.modules, "stand_in_of_toyros", _stand_in())
    node = write("import toyros\nwhile True:\n    print(toyros.name())\n    toyros.wait(0.5)\n")
    run = simulate(node, 1.2, ["robin"])
    assert run.console.startswith("robin\n" * 3 + "Traceback") and run.console.endswith("KeyboardInterrupt\n")
    assert run.status == 130
