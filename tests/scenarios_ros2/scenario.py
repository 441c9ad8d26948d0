"""What the scenarios share.

A line that begins with @ holds times, which the test compares with a tolerance; every other line must be the same on
each runtime, byte for byte, but for stamps.
"""

import os
import sys
import threading
import time

P = 0.4  # the period of timers and rates, s

_zero = [0.0]


def begin():
    """Times count from here. Make the nodes first, which takes its time on a real ROS."""
    threading.Thread(target=_watch, daemon=True).start()
    _zero[0] = time.monotonic()
    _write(f"@zero {time.time():.4f}")


def _watch():
    """Print when this process has not been running for a while: what came late then is no fault of rclpy's."""
    while True:
        before = time.monotonic()
        time.sleep(0.01)
        late = time.monotonic() - before - 0.01
        if late > 0.01:
            _write(f"@stall {late:.3f}")


def now():
    """Seconds since the beginning."""
    return time.monotonic() - _zero[0]


def mark(label, *times):
    """Print times (now, if none is given)."""
    _write(" ".join(["@" + label, *[f"{value:.4f}" for value in times or (now(),)]]))


def _write(line):
    # In one go, so that the lines of several threads do not mix.
    sys.stdout.write(line + "\n")
    sys.stdout.flush()


def arg(name, default=0.0):
    """A number from the command line: ``block:=2.4``."""
    words = [word.partition(":=")[2] for word in sys.argv if word.startswith(name + ":=")]
    return float(words[0]) if words else default


def block(periods):
    """Take so many periods of time; jitter:=SECONDS comes on top."""
    time.sleep(periods * P + arg("jitter"))


def until(periods):
    """Let time go by until so many periods after the beginning; jitter comes on top."""
    block(max(0.0, periods - now() / P))


def say(*words):
    """Print words in one go, so that the lines of several threads do not mix."""
    _write(" ".join(str(word) for word in words))


def end_after(periods):
    """After so many periods the process ends at once, whatever it does then: no race with a shutdown."""

    def end():
        time.sleep(periods * P)
        mark("end")
        os._exit(0)

    threading.Thread(target=end, daemon=True).start()


def after(periods, function):
    """Call a function after so many periods, in a thread of its own."""

    def call():
        until(periods)
        function()

    threading.Thread(target=call, daemon=True).start()


def attempt(text, names=None):
    """Print an expression and its value, or the exception that it raises."""
    try:
        value = repr(eval(text, names or {}))
    except Exception as error:
        value = f"{type(error).__name__}: {error}"
    say(text, "->", value)
