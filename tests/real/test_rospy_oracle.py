"""What is wrong, and times, on the stand-in and on the real rospy's own Python, to the nanosecond: see rospy_oracle."""

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
from hypothesis import given, settings
from hypothesis import strategies as st

from rosspin import rospy, simulate
from rosspin.messages import genpy
from tests.helpers.random_rospy_nodes import rospy_folder
from tests.helpers.rospy_oracle import on_the_oracle, oracle


@pytest.fixture(scope="module")
def folder(require: Callable[[str], None]) -> Path:
    return rospy_folder(require)


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
        import rospy  # type: ignore[import-not-found]

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
