"""What is published waits for its subscribers: a belief that this reveals."""

from __future__ import annotations

from ..predictions import predicted

TITLE = "What a late subscriber hears"
TEXT = """
**You need**: [publish and subscribe in ROS 2](../docs/ros2/publish.rst) and [its notebook](ros2-publish.md).

This node publishes 1 at 0.5 s, 2 at 1.0 s, 3 at 1.5 s, and so on, and subscribes at 1.75 s. Which three counters does
it hear first? Answer as in `[1, 2, 3]`; `[]` means none.

```python
import rclpy
from rclpy.node import Node
from std_msgs.msg import UInt32


class PubSubPyNode(Node):
    def __init__(self):
        super().__init__("pubsub_py_node")
        self.counter = 0
        self.publisher = self.create_publisher(UInt32, "counter", 10)
        self.create_timer(0.5, self.timer_callback)
        self.later = self.create_timer(1.75, self.later_callback)

    def timer_callback(self):
        self.counter += 1
        self.publisher.publish(UInt32(data=self.counter))

    def later_callback(self):
        self.later.cancel()
        self.create_subscription(UInt32, "counter", self.counter_callback, 10)

    def counter_callback(self, message):
        self.get_logger().info("[PUBSUB PY NODE] counter = " + str(message.data))


rclpy.init()
rclpy.spin(PubSubPyNode())
```

Now both sides have this profile in place of `10`; then only the publisher has it; finally, only the subscription:

```python
QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
```
"""
REVEALS = "What is published waits for its subscribers."

NODE = """
both_plain = ...
both_keep = ...
only_publisher = ...
only_subscription = ...
"""

HINTS = [
    "When 3 is published, there is no subscription. Where could the message wait?",
    "With `TRANSIENT_LOCAL`, a publisher keeps its last messages, as many as its depth. Only a subscription of the "
    "same durability hears them.",
    "What happens if a subscription asks for more than the publisher offers?",
]
HINT = "Who keeps a message that was published before there was a subscription?"


check = predicted(
    "counters",
    both_plain=(
        "with `10` on both sides",
        [4, 5, 6],
        "When 3 is published, there is no subscription yet, and the message is not kept for later.",
        {
            (1, 2, 3): "",
            (3, 4, 5): "",
        },
    ),
    both_keep=(
        "with the profile on both sides",
        [3, 4, 5],
        "A publisher with `TRANSIENT_LOCAL` keeps its last messages for whoever comes later: as many as its depth.",
        {
            (4, 5, 6): "",
            (1, 2, 3): "The publisher keeps as many messages as its depth says, the last ones. Its depth is 1.",
            (1, 4, 5): "It is the last message that is kept, not the first.",
        },
    ),
    only_publisher=(
        "with the profile on the publisher's side",
        [4, 5, 6],
        "A subscription hears what the publisher has kept only if it asks for that, with the same durability.",
        {
            (3, 4, 5): "",
            (1, 2, 3): "",
            (): "The publisher offers more than the subscription asks for, and that is enough to connect.",
        },
    ),
    only_subscription=(
        "with the profile on the subscription's side",
        [],
        "A subscription is not connected to a publisher that offers less than it asks for.",
        {
            (4, 5, 6): "",
            (3, 4, 5): "",
            (1, 2, 3): "",
        },
    ),
)

SOLUTION = """
# No message is kept for a subscription that comes later.
both_plain = [4, 5, 6]
# The publisher keeps the last one, and the subscription asks for it.
both_keep = [3, 4, 5]
# It is kept, but the subscription does not ask for it.
only_publisher = [4, 5, 6]
# It asks for what the publisher does not offer: they do not match.
only_subscription = []
"""
AFTER = """
In the last case the node prints two warnings, which name the policy `DURABILITY`.
"""

RIGHT = [
    {"both_plain = [4, 5, 6]": "both_plain = (4, 5, 6)"},
    {"[3, 4, 5]": "list(range(3, 6))"},
    {"only_publisher = [4, 5, 6]": "only_publisher = [4.0, 5.0, 6.0]"},
    {"[]": "()"},
    {"[]": "list()\nprint(only_subscription)"},
]
WRONG = [
    (
        {"both_plain = [4, 5, 6]": "both_plain = [1, 2, 3]"},
        "With `10` on both sides: not 1, 2, 3",
        "the message is not kept",
    ),
    (
        {"both_plain = [4, 5, 6]": "both_plain = [3, 4, 5]"},
        "With `10` on both sides: not 3, 4, 5",
        "the message is not kept",
    ),
    (
        {"both_plain = [4, 5, 6]": "both_plain = [4, 5, 7]"},
        "the third of these counters is not 7",
        "the message is not kept",
    ),
    ({"[3, 4, 5]": "[4, 5, 6]"}, "not 4, 5, 6", "keeps its last messages"),
    ({"[3, 4, 5]": "[1, 2, 3]"}, "not 1, 2, 3", "Its depth is 1"),
    ({"[3, 4, 5]": "[1, 4, 5]"}, "not 1, 4, 5", "not the first"),
    ({"only_publisher = [4, 5, 6]": "only_publisher = [3, 4, 5]"}, "not 3, 4, 5", "only if it asks for that"),
    ({"only_publisher = [4, 5, 6]": "only_publisher = []"}, "not nothing at all", "that is enough to connect"),
    ({"[]": "[4, 5, 6]"}, "not 4, 5, 6", "offers less than it asks for"),
    ({"[]": "[3, 4, 5]"}, "not 3, 4, 5", "offers less than it asks for"),
    ({"[]": "[9]"}, "not 9", "offers less than it asks for"),
    ({"only_subscription = []": ""}, "there is no prediction yet", "Give `only_subscription`"),
]
