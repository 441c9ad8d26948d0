"""An exception in main, with a node that was never destroyed."""

import rclpy
from scenario import say

rclpy.init()
node = rclpy.create_node("main_raises")
say("raising")
raise RuntimeError("in main")
