"""rclpy.shutdown() in a callback: hooks run in it, spin returns after it, and what comes after shutdown."""

import rclpy
from scenario import P, attempt, begin, mark, say


def callback():
    mark("tick")
    rclpy.shutdown()
    say("ok", rclpy.ok())


rclpy.init()
node = rclpy.create_node("shutdown_in_callback")
context = rclpy.get_default_context()
context.on_shutdown(lambda: say("first hook", rclpy.ok()))
context.on_shutdown(lambda: say("second hook"))
begin()
node.create_timer(P, callback)
say(rclpy.spin(node))
mark("spun")
names = {"rclpy": rclpy, "node": node, "context": context, "say": say}
for text in """
rclpy.shutdown()
rclpy.try_shutdown()
node.get_clock().now() is not None
node.create_timer(1, print)
node.get_logger().info('after the shutdown')
context.on_shutdown(lambda: say('late hook'))
node.destroy_node()
""".strip().splitlines():
    attempt(text, names)
