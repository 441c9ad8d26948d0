"""Waiting for a server that is not there, and for one that comes."""

import rclpy
from rclpy.action import ActionClient, ActionServer
from scenario import after, begin, mark, say
from test_msgs.action import Fibonacci


def serve():
    global server
    server = ActionServer(node, Fibonacci, "fibonacci", lambda goal_handle: Fibonacci.Result())


rclpy.init()
node = rclpy.create_node("actions_wait")
client = ActionClient(node, Fibonacci, "fibonacci")
begin()
say(client.server_is_ready())
say(client.wait_for_server(timeout_sec=0.4))
mark("waited")
say(client.wait_for_server(timeout_sec=0.0))
mark("looked")
after(3.1, serve)
say(client.wait_for_server())
mark("there")
server.destroy()
say(client.server_is_ready())
