"""What the scenarios share.

A line that begins with @ holds times, which the test compares with a tolerance; every other line must be the same on
each runtime, byte for byte.
"""

import sys
import threading
import time

import rospy

P = 0.4  # the period of timers and rates, s

_zero = [0.0]


def begin(name, **options):
    """Start the node ``name``; times count from here."""
    rospy.init_node(name, **options)
    threading.Thread(target=_watch, daemon=True).start()
    _zero[0] = rospy.get_time()
    _write(f"@zero {time.time():.4f}")


def _watch():
    """Print when this process has not been running for a while: what came late then is no fault of rospy's."""
    while True:
        before = time.monotonic()
        time.sleep(0.01)
        late = time.monotonic() - before - 0.01
        if late > 0.01:
            _write(f"@stall {late:.3f}")


def now():
    """Seconds since the beginning."""
    return rospy.get_time() - _zero[0]


def mark(label, *times):
    """Print times (now, if none is given): Time since the beginning, numbers and None as they are."""
    _write(" ".join(["@" + label, *[_seconds(value) for value in times or (now(),)]]))


def _write(line):
    # In one go, so that the lines of several threads do not mix.
    sys.stdout.write(line + "\n")
    sys.stdout.flush()


def _seconds(value):
    if value is None:
        return "None"
    return f"{value.to_sec() - _zero[0] if hasattr(value, 'to_sec') else value:.4f}"


def mark_event(label, event):
    """Print every field of a TimerEvent."""
    mark(
        label,
        event.last_expected,
        event.last_real,
        event.current_expected,
        event.current_real,
        event.last_duration,
    )


def block(periods):
    """Take so many periods of time, on the wall; ~jitter (s) comes on top."""
    time.sleep(periods * P + rospy.get_param("~jitter", 0.0))


def until(periods):
    """Let time go by until so many periods after the beginning; ~jitter comes on top."""
    block(max(0.0, periods - now() / P))


def say(*words):
    """Print words in one go, so that the lines of several threads do not mix."""
    _write(" ".join(str(word) for word in words))


def end_after(periods):
    """Let so many periods go by, then shut the node down."""
    time.sleep(periods * P)
    mark("end")
    rospy.signal_shutdown("end of the scenario")


def attempt(text, names=None):
    """Print an expression and its value, or the exception that it raises."""
    try:
        value = repr(eval(text, {"rospy": rospy, **(names or {})}))
    except Exception as error:
        value = f"{type(error).__name__}: {error}"
    print(text, "->", value, flush=True)
