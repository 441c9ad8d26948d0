"""Random nodes do the same on the stand-in and on the real rospy's own Python, to the nanosecond: see rospy_oracle."""

from __future__ import annotations

import operator
import sys
import threading
import time
from collections.abc import Callable
from copy import copy
from decimal import Decimal
from fractions import Fraction
from importlib import import_module
from operator import attrgetter
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from rospy_oracle import on_the_oracle, oracle, real_rospy

from rosspin import rospy, simulate
from rosspin.messages import genpy

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


@pytest.fixture(scope="module")
def folder(require: Callable[[str], None]) -> Path:
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
            """Wait for a moment at which nobody else does anything: who comes first then is nobody's promise."""
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
            say("timer", made.index(args.thread), "dies of", args.exc_type.__name__, args.exc_value)

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
    """The lines, those of one instant sorted: which of them comes first is nobody's promise."""
    return sorted(line.split() for line in console.splitlines())


@pytest.mark.filterwarnings("ignore:notifyAll:DeprecationWarning")
@given(specs)
@settings(max_examples=150, deadline=None, suppress_health_check=list(HealthCheck))
def test_random_nodes(folder: Path, spec: dict[str, Any]) -> None:
    node = program(spec)
    ours, theirs = simulate(node, END + 1), simulate(on_the_oracle(node, folder), END + 1)
    assert (ours.status, lines(ours.console)) == (theirs.status, lines(theirs.console))


# --- what is wrong ----------------------------------------------------------------------------------------------------

WRONG: dict[str, Callable[[Any], object]] = {
    "Rate(0)": lambda rospy: rospy.Rate(0),
    "Rate('1')": lambda rospy: rospy.Rate("1"),
    "Rate(inf)": lambda rospy: rospy.Rate(float("inf")).sleep_dur,
    "Rate(nan)": lambda rospy: rospy.Rate(float("nan")),
    "Timer(0)": lambda rospy: rospy.Timer(rospy.Duration(0), print).join(2),
    "Timer(1)": lambda rospy: rospy.Timer(1, print).join(2),
    "Timer(Time)": lambda rospy: rospy.Timer(rospy.Time(1), print).join(2),
    "Timer(callback)": lambda rospy: rospy.Timer(rospy.Duration(1), "print").join(2),
    "sleep('1')": lambda rospy: rospy.sleep("1"),
    "sleep(None)": lambda rospy: rospy.sleep(None),
    "sleep(Time)": lambda rospy: rospy.sleep(rospy.Time(1)),
    "sleep(-1)": lambda rospy: rospy.sleep(-1),
    "sleep(-9)": lambda rospy: rospy.sleep(-9),
    "sleep(nan)": lambda rospy: rospy.sleep(float("nan")),
    "sleep(inf)": lambda rospy: rospy.sleep(float("inf")),
    "wallsleep(-1)": lambda rospy: rospy.rostime.wallsleep(-1),
    "_set_rostime(1)": lambda rospy: rospy.rostime._set_rostime(1),
    "_set_rostime(None)": lambda rospy: rospy.rostime._set_rostime(None),
}


@pytest.mark.filterwarnings("ignore:notifyAll:DeprecationWarning")
@pytest.mark.parametrize("told", [False, True])
@pytest.mark.parametrize("wrong", WRONG)
def test_what_is_wrong(folder: Path, wrong: str, told: bool) -> None:
    def node() -> None:
        import rospy

        def tell(text: str) -> None:
            sys.stdout.write(f"{time.time_ns()} {text}\n")

        threading.excepthook = lambda args: tell(f"thread: {args.exc_type.__name__}: {args.exc_value}")
        tell(outcome(WRONG[wrong], rospy))
        rospy.init_node("node")
        if told:
            rospy.rostime._set_rostime(rospy.Time(5))
        tell(outcome(WRONG[wrong], rospy))

    ours, theirs = simulate(node, 20), simulate(on_the_oracle(node, folder), 20)
    assert (ours.status, ours.console) == (theirs.status, theirs.console)


# --- times and durations ----------------------------------------------------------------------------------------------

numbers = st.one_of(
    st.sampled_from([0, 1, -1, 0.5, -0.25, 2.3]),
    st.integers(-(2**33), 2**33),
    st.floats(-1e10, 1e10),
    st.floats(),
    st.sampled_from([True, Fraction(1, 3), Decimal("1.5"), "1", None, 10**400]),
)
times = st.tuples(
    st.sampled_from(["rospy.Time", "rospy.Duration", "genpy.Time", "genpy.Duration"]),
    numbers,
    st.one_of(st.just(0), st.just(0), st.integers(-(2**62), 2**62), numbers),
)
TWO = ("add", "sub", "mul", "truediv", "floordiv", "mod", "lt", "le", "gt", "ge", "eq", "ne", "iadd", "isub")
OPERATIONS: dict[str, Callable[..., object]] = {
    **{name: getattr(operator, name) for name in TWO},
    "divmod": divmod,
    "from_sec": lambda a, b: a.from_sec(b),
    "set": lambda a, b: (a.set(a.nsecs, a.secs), str(a), a == b, a.canon(), a, a + b),
    "all of one": lambda a, b: (a.secs, a.nsecs, str(a), hash(a), bool(a), a.to_sec(), a.to_nsec(), a.is_zero()),
    "neg": lambda a, b: -a,
    "abs": lambda a, b: abs(a),
    "copy": lambda a, b: copy(a),
    "to_time": lambda a, b: a.to_time(),
}


def outcome(function: Callable[..., object], *operands: object) -> str:
    """What is returned or raised, as text."""
    try:
        return repr(function(*operands))
    except Exception as error:
        return f"{type(error).__name__}: {error}"


@pytest.fixture(scope="module")
def theirs(folder: Path) -> dict[str, Any]:
    """The real rospy's and genpy's classes, by their names."""
    with oracle(folder):
        return {name: import_module(name) for name in ("rospy", "genpy")}


@given(st.sampled_from(list(OPERATIONS)), times, st.one_of(times, numbers))
@settings(max_examples=500, deadline=None)
def test_times_and_durations(theirs: dict[str, Any], operation: str, one: Any, other: Any) -> None:
    def calculate(of: dict[str, Any]) -> object:
        def made(what: Any) -> Any:
            return attrgetter(what[0])(SimpleNamespace(**of))(*what[1:]) if isinstance(what, tuple) else what

        return OPERATIONS[operation](made(one), made(other))

    assert outcome(calculate, {"rospy": rospy, "genpy": genpy}) == outcome(calculate, theirs)
