"""Whoever cancels a goal stops the server: a belief that this reveals."""

from __future__ import annotations

from .. import judges as by

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

check = by.cancels

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
FOR_ROS_1 = "import rospy\nrospy.init_node('n')\nrospy.spin()\n"

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
    (FOR_ROS_1, "This node is for ROS 1", "This exercise is on ROS 2"),
]
