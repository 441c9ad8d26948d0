"""Tests of what a run is on either clock. ``run`` is rosspin.simulate, or in tests/real rosspin.measure."""

from __future__ import annotations

import _thread
import logging
import os
import signal
import sys
import tempfile
import threading
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import pytest

import rosspin
from rosspin import NotSimulated, rospy, simulate
from rosspin.run.explain import say_error

# Only so that a test that hangs ends at all.
NEVER = 60

Run = Callable[..., rosspin.Run]


def test_a_run_leaves_the_process_as_it_was(run: Run, write: Any) -> None:
    write("value = 1", "neighbour.py")
    path = write("import sys, rospy, rospy.rostime, neighbour\nsys.path.append('x')\nsys.argv.append('y')\nsys.exit(5)")
    before = sys.argv, sys.argv[:], sys.path[:], sys.stdout, sys.stderr, set(sys.modules), sys.modules["__main__"]
    handlers = signal.getsignal(signal.SIGINT), signal.getsignal(signal.SIGTERM)
    assert run(path, NEVER).status == 5
    after = sys.argv, sys.argv[:], sys.path[:], sys.stdout, sys.stderr, set(sys.modules), sys.modules["__main__"]
    assert after == before
    assert (signal.getsignal(signal.SIGINT), signal.getsignal(signal.SIGTERM)) == handlers
    assert "rospy" not in sys.modules or not sys.modules["rospy"].__name__.startswith("rosspin")


ONE = "import rospy, threading\nfrom std_msgs.msg import UInt32\nrospy.init_node('node')\n"
TWO = "import rclpy, threading\nrclpy.init()\nnode = rclpy.create_node('node')\n"
TWO += "from std_msgs.msg import UInt32\n"
CALLBACK = "def callback(*args):\n    import cv_bridge\n"
PUBLISHES = "publisher = rospy.Publisher('a', UInt32, queue_size=1)\nfor _ in range(9):\n"
PUBLISHES += "    publisher.publish(1)\n    rospy.sleep(0.1)\n"
IN_A_THREAD = "threading.Thread(target=callback).start()\n"


@pytest.mark.parametrize(
    "calls",
    [
        (ONE, "rospy.Timer(rospy.Duration(0.1), callback)\nrospy.spin()\n"),
        (ONE, f"rospy.Subscriber('a', UInt32, callback)\n{PUBLISHES}"),
        (ONE, f"{IN_A_THREAD}rospy.spin()\n"),
        (TWO, "node.create_timer(0.1, callback)\nrclpy.spin(node)\n"),
        (TWO, f"{IN_A_THREAD}rclpy.spin(node)\n"),
        (
            TWO,
            "node.create_subscription(UInt32, 'a', callback, 1)\npublisher = node.create_publisher(UInt32, 'a', 1)\n"
            "node.create_timer(0.1, lambda: publisher.publish(UInt32()))\nrclpy.spin(node)\n",
        ),
    ],
    ids=["timer", "subscriber", "thread", "timer 2", "thread 2", "subscriber 2"],
)
def test_a_package_of_ros_that_is_imported_late_is_named(run: Run, write: Any, calls: tuple[str, str]) -> None:
    node = write(calls[0] + CALLBACK + calls[1])
    with pytest.raises(NotSimulated, match=r"cv_bridge is not simulated; run this node on a real ROS") as caught:
        run(node, NEVER)
    if run is simulate:
        assert say_error(caught.value).startswith(f"{node}:{len(calls[0].splitlines()) + 2}: cv_bridge")


def test_an_error_is_told_where_stderr_is_gone(run: Run, write: Any) -> None:
    node = write(
        """
        import sys, threading
        def fail():
            raise RuntimeError("boom")
        sys.stderr = None
        thread = threading.Thread(target=fail, name="worker")
        thread.start()
        thread.join()
        fail()
        """
    )
    result = run(node, NEVER)
    assert result.status == 1
    assert result.console.count("rosspin: sys.stderr is None, and Python would show nothing of this:\n") == 2
    assert result.console.count("RuntimeError: boom\n") == 2
    assert "Exception in thread worker:\n" in result.console
    assert sys.stderr is not None


def test_a_node_may_remove_the_folder_that_it_is_in(run: Run) -> None:
    def node() -> None:
        folder = tempfile.mkdtemp()
        os.chdir(folder)
        os.rmdir(folder)
        print("gone")

    before = os.getcwd()
    assert (run(node, NEVER).console, os.getcwd()) == ("gone\n", before)


@pytest.mark.parametrize(
    ("file", "whose"),
    [
        ("random.py", "Python's module random"),
        ("queue.py", "Python's module queue"),
        ("copy/__init__.py", "Python's module copy"),
        ("rospy.py", "ROS 1's module rospy"),
        ("std_msgs/__init__.py", "ROS 1's module std_msgs"),
        ("sensor_msgs.py", "ROS 1's module sensor_msgs"),
    ],
)
def test_a_file_in_the_way_of_a_module_is_named(run: Run, write: Any, tmp_path: Path, file: str, whose: str) -> None:
    (tmp_path / file).parent.mkdir(exist_ok=True)
    write("", file)
    text = "import rospy, std_msgs.msg, sensor_msgs.msg, random, queue, copy\nprint(random.Random, copy.copy)\n"
    console = run(write(text), NEVER).console
    said = f" is in the way of {whose}: on a real ROS whatever imports {whose.split()[-1]} is given this file\n"
    assert console.startswith("rosspin: ") and console.partition("\n")[0].endswith(f"{file}{said.rstrip()}")
    assert console.endswith("<class 'random.Random'> <function copy at " + console.rpartition("copy at ")[2])


def test_an_exception_of_a_handler_at_the_very_end_stays_in_the_run(run: Run) -> None:
    def node() -> None:
        signal.signal(signal.SIGINT, lambda number, frame: sys.exit(3))
        threading.Thread(target=time.sleep, args=(1.5,)).start()

    result = run(node, 0.5)
    assert result.status == 0
    assert result.console.startswith("Exception ignored in: <module 'threading'>\n")


def test_a_run_leaves_the_folder_and_the_loggers_as_they_were(run: Run, tmp_path: Path) -> None:
    def node() -> None:
        os.chdir(tmp_path)
        logging.getLogger("robot").addHandler(logging.NullHandler())
        logging.getLogger().setLevel(logging.DEBUG)

    before = os.getcwd(), logging.getLogger().level, set(logging.root.manager.loggerDict)
    assert run(node, NEVER).status == 0
    assert (os.getcwd(), logging.getLogger().level, set(logging.root.manager.loggerDict)) == before


def test_a_console_takes_bytes_too(run: Run) -> None:
    def node() -> None:
        print("one")
        sys.stdout.buffer.write("zwö".encode()[:3])
        sys.stdout.buffer.write("zwö".encode()[3:] + b"\n")
        sys.stderr.write("three\n")

    assert run(node, NEVER).console == "one\nzwö\nthree\n"


def test_exit_at_once_ends_the_node_alone(run: Run) -> None:
    def node() -> None:
        threading.Timer(0.05, os._exit, (5,)).start()
        rospy.init_node("node")
        rospy.on_shutdown(lambda: print("hook"))
        rospy.spin()

    result = run(node, NEVER)
    assert (result.status, result.console) == (5, "")


def test_what_was_registered_for_the_exit_is_called_then(run: Run) -> None:
    def node() -> None:
        import atexit

        for word in ("second", "first"):
            atexit.register(print, word)

        def late() -> None:
            time.sleep(0.05)
            print("thread")

        threading.Thread(target=late).start()

    assert run(node, NEVER).console == "thread\nfirst\nsecond\n"


def test_a_thread_however_it_was_started_is_in_the_node_s_world(run: Run) -> None:
    def node() -> None:
        rospy.init_node("world")
        done = threading.Semaphore(0)

        def look(how: str) -> None:
            rospy.Rate(1000).sleep()
            print(how, rospy.get_name(), rospy.is_shutdown())
            done.release()

        threading.Thread(target=look, args=("Thread",)).start()
        done.acquire()
        threading.Timer(0, look, ("Timer",)).start()
        done.acquire()
        _thread.start_new_thread(look, ("_thread",))
        done.acquire()
        with ThreadPoolExecutor() as pool:
            pool.submit(look, "pool")
        threading.Timer(0.01, rospy.signal_shutdown, ("enough",)).start()
        rospy.spin()

    lines = [f"{how} /world False" for how in ("Thread", "Timer", "_thread", "pool")]
    result = run(node, NEVER)
    assert (result.status, result.console.splitlines()) == (0, lines)
