"""What is said of threads that wait for each other, in both ROSes, and of those that only wait."""

from __future__ import annotations

from typing import Any

import pytest

from rosspin import simulate

LOCKS = """
import threading, rospy
rospy.init_node("n")
a, b = threading.{kind}(), threading.{kind}()
def one(event):
    with a:
        rospy.sleep(0.1)
        with b: pass
def two(event):
    with b:
        rospy.sleep(0.1)
        with a: pass
rospy.Timer(rospy.Duration(0.5), one)
rospy.Timer(rospy.Duration(0.5), two)
rospy.spin()
"""
RING = """\
rosspin: deadlock. This can never continue:
rosspin:   the thread Thread-1 waits for a lock that the thread Thread-2 holds
rosspin:     at FILE:8: with b: pass
rosspin:   the thread Thread-2 waits for a lock that the thread Thread-1 holds
rosspin:     at FILE:12: with a: pass
rosspin: Take the locks in the same order everywhere.
"""
TWICE = """
import threading, rospy
rospy.init_node("n")
lock = threading.Lock()
def tick(event):
    with lock:
        with lock: pass
rospy.Timer(rospy.Duration(0.5), tick)
rospy.spin()
"""
HELD_TWICE = """\
rosspin: deadlock. This can never continue:
rosspin:   the thread Thread-1 waits for a lock that it holds
rosspin:     at FILE:7: with lock: pass
rosspin: A threading.Lock cannot be taken twice by one thread: release it first, or use an RLock.
"""
JOIN = """
import threading, time
import rclpy
lock = threading.Lock()
def work():
    time.sleep(0.1)
    with lock: pass
thread = threading.Thread(target=work, name="worker", daemon=True)
with lock:
    thread.start()
    thread.join()
"""
JOINED = """\
rosspin: deadlock. This can never continue:
rosspin:   the thread MainThread waits for the end of the thread worker
rosspin:     at FILE:11: thread.join()
rosspin:   the thread worker waits for a lock that the thread MainThread holds
rosspin:     at FILE:7: with lock: pass
rosspin: Hold no lock while you wait for a thread that needs it.
"""

BOTH = """
import threading, time
threads = []
def one(): time.sleep(0.1); threads[1].join()
def two(): time.sleep(0.1); threads[0].join()
threads += [threading.Thread(target=work, daemon=True) for work in (one, two)]
for thread in threads: thread.start()
time.sleep(9)
"""
JOINED_BOTH = """\
rosspin: deadlock. This can never continue:
rosspin:   the thread Thread-1 (one) waits for the end of the thread Thread-2 (two)
rosspin:     at FILE:4: threads[1].join()
rosspin:   the thread Thread-2 (two) waits for the end of the thread Thread-1 (one)
rosspin:     at FILE:5: threads[0].join()
rosspin: One of them has to continue without waiting for the other.
"""
CALL = """
import threading, rospy
from std_srvs.srv import Trigger
rospy.init_node("n")
lock = threading.Lock()
def handle(request):
    with lock: pass
    return {}
rospy.Service("work", Trigger, handle)
def tick(event):
    with lock:
        rospy.ServiceProxy("work", Trigger)()
rospy.Timer(rospy.Duration(0.5), tick)
rospy.spin()
"""
CALLED = """\
rosspin: deadlock. This can never continue:
rosspin:   the thread Thread-1 waits for the answer of /work, which the thread Thread-2 (handle) has to give
rosspin:     at FILE:12: rospy.ServiceProxy("work", Trigger)()
rosspin:   the thread Thread-2 (handle) waits for a lock that the thread Thread-1 holds
rosspin:     at FILE:7: with lock: pass
rosspin: Hold no lock while you wait for a thread that needs it.
"""


@pytest.mark.parametrize(
    ("source", "said"),
    [
        (CALL, CALLED),
        (BOTH, JOINED_BOTH),
        (LOCKS.format(kind="Lock"), RING),
        (LOCKS.format(kind="RLock"), RING),
        (TWICE, HELD_TWICE),
        (JOIN, JOINED),
    ],
    ids=["call", "both", "locks", "rlocks", "twice", "join"],
)
def test_threads_that_wait_for_each_other_are_told(write: Any, source: str, said: str) -> None:
    path = write(source)
    assert said.replace("FILE", str(path)) in simulate(path, 2).console


WAITING = """
import queue, threading, rospy
rospy.init_node("n")
condition, lock = threading.Condition(), threading.Lock()
def wait():
    with condition:
        condition.wait()
def hold():
    with lock:
        rospy.sleep(100)
def ask():
    with lock: pass
for work in (wait, hold, ask, queue.Queue().get, threading.Event().wait, threading.Semaphore(0).acquire):
    threading.Thread(target=work, daemon=True).start()
rospy.spin()
"""


def test_nothing_is_said_of_threads_that_only_wait(write: Any) -> None:
    assert simulate(write(WAITING), 2).console == ""


HAS_WAITED = """
import asyncio, threading, time
lock = threading.Lock()
def work():
    with lock: pass
    asyncio.new_event_loop().run_forever()
thread = threading.Thread(target=work, daemon=True)
with lock:
    thread.start()
    time.sleep(0.1)
time.sleep(0.1)
with lock: thread.join()
"""


def test_a_thread_does_not_wait_for_a_lock_that_it_has_had(write: Any) -> None:
    assert "can never continue" not in simulate(write(HAS_WAITED), 2).console
