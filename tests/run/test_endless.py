"""Nodes that start thread after thread: their run ends, with a clear error, and costs no more than it has to."""

from __future__ import annotations

import sys
import threading
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

import rosspin
from rosspin import TimeStandsStill, simulate
from rosspin.clocks import simulation
from rosspin.clocks.stacks import current
from rosspin.exercises import check
from rosspin.run import simulate as run
from tests.helpers.endless import BOTH, RATES, SLEEPING, SOME, TIMERS, as_before, noting, source

NODES = [
    *(pytest.param(source(ros, body), id=f"ros{ros} {name}") for name, body in BOTH.items() for ros in (1, 2)),
    pytest.param(source(1, TIMERS), id="ros1 timers"),
    pytest.param(source(2, RATES), id="ros2 rates"),
]


@pytest.fixture
def raised(monkeypatch: pytest.MonkeyPatch) -> Iterator[list[bool]]:
    with noting(monkeypatch) as found:
        yield found


@pytest.fixture
def few(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(simulation, "MOST_STACKS", 100)


@pytest.mark.parametrize("text", NODES)
def test_too_many_threads_end_the_run(text: str, write: Any, few: None, raised: list[bool]) -> None:
    trace = sys.gettrace()
    with pytest.raises(TimeStandsStill, match=r"node\.py:\d+: simulated time stands still at .*100 threads have not"):
        simulate(write(text), 5)
    assert not any(raised)
    assert sys.gettrace() is trace and as_before()


@pytest.mark.parametrize("thread", ["", "threading.Thread(target=SLEEP, args=(5,)).start()"])
def test_so_it_is_if_time_stands_still_between_two_stacks(
    thread: str, write: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    class Standing(simulation.Simulation):
        def _next(self) -> Any:
            if current() is self._home and self.now():
                raise simulation.Standstill([], "")
            return super()._next()

    monkeypatch.setattr(run, "Simulation", Standing)
    text = source(1, f"{thread}\nrospy.sleep(1)\nthreading.Thread(target=rospy.sleep, args=(1,)).start()\nrospy.spin()")
    line = text.count("\n")
    with pytest.raises(TimeStandsStill, match=rf"node\.py:{line}: simulated time stands still"):
        simulate(write(text), 5)


@pytest.mark.parametrize("text", SOME)
def test_in_a_test_in_an_exercise_and_in_another_thread(text: str, write: Any, few: None) -> None:
    path = write(text)
    with pytest.raises(TimeStandsStill), rosspin.start(path) as started:
        started.advance(1)
    assert "simulated time stands still" in str(check("ten-hertz" if "rospy" in text else "call-back-once", text))
    errors: list[BaseException] = []

    def run() -> None:
        try:
            simulate(path, 5)
        except TimeStandsStill as error:
            errors.append(error)

    thread = threading.Thread(target=run)
    thread.start()
    thread.join()
    assert len(errors) == 1 and as_before()


def test_among_several_nodes(write: Any, few: None, tmp_path: Path) -> None:
    quiet = tmp_path / "quiet.py"
    quiet.write_text("import rospy\nrospy.init_node('quiet')\nrospy.spin()\n")
    with pytest.raises(TimeStandsStill, match=r"node\.py:\d+: .*100 threads"):
        simulate([str(quiet), write(source(1, SLEEPING))], 5)
    assert as_before()
