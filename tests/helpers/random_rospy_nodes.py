"""Random nodes for the stand-in and for the real rospy's own Python: see rospy_oracle."""

from __future__ import annotations

import sys
import threading
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from hypothesis import strategies as st

from rosspin import simulate

from .rospy_oracle import on_the_oracle, real_rospy

MS = 1_000_000
BEGIN, END = 1000, 1005  # s: as on a real machine, no time is near 0 but one that is told

# Lengths of time in ms: some that fall together often, some that hardly ever do; and periods in ns.
lengths = st.one_of(st.sampled_from([100, 200, 250, 300, 500, 700, 1000]), st.integers(50, 1500))
periods = st.one_of(lengths.map(lambda ms: ms * MS), st.integers(50 * MS, 1500 * MS))

# What a pass works, in periods and ns: mostly around the limits of 1, 2 and 3 periods. See ``length``.
works = st.lists(
    st.tuples(st.sampled_from([0, 0, 0, 0.3, 0.7, 1, 1.2, 2, 2.2, 3, 3.5, 7]), st.sampled_from([0, 0, 0, -1, 1, 2])),
    min_size=1,
    max_size=4,
)

# What a callback does, to which timer, with which length: see ``act``.
acts = st.tuples(
    st.sampled_from(["nothing"] * 8 + ["stop", "make", "raise", "sleep", "sleep seconds", "wallsleep", "shut down"]),
    st.integers(0, 3),
    lengths,
)
timers = st.fixed_dictionaries(
    {
        "period": periods,
        "oneshot": st.sampled_from([False, False, False, True]),
        "reset": st.booleans(),
        "works": works,
        "acts": st.lists(acts, min_size=1, max_size=4),
    }
)
rates = st.fixed_dictionaries(
    {
        "hz": st.one_of(st.sampled_from([1, 10, 3.0, 7.0, -2.0]), periods.map(lambda ns: 1e9 / ns)),
        "reset": st.booleans(),
        "works": works,
        "looks": st.booleans(),
        "changes": st.one_of(st.none(), st.none(), periods),
    }
)
# How the ROS time is told: after how many ms, and by how much it has moved since, in ms; None: not told any more.
tellings = st.lists(
    st.tuples(
        st.sampled_from([20, 50, 100, 100, 250, 600]),
        st.one_of(st.sampled_from([0, 50, 100, 100, 100, 100, 250, 600, 3000, 2_000_000, -50, -700, -5000]), st.none()),
    ),
    min_size=1,
    max_size=30,
)
specs = st.fixed_dictionaries(
    {
        "timers": st.lists(timers, min_size=1, max_size=4),
        "rates": st.lists(rates, max_size=2),
        "thread": st.lists(st.tuples(lengths, acts), max_size=3),
        "told": st.one_of(st.none(), tellings),
    }
)


def rospy_folder(require: Callable[[str], None]) -> Path:
    """The real rospy's."""
    found = real_rospy()
    if found is None:
        require("ros1")
        pytest.fail("ROS 1 is installed, but its rospy is not where it is looked for")
    return found


def length(work: tuple[float, int], period: int) -> int:
    """What a pass works, in ns: whole periods, whole ms of another, and some ns."""
    periods, ns = work
    whole = int(periods)
    return max(whole * period + round((periods - whole) * period / MS) * MS + ns, 0)


def program(spec: dict[str, Any]) -> Callable[[], None]:
    """A node as a specification has it, which prints the time (ns) of all that it does."""

    def node() -> None:
        import rospy  # type: ignore[import-not-found]
        from rospy import rostime

        def say(*words: object) -> None:
            if not over:  # how a process ends is another question
                sys.stdout.write(" ".join([str(time.time_ns()), repr(rospy.Time.now()), *map(str, words)]) + "\n")

        def nap(ns: int) -> None:
            if ns:
                time.sleep(ns / 1e9)

        def alone(who: int, call: int) -> None:
            """Wait for a moment at which nothing else happens: who comes first then is not promised."""
            nap((who * 100_000 + call * 1000 + 500 - time.time_ns()) % MS)

        def make(timer: dict[str, Any]) -> None:
            number, calls = len(made), 0

            def callback(event: Any) -> None:
                nonlocal calls
                calls += 1
                duration = None if event.last_duration is None else float(event.last_duration)
                times = event.last_expected, event.last_real, event.current_expected, event.current_real
                say("timer", number, calls, *map(repr, times), duration)
                nap(length(timer["works"][calls % len(timer["works"])], timer["period"]))
                if calls < 100:
                    act(number, calls, *timer["acts"][calls % len(timer["acts"])])
                say("timer", number, "ends", calls)

            made.append(rospy.Timer(rospy.Duration(0, timer["period"]), callback, timer["oneshot"], timer["reset"]))

        def act(who: int, call: int, what: str, which: int, ms: int) -> None:
            if what in ("stop", "make", "shut down"):
                alone(who, call)
            if what == "stop":
                made[which % len(made)].shutdown()
            elif what == "make" and len(made) < 8:
                make(spec["timers"][which % len(spec["timers"])])
            elif what == "raise":
                raise ValueError(ms)
            elif what == "sleep":
                rospy.sleep(rospy.Duration(0, ms * MS))
            elif what == "sleep seconds":
                rospy.sleep(ms / 1000 * (-1) ** which)
            elif what == "wallsleep":
                rostime.wallsleep(ms / 1000)
            elif what == "shut down" and which == 0:
                rospy.signal_shutdown("")

        def from_outside() -> None:
            for call, (ms, what) in enumerate(spec["thread"]):
                nap(ms * MS)
                act(8, call, *what)

        def tell() -> None:
            told = 0
            for call, (ms, moved) in enumerate(spec["told"]):
                nap(ms * MS)
                alone(9, call)
                if moved is None:
                    rostime.switch_to_wallclock()
                else:
                    told = max(told + moved * MS, 0)
                    rostime._set_rostime(rospy.Time(0, told))

        def loop(number: int, of: dict[str, Any], rate: Any) -> None:
            for count in range(20):
                nap(length(of["works"][count % len(of["works"])], abs(rate.sleep_dur.to_nsec())))
                if of["changes"] and count == 5:
                    rate.sleep_dur = rospy.Duration(0, of["changes"])
                    rate.last_time = rospy.Time.now()
                if of["looks"]:
                    say("rate", number, "remaining", repr(rate.remaining()))
                try:
                    rate.sleep()
                except Exception as error:
                    say("rate", number, type(error).__name__, error, getattr(error, "time", ""))
                    nap(50 * MS)
                say("rate", number, count, repr(rate.last_time), repr(rate.sleep_dur))

        def note(args: Any) -> None:
            who = made.index(args.thread) if args.thread in made else "none"
            say("timer", who, "dies of", args.exc_type.__name__, args.exc_value)

        over: list[bool] = []
        time.sleep(BEGIN)
        rospy.init_node("node")
        threading.excepthook = note
        rospy.on_shutdown(lambda: say("shuts down", rospy.is_shutdown()))
        if spec["told"] is not None:
            rostime._set_rostime(rospy.Time(0))
            threading.Thread(target=tell, daemon=True).start()
        made: list[Any] = []
        for timer in spec["timers"]:
            make(timer)
        for number, rate in enumerate(spec["rates"]):
            # With a negative one, which never sleeps, times just after 0 would have others before them.
            hz = rate["hz"] if spec["told"] is None else abs(rate["hz"])
            arguments = (number, rate, rospy.Rate(hz, rate["reset"]))
            threading.Thread(target=loop, args=arguments, daemon=True).start()
        threading.Thread(target=from_outside, daemon=True).start()
        time.sleep(END - BEGIN)
        alone(9, 99)
        say(*(timer.is_alive() for timer in made))
        over.append(True)

    return node


def lines(console: str) -> list[list[str]]:
    """The lines, sorted within an instant: which of them comes first is not promised."""
    return sorted(line.split() for line in console.splitlines())


def do_the_same(folder: Path, spec: dict[str, Any]) -> None:
    """Such a node does the same on the stand-in and on the oracle, to the nanosecond."""
    node = program(spec)
    ours, theirs = simulate(node, END + 1), simulate(on_the_oracle(node, folder), END + 1)
    assert (ours.status, lines(ours.console)) == (theirs.status, lines(theirs.console))
