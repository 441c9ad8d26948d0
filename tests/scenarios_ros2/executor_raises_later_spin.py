"""After an exception that was caught, a MultiThreadedExecutor of two nodes is shut down, and another one spins on."""

import rclpy
from rclpy.executors import MultiThreadedExecutor, SingleThreadedExecutor
from scenario import P, begin, end_after, mark, say


def callback():
    mark("raises")
    raise ValueError("in a callback")


rclpy.init()
bad, good = rclpy.create_node("bad"), rclpy.create_node("good")
begin()
bad.create_timer(1.5 * P, callback)
good.create_timer(P, lambda: mark("good"))
executor = MultiThreadedExecutor(2)
executor.add_node(bad)
executor.add_node(good)
try:
    executor.spin()
except ValueError as error:
    mark("caught")
    say(error)
executor.shutdown()
bad.destroy_node()
another = SingleThreadedExecutor()
another.add_node(good)
end_after(3.7)
another.spin()
