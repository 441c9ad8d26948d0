"""An executor to which only nodes refer: it is gone."""

import threading

import rclpy
from rclpy.executors import MultiThreadedExecutor, SingleThreadedExecutor
from rclpy.node import Node


class Inside(Node):
    def __init__(self):
        super().__init__("inside")
        self.executor = SingleThreadedExecutor()
        self.create_timer(0.3, lambda: print("tick"))

    def run(self):
        self.executor.spin()


def attach(node):
    executor = MultiThreadedExecutor(2)
    executor.add_node(node)


rclpy.init()
other = Node("other")
attach(other)
print("other:", other.executor)
node = Inside()
try:
    node.run()
except AttributeError as error:
    print(error)

thread = threading.Thread(target=attach, args=(other,))
thread.start()
thread.join()
print("other:", other.executor)
