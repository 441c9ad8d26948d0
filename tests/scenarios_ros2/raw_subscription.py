"""A raw subscription gets what is on the wire; bytes can be published, too, and what is no message reaches only it."""

import rclpy
from rclpy.serialization import deserialize_message, serialize_message
from scenario import attempt, say
from std_msgs.msg import Empty, String, UInt8, UInt16MultiArray

rclpy.init()
node = rclpy.create_node("raw_subscription")
for kind, messages in (
    (String, (String(data="abcd"), String(), serialize_message(String(data="äb")))),
    (UInt8, (UInt8(data=3), b"\0\1\0\0\4\0\0\0")),
    (Empty, (Empty(),)),
    (UInt16MultiArray, (UInt16MultiArray(data=[1, 2, 65535]),)),
):
    topic = kind.__name__.lower()
    publisher = node.create_publisher(kind, topic, 10)
    raw = node.create_subscription(kind, topic, lambda data: say("raw  ", type(data).__name__, data), 10, raw=True)
    usual = node.create_subscription(kind, topic, lambda message: say("usual", message), 10)
    say(kind.__name__, raw.raw, usual.raw)
    while publisher.get_subscription_count() < 2:
        rclpy.spin_once(node, timeout_sec=0.05)
    for message in messages:
        publisher.publish(message)
        for _ in range(6):
            rclpy.spin_once(node, timeout_sec=0.05)
    node.destroy_subscription(raw)
    node.destroy_subscription(usual)
attempt("publisher.publish(bytearray(4))", {"publisher": publisher})
node.create_subscription(String, "last", lambda data, info: say(deserialize_message(data, String), *info), 10, raw=True)
publisher = node.create_publisher(String, "last", 10)
while not publisher.get_subscription_count():
    rclpy.spin_once(node, timeout_sec=0.05)
publisher.publish(String(data="with info"))
rclpy.spin_once(node, timeout_sec=5.0)
odd = node.create_subscription(String, "odd", lambda data: say(type(data).__name__, data), 10, raw=True)
node.create_subscription(String, "odd", lambda message: say("usual", message), 10)
publisher = node.create_publisher(String, "odd", 10)
while publisher.get_subscription_count() < 2:
    rclpy.spin_once(node, timeout_sec=0.05)
for data in (b"", b"no message", b"\0\1\0\0\5\0\0\0ab"):
    publisher.publish(data)
    for _ in range(6):
        rclpy.spin_once(node, timeout_sec=0.05)
rclpy.shutdown()
