"""What can still be asked of a node that was destroyed, and of what it had."""

import rclpy
import rclpy.wait_for_message
from rclpy.parameter import Parameter
from scenario import attempt
from std_msgs.msg import UInt32

rclpy.init()
node = rclpy.create_node("node_destroyed")
node.declare_parameter("a", 1)
node.declare_parameter("b", 1)
names = {
    "p": node.create_publisher(UInt32, "numbers", 10),
    "s": node.create_subscription(UInt32, "numbers", print, 10),
    "t": node.create_timer(1, print),
    "g": node.create_guard_condition(print),
    **{"n": node, "rclpy": rclpy, "Parameter": Parameter, "UInt32": UInt32},
}
node.destroy_node()
for text in """
n.declare_parameter('x', 1)
n.declare_parameters('', [('y', 1), ('z', 1)])
n.has_parameter('x'), n.has_parameter('y')
n.declare_parameter('a', 1)
n.set_parameters([Parameter('a', value=2)])
n.set_parameters_atomically([Parameter('a', value=3)])
n.set_parameters([Parameter('a', value='x')])
n.set_parameters([])
n.set_parameters([Parameter('use_sim_time', value=True)])
n.get_parameter('a').value, n.get_parameter('use_sim_time').value
n.undeclare_parameter('b')
n.describe_parameter('a').type
n.list_parameters([], 0).names
n.create_timer(1, print) is not None
n.create_rate(1) is not None
n.create_guard_condition(print) is not None
n.create_publisher(UInt32, 'numbers', 10)
n.create_subscription(UInt32, 'numbers', print, 10)
rclpy.wait_for_message.wait_for_message(UInt32, n, 'numbers', time_to_wait=0.1)
n.resolve_topic_name('numbers')
n.get_topic_names_and_types()
n.count_publishers('numbers')
n.count_subscribers('a b')
n.get_node_names()
n.get_node_names_and_namespaces()
n.get_fully_qualified_node_names()
n.wait_for_node('node_destroyed', 0.1)
n.wait_for_node('node_destroyed', 0)
n.get_name()
n.get_logger().name
n.get_clock().now() is not None
n.context.ok()
n.destroy_publisher(p), n.destroy_subscription(s), n.destroy_timer(t), n.destroy_guard_condition(g)
p.publish(UInt32())
p.topic_name
p.get_subscription_count()
p.assert_liveliness()
p.logger_name
s.topic_name
s.get_publisher_count()
s.logger_name
t.cancel()
g.trigger()
n.destroy_node()
""".strip().splitlines():
    attempt(text, names)
rclpy.shutdown()
