"""What actions do not take."""

import rclpy
from rclpy.action import ActionClient, ActionServer, CancelResponse, GoalResponse
from rclpy.action.server import ServerGoalHandle
from scenario import attempt, say
from test_msgs.action import Fibonacci

rclpy.init()
node = rclpy.create_node("actions_errors")
handles = []


def execute(goal_handle):
    attempt("handle.publish_feedback(Fibonacci.Result())", {"handle": goal_handle, "Fibonacci": Fibonacci})
    goal_handle.succeed()
    attempt("handle.succeed()", {"handle": goal_handle})
    attempt("handle.canceled()", {"handle": goal_handle})
    say(goal_handle.status)
    return Fibonacci.Result()


server = ActionServer(node, Fibonacci, "fibonacci", execute, handle_accepted_callback=handles.append)
client = ActionClient(node, Fibonacci, "fibonacci")
names = {**globals()}
attempt("ActionServer(node, Fibonacci, 'fibonacci', None)", names)
attempt("server.register_execute_callback(3)", names)
attempt("client.send_goal_async(Fibonacci.Result())", names)
attempt("client.send_goal(Fibonacci.Feedback())", names)
attempt("client._cancel_goal_async(3)", names)
attempt("client._get_result_async(3)", names)
say(list(GoalResponse), list(CancelResponse))
future = client.send_goal_async(Fibonacci.Goal(order=1))
rclpy.spin_until_future_complete(node, future)
(handle,) = handles
say(type(handle) is ServerGoalHandle, handle == handle, handle.request, handle.status, handle.is_cancel_requested)
say(repr(future.result()).partition("<")[0], repr(future.result()).rpartition("accepted")[2])
say(future.result().goal_id == handle.goal_id, len(handle.goal_id.uuid))
handle.execute()
result = future.result().get_result_async()
rclpy.spin_until_future_complete(node, result)
say(result.result())
