"""Runs in the process of a node on the real rclpy, before the node's file, and tells of its ticks.

``ros2`` starts it through ``sitecustomize``. It writes these lines, each in one go, and ``ros2`` takes them out again:

    ESC ]rosspin;begin NANOSECONDS BEL \n
    ESC ]rosspin;tick SOURCE TAB NUMBER TAB EXPECTED TAB REAL BEL \n
    ESC ]rosspin;done SOURCE TAB NUMBER TAB DURATION BEL \n

It waits until the node imports what it changes: until then, no module of rclpy is there that would not be there anyway.
No function of ours calls a callback, so its traceback is what it would be without the probe. The probe notices when an
executor takes a timer, which is right before the callback, and when the timer's group is told that the callback is
over.
"""

import os
import sys
import threading
import time
from importlib.abc import MetaPathFinder
from importlib.machinery import PathFinder

_console = os.dup(2)  # the node may redirect its own
_names = {}  # how often each has been given


def _tell(word, *fields):
    words = "\t".join(map(str, fields))
    os.write(_console, f"\x1b]rosspin;{word} {words}\x07\n".encode())


def _source(name):
    """Make a new name for something that ticks."""
    _names[name] = number = _names.get(name, 0) + 1
    return name if number == 1 else f"{name} {number}"


class _Ticks:
    """The ticks of one timer or Rate."""

    def __init__(self, name):
        self.source = _source(name)
        self.number = 0

    def tell(self, expected, real):
        self.number += 1
        _tell("tick", self.source, self.number, expected, real)
        return self.source, self.number, real


def _tell_done(source, number, real):
    _tell("done", source, number, time.time_ns() - real)


def _after(target, name, then):
    """Replace a method by one that then also calls ``then``, with the same arguments."""
    real = getattr(target, name)

    def method(*args, **kwargs):
        result = real(*args, **kwargs)
        then(*args, **kwargs)
        return result

    setattr(target, name, method)


def _node_made(node, *args, **kwargs):
    global _begun
    if not _begun:
        _begun = True
        _tell("begin", time.time_ns())


_begun = False


# --- timers -----------------------------------------------------------------------------------------------------------


def _made(timer, callback, *args, **kwargs):
    # An executor makes timers for itself, and a Rate has one: neither has a callback when it is made.
    timer._rosspin_ticks = callback and _Ticks(getattr(callback, "__name__", type(callback).__name__))
    timer._rosspin_rate = None
    timer._rosspin_running = {}  # by thread: in a reentrant group a callback may overlap itself


def _taking(real):
    from rclpy.exceptions import InvalidHandle

    def take(executor, timer, *args):
        try:
            expected = time.time_ns() + timer.time_until_next_call()
        except (InvalidHandle, TypeError):  # destroyed or cancelled meanwhile
            expected = None
        taken = real(executor, timer, *args)
        if taken is not None and expected is not None:
            if timer._rosspin_ticks:
                tick = timer._rosspin_ticks.tell(expected, time.time_ns())
                timer._rosspin_running[threading.get_ident()] = tick
            elif timer._rosspin_rate and not timer._rosspin_rate._event.is_set():
                # If the timer is called more than once during a long pass, the first call ends the sleep.
                timer._rosspin_rate._rosspin_due = expected
        return taken

    return take


def _ended(group, entity):
    running = getattr(entity, "_rosspin_running", None)
    if running:
        # A callback that awaits something may end in another thread than it began in.
        thread = threading.get_ident()
        _tell_done(*running.pop(thread if thread in running else next(iter(running))))


# --- rates: a pass begins when the last sleep has ended, the first one when the Rate is made --------------------------


def _rate_made(rate, timer, *args, **kwargs):
    timer._rosspin_rate = rate
    rate._rosspin_ticks = _Ticks("Rate")
    rate._rosspin_due = time.time_ns()
    _woken(rate)


def _sleeps(rate):
    _tell_done(*rate._rosspin_ticks.tell(*rate._rosspin_pass))


def _woken(rate):
    rate._rosspin_pass = rate._rosspin_due, time.time_ns()


# --- what is changed, as soon as the node imports it ------------------------------------------------------------------


def _change_groups(module):
    for group in (module.MutuallyExclusiveCallbackGroup, module.ReentrantCallbackGroup):
        _after(group, "ending_execution", _ended)


def _change_executors(module):
    module.Executor._take_timer = _taking(module.Executor._take_timer)


def _change_node(module):
    _after(module.Node, "__init__", _node_made)


def _change_timer(module):
    _after(module.Timer, "__init__", _made)
    _after(module.Rate, "__init__", _rate_made)
    _after(module.Rate, "_presleep", _sleeps)
    _after(module.Rate, "_postsleep", _woken)


_CHANGES = {
    "rclpy.callback_groups": _change_groups,
    "rclpy.executors": _change_executors,
    "rclpy.node": _change_node,
    "rclpy.timer": _change_timer,
}


class _Finder(MetaPathFinder):
    def find_spec(self, fullname, path=None, target=None):
        spec = PathFinder.find_spec(fullname, path) if fullname in _CHANGES else None
        if spec:
            _after(spec.loader, "exec_module", _CHANGES[fullname])
        return spec


sys.meta_path.insert(0, _Finder())
