"""Which names a topic may have, what they stand for, and whose publishers are counted."""

import rclpy
from rclpy.expand_topic_name import expand_topic_name
from scenario import attempt
from std_msgs.msg import UInt32

rclpy.init(args=["--ros-args", "-r", "old:=new"])
node = rclpy.create_node("n", namespace="x")
node.create_publisher(UInt32, "old", 10)
names = {"node": node, "expand": expand_topic_name, "UInt32": UInt32}
words = [
    "",
    "/",
    "a/",
    "a/5",
    "5a",
    "a//b",
    "/a//b",
    "a b",
    "é",
    "{",
    "{node",
    "a}",
    "{a}",
    "{}",
    "a~b",
    "~a",
    "a" * 250,
]
for word in [*words, "~", "~/a", "{node}/{ns}", "/a", "__a", "a__b", "a" * 245, "old", "new"]:
    attempt(f"expand({word!r}, 'n', '/x')", names)
    attempt(f"node.count_publishers({word!r})", names)
    attempt(f"node.create_publisher(UInt32, {word!r}, 10).topic_name", names)
for text in """
expand('a', '', '/x')
expand('a', 'b c', '/x')
expand('a', 'n', 'x')
expand('a', 'n', '/5')
expand(5, 'n', '/x')
node.count_subscribers(5)
""".strip().splitlines():
    attempt(text, names)
rclpy.shutdown()
