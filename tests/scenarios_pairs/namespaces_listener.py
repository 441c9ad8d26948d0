"""Is started in the namespace /right."""

import rclpy
from scenario import say, spin_until
from std_msgs.msg import String

rclpy.init()
node = rclpy.create_node("listener")
seen = []
for name in "words", "/words", "/left/talker/words":
    node.create_subscription(String, name, lambda message, name=name: seen.append((name, message.data)), 10)
spin_until(node, lambda: len(seen) == 2)
say(node.get_fully_qualified_name(), sorted(seen))
rclpy.shutdown()
