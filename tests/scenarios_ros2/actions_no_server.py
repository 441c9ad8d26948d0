"""A goal that is sent before there is a server is lost."""

import rclpy
from rclpy.action import ActionClient, ActionServer
from scenario import say
from test_msgs.action import Fibonacci

rclpy.init()
node = rclpy.create_node("actions_no_server")
client = ActionClient(node, Fibonacci, "fibonacci")
future = client.send_goal_async(Fibonacci.Goal(order=1))
rclpy.spin_until_future_complete(node, future, timeout_sec=0.2)
say(future.done())
server = ActionServer(node, Fibonacci, "fibonacci", lambda goal_handle: Fibonacci.Result())
rclpy.spin_until_future_complete(node, future, timeout_sec=0.3)
say(future.done())
