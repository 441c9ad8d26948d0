"""What executors do, step by step: told as it happens, in simulated time, and only if asked for."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from rosspin.clocks.simulation import Simulation
from rosspin.run.noted_steps import NotedSteps, NotedThreads
from rosspin.run.roslaunch.launch import Launch, Node
from rosspin.run.scenes import Scenes
from rosspin.run.simulate import run_node, run_nodes
from rosspin.run.source import load
from rosspin.run.streams import capture
from rosspin.world.graph import TickLog
from tests.helpers.tree import EXAMPLES, TESTS

TASKS = """\
import rclpy

rclpy.init()
node = rclpy.create_node("waits")
future = rclpy.Future()

async def wait_for_it():
    await future

def wake():
    future.set_result(None)
    timer.cancel()

def never():
    pass

timer = node.create_timer(0.5, wake)
executor = rclpy.get_global_executor()
executor.add_node(node)
task = executor.create_task(wait_for_it)
executor.create_task(never).cancel()
executor.spin_until_future_complete(task)
"""


def written(folder: Path, text: str) -> Path:
    path = folder / "node.py"
    path.write_text(text)
    return path


class Told:
    """The scenes of a run, with names in place of numbers."""

    def __init__(self, path: Path, seconds: float, *others: Path, kind: type[NotedSteps] = Scenes) -> None:
        log = TickLog()
        scenes = kind(log, str(path), several=bool(others))
        with capture() as console:
            if others:
                nodes = Launch([Node(each) for each in (path, *others)])
                result = run_nodes(nodes, seconds, scenes.clock, log)
            else:
                result = run_node(load(path), seconds, (), scenes.clock, log)
        self.console, self.ticks = console.text(), result.ticks
        self.data: dict[str, Any] = scenes.data(result.status) or {}
        self.names = [name for name, _ in self.data.get("callbacks", ())]
        self.lines = path.read_text().splitlines()
        self.said = [f"{time:g}: {said}" for time, said, *_ in self.data.get("steps", ())]

    def at(self, time: float, said: str) -> tuple[list[str], dict[str, tuple[str, str]], dict[str, str]]:
        """What is ready, in which thread runs what and in which line, and how each callback is."""
        ready, where, how = next(step[2:] for step in self.data["steps"] if step[0] == time and said in step[1])
        threads = {
            self.data["threads"][thread]: (
                "" if callback < 0 else self.names[callback],
                self.lines[line - 1].strip() if line else "",
            )
            for thread, callback, line in where
        }
        return [self.names[number] for number in ready], threads, dict(zip(self.names, how))


def told(name: str, seconds: float) -> Told:
    return Told(EXAMPLES / f"{name}_py_node.py", seconds)


def test_on_one_thread_the_quick_callback_waits_for_the_slow_one() -> None:
    run = told("executors/one_thread", 2.2)
    assert run.said[:7] == [
        "0: No callback runs until 0.5 s.",
        "0.5: The executor finds what is ready: slow_callback, quick_callback.",
        "0.5: MainThread calls slow_callback.",
        "0.5: slow_callback is at work until 1.3 s.",
        "1.3: slow_callback ends.",
        "1.3: MainThread calls quick_callback, 0.8 s late.",
        "1.3: quick_callback ends.",
    ]
    _, threads, _ = run.at(0.5, "calls")
    assert threads == {"MainThread": ("slow_callback", "def slow_callback(self):")}
    ready, threads, how = run.at(0.5, "at work")
    assert ready == ["quick_callback"]
    assert threads == {"MainThread": ("slow_callback", "time.sleep(0.8)  # the work")}
    waits = "waits for the thread, which is in slow_callback"
    assert how == {"slow_callback": "runs", "quick_callback": waits}
    _, threads, how = run.at(1.3, "slow_callback ends")
    assert threads == {"MainThread": ("", "rclpy.spin(two_timers_py_node)")}
    assert how["slow_callback"] == "waits for the next round"


def test_a_node_lives_no_longer_because_it_is_seen() -> None:
    scenario = TESTS / "scenarios_ros2" / "life_after_spin.py"
    recorded = scenario.parent / "recorded" / "life_after_spin.txt"
    assert f"status 0\n{Told(scenario, 5).console}" == recorded.read_text(encoding="utf-8")


def test_of_several_nodes_each_is_named() -> None:
    """The lines are the first one's."""
    folder = EXAMPLES / "my_robotics_pkg_ros2/my_robotics_pkg"
    run = Told(folder / "publisher_py_node.py", 0.6, folder / "subscriber_py_node.py")
    assert [said for said in run.said if said.startswith("0.5: ") and "No" not in said] == [
        "0.5: The executor of /publisher_py_node finds what is ready: timer_callback.",
        "0.5: /publisher_py_node calls timer_callback.",
        "0.5: timer_callback ends.",
        "0.5: The executor of /subscriber_py_node finds what is ready: counter_callback.",
        "0.5: /subscriber_py_node calls counter_callback.",
        "0.5: counter_callback ends.",
    ]
    assert run.data["groups"] == [
        "Default group of /publisher_py_node: one at a time",
        "Default group of /subscriber_py_node: one at a time",
    ]
    _, threads, _ = run.at(0.5, "calls timer_callback")
    assert threads == {
        "/publisher_py_node": ("timer_callback", "def timer_callback(self):"),
        "/subscriber_py_node": ("", ""),
    }


def test_of_several_nodes_of_ros_1_each_thread_is_named() -> None:
    folder = EXAMPLES / "my_robotics_pkg/src"
    run = Told(folder / "publisher_py_node.py", 0.6, folder / "subscriber_py_node.py", kind=NotedThreads)
    assert [said for said in run.said if "calls" in said] == [
        "0.5: /publisher_py_node: Thread-1 calls timerCallback.",
        "0.5: /subscriber_py_node: /counter calls counterCallback.",
    ]
    _, threads, _ = run.at(0.5, "calls counterCallback")
    assert threads["/subscriber_py_node: /counter"] == ("counterCallback", "")


def test_a_done_callback_is_called_in_the_next_round() -> None:
    run = told("hangs/call_async", 1.5)
    at = run.said.index("1: MainThread hands done_callback to the executor, which calls it in its next round.")
    assert run.said[at + 1 : at + 4] == [
        "1: the answer of /take_picture ends.",
        "1: MainThread calls done_callback.",
        "1: done_callback ends.",
    ]
    ready, _, how = run.at(1.0, "hands done_callback")
    assert ready == ["done_callback"] and how["done_callback"] == "ready"
    ready, threads, how = run.at(1.0, "calls done_callback")
    assert ready == [] and threads == {"MainThread": ("done_callback", "def done_callback(self, future):")}
    assert how["done_callback"] == "runs"
    assert run.data["groups"][-1] == "Handed to the executor: in no group"


def test_a_task_that_awaits_keeps_no_thread(tmp_path: Path) -> None:
    """What was handed over and cancelled is not ready; what the stand-in hands over itself is no step."""
    run = Told(written(tmp_path, TASKS), 1.0)
    _, _, how = run.at(0.5, "calls wake")
    assert how["wait_for_it"] == "awaits" and how["never"] == ""
    assert "0.5: wait_for_it ends." in run.said
    assert not [said for said in run.said if "lambda" in said or "calls never" in said]


def test_a_second_thread_does_not_help_within_a_group() -> None:
    run = told("executors/two_threads", 2.2)
    ready, threads, how = run.at(0.5, "at work")
    assert ready == [] and "quick_callback" not in {callback for callback, _ in threads.values()}
    assert how["quick_callback"] == "waits for its group, which is taken by slow_callback"
    assert run.data["groups"] == ["Default group: one at a time"]


def test_with_a_group_each_nothing_waits() -> None:
    run = told("executors/own_groups", 2.2)
    assert [group for _, group in run.data["callbacks"]] == [0, 1]
    before = [how for time, said, _, _, how in run.data["steps"] if "at work" in said]
    assert not any("waits" in words for how in before for words in how if "from" not in words)
    _, threads, _ = run.at(1.0, "calls quick_callback")
    assert {callback for callback, _ in threads.values()} == {"", "slow_callback", "quick_callback"}


def test_who_wakes_a_rate() -> None:
    """The thread that spins calls the Rate's timer; the loop in another thread continues after that."""
    run = told("my_robotics_pkg_ros2/my_robotics_pkg/spinner_rate", 0.7)
    steps = [said for said in run.said if said.startswith("0.5")]
    assert [step.partition(": ")[2] for step in steps[:4]] == [
        "The executor finds what is ready: the Rate's timer.",
        "MainThread calls the Rate's timer. That sets the event for which the loop sleeps.",
        "the Rate's timer ends.",
        "Thread-1 (loop) continues: the event is set.",
    ]
    _, threads, _ = run.at(0.0, "No callback runs")
    assert threads["Thread-1 (loop)"] == ("", "self.loop_rate.sleep()")


def test_a_rate_in_a_callback_waits_for_the_thread_that_sleeps() -> None:
    run = told("hangs/rate", 2.5)
    _, threads, how = run.at(1.0, "is at work until 2.5 s")
    assert threads == {"MainThread": ("timer_callback", "rate.sleep()")}
    assert how["the Rate's timer"] == "waits from 1.2 s on for the thread, which is in timer_callback"
    (ring,) = run.data["rings"]
    assert ring["to"] == 0
    assert ring["links"][0][1].startswith("waits for its Rate; its timer is due, but the only thread of the executor")


def test_the_way_of_ctrl_c() -> None:
    run = told("my_robotics_pkg_ros2/my_robotics_pkg/spinner", 0.7)
    assert run.said[-4:] == [
        "0.7: MainThread gets the signal: rclpy shuts its contexts down and wakes the executors.",
        "0.7: MainThread continues with what the signal does in Python: at Ctrl-C it raises KeyboardInterrupt here.",
        "0.7: MainThread shuts rclpy down, which the signal has done already.",
        "0.7: The node has ended, with status 0.",
    ]
    assert run.at(0.7, "KeyboardInterrupt")[1] == {"MainThread": ("", "rclpy.spin(spinner_py_node)")}
    assert run.at(0.7, "shuts rclpy down")[1] == {"MainThread": ("", "rclpy.try_shutdown()")}


def test_a_callback_that_awaits_has_no_thread_and_keeps_its_group() -> None:
    _, threads, how = told("hangs/await", 2.5).at(1.0, "No callback runs")
    assert threads["MainThread"][0] == ""
    assert how["timer_callback"] == "awaits, and keeps its group"
    assert how["picture_callback"] == "waits for its group, which is taken by timer_callback"


RINGS = {
    "call": (["/take_picture"], 0),
    "ring": (["/plan", "/locate", "/plan"], 1),
    "nobody_spins": (["/take_picture"], -1),
    "call_async": ([], None),
}


@pytest.mark.parametrize("name", RINGS)
def test_who_waits_for_whom_for_ever(name: str) -> None:
    asked, to = RINGS[name]
    rings = told(f"hangs/{name}", 2.5).data["rings"]
    assert [ring["to"] for ring in rings] == ([] if to is None else [to])
    for ring in rings:
        answers = [waits.partition(";")[0].removeprefix("waits for the answer of ") for _, waits in ring["links"]]
        assert answers == asked


def test_threads_that_wait_for_each_others_locks(tmp_path: Path) -> None:
    node = tmp_path / "node.py"
    node.write_text(
        """
import threading
import time

import rclpy

rclpy.init()
one, other = threading.Lock(), threading.Lock()


def take(first, second):
    with first:
        time.sleep(0.1)
        with second:
            pass


threads = [threading.Thread(target=take, args=args, daemon=True) for args in ((one, other), (other, one))]
for thread in threads:
    thread.start()
rclpy.spin(rclpy.create_node("node"))
"""
    )
    (ring,) = Told(node, 1.0).data["rings"]
    assert [waits for _, waits in ring["links"]] == [
        "waits for a lock that the thread Thread-2 (take) holds",
        "waits for a lock that the thread Thread-1 (take) holds",
    ]


TWO_EXECUTORS = """
import threading
import time

import rclpy
from rclpy.executors import SingleThreadedExecutor


def work():
    time.sleep(0.3)


def quick():
    pass


rclpy.init()
for callbacks in ((work,), (quick, work)):
    node = rclpy.create_node(f"node_{len(callbacks)}")
    for callback in callbacks:
        node.create_timer(0.2, callback)
    executor = SingleThreadedExecutor()
    executor.add_node(node)
    if len(callbacks) == 1:
        threading.Thread(target=executor.spin, daemon=True).start()
guard = node.create_guard_condition(quick)
guard.trigger()
executor.spin()
"""


def test_an_executor_waits_for_its_own_thread_only(tmp_path: Path) -> None:
    """And two callbacks of one name are told apart."""
    node = tmp_path / "node.py"
    node.write_text(TWO_EXECUTORS)
    run = Told(node, 0.6)
    assert sorted(run.names) == ["quick", "quick #2", "work", "work #2"]
    quick = run.names.index("quick")
    how = {(time, step[quick]) for time, said, _, _, step in run.data["steps"] if "at work" in said}
    assert (0.2, "waits from 0.4 s on for the thread, which is in work #2") in how, how
    assert "0: MainThread calls quick #2." in run.said


@pytest.mark.parametrize("name", ["executors/one_thread", "executors/own_groups", "hangs/ring"])
def test_a_run_that_is_watched_goes_as_any_other(name: str) -> None:
    watched = told(name, 2.2)
    log = TickLog()
    with capture() as console:
        result = run_node(load(EXAMPLES / f"{name}_py_node.py"), 2.2, (), Simulation(), log)
    assert log.watcher is None
    assert (watched.console, repr(watched.ticks)) == (console.text(), repr(result.ticks))


def test_a_node_of_ros_1_has_no_scenes() -> None:
    assert told("my_robotics_pkg/src/spinner", 1.0).data == {}


def test_a_long_run_keeps_its_first_steps() -> None:
    run = told("executors/one_thread", 1000.0)
    assert len(run.data["steps"]) == 301 and run.said[0].startswith("0: ")
    assert run.said[-1].endswith("The rest is not shown.")


# --- ROS 1 ------------------------------------------------------------------------------------------------------------


def threads_of(path: Path, seconds: float, *args: str) -> dict[str, Any]:
    log = TickLog()
    threads = NotedThreads(log, str(path))
    with capture():
        status = run_node(load(path), seconds, args, threads.clock, log).status
    return threads.data(status) or {}


def test_each_timer_of_rospy_calls_in_its_own_thread() -> None:
    """A callback without a pause has a beginning and an end, too, at one time."""
    data = threads_of(EXAMPLES / "timing_probes/src/timer_probe.py", 1.4, "_block:=0.8", "_second_timer:=true")
    said = [f"{time:g}: {said}" for time, said, *_ in data["steps"]]
    assert said[:10] == [
        "0: No callback runs until 0.5 s.",
        "0.5: Thread-1 calls callback.",
        "0.5: Thread-2 calls callback #2.",
        "0.5: callback #2 ends.",
        "0.5: callback is at work until 1 s.",
        "1: Thread-2 calls callback #2.",
        "1: callback #2 ends.",
        "1: callback is at work until 1.3 s.",
        "1.3: callback ends.",
        "1.3: Thread-1 calls callback, 0.3 s late.",
    ]
    assert data["threads"] == ["MainThread", "Thread-1", "Thread-2"] and data["groups"] == []
    _, _, ready, where, how = data["steps"][2]
    assert ready == [] and how == ["runs", "runs"]
    assert [callback for _, callback, _ in where] == [-1, 0, 1]


def test_messages_and_passes_of_a_loop() -> None:
    data = threads_of(EXAMPLES / "my_robotics_pkg/src/pubsub_py_node.py", 0.6)
    said = [said for _, said, *_ in data["steps"]]
    assert said.index("timerCallback ends.") < said.index("/counter calls counterCallback.")
    data = threads_of(EXAMPLES / "my_robotics_pkg/src/spinner_rate_py_node.py", 0.6)
    assert [said for _, said, *_ in data["steps"] if "pass" in said] == [
        "MainThread ends pass 1 of its loop.",
        "MainThread ends pass 2 of its loop.",
    ]


def test_a_callback_that_fails_has_ended(tmp_path: Path) -> None:
    path = written(
        tmp_path,
        "import rospy\nrospy.init_node('fails')\nrospy.Timer(rospy.Duration(0.5), lambda event: 1 / 0)\nrospy.spin()\n",
    )
    assert "<lambda> ends." in [said for _, said, *_ in threads_of(path, 0.6)["steps"]]
