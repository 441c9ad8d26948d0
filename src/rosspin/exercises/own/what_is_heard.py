"""What is published waits until there is a subscriber: a belief that this reveals."""

from __future__ import annotations

from ..predictions import predicted

TITLE = "What the subscriber hears"
TEXT = """
**You need**: [the second tutorial](../docs/publish.rst) and [the notebook on publishing](publish.md).

This node publishes its first counter immediately, and then one every 0.5 s:

```python
import rospy
from std_msgs.msg import UInt32


class PubsubPyNode:
    def __init__(self):
        self.counter = 0
        self.publisher = rospy.Publisher("counter", UInt32, queue_size=10)
        rospy.Subscriber("counter", UInt32, self.counterCallback)
        self.timerCallback(None)
        rospy.Timer(rospy.Duration(0.5), self.timerCallback)

    def timerCallback(self, event):
        self.counter += 1
        self.publisher.publish(self.counter)

    def counterCallback(self, message):
        rospy.loginfo("[PUBSUB PY NODE] counter = " + str(message.data))


rospy.init_node("pubsub_py_node")
pubsub_py_node = PubsubPyNode()
rospy.spin()
```

Which three counters does it print first, as in `[1, 2, 3]`? And with `latch=True` in `rospy.Publisher`?

Now the publisher latches, and `self.timerCallback(None)` three times in a row replaces the timer. Give all counters.

Last, a publisher sends 0, 1, 2 and so on, one every 0.1 s, to a subscriber that has long been connected. This has a
`queue_size` of 1; its callback prints the counter and then takes 0.33 s. Give the first three; the first is 0.
"""
REVEALS = (
    "What is published waits until there is a subscriber. A latch keeps everything. A queue of 1 makes a callback wait "
    "for the next message."
)

NODE = """
without_latch = ...
with_latch = ...
three_at_once = ...
slow_callback = ...
"""

HINTS = [
    "A subscriber needs a moment to connect to a new publisher. What becomes of a message before that?",
    "A latching publisher keeps its last message for later subscribers. How many is that?",
    "The slow callback begins with counter 0, at 0 s, say. Which counters have been published when it returns at 0.33 "
    "s, and which of them are still there?",
]
HINT = (
    "Is the connection there when the message is published? Which message is the newest one when the callback is free?"
)

_UNCONNECTED = "When 1 is published, the subscriber is not connected yet, and the message is not kept for later."
_LATCH = "A publisher that latches keeps its last message for whoever connects later."

check = predicted(
    "counters",
    without_latch=(
        "without `latch`",
        [2, 3, 4],
        "Is the subscriber connected when the first message is published?",
        {(1, 2, 3): _UNCONNECTED},
    ),
    with_latch=(
        "with `latch`",
        [1, 2, 3],
        "Which message does a publisher that latches keep for whoever connects later?",
        {(2, 3, 4): _LATCH},
    ),
    three_at_once=(
        "three in a row",
        [3],
        "How many messages does a publisher that latches keep?",
        {
            (1, 2, 3): "A publisher that latches keeps one message only, the last.",
            (1,): "It is the last message that is kept, not the first.",
            (): _LATCH,
        },
    ),
    slow_callback=(
        "the slow callback",
        [0, 3, 6],
        "Only one message can wait in the queue. Which one is it when the callback is free again?",
        {
            (0, 1, 2): "This is what happens without a `queue_size`. With 1, all but the newest are dropped.",
            (0, 4, 8): "The callback does not wait for the next message: the newest one is there already.",
            (0, 1, 4): "The message that waits is replaced by each newer one.",
        },
    ),
)

SOLUTION = """
# Counter 1 is published before the connection is made, and is lost.
without_latch = [2, 3, 4]
# It is kept, and sent as soon as the connection is made.
with_latch = [1, 2, 3]
# Only the last one is kept.
three_at_once = [3]
# Back at 0.33 s: 1, 2 and 3 have been published, and 3 has replaced the others.
slow_callback = [0, 3, 6]
"""

RIGHT = [
    {"[2, 3, 4]": "(2, 3, 4)"},
    {"[1, 2, 3]": "range(1, 4)"},
    {"[3]": "(3,)"},
    {"[0, 3, 6]": "[0.0, 3.0, 6.0]"},
    {"[0, 3, 6]": "[3 * n for n in range(3)]", "[2, 3, 4]": "(2, 3, 4)"},
]
WRONG = [
    ({"[2, 3, 4]": "[1, 2, 3]"}, "Without `latch`: not 1, 2, 3", "is not connected yet"),
    ({"[1, 2, 3]": "[2, 3, 4]"}, "With `latch`: not 2, 3, 4", "keeps its last message for whoever"),
    ({"[3]": "[1, 2, 3]"}, "Three in a row: not 1, 2, 3", "keeps one message only, the last"),
    ({"[3]": "[1]"}, "Three in a row: not 1.", "not the first"),
    ({"[3]": "[]"}, "Three in a row: not nothing at all", "keeps its last message for whoever"),
    ({"[0, 3, 6]": "[0, 1, 2]"}, "The slow callback: not 0, 1, 2", "happens without a `queue_size`"),
    ({"[0, 3, 6]": "[0, 4, 8]"}, "The slow callback: not 0, 4, 8", "does not wait for the next message"),
    ({"[0, 3, 6]": "[0, 1, 4]"}, "The slow callback: not 0, 1, 4", "is replaced by each newer one"),
    ({"[0, 3, 6]": "[0, 3, 7]"}, "the third of these counters is not 7", "Only one message can wait"),
    ({"[2, 3, 4]": "[2, 3]"}, "3 counters are asked for, not 2", "These are right, and one more is asked for"),
    ({"[2, 3, 4]": "2"}, "a list of counters, not a value of type `int`", "`[1, 2, 3]`"),
    (
        {"three_at_once = [3]": ""},
        "Three in a row: there is no prediction yet",
        "Give `three_at_once` a list of counters",
    ),
]
