"""The log of ticks: each keeps its place, its fields and its duration, whoever else records."""

from __future__ import annotations

import copy
import dataclasses
import pickle
import struct
import sys
import threading
from collections.abc import Callable

import pytest

from rosspin import Run, Tick, simulate
from rosspin.clocks.simulation import Simulation
from rosspin.run.simulate import run_node
from rosspin.run.source import load
from rosspin.world.graph import TickLog, unpacked
from tests.helpers.tree import EXAMPLES


def test_a_tick_has_no_duration_until_it_has_ended() -> None:
    log = TickLog()
    first = log.add("timer", 1, 5, 6)
    second = log.add("Rate", 1, 7, 8, 9)
    assert [log.is_running(place) for place in (first, second)] == [True, False]
    assert [*zip(*log.columns())] == [("timer", 1, 5, 6, None), ("Rate", 1, 7, 8, 9)]
    log.end(first, 0)
    assert not log.is_running(first)
    assert [*zip(*log.columns(1))] == [("Rate", 1, 7, 8, 9)]
    assert len(log) == 2 and log.columns(2) == ([],) * 5


def test_threads_that_record_at_the_same_time_end_their_own_ticks() -> None:
    log = TickLog()

    def tick(source: str, duration: int) -> None:
        for number in range(1, 5001):
            log.end(log.add(source, number, number, number), duration)

    threads = [threading.Thread(target=tick, args=(f"timer {each}", each)) for each in range(4)]
    before = sys.getswitchinterval()
    sys.setswitchinterval(1e-6)
    try:
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
    finally:
        sys.setswitchinterval(before)
    rows = [*zip(*log.columns())]
    for each in range(4):
        mine = [row for row in rows if row[0] == f"timer {each}"]
        assert mine == [(f"timer {each}", number, number, number, each) for number in range(1, 5001)]


def test_a_tick_finds_its_place_when_another_thread_comes_in_between() -> None:
    class Raced(list[object]):
        """A list to which another thread adds a tick just before one is added, and just after."""

        def __iadd__(self, row: tuple[object, ...]) -> Raced:  # type: ignore[override,misc]
            self.extend(["other", 1, 0, 0, None, *row, "other", 2, 0, 0, None])
            return self

    log = TickLog()
    log._fields = Raced()
    log.end(log.add("timer", 1, 5, 6), 3)
    assert [*zip(*log.columns())] == [
        ("other", 1, 0, 0, None),
        ("timer", 1, 5, 6, 3),
        ("other", 2, 0, 0, None),
    ]


NAMES = ["timer", "Rate"]
WRITTEN = [(0, 1, 5, 6, -1), (1, 1, -1, -1, 9), (0, 2, 7, 8, 0)]
ROWS = [("timer", 1, 5, 6, None), ("Rate", 1, -1, -1, 9), ("timer", 2, 7, 8, 0)]


def written(*ticks: tuple[int, ...]) -> bytes:
    return b"".join(struct.pack("<iiqqq", *tick) for tick in ticks)


def test_what_a_program_has_written_is_recorded_in_order() -> None:
    log = TickLog()
    assert log.add("before", 1, 1, 2, 3) == 0
    assert log.extend(written(*WRITTEN[:2]), NAMES) == 1 and log.extend(written(WRITTEN[2]), NAMES) == 3
    assert len(log) == 4 and log.add("after", 1, 9, 9, 0) == 4
    assert [*zip(*log.columns())] == [("before", 1, 1, 2, 3), *ROWS, ("after", 1, 9, 9, 0)]
    assert [*zip(*log.columns(1, 4))] == ROWS == [*zip(*unpacked((written(*WRITTEN), NAMES)))]


@pytest.mark.parametrize(
    "look",
    [
        lambda log: log.end(0, 4) or log.columns()[4] == [4, 9, 0],
        lambda log: log.is_running(0) and not log.is_running(2),
        lambda log: [log.source(place) for place in range(3)] == ["timer", "Rate", "timer"],
    ],
)
def test_whoever_asks_finds_what_a_program_has_written(look: Callable[[TickLog], bool]) -> None:
    log = TickLog()
    log.extend(written(*WRITTEN), NAMES)
    assert look(log)


def test_the_last_numbers_are_of_ticks_since_the_end() -> None:
    log = TickLog()
    log.add("early", 1, 0, 0, 0)
    log.extend(written(WRITTEN[1]), NAMES)
    log.look_ahead(dict)
    log.extend(written(WRITTEN[0]), NAMES)
    log.extend(written(WRITTEN[2]), NAMES)
    assert log.last_numbers() == {"timer": 2}
    log.add("late", 7, 0, 0, 0)
    assert log.last_numbers() == {"timer": 2, "late": 7}


SPINNER = EXAMPLES / "my_robotics_pkg" / "src" / "spinner_py_node.py"


@pytest.mark.parametrize(
    "made",
    [
        lambda run: run,
        copy.copy,
        copy.deepcopy,
        lambda run: pickle.loads(pickle.dumps(run)),
        lambda run: dataclasses.replace(run, console=run.console),
        lambda run: Run(**{field.name: getattr(run, field.name) for field in dataclasses.fields(run)}),
    ],
)
def test_the_ticks_of_a_run_are_made_when_someone_asks_for_them(made: Callable[[Run], Run]) -> None:
    """No one else sees that: a copy has them, and they are a tuple, the same each time."""
    one, other = simulate(SPINNER, 1.2), simulate(SPINNER, 1.2)
    assert "ticks" not in vars(one)
    run = made(one)
    assert run.ticks == (Tick("timerCallback", 1, 0.5, 0.5, 0.0), Tick("timerCallback", 2, 1.0, 1.0, 0.0))
    assert type(run.ticks) is tuple and run.ticks is run.ticks
    # In what would have come next is a NaN, of which a copy is another.
    one, other = (dataclasses.replace(each, coming=()) for each in (run, other))
    assert one == other and hash(one) == hash(other) and repr(run) == repr(other)
    with pytest.raises(AttributeError, match="'Run' object has no attribute 'tock'"):
        run.tock  # type: ignore[attr-defined] # noqa: B018


def test_the_ticks_of_a_run_are_those_of_its_end() -> None:
    result = run_node(load(SPINNER), 1.2, (), Simulation(), TickLog())
    log = result.host.recording.log
    assert log
    log.add("late", 1, 0, 0)
    assert len(result.ticks) == len(result.run("", "simulated", 1.2).ticks) == 2
