"""The log of ticks: each keeps its place, its fields and its duration, whoever else records."""

from __future__ import annotations

import sys
import threading

from rosspin.world.graph import TickLog


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
