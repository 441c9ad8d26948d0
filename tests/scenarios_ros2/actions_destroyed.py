"""Destroying a client and a server, with a goal on its way."""

import rclpy
from rclpy.action import ActionClient, ActionServer
from scenario import attempt, say
from test_msgs.action import Fibonacci

rclpy.init()
node = rclpy.create_node("actions_destroyed")
handles = []
server = ActionServer(node, Fibonacci, "fibonacci", lambda goal: None, handle_accepted_callback=handles.append)
client = ActionClient(node, Fibonacci, "fibonacci")
future = client.send_goal_async(Fibonacci.Goal(order=1))
rclpy.spin_until_future_complete(node, future)
result = future.result().get_result_async()
before = len(list(node.waitables))
server.destroy()
say(len(list(node.waitables)) - before, handles[0].status, handles[0].is_active)
handles[0].succeed()
rclpy.spin_until_future_complete(node, result, timeout_sec=0.2)
say(result.done())
client.destroy()
say(len(list(node.waitables)) - before)
attempt("client.send_goal_async(Fibonacci.Goal())", globals())
node.destroy_node()
