"""Whoever cancels a goal stops the server: a belief that this reveals."""

from __future__ import annotations

from collections.abc import Iterator

from .. import judges as by
from ..feedback import Finding
from ..judging import Answer, plain, say
from ..observed import ObservedRun

TITLE = "Cancel a goal"
TEXT = """
**You need**: [services and actions](ros2-services.md).

The server of this node adds a number every 0.5 s, until there are ten. The client sends a goal at 1.0 s, and wants to
cancel it at 3.2 s, but the server refuses. Change the server so that

- a cancelled goal stops before the next number, with the status 5, "cancelled", and the numbers so far, and
- any other goal still succeeds, with the status 4 and all ten numbers.
"""
REVEALS = "Whoever cancels a goal stops the server. A goal can be cancelled unless the server refuses."

NODE = """
import time

import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionClient, ActionServer
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor
from rclpy.node import Node


class RobotPyNode(Node):
    def __init__(self):
        super().__init__("robot_py_node")
        self.server = ActionServer(
            self, Fibonacci, "fibonacci", self.execute_callback)
        self.client = ActionClient(self, Fibonacci, "fibonacci")
        cancel_at = self.declare_parameter("cancel_at", 3.2).value
        self.send = self.create_timer(1.0, self.send_callback)
        self.stop = self.create_timer(cancel_at, self.stop_callback)

    # The server, which you should change
    def execute_callback(self, goal):
        numbers = [0, 1]
        while len(numbers) < goal.request.order:
            numbers.append(numbers[-1] + numbers[-2])
            time.sleep(0.5)
        goal.succeed()
        return Fibonacci.Result(sequence=numbers)

    # The client, which should stay as it is
    def send_callback(self):
        self.send.cancel()
        future = self.client.send_goal_async(Fibonacci.Goal(order=10))
        future.add_done_callback(self.accepted_callback)

    def accepted_callback(self, future):
        self.goal = future.result()
        self.goal.get_result_async().add_done_callback(self.ended_callback)

    def stop_callback(self):
        self.stop.cancel()
        self.goal.cancel_goal_async().add_done_callback(self.cancel_callback)

    def cancel_callback(self, future):
        count = len(future.result().goals_canceling)
        self.get_logger().info("[CLIENT] cancelling = " + str(count))

    def ended_callback(self, future):
        response = future.result()
        self.get_logger().info("[CLIENT] status = " + str(response.status))
        numbers = len(response.result.sequence)
        self.get_logger().info("[CLIENT] numbers = " + str(numbers))


def main():
    rclpy.init()
    robot_py_node = RobotPyNode()
    try:
        rclpy.spin(robot_py_node, MultiThreadedExecutor())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == '__main__':
    main()
"""

HINTS = [
    "An action server refuses unless it has a `cancel_callback=`. The method `cancel_callback` of "
    "this node belongs to the client, so give your function another name.",
    "`cancel_callback` returns `CancelResponse.ACCEPT`, from `rclpy.action`. That interrupts "
    "nothing. How does the server find out that it should stop?",
    "Before each number, look at `goal.is_cancel_requested`. If it is true, call `goal.canceled()` "
    "in place of `goal.succeed()`, and return the numbers.",
]
HINT = (
    "A server is asked whether a goal may be cancelled, by its `cancel_callback`; then it has to stop by "
    "itself, and say `goal.canceled()`."
)
_REACHED = {
    "4": "The server continued to the end. In `execute_callback`, look at `is_cancel_requested` before each number.",
    "6": "A goal is aborted if its callback says `goal.abort()`, fails, or returns without saying how it ended: "
    "`goal.canceled()`, `goal.succeed()`.",
}
_REFUSED = "Unless it has a `cancel_callback` that returns `CancelResponse.ACCEPT`, a server cancels no goal."


def _ended(run: ObservedRun, when: str, status: str, at: float, length: int) -> Finding:
    """Whether the goal has ended at a time (s), with a status and so many numbers, which the client has printed."""
    names = {"4": "reached (4)", "5": "cancelled (5)", "6": "aborted (6)"}
    found, numbers = run.values("CLIENT", "status"), run.values("CLIENT", "numbers")
    cancelled = [line for line in run.values("CLIENT", "cancelling") if line.time <= run.seconds]
    if not found or not numbers:
        hint = "Does `execute_callback` return a `Fibonacci.Result`? The client should stay as it is."
        return Finding(False, f"{when}: the client did not hear how the goal ended.", hint)
    if found[0].text != status:
        said = names.get(found[0].text, f"`{plain(found[0].text)}`")
        hint = _REACHED.get(found[0].text, "Only if a cancel was requested: look before you call `canceled()`.")
        asked = [line.text for line in run.printed if "Error raised in execute callback" in line.text]
        if asked:
            hint = f"`execute_callback` failed: `{plain(asked[0].rpartition('callback: ')[2])}`."
        elif status == "5" and not cancelled:
            hint = "The client cancels the goal. It should stay as it is."
        elif found[0].text == "4" and found[0].time < 5.0 - by.CLOSE and numbers[0].text == "10":
            hint = "It was reached too early: take 0.5 s for each number, as before."
        elif found[0].text == "4" and numbers[0].text != "10":
            hint = "It succeeded early: `goal.succeed()` in place of `goal.canceled()`, or a client that asks for less."
        elif status == "5" and cancelled[0].text == "0":
            hint = _REFUSED
        return Finding(False, f"{when}: the goal was {said} at {say(found[0].time)}, not {names[status]}.", hint)
    if abs(found[0].time - at) > by.CLOSE:
        text = f"{when}: the goal was {names[status]} at {say(found[0].time)}, not at {say(at)}."
        return Finding(False, text, "Look before each number, and take 0.5 s for each, as before.")
    if numbers[0].text != str(length):
        text = f"{when}: the result has {plain(numbers[0].text)} numbers, not {length}."
        return Finding(False, text, "Return the numbers that the server has, even if the goal is cancelled.")
    return Finding(True, f"{when}: the goal was {names[status]} at {say(at)}, with {length} numbers.")


def check(answer: Answer) -> Iterator[Finding]:
    """Whether an action server cancels a goal within a step of 0.5 s, and else reaches it."""
    for at, ends, length in (3.2, 3.5, 7), (2.2, 2.5, 5):
        run = answer.run(7.0, f"cancel_at:={at}", has_to_end=False)
        yield _ended(run, f"Cancelled at {at} s", "5", ends, length)
    run = answer.run(7.0, "cancel_at:=9.0")
    yield _ended(run, "Not cancelled", "4", 5.0, 10)


SOLUTION = {
    "from rclpy.action import ActionClient, ActionServer\n": "from rclpy.action import ActionClient, "
    "ActionServer, CancelResponse\n",
    '            self, Fibonacci, "fibonacci", self.execute_callback)\n': "            self, Fibonacci, "
    '"fibonacci", self.execute_callback,\n            cancel_callback=self.may_cancel)\n',
    "    # The server, which you should change\n": "    # The server, which you should change\n"
    "    def may_cancel(self, goal):\n"
    "        return CancelResponse.ACCEPT\n"
    "\n",
    "        while len(numbers) < goal.request.order:\n": "        while len(numbers) < goal.request.order:\n"
    "            if goal.is_cancel_requested:\n"
    "                goal.canceled()\n"
    "                return Fibonacci.Result(sequence=numbers)\n",
}
AFTER = """
With a single-threaded executor the server could not even be asked, as [the notebook](ros2-services.md) shows.
"""

LOOKS = """            if goal.is_cancel_requested:
                goal.canceled()
                return Fibonacci.Result(sequence=numbers)
"""
APPENDS = "            numbers.append(numbers[-1] + numbers[-2])\n"
SLEEPS_HALF = "            time.sleep(0.5)\n"
SUCCEEDS = "        goal.succeed()\n"
MAY_CANCEL = """    def may_cancel(self, goal):
        return CancelResponse.ACCEPT

"""

RIGHT = [
    {"MultiThreadedExecutor())": "MultiThreadedExecutor(2))"},
    {"cancel_callback=self.may_cancel": "cancel_callback=lambda goal: CancelResponse.ACCEPT"},
    # It looks after each number.
    {LOOKS + APPENDS: APPENDS, SLEEPS_HALF: SLEEPS_HALF + LOOKS},
    # It leaves the loop.
    {
        LOOKS: "            if goal.is_cancel_requested:\n                break\n",
        SUCCEEDS: "        goal.canceled() if goal.is_cancel_requested else goal.succeed()\n",
    },
    {
        "while len(numbers) < goal.request.order:\n": "while len(numbers) < goal.request.order "
        "and not goal.is_cancel_requested:\n",
        LOOKS: "",
        SUCCEEDS: "        if goal.is_cancel_requested:\n            goal.canceled()\n"
        "        else:\n            goal.succeed()\n",
    },
    {
        MAY_CANCEL: "",
        "            cancel_callback=self.may_cancel)\n": "            )\n"
        "        self.server.register_cancel_callback(lambda goal: CancelResponse.ACCEPT)\n",
    },
]
WRONG = [
    ({SLEEPS_HALF: SLEEPS_HALF.replace("0.5", "0.25")}, "was reached (4) at 3 s", "take 0.5 s for each number"),
    (
        {"return Fibonacci.Result(sequence=numbers)\n            ": "return\n            "},
        "AssertionError",
        "return a result",
    ),
    ({"cancel_requested": "cancel_requested()"}, "aborted (6) at 1 s", "`execute_callback` failed: `'bool' object"),
    ({"self.goal.cancel_goal_async()": "pass  # "}, "was reached (4) at 5 s", "The client cancels the goal"),
    (
        {"            cancel_callback=self.may_cancel)\n": "            )\n"},
        "Cancelled at 3.2 s: the goal was reached (4) at 5 s, not cancelled (5)",
        "cancels no goal",
    ),
    ({"CancelResponse.ACCEPT": "CancelResponse.REJECT"}, "reached (4) at 5 s, not cancelled", "cancels no goal"),
    (
        {"        return CancelResponse.ACCEPT\n": "        pass\n"},
        "reached (4)",
        "returns `CancelResponse.ACCEPT`",
    ),
    ({LOOKS: ""}, "was reached (4) at 5 s, not cancelled (5)", "look at `is_cancel_requested` before each number"),
    (
        {"                goal.canceled()\n": ""},
        "the goal was aborted (6) at 3.5 s, not cancelled (5)",
        "without saying how it ended",
    ),
    ({"goal.canceled()": "goal.abort()"}, "was aborted (6) at 3.5 s", "without saying how it ended"),
    ({"goal.canceled()": "goal.succeed()"}, "was reached (4) at 3.5 s", "It succeeded early:"),
    (
        {"sequence=numbers)\n            numbers": "sequence=[])\n            numbers"},
        "the result has 0 numbers, not 7",
        "Return the numbers that the server has",
    ),
    (
        {
            LOOKS: "",
            "        numbers = [0, 1]\n": "        numbers = [0, 1]\n" + LOOKS.replace("            ", "        ", 1),
        },
        "reached (4) at 5 s",
        "before each number",
    ),
    ({SLEEPS_HALF: "            time.sleep(1.0)\n"}, "cancelled (5) at 4 s, not at 3.5 s", "0.5 s for each"),
    ({", MultiThreadedExecutor())": ")"}, "the node stopped", ""),
    ({SUCCEEDS: ""}, "Not cancelled: the goal was aborted (6) at 5 s", "`goal.succeed()`"),
    (
        {"if goal.is_cancel_requested": "if len(numbers) > 6"},
        "Not cancelled: the goal was aborted (6) at 3.5 s",
        "",
    ),
    (
        {"if goal.is_cancel_requested": "if len(numbers) == 7 and goal.is_cancel_requested"},
        "Cancelled at 2.2 s: the goal was cancelled (5) at 3.5 s, not at 2.5 s",
        "Look before each number",
    ),
]
