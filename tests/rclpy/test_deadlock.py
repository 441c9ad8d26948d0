"""What is said of nodes in a deadlock, and of others that only seem to be."""

from __future__ import annotations

from typing import Any

import pytest

from rosspin import simulate

BEGIN = """
import rclpy
from rclpy.action import ActionClient, ActionServer
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup as Group
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from std_srvs.srv import Trigger
from example_interfaces.action import Fibonacci

rclpy.init()
node = rclpy.create_node("n")


def serve(name="work", group=None, callback=lambda request, response: response):
    node.create_service(Trigger, name, callback, callback_group=group)


def client_of(name="work", group=None):
    return node.create_client(Trigger, name, callback_group=group)


def spin_with(threads):
    executor = MultiThreadedExecutor(num_threads=threads)
    executor.add_node(node)
    executor.spin()

"""

# What waits, and lines that are said of it, in their order.
FOR_EVER = {
    "call on one thread": (
        """
serve()
client = client_of()
def ask():
    client.call(Trigger.Request())
node.create_timer(0.5, ask)
rclpy.spin(node)
""",
        [
            "the timer's callback ask waits for the answer of /work",
            "node.py:31: client.call(Trigger.Request())",
            "the request has come, but the callback group of the service lets one callback run at a time:",
            "  the timer's callback ask",
            "Ask with call_async, or send_goal_async, and continue in a done callback. Or spin with a Multi",
        ],
    ),
    "groups of their own, and one thread": (
        """
serve(group=Group())
client = client_of(group=Group())
def ask():
    client.call(Trigger.Request())
node.create_timer(0.5, ask)
rclpy.spin(node)
""",
        [
            "the request has come, but the only thread of the executor is in a callback:",
            "  the timer's callback ask",
            "Or spin with a MultiThreadedExecutor, and put the callback that waits into a callback group of its own.",
        ],
    ),
    "the client in the group of the callback": (
        """
serve(group=Group())
client = client_of()
def ask():
    client.call(Trigger.Request())
node.create_timer(0.5, ask)
spin_with(4)
""",
        [
            "the answer has come, but the callback group of the client lets one callback run at a time:",
            "Put the callback that waits into a callback group of its own, or ask with call_async",
        ],
    ),
    "await in the group of the client": (
        """
serve(group=Group())
client = client_of()
async def ask():
    await client.call_async(Trigger.Request())
node.create_timer(0.5, ask)
rclpy.spin(node)
""",
        [
            "node.py:31: await client.call_async(Trigger.Request())",
            "the answer has come, but the callback group of the client lets one callback run at a time:",
            "An async callback keeps its group while it awaits: put that callback into a group of its own.",
        ],
    ),
    "two services that ask each other": (
        """
def first(request, response):
    return to_second.call(Trigger.Request())
def second(request, response):
    return to_first.call(Trigger.Request())
serve("first", Group(), first)
serve("second", Group(), second)
to_first, to_second = client_of("first", Group()), client_of("second", Group())
def ask():
    to_first.call(Trigger.Request())
node.create_timer(0.5, ask)
spin_with(4)
""",
        [
            "the timer's callback ask waits for the answer of /first",
            "that has to come from the callback of the service /first (first)",
            "the callback of the service /first (first) waits for the answer of /second",
            "that has to come from the callback of the service /second (second)",
            "the callback of the service /second (second) waits for the answer of /first",
            "the request has come, but the callback group of the service lets one callback run at a time:",
            "  the callback of the service /first (first)",
            "No executor or group helps here: one of these callbacks has to answer without asking.",
        ],
    ),
    "all threads ask": (
        """
serve(group=Group())
client = client_of(group=Group())
def ask():
    client.call(Trigger.Request())
node.create_timer(0.5, ask, ReentrantCallbackGroup())
node.create_timer(0.5, ask, ReentrantCallbackGroup())
spin_with(2)
""",
        [
            "but each of the 2 threads of the executor is in a callback:",
            "  the timer's callback ask",
            "Give the executor more threads, or ask with call_async",
        ],
    ),
    "nobody offers it": (
        """
client = client_of()
rclpy.spin_until_future_complete(node, client.call_async(Trigger.Request()))
""",
        [
            "the thread MainThread waits for the answer of /work",
            "no node offers that, as far as it knows",
            "Start the node that offers it",
        ],
    ),
    "nobody spins": (
        """
serve()
client_of().call(Trigger.Request())
""",
        ["the request has come, but no thread spins /n", "Spin the node meanwhile: with rclpy.spin_until_future"],
    ),
    "a Rate in a callback": (
        """
rate = node.create_rate(1)
def tick():
    rate.sleep()
node.create_timer(0.5, tick)
rclpy.spin(node)
""",
        [
            "the timer's callback tick waits for its Rate",
            "its timer is due, but the only thread of the executor is in a callback:",
            "Do the work of the loop in a timer",
        ],
    ),
    "a spin in a callback": (
        """
serve()
client = client_of()
def ask():
    rclpy.spin_until_future_complete(node, client.call_async(Trigger.Request()))
node.create_timer(0.5, ask)
rclpy.spin(node)
""",
        ["the timer's callback ask waits for the answer of /work", "the callback group of the service"],
    ),
    "a lock that the service needs": (
        """
import threading
lock = threading.Lock()
def locked(request, response):
    with lock: return response
serve(group=Group(), callback=locked)
client = client_of(group=Group())
def ask():
    with lock: client.call(Trigger.Request())
node.create_timer(0.5, ask)
spin_with(4)
""",
        [
            "the timer's callback ask waits for the answer of /work",
            "that has to come from the callback of the service /work (locked)",
            "the callback of the service /work (locked) waits for a lock that the timer's callback ask holds",
            "node.py:31: with lock: return response",
            "Hold no lock while you wait for what needs it.",
        ],
    ),
    "a lock held while a Rate sleeps": (
        """
import threading
lock = threading.Lock()
def tick():
    with lock: pass
node.create_timer(0.1, tick)
rate = node.create_rate(2)
threading.Thread(target=rclpy.spin, args=(node,), daemon=True).start()
with lock: rate.sleep()
""",
        [
            "the thread MainThread waits for its Rate",
            "but the only thread of the executor is in a callback:",
            "the timer's callback tick waits for a lock that the thread MainThread holds",
            "Hold no lock while you wait for what needs it.",
        ],
    ),
    "a callback that waits for the end of a thread that asks": (
        """
import threading
serve()
client = client_of()
def ask():
    client.call(Trigger.Request())
def tick():
    thread = threading.Thread(target=ask, name="asker")
    thread.start()
    thread.join()
node.create_timer(0.5, tick)
rclpy.spin(node)
""",
        [
            "the thread asker waits for the answer of /work",
            "the callback group of the service lets one callback run at a time:",
            "the timer's callback tick waits for the end of the thread asker",
            "node.py:36: thread.join()",
            "Ask with call_async, or send_goal_async, and continue in a done callback. Or spin with a Multi",
        ],
    ),
    "a goal sent on one thread": (
        """
server = ActionServer(node, Fibonacci, "fibonacci", lambda goal: Fibonacci.Result())
client = ActionClient(node, Fibonacci, "fibonacci")
def send():
    client.send_goal(Fibonacci.Goal())
node.create_timer(0.5, send)
rclpy.spin(node)
""",
        [
            "the timer's callback send waits for the answer to a goal of /fibonacci",
            "the request has come, but the callback group of the action server lets one callback run at a time:",
        ],
    ),
    "a goal that waits for a service on the only thread": (
        """
serve(group=Group())
asker = client_of(group=Group())
def execute(goal):
    asker.call(Trigger.Request())
server = ActionServer(node, Fibonacci, "fibonacci", execute)
client = ActionClient(node, Fibonacci, "fibonacci")
client.send_goal_async(Fibonacci.Goal())
rclpy.spin(node)
""",
        [
            "the execution of a goal (execute) waits for the answer of /work",
            "but the only thread of the executor is in a callback:",
            "  the execution of a goal (execute)",
        ],
    ),
}


@pytest.mark.parametrize("kind", FOR_EVER)
def test_what_waits_for_ever_is_explained(write: Any, kind: str) -> None:
    source, wanted = FOR_EVER[kind]
    console = simulate(write(BEGIN + source), 2).console
    said = [line.removeprefix("rosspin: ") for line in console.splitlines() if line.startswith("rosspin: ")]
    assert said[0] == "deadlock. This can never continue:"
    at = 0
    for words in wanted:
        at = next((number for number, line in enumerate(said) if number >= at and words in line), None) or pytest.fail(
            f"{words!r} is not said, or earlier: {said}"
        )


# Each of these still waits when Ctrl-C comes, and would continue later, or no one knows what for.
NOT_FOR_EVER = {
    "a slow service": """
import time
def slow(request, response):
    time.sleep(5)
    return response
serve(callback=slow, group=Group())
client = client_of(group=Group())
def ask():
    client.call(Trigger.Request())
node.create_timer(0.5, ask)
spin_with(4)
""",
    "a Rate beside the one who spins": """
import threading
rate = node.create_rate(0.1)
threading.Thread(target=rate.sleep, daemon=True).start()
rclpy.spin(node)
""",
    "a future of the node's own": """
rclpy.spin_until_future_complete(node, rclpy.task.Future())
""",
    "a lock that is released in the end": """
import threading, time
lock = threading.Lock()
def locked(request, response):
    with lock: return response
serve(group=Group(), callback=locked)
client = client_of(group=Group())
def hold():
    with lock: time.sleep(5)
node.create_timer(0.4, hold, Group())
node.create_timer(0.5, lambda: client.call(Trigger.Request()))
spin_with(4)
""",
    "a thread that spins": """
import threading
executor = MultiThreadedExecutor(num_threads=2)
executor.add_node(node)
thread = threading.Thread(target=executor.spin)
thread.start()
thread.join()
""",
    "an executor within a callback": """
import threading
other = MultiThreadedExecutor(num_threads=2)
other.add_node(rclpy.create_node("other"))
def answer(request, response):
    other.spin_once()
    return response
serve(callback=answer)
client = client_of()
threading.Thread(target=rclpy.spin, args=(node,), daemon=True).start()
client.call(Trigger.Request())
""",
    "a call with a time limit": """
serve()
client = client_of()
node.create_timer(0.5, lambda: client.call(Trigger.Request(), timeout_sec=10))
rclpy.spin(node)
""",
}


@pytest.mark.parametrize("kind", NOT_FOR_EVER)
def test_nothing_is_said_of_what_may_go_on(write: Any, kind: str) -> None:
    assert "can never continue" not in simulate(write(BEGIN + NOT_FOR_EVER[kind]), 2).console


def test_a_wait_across_processes_is_explained(write: Any) -> None:
    asking = """
import rclpy
from std_srvs.srv import Trigger
rclpy.init()
node = rclpy.create_node("NAME")
client = node.create_client(Trigger, "OTHER")
def answer(request, response):
    return client.call(Trigger.Request())
node.create_service(Trigger, "NAME", answer)
"""
    left = asking.replace("NAME", "left").replace("OTHER", "right")
    right = asking.replace("NAME", "right").replace("OTHER", "left")
    left += "node.create_timer(1.0, lambda: client.call(Trigger.Request()))\nrclpy.spin(node)\n"
    right += "rclpy.spin(node)\n"
    console = simulate([write(left, "left.py"), write(right, "right.py")], 4).console
    assert "the callback of the service /right (answer) waits for the answer of /left" in console
    assert "the request has come, but the callback group of the service lets one callback run at a time:" in console
