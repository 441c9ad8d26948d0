"""Simulated time: which stack wakes when, compared with a plain model."""

from __future__ import annotations

from functools import partial

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rosspin.clocks.simulation import Simulation, Standstill
from rosspin.clocks.stacks import Program, Stack

FOREVER = 10**15

lengths = st.integers(-2, 12)  # short, so that many fall due at the same time
stacks_of_sleeps = st.lists(st.lists(lengths, max_size=8), max_size=6)


def model(stacks: list[list[int]]) -> list[tuple[int, int]]:
    """(time, stack) of every wake-up: a sorted list of them, the next one always the first."""
    waiting = [(0, number, number, 0) for number in range(len(stacks))]
    asleep, woken = len(stacks), []
    while waiting:
        waiting.sort()
        now, _, stack, step = waiting.pop(0)
        woken.append((now, stack))
        if step < len(stacks[stack]):
            waiting.append((now + max(0, stacks[stack][step]), asleep, stack, step + 1))
            asleep += 1
    return woken


def simulated(stacks: list[list[int]]) -> list[tuple[int, int]]:
    simulation = Simulation()
    woken = []

    def sleeper(number: int) -> None:
        woken.append((simulation.now(), number))
        for length in stacks[number]:
            simulation.sleep(length)
            woken.append((simulation.now(), number))

    def main() -> None:
        for number in range(len(stacks)):
            simulation.start(partial(sleeper, number), Program(), f"stack {number}")
        simulation.sleep(FOREVER)

    simulation.run(main, Program(), 0)
    return woken


@settings(max_examples=150, deadline=None)
@given(stacks_of_sleeps)
def test_stacks_wake_by_time_and_then_by_who_fell_asleep_first(stacks: list[list[int]]) -> None:
    assert simulated(stacks) == model(stacks)


def test_a_thousand_stacks_can_be_asleep_at_once() -> None:
    stacks = [[1000 - number] for number in range(1000)]
    assert simulated(stacks) == model(stacks)


def test_several_deep_in_calls_wake_in_any_order() -> None:
    simulation, woken = Simulation(), []

    def deep(calls: int, length: int) -> None:
        if calls:
            deep(calls - 1, length)
        else:
            simulation.sleep(length)
        if calls == 5:
            woken.append(length)

    def main() -> None:
        for length in (3, 1, 2):
            simulation.start(partial(deep, 5 + length, length), Program(), "")
        simulation.sleep(2)  # the stack of length 2 falls asleep after this one
        assert woken == [1]
        simulation.sleep(10)

    simulation.run(main, Program(), 0)
    assert woken == [1, 2, 3]


@settings(max_examples=100, deadline=None)
@given(st.lists(st.integers(1, 40), max_size=5), st.lists(st.integers(1, 12), max_size=4))
def test_a_wait_ends_at_its_time_or_when_it_is_woken(waits: list[int], gaps: list[int]) -> None:
    simulation = Simulation()
    ended: dict[int, object] = {}
    stacks: list[Stack] = []

    def waiter(number: int, longest: int) -> None:
        ended[number] = simulation.wait(longest), simulation.now()
        simulation.sleep(FOREVER)
        ended[number] = "woken when it no longer waited"

    def main() -> None:
        for number, longest in enumerate(waits):
            stacks.append(simulation.start(partial(waiter, number, longest), Program(), ""))
        for gap in gaps:
            simulation.sleep(gap)
            for stack in stacks:
                simulation.wake(stack)
        simulation.sleep(1000)

    simulation.run(main, Program(), 0)
    first = gaps[0] if gaps else FOREVER
    # Main fell asleep first: of two at one time it continues first.
    assert ended == {number: (first <= longest, min(longest, first)) for number, longest in enumerate(waits)}


@settings(max_examples=100, deadline=None)
@given(st.integers(0, 20), st.integers(0, 20), st.integers(0, 20))
def test_an_interrupted_sleep_goes_on_after_the_handler(length: int, when: int, handling: int) -> None:
    simulation, handled = Simulation(), []

    def handler() -> None:
        handled.append(simulation.now())
        simulation.sleep(handling)

    def main() -> None:
        simulation.at(when, lambda: simulation.interrupt(simulation.main, handler))
        simulation.sleep(length)
        if when < length:
            assert handled == [when]
            assert simulation.now() == max(length, when + handling)
        else:
            assert (handled, simulation.now()) == ([], length)

    simulation.run(main, Program(), 0)


def test_an_exception_from_the_handler_ends_the_sleep() -> None:
    simulation = Simulation()

    def handler() -> None:
        raise KeyboardInterrupt

    def main() -> None:
        simulation.at(3, lambda: simulation.interrupt(simulation.main, handler))
        with pytest.raises(KeyboardInterrupt):
            simulation.sleep(10)
        assert simulation.now() == 3

    simulation.run(main, Program(), 0)


def test_at_comes_after_everything_that_falls_due_then() -> None:
    simulation = Simulation()
    order: list[object] = []

    def sleeper() -> None:
        simulation.sleep(5)
        for step in range(3):
            order.append(step)
            simulation.sleep(0)

    def main() -> None:
        simulation.at(5, lambda: order.append("at"))
        simulation.at(5, lambda: order.append("at, too"))
        simulation.start(sleeper, Program(), "")
        simulation.sleep(5)
        simulation.sleep(1)

    simulation.run(main, Program(), 0)
    assert order == [0, 1, 2, "at", "at, too"]


@pytest.mark.parametrize("length", [0, -7])
def test_sleeping_no_time_for_ever_is_a_standstill(length: int) -> None:
    simulation = Simulation()

    def never_sleeps() -> None:
        simulation.sleep(3)
        while True:
            simulation.sleep(length)

    def main() -> None:
        simulation.start(never_sleeps, Program(), "the culprit")
        simulation.sleep(FOREVER)

    with pytest.raises(Standstill) as caught:
        simulation.run(main, Program(), 0)
    assert caught.value.place == "the culprit"
    assert any(place.call == "simulation.sleep(length)" for place in caught.value.places)
    assert simulation.now() == 3


def test_many_stacks_at_one_time_are_no_standstill() -> None:
    assert len(simulated([[1, 1]] * 2000)) == 6000


def test_the_end_of_main_ends_the_others_through_their_finally() -> None:
    simulation, said = Simulation(), []

    def sleeper() -> None:
        try:
            simulation.sleep(FOREVER)
            said.append("must not go on")
        except Exception:
            said.append("must not see it")
        finally:
            said.append("finally")

    def main() -> None:
        simulation.start(sleeper, Program(), "")
        simulation.sleep(1)

    simulation.run(main, Program(), 0)
    assert said == ["finally"]
    assert simulation.now() == 1


def test_a_finally_that_sleeps_does_not_hold_up_the_end() -> None:
    simulation, said = Simulation(), []

    def sleeper() -> None:
        try:
            simulation.sleep(FOREVER)
        finally:
            said.append("before")
            simulation.sleep(1)
            said.append("after")

    def main() -> None:
        simulation.start(sleeper, Program(), "")
        simulation.sleep(1)

    simulation.run(main, Program(), 0)
    assert said == ["before"]


def test_an_exception_ends_the_run_and_names_its_stack() -> None:
    simulation = Simulation()

    def fails() -> None:
        simulation.sleep(2)
        raise LookupError("lost")

    def main() -> None:
        simulation.start(fails, Program(), "the one that fails")
        simulation.sleep(FOREVER)

    with pytest.raises(LookupError, match="lost"):
        simulation.run(main, Program(), 0)
    assert simulation.failed == "the one that fails"


def test_a_simulation_can_run_inside_of_another() -> None:
    outer = Simulation()
    seen: list[object] = []

    def main() -> None:
        outer.sleep(7)
        seen.append(simulated([[3], [1]]))
        seen.append(outer.now())

    outer.run(main, Program(), 0)
    assert seen == [[(0, 0), (0, 1), (1, 1), (3, 0)], 7]
