"""rospy.Time and rospy.Duration, in whole nanoseconds, and the texts of their errors."""

from __future__ import annotations

import operator
import pickle
from typing import Any

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from rosspin import rospy, simulate
from rosspin.messages import genpy
from tests.helpers.python_texts import of_any_python

NS = 10**9
fast = settings(max_examples=80, deadline=None)

any_ns = st.integers(-(2**62), 2**62)
times = st.integers(0, 2**62).map(lambda ns: rospy.Time(0, ns))
durations = any_ns.map(lambda ns: rospy.Duration(0, ns))
seconds = st.floats(-1e6, 1e6)


@fast
@given(st.integers(-(2**31), 2**31), st.integers(-(2**40), 2**40))
def test_the_fields_are_whole_and_nsecs_stays_below_a_second(secs: int, nsecs: int) -> None:
    duration = rospy.Duration(secs, nsecs)
    assert 0 <= duration.nsecs < NS
    assert duration.secs * NS + duration.nsecs == duration.to_nsec() == secs * NS + nsecs


@fast
@given(seconds)
def test_seconds_are_cut_to_nanoseconds(value: float) -> None:
    # As genpy does it: the whole part, then what is left of a billion times the rest.
    whole = int(value)
    ns = whole * NS + int((value - whole) * NS)
    assert rospy.Duration(value).to_nsec() == rospy.Duration.from_sec(value).to_nsec() == ns
    assert rospy.Duration(value).to_sec() == pytest.approx(value, abs=2e-9)


def test_a_negative_duration_has_positive_nsecs() -> None:
    duration = rospy.Duration(-0.25)
    assert (duration.secs, duration.nsecs) == (-1, 750_000_000)
    assert duration.to_sec() == -0.25


@fast
@given(times, durations)
def test_sums_of_times_and_durations(time: Any, duration: Any) -> None:
    for function, operands, ns in (
        (operator.add, (time, duration), time.to_nsec() + duration.to_nsec()),
        (operator.add, (duration, time), time.to_nsec() + duration.to_nsec()),
        (operator.sub, (time, duration), time.to_nsec() - duration.to_nsec()),
    ):
        if ns < 0:
            with pytest.raises(TypeError, match="^time values must be positive\nrosspin: simulated clocks begin at 0"):
                function(*operands)
        else:
            result = function(*operands)
            assert type(result) is rospy.Time
            assert result.to_nsec() == ns


@fast
@given(durations, durations, st.integers(-1000, 1000))
def test_sums_and_multiples_of_durations(a: Any, b: Any, factor: int) -> None:
    for result, ns in (
        (a + b, a.to_nsec() + b.to_nsec()),
        (a - b, a.to_nsec() - b.to_nsec()),
        (-a, -a.to_nsec()),
        (abs(a), abs(a.to_nsec())),
        (a * factor, a.to_nsec() * factor),
        (factor * a, a.to_nsec() * factor),
    ):
        assert type(result) is rospy.Duration
        assert result.to_nsec() == ns


@fast
@given(times, times)
def test_times_differ_by_a_duration_of_genpy(a: Any, b: Any) -> None:
    assert type(a - b) is genpy.Duration
    assert (a - b).to_nsec() == a.to_nsec() - b.to_nsec()
    assert b + (a - b) == a


@fast
@given(durations, seconds, durations)
def test_division_goes_by_way_of_float_seconds(a: Any, number: float, b: Any) -> None:
    assume(number and b and abs(a.to_sec() / number) < 2**60 and abs(a.to_sec() * number) < 2**60)
    assert a / number == rospy.Duration.from_sec(a.to_sec() / number)
    assert a // number == rospy.Duration.from_sec(a.to_sec() // number)
    assert a * number == rospy.Duration.from_sec(a.to_sec() * number)
    assert a / b == a.to_sec() / b.to_sec()
    assert a // b == int(a.to_sec() // b.to_sec())
    assert a % b == rospy.Duration.from_sec(a.to_sec() % b.to_sec())
    assert divmod(a, b) == (a // b, a % b)
    assert {type(a / number), type(a // number), type(a % b)} == {rospy.Duration}


@fast
@given(st.sampled_from([rospy.Time, rospy.Duration]), st.integers(0, 2**40), st.integers(0, 2**40))
def test_comparisons_hash_and_truth(kind: Any, a: int, b: int) -> None:
    for compare in (operator.lt, operator.le, operator.gt, operator.ge, operator.eq, operator.ne):
        assert compare(kind(0, a), kind(0, b)) is compare(a, b)
    assert hash(kind(0, a)) == hash(kind(0, a))
    assert bool(kind(0, a)) is (a != 0) is not kind(0, a).is_zero()


def test_a_time_and_a_duration_are_not_compared() -> None:
    assert rospy.Time(1) != rospy.Duration(1)
    assert rospy.Time(1) != 1
    with pytest.raises(TypeError, match="'<' not supported between instances of 'Time' and 'Duration'"):
        rospy.Time(1) < rospy.Duration(1)


def test_fields_set_by_hand_are_compared_as_they_are() -> None:
    time = rospy.Time(0)
    time.set(0, NS)
    assert time != rospy.Time(1)
    time.canon()
    assert time == rospy.Time(1)


def test_how_they_are_written() -> None:
    assert repr(rospy.Time(1, 5)) == "rospy.Time[1000000005]"
    assert repr(rospy.Duration(-0.25)) == "rospy.Duration[-250000000]"
    assert repr(rospy.Time(2) - rospy.Time(0.5)) == "genpy.Duration[1500000000]"
    assert str(rospy.Time(1, 5)) == "1000000005"


@pytest.mark.parametrize("value", [rospy.Time(1, 5), rospy.Duration(-0.25)], ids=repr)
def test_they_can_be_pickled(value: Any) -> None:
    again = pickle.loads(pickle.dumps(value))
    assert (type(again), again) == (type(value), value)


POSITIVE = "time values must be positive"
UNSUPPORTED = "unsupported operand type(s) for "
TIME: Any = rospy.Time  # called in ways that its annotations forbid
DURATION: Any = rospy.Duration


@pytest.mark.parametrize(
    ("wrong", "error", "text"),
    [
        (lambda: TIME(-1), TypeError, POSITIVE),
        (lambda: TIME(-0.5), TypeError, POSITIVE),
        (lambda: TIME(0, -1), TypeError, POSITIVE),
        (lambda: TIME.from_sec(-1.0), TypeError, POSITIVE),
        (lambda: DURATION(1.5, 1), ValueError, "if secs is a float, nsecs cannot be set"),
        (lambda: TIME(1) + TIME(1), TypeError, UNSUPPORTED + "+: 'Time' and 'Time'"),
        (lambda: TIME(1) + 1, TypeError, UNSUPPORTED + "+: 'Time' and 'int'"),
        (lambda: TIME(1) - 1, TypeError, UNSUPPORTED + "-: 'Time' and 'int'"),
        (lambda: DURATION(1) + 1, TypeError, UNSUPPORTED + "+: 'Duration' and 'int'"),
        (lambda: DURATION(1) - 1.0, TypeError, UNSUPPORTED + "-: 'Duration' and 'float'"),
        (lambda: DURATION() - TIME(), TypeError, UNSUPPORTED + "-: 'Duration' and 'Time'"),
        (lambda: DURATION(1) * "2", TypeError, "can't multiply sequence by non-int of type 'Duration'"),
        (lambda: DURATION(1) % 1, TypeError, UNSUPPORTED + "%: 'Duration' and 'int'"),
        (lambda: DURATION(1) / 0, ZeroDivisionError, "division by zero"),
        (lambda: DURATION("1"), TypeError, UNSUPPORTED + "-: 'str' and 'int'"),
    ],
)
def test_what_goes_wrong_says_so_as_genpy_does(wrong: Any, error: type[Exception], text: str) -> None:
    with pytest.raises(error) as caught:
        wrong()
    assert type(caught.value) is error
    assert of_any_python(str(caught.value)) == text


@pytest.mark.parametrize("early", [rospy.Time.now, rospy.get_time, rospy.get_rostime, lambda: rospy.Rate(1)])
def test_before_init_node_there_is_no_time(early: Any) -> None:
    def node() -> None:
        with pytest.raises(rospy.ROSInitException) as caught:
            early()
        assert str(caught.value) == "time is not initialized. Have you called init_node()?"

    assert simulate(node, 1).status == 0


def test_now_is_the_time_since_the_start_of_a_simulated_run() -> None:
    def node() -> None:
        rospy.init_node("node")
        rospy.sleep(rospy.Duration(3, 5))
        assert rospy.Time.now() == rospy.get_rostime() == rospy.Time(3, 5)
        assert type(rospy.Time.now()) is rospy.Time
        assert rospy.get_time() == 3.000000005
        assert rospy.Time.from_seconds(1.5).to_time() == 1.5

    assert simulate(node, 10).status == 0
