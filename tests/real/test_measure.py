"""Functions and cells on the wall clock: counts and patterns, no timings."""

from __future__ import annotations

import multiprocessing
import os
import sys
import threading
import time
from pathlib import Path
from typing import Any

import pytest

from rosspin import NotSimulated, measure, rospy, simulate, start
from tests.helpers.shells import ipython_shell
from tests.helpers.tree import ROOT
from tests.helpers.verdicts import control

TIMER_NODE = ROOT / "examples" / "my_robotics_pkg" / "src" / "spinner_py_node.py"

# Only so that a test that hangs ends at all.
NEVER = 60


def test_measure_runs_timers_for_real() -> None:
    calls: list[float] = []

    def callback(event: Any) -> None:
        calls.append(event.current_real.to_sec())
        rospy.loginfo("tick")
        if len(calls) == 5:
            rospy.signal_shutdown("enough")

    def node() -> None:
        rospy.init_node("node")
        rospy.Timer(rospy.Duration(0.02), callback)
        rospy.spin()

    before = time.time()
    run = measure(node, 60)
    assert (run.status, run.runtime, run.seconds) == (0, "wall", 60)
    assert before <= run.start <= calls[0]
    assert [tick.number for tick in run.ticks] == [1, 2, 3, 4, 5]
    assert [tick.real for tick in run.ticks] == pytest.approx([call - run.start for call in calls], abs=1e-6)
    assert run.console.count("]: tick\n") == 5


def test_measure_runs_a_rate_loop_until_ctrl_c() -> None:
    def node() -> None:
        rospy.init_node("node")
        rate = rospy.Rate(50)
        while not rospy.is_shutdown():
            rate.sleep()
        print("left")

    with control(bears=0.1):
        run = measure(node, 0.5)
        assert (run.status, run.console) == (0, "left\n")
    assert run.ticks[0].expected == run.ticks[0].real
    assert run.ticks[0].source == "Rate"


def test_on_the_wall_a_slow_callback_is_followed_by_the_same_pattern() -> None:
    """As simulated: periods apart enough that no busy machine confuses them."""
    calls: list[float] = []

    def callback(event: Any) -> None:
        calls.append(event.current_real.to_sec())
        if len(calls) == 2:
            rospy.sleep(0.8)

    def node() -> None:
        rospy.init_node("node")
        rospy.Timer(rospy.Duration(0.2), callback)
        while len(calls) < 4:
            rospy.sleep(0.01)

    measure(node, 60)
    # More than three periods: the next call comes at once, but the one after it a whole period later.
    blocked_until = calls[1] + 0.8
    assert calls[2] >= blocked_until - 0.001
    assert calls[3] >= blocked_until + 0.2 - 0.001


def test_measure_needs_the_main_thread() -> None:
    errors = []

    def elsewhere() -> None:
        with pytest.raises(RuntimeError, match="only in the main thread"):
            measure(lambda: None, 1)
        errors.append(simulate(TIMER_NODE, 2).status)  # simulated time does not mind

    thread = threading.Thread(target=elsewhere)
    thread.start()
    thread.join()
    assert errors == [0]


def test_the_threads_of_a_wall_run_do_not_outlive_it() -> None:
    calls: list[int] = []

    def node() -> None:
        rospy.init_node("node")
        rospy.Timer(rospy.Duration(0.01), lambda event: calls.append(1))
        rospy.sleep(0.1)

    before = threading.enumerate()
    measure(node, 60)
    seen = len(calls)
    for thread in set(threading.enumerate()) - set(before):
        thread.join(60)
        assert not thread.is_alive()
    assert len(calls) <= seen + 1


def test_on_the_wall_a_process_can_be_forked_but_not_made_anew(write: Any) -> None:
    """And the node waits for it at its end, as Python does."""
    text = """
        import multiprocessing
        import time
        def late():
            time.sleep(0.3)
            print("hi")
        multiprocessing.get_context({!r}).Process(target=late).start()
        """
    assert measure(write(text.format("fork")), 60).console == "hi\n"
    with pytest.raises(
        NotSimulated, match=r"multiprocessing.Process \(spawn\) is not simulated; run this node on a re"
    ):
        measure(write(text.format("spawn")), 60)


def test_a_process_that_a_function_has_forked_runs_on() -> None:
    """As its caller does: it is not the end of a program."""
    forked: list[Any] = []
    read, write = os.pipe()

    def node() -> None:
        forked.append(multiprocessing.get_context("fork").Process(target=os.read, args=(read, 1)))
        forked[0].start()

    try:
        assert measure(node, 60).status == 0
        assert forked[0].is_alive()
    finally:
        os.write(write, b".")
        forked[0].join()
        os.close(read)
        os.close(write)


def test_a_node_that_catches_everything_is_ended_and_does_nothing_afterwards(impatient: None) -> None:
    seen: list[str] = []

    def catches(name: str) -> None:
        while True:
            try:
                try:
                    time.sleep(0.01)
                    seen.append(name)
                except BaseException:
                    pass
            except BaseException as error:
                seen.append(str(error))

    def node() -> None:
        threading.Thread(target=catches, args=("thread",), daemon=True).start()
        catches("main")

    before, trace = set(threading.enumerate()), sys.gettrace()
    with control(bears=0.05):
        run = measure(node, 0.1)
        assert run.status == 137
    for thread in set(threading.enumerate()) - before:
        thread.join(NEVER)
    count = len(seen)
    assert set(threading.enumerate()) == before
    assert sys.gettrace() is trace
    time.sleep(0.05)
    assert len(seen) == count


def test_a_node_that_waits_for_ever_is_ended(impatient: None) -> None:
    def node() -> None:
        rospy.init_node("node")
        lock = threading.Lock()
        lock.acquire()
        lock.acquire()

    with control(bears=0.05):
        run = measure(node, 0.1)
        assert run.status == 137
    assert run.console.splitlines()[1].endswith(": lock.acquire()")


def test_a_cell_is_measured(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    with ipython_shell(tmp_path) as shell:
        with control(bears=0.1):
            shell.run_cell(f"%%measure 0.5\n{TIMER_NODE.read_text()}")
            assert "namespace of node = /\n" in capsys.readouterr().out
        run = shell.user_ns["run"]
    assert (run.status, run.runtime, run.seconds) == (0, "wall", 0.5)
    assert run.start > 1e9


def test_real_time_is_real_between_the_steps() -> None:
    def node_function() -> None:
        rospy.init_node("n")
        while not rospy.is_shutdown():
            print(time.time(), time.monotonic())
            time.sleep(1)

    with start(node_function) as node:
        node.advance(1)
        began = time.monotonic()
        assert time.time() > 1e9
        time.sleep(0.01)
        assert time.monotonic() >= began + 0.01
        thread = threading.Thread(target=node.run.console.upper)
        thread.start()
        thread.join()
        assert node.advance(1).console == "2.0 2.0\n"


def test_an_action_on_the_wall_clock(write: Any) -> None:
    source = """
    import rclpy
    from example_interfaces.action import Fibonacci
    from rclpy.action import ActionClient, ActionServer

    def execute(goal_handle):
        goal_handle.succeed()
        return Fibonacci.Result(sequence=[goal_handle.request.order])

    rclpy.init()
    node = rclpy.create_node("n")
    server = ActionServer(node, Fibonacci, "fibonacci", execute)
    client = ActionClient(node, Fibonacci, "fibonacci")
    future = client.send_goal_async(Fibonacci.Goal(order=2))
    rclpy.spin_until_future_complete(node, future)
    result = future.result().get_result_async()
    rclpy.spin_until_future_complete(node, result)
    print(list(result.result().result.sequence))
    """
    run = measure(write(source), 60)
    assert (run.status, run.console) == (0, "[2]\n")
    goal, result = run.calls
    assert (goal.service, goal.response.accepted) == ("/fibonacci/_action/send_goal", True)
    assert result.asked <= result.answered
    assert result.response.result.sequence.tolist() == [2]


def test_ticks_of_ros2_are_expected_on_their_grid_whatever_comes_between(write: Any) -> None:
    source = """
    import rclpy

    rclpy.init()
    node = rclpy.create_node("n")
    node.create_timer(0.02, lambda: None)
    rclpy.spin(node)
    """
    run = measure(write(source), 1.0)
    places = [(tick.expected - run.ticks[0].expected) / 0.02 for tick in run.ticks]
    assert places and all(abs(place - round(place)) < 1e-5 for place in places)
