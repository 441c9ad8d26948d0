"""Nodes that start thread after thread, and what each test of them looks for."""

from __future__ import annotations

import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from textwrap import dedent
from types import FunctionType
from typing import Any

import pytest

from rosspin import simulate
from rosspin.clocks import watchdog
from rosspin.clocks.ending import Ended

SLEEPING = """
    def work():
        SLEEP(1)

    while True:
        threading.Thread(target=work).start()
"""
_DAEMONS = """
    while True:
        threading.Thread(target=SLEEP, args=(1,), daemon=True).start()
"""
CHILDREN = """
    def work():
        threading.Thread(target=work).start()
        threading.Thread(target=work).start()
        SLEEP(0.1)

    work()
"""
_UNASKED = """
    while True:
        _thread.start_new_thread(SLEEP, (1,))
        SLEEP(0.0001)
"""
_POOLS = """
    def work():
        concurrent.futures.ThreadPoolExecutor(1).submit(work)
        SLEEP(1)

    work()
"""
_LAST_WILL = """
    def work():
        try:
            SLEEP(1)
        finally:
            while True:
                threading.Thread(target=work).start()

    while True:
        threading.Thread(target=work).start()
"""
TIMERS = """
    def callback(event):
        rospy.Timer(rospy.Duration(0.01), callback)
        rospy.Timer(rospy.Duration(0.01), callback)

    callback(None)
    rospy.spin()
"""
RATES = """
    node = rclpy.create_node("node")
    while True:
        threading.Thread(target=node.create_rate(10).sleep, daemon=True).start()
"""
OBSTINATE = """
    def work():
        while True:
            try:
                SLEEP(1)
            except BaseException:
                pass

    while True:
        threading.Thread(target=work, daemon=True).start()
"""

BOTH = {
    "sleeping": SLEEPING,
    "daemons": _DAEMONS,
    "children": CHILDREN,
    "without Thread": _UNASKED,
    "pools": _POOLS,
    "last will": _LAST_WILL,
    "obstinate": OBSTINATE,
}


def source(ros: int, body: str) -> str:
    begin = {1: "import rospy\nrospy.init_node('node')", 2: "import rclpy, time\nrclpy.init()"}[ros]
    body = dedent(body).replace("SLEEP", {1: "rospy.sleep", 2: "time.sleep"}[ros])
    return f"import _thread, concurrent.futures, threading\n{begin}\n{body}"


SOME = [pytest.param(source(ros, SLEEPING), id=f"ros{ros}") for ros in (1, 2)]


@contextmanager
def noting(monkeypatch: pytest.MonkeyPatch) -> Iterator[list[bool]]:
    """For each Ended, whether a run was being taken down when it was raised; none is raised unheard."""
    found: list[bool] = []
    unheard: list[Any] = []
    taken_down = False
    init, begin = Ended.__init__, watchdog.Watchdog._begin

    def note(self: Ended) -> None:
        found.append(taken_down)
        init(self)

    def beginning(self: watchdog.Watchdog, taking_down: bool) -> None:
        nonlocal taken_down
        begin(self, taking_down)
        taken_down = taking_down

    # As a function of rosspin, in which nothing is raised.
    ours = FunctionType(note.__code__, {"__name__": "rosspin"}, closure=note.__closure__)
    monkeypatch.setattr(Ended, "__init__", ours)
    monkeypatch.setattr(watchdog.Watchdog, "_begin", beginning)
    monkeypatch.setattr(sys, "unraisablehook", unheard.append)
    yield found
    assert not unheard


def as_before() -> bool:
    """Whether a run is as always, and nothing of an earlier one is in the way."""

    def node() -> None:
        threads = [threading.Thread(target=print, args=(number,)) for number in range(3)]
        for thread in threads:
            thread.start()

    return simulate(node, 1).console == "0\n1\n2\n" and sys.gettrace() is None
