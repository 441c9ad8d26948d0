"""Actions, and what is recorded of them, beyond what the scenarios hold."""

from __future__ import annotations

from typing import Any

import pytest

from rosspin import simulate, start

NODE = """
import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionClient, ActionServer
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor


def execute(goal_handle):
    import time
    sequence = [0, 1]
    for _ in range(goal_handle.request.order):
        sequence.append(sequence[-1] + sequence[-2])
        goal_handle.publish_feedback(Fibonacci.Feedback(sequence=sequence))
        time.sleep(0.1)
    goal_handle.succeed()
    return Fibonacci.Result(sequence=sequence)


rclpy.init()
node = rclpy.create_node("n", namespace="/mrp")
"""
BOTH = """
server = ActionServer(node, Fibonacci, "fibonacci", execute)
client = ActionClient(node, Fibonacci, "fibonacci")


def answered(future):
    future.result().get_result_async().add_done_callback(lambda future: print(list(future.result().result.sequence)))


client.send_goal_async(Fibonacci.Goal(order=3)).add_done_callback(answered)
rclpy.spin(node)
"""


def test_a_run_has_the_calls_and_messages_of_an_action(write: Any) -> None:
    run = simulate(write(NODE + BOTH), 2)
    goal, result = run.calls
    assert (goal.service, goal.client, goal.server) == ("/mrp/fibonacci/_action/send_goal", "/mrp/n", "/mrp/n")
    assert (goal.request.goal.order, goal.response.accepted) == (3, True)
    assert (result.service, result.response.status) == ("/mrp/fibonacci/_action/get_result", 4)
    assert result.asked == pytest.approx(0.3)  # one thread: the answer to the goal is taken after its end
    assert result.answered == pytest.approx(0.3)
    assert list(result.response.result.sequence) == [0, 1, 1, 2, 3]
    feedback = [list(each.message.feedback.sequence)[-1] for each in run.messages if each.topic.endswith("feedback")]
    assert feedback == [1, 2, 3]
    statuses = [
        [each.status for each in message.message.status_list] for message in run.messages if "status" in message.topic
    ]
    assert statuses == [[1], [2], [4]]


def test_a_goal_without_an_answer_is_a_call_without_one(write: Any) -> None:
    run = simulate(
        write(NODE + 'ActionClient(node, Fibonacci, "f").send_goal_async(Fibonacci.Goal())\nrclpy.spin(node)\n'), 1
    )
    (call,) = run.calls
    assert (call.server, call.response) == ("", None)
    assert call.answered != call.answered


def test_the_ids_of_goals_are_the_same_in_each_run_and_differ_in_one(write: Any) -> None:
    source = NODE + (
        'client = ActionClient(node, Fibonacci, "f")\n'
        "for _ in range(3):\n    client.send_goal_async(Fibonacci.Goal())\n"
    )
    path = write(source)
    first, second = ([bytes(call.request.goal_id.uuid) for call in simulate(path, 1).calls] for _ in range(2))
    assert first == second
    assert len(set(first)) == 3


def test_a_test_may_look_at_an_action(write: Any) -> None:
    with start(write(NODE + BOTH)) as node:
        node.advance(0.15)
        assert node.messages("/mrp/fibonacci/_action/feedback")[-1].message.feedback.sequence.tolist() == [0, 1, 1, 2]
        run = node.advance(1)
        assert run.console == "[0, 1, 1, 2, 3]\n"
        assert [call.service for call in run.calls] == ["/mrp/fibonacci/_action/get_result"]


def test_a_custom_executor_gets_what_rclpy_gives_it(write: Any) -> None:
    source = """
import rclpy
from rclpy.executors import Executor, ShutdownException, TimeoutException

class Loud(Executor):
    def spin_once(self, timeout_sec=None):
        try:
            handler, entity, node = self.wait_for_ready_callbacks(timeout_sec=timeout_sec)
        except (ShutdownException, TimeoutException):
            return
        print(type(entity).__name__, node and node.get_name())
        handler()
        if handler.exception() is not None:
            raise handler.exception()

rclpy.init()
node = rclpy.create_node("n")
node.create_timer(0.5, lambda: None)
executor = Loud()
executor.add_node(node)
executor.create_task(lambda: None)
executor.spin()
"""
    assert simulate(write(source), 1).console.startswith("NoneType None\nTimer n\nTimer n\n")


def test_a_context_that_is_destroyed_says_so(write: Any) -> None:
    source = """
import rclpy
from rclpy.context import Context
context = Context()
context.destroy()
print(context.ok())
context.init()
context.destroy()
try:
    context.ok()
except Exception as error:
    print(type(error).__name__, error)
"""
    words = "cannot use Destroyable because destruction was requested"
    assert simulate(write(source), 1).console == f"False\nInvalidHandle {words}\n"


def test_a_goal_after_one_that_is_not_cancelled_is_passed_over(write: Any) -> None:
    """And the server says that it is: rclpy takes a goal out of the list that it goes through. So the real one did."""
    node = write("""
        import rclpy
        from action_msgs.srv import CancelGoal
        from rclpy.action import ActionClient, ActionServer, CancelResponse
        from test_msgs.action import Fibonacci

        def cancel(goal):
            asked.append(goal)
            return CancelResponse.REJECT if len(asked) == 1 else CancelResponse.ACCEPT

        def done(future):
            rclpy.spin_until_future_complete(node, future)
            return future.result()

        asked = []
        rclpy.init()
        node = rclpy.create_node("node")
        wait = {"handle_accepted_callback": lambda goal: None}
        server = ActionServer(node, Fibonacci, "count", lambda goal: None, cancel_callback=cancel, **wait)
        sender = ActionClient(node, Fibonacci, "count")
        client = node.create_client(CancelGoal, "count/_action/cancel_goal")
        goals = [done(sender.send_goal_async(Fibonacci.Goal(order=order))) for order in (1, 2, 3)]
        answer = done(client.call_async(CancelGoal.Request()))
        for _ in range(5):
            rclpy.spin_once(node, timeout_sec=0.1)
        print(len(asked), len(answer.goals_canceling), sorted(goal.status for goal in goals))
    """)
    assert simulate(node, 5).console == "2 2 [1, 1, 3]\n"


AFTER_SHUTDOWN = """
import rclpy
from rclpy.action import ActionClient, ActionServer
from test_msgs.action import Fibonacci
rclpy.init()
node = rclpy.create_node("node")
def execute(goal):
    rclpy.shutdown()
    for act in (goal.abort, lambda: goal.publish_feedback(Fibonacci.Feedback())):
        try:
            act()
        except Exception as error:
            print(type(error).__name__, error)
    return Fibonacci.Result()
server = ActionServer(node, Fibonacci, "fib", execute)
ActionClient(node, Fibonacci, "fib").send_goal_async(Fibonacci.Goal())
rclpy.spin(node)
"""


def test_after_shutdown_a_goal_says_nothing_more(write: Any) -> None:
    """As on the real rclpy 7.1.6, which adds a line of its source."""
    assert simulate(write(AFTER_SHUTDOWN), 1.0).console.splitlines() == [
        "RCLError Failed get goal status array: feedback publisher is invalid",
        "RCLError Failed to publish feedback with an action server: feedback publisher is invalid",
    ]
