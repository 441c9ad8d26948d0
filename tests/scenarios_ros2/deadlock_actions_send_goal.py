"""send_goal in a callback on one thread waits for what that thread would have to do."""

import rclpy
from rclpy.action import ActionClient, ActionServer
from scenario import P, begin, say
from test_msgs.action import Fibonacci


def tick():
    say("sends")
    client.send_goal(Fibonacci.Goal(order=1))
    say("never")


rclpy.init()
node = rclpy.create_node("deadlock_actions_send_goal")
server = ActionServer(node, Fibonacci, "fibonacci", lambda goal_handle: Fibonacci.Result())
client = ActionClient(node, Fibonacci, "fibonacci")
begin()
node.create_timer(P, tick)
try:
    rclpy.spin(node)
except KeyboardInterrupt:
    say("KeyboardInterrupt")
