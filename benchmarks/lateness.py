"""How late the wall clock's Timer and Rate are, beside a plain Python loop that sleeps until absolute deadlines."""

from __future__ import annotations

import time
from collections.abc import Iterator, Sequence

from rosspin import measure, rospy
from rosspin.measures import quantile, say_time

from .ratios import line

# Hz and seconds of a turn: each makes ticks enough for a 99th percentile, the slowest barely.
TURNS = ((2, 5.0), (50, 2.0), (500, 1.0))


def report(turns: Sequence[tuple[int, float]] = TURNS, rounds: int = 4) -> Iterator[str]:
    """The lines of the report. There is no goal: how late the deadlines are is up to the machine."""
    yield "Lateness on the wall clock, beside absolute deadlines in plain Python"
    for hertz, seconds in turns:
        late: dict[str, list[float]] = {"Timer": [], "Rate": [], "deadlines": []}
        for _ in range(rounds):
            late["Timer"] += of_timer(hertz, seconds)
            late["Rate"] += of_rate(hertz, seconds)
            late["deadlines"] += of_deadlines(hertz, seconds)
        for percent in (50, 99):
            at = {name: quantile(values, percent / 100) for name, values in late.items()}
            for name in ("Timer", "Rate"):
                yield line(
                    f"  {hertz} Hz, p{percent} of {len(late[name])} ticks, {name} / deadlines",
                    at[name] / at["deadlines"],
                    times=f"{say_time(at[name])} / {say_time(at['deadlines'])}",
                )


def of_timer(hertz: float, seconds: float) -> list[float]:
    """How late (s) a rospy.Timer calls back."""

    def node() -> None:
        rospy.init_node("timer")
        rospy.Timer(rospy.Duration(1 / hertz), lambda event: None)
        rospy.spin()

    return [tick.lateness for tick in measure(node, seconds).ticks]


def of_rate(hertz: float, seconds: float) -> list[float]:
    """How late (s) the passes of a rospy.Rate loop begin."""

    def node() -> None:
        rospy.init_node("rate")
        rate = rospy.Rate(hertz)
        while not rospy.is_shutdown():
            rate.sleep()

    first, *others = measure(node, seconds).ticks
    return [tick.lateness for tick in others]  # the first waits for nothing


def of_deadlines(hertz: float, seconds: float) -> list[float]:
    """How late (s) a loop is that sleeps until one deadline after another."""
    late = []
    start = time.time()
    for number in range(1, int(seconds * hertz)):
        deadline = start + number / hertz
        time.sleep(max(0.0, deadline - time.time()))
        late.append(time.time() - deadline)
    return late
