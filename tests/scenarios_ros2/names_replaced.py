"""Methods of a node's class with names that Node has, and where rclpy meets them."""

import rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from scenario import say
from std_msgs.msg import String

NAMES = """
clients guards services subscriptions timers waitables publishers executor handle
create_client create_publisher create_service create_subscription create_timer declare_parameter declare_parameters
get_parameter set_parameters destroy_publisher destroy_service destroy_timer destroy_node get_clock get_logger
has_parameter remove_waitable count_publishers
""".split()


def use(kind):
    node = kind("used")
    node.create_timer(0.05, lambda: None)
    node.create_subscription(String, "topic", print, 1)
    executor = SingleThreadedExecutor()
    executor.add_node(node)
    executor.spin_once(0.5)
    executor.shutdown()
    node.destroy_node()


rclpy.init()
watch = rclpy.create_node("watch")
for name in NAMES:
    kind = type("Own", (Node,), {name: lambda self: "own"})
    try:
        use(kind)
    except Exception as error:
        say(name, "->", type(error).__name__, str(error).partition(" (missed")[0])  # which Python 3.14 adds
    else:
        say(name, "-> no one asks")
    say(watch.get_node_names())
rclpy.shutdown()
