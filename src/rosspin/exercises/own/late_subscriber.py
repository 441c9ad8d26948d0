"""What is published waits for its subscribers: a belief that this reveals."""

from __future__ import annotations

from .. import judges as by
from ..feedback import Finding
from ..judging import Judge, plain, say
from ..observed import ObservedRun

TITLE = "Reach a subscriber that comes late"
TEXT = """
**You need**: [the second tutorial](../docs/publish.rst) and [the notebook on publishing](publish.md).

The planner publishes one goal, 7, when it starts. The robot subscribes some seconds later. Change the planner so that
the goal arrives once, within half a second after the robot subscribes. The check tries different times with
`_subscribes_at:=`.
"""
REVEALS = "What is published waits for its subscribers. A longer queue keeps it for them."

NODE = """
import rospy
from std_msgs.msg import UInt32


class Robot:
    def __init__(self):
        subscribes_at = rospy.get_param("~subscribes_at", 1.0)
        rospy.Timer(
            rospy.Duration(subscribes_at), self.subscribe, oneshot=True)

    def subscribe(self, event):
        rospy.Subscriber("goal", UInt32, self.goalCallback)

    def goalCallback(self, message):
        rospy.loginfo("[LISTENER] goal = " + str(message.data))


class Planner:
    def __init__(self):
        self.publisher = rospy.Publisher("goal", UInt32, queue_size=10)
        self.publisher.publish(7)


if __name__ == '__main__':
    rospy.init_node("planner_py_node")
    robot = Robot()
    planner = Planner()
    rospy.spin()
"""

HINTS = [
    "`queue_size` does not help: that queue leads to a subscriber, and there is none yet.",
    "If it is published again and again, it arrives more than once.",
    "A publisher can keep its last message for later subscribers.",
]
HINT = "`rospy.Publisher` has a parameter `latch`."


def _arrives_once(at: float) -> Judge:
    """Whether the listener, which subscribes at a time (s), hears the goal, 7, once, soon after."""

    def look(run: ObservedRun, when: str) -> Finding:
        heard = run.values("LISTENER", "goal")
        if not heard:
            sent = any(message.topic == "/goal" for message in run.sent)
            never = "The planner publishes nothing on `/goal`. It should publish 7 there, once."
            other = "The robot should stay as it is, and print `[LISTENER] goal = 7`."
            hint = other if any(line.heard == "7" for line in run.printed) else "" if sent else never
            return Finding(False, f"{when}: the goal did not arrive.", hint)
        if wrong := [line.text for line in heard if line.text != "7"]:
            text = f"{when}: the goal {plain(wrong[0])} arrived, not 7."
            return Finding(False, text, "The goal is 7. What is published last is what is kept.")
        if heard[0].time < at - by.CLOSE or heard[0].timer:
            text = f"{when}: the robot printed the goal at {say(heard[0].time)}, but no message had brought it."
            return Finding(False, text, "The topic carries the goal: leave its callback to the subscription.")
        if len(heard) > 1:
            text = f"{when}: the goal arrived {len(heard)} times; a robot would start again each time."
            return Finding(False, text, "Publish once, with a publisher that keeps the message.")
        if not at <= heard[0].time <= at + 0.5:
            return Finding(False, f"{when}: the goal arrived only at {say(heard[0].time)}.")
        return Finding(True, f"{when}: the goal arrived once, at {say(heard[0].time)}.")

    return by.run(4.0, look, given=f"_subscribes_at:={at}")


check = by.every(_arrives_once(1.0), _arrives_once(2.5), _arrives_once(0.3))

SOLUTION = {"queue_size": "latch=True, queue_size"}

GOAL = "        self.publisher.publish(7)"
LATCHES = "latch=True, "


def planner(publishing: str) -> dict[str, str]:
    """The solution with a planner that publishes in another way."""
    lines = "\n".join(f"        {line}" for line in publishing.splitlines())
    return {LATCHES: "", GOAL: lines}


WAITS = "while not self.publisher.get_num_connections():\n    rospy.sleep(0.1)\nself.publisher.publish(7)"
LISTENER = """        class Listener(rospy.SubscribeListener):
            def peer_subscribe(self, topic_name, topic_publish, peer_publish):
                peer_publish(UInt32(7))
        self.publisher = rospy.Publisher("goal", UInt32, Listener(), queue_size=1)"""

RIGHT = [
    {LATCHES: "latch=1, "},
    {LATCHES: "", '"goal", UInt32, queue_size': '"goal", UInt32, latch=True, queue_size'},
    planner(WAITS),
    planner(
        f"import threading\ndef wait():\n    {WAITS.replace(chr(10), chr(10) + '    ')}\n"
        "threading.Thread(target=wait, daemon=True).start()"
    ),
    planner(
        "def look(event):\n    if self.publisher.get_num_connections():\n        timer.shutdown()\n"
        "        self.publisher.publish(7)\ntimer = rospy.Timer(rospy.Duration(0.1), look)"
    ),
    {f'        self.publisher = rospy.Publisher("goal", UInt32, {LATCHES}queue_size=10)\n{GOAL}': LISTENER},
    {GOAL: "        self.publisher.publish(UInt32(data=7))"},
]
WRONG = [
    ({LATCHES: ""}, "With `_subscribes_at:=1.0`: the goal did not arrive", "has a parameter `latch`"),
    ({LATCHES: "", "queue_size=10": "queue_size=1000"}, "the goal did not arrive", "has a parameter `latch`"),
    (
        planner("rospy.sleep(1.2)\nself.publisher.publish(7)"),
        "With `_subscribes_at:=2.5`: the goal did not",
        "latch",
    ),
    (
        planner("rospy.Timer(rospy.Duration(0.2), lambda event: self.publisher.publish(7))"),
        "With `_subscribes_at:=1.0`: the goal arrived 15 times",
        "Publish once, with a publisher that keeps",
    ),
    (
        planner("rospy.Timer(rospy.Duration(3), lambda event: self.publisher.publish(7), oneshot=True)"),
        "With `_subscribes_at:=1.0`: the goal arrived only at 3 s",
        "has a parameter `latch`",
    ),
    (
        planner("while not self.publisher.get_num_connections():\n    rospy.sleep(1.5)\nself.publisher.publish(7)"),
        "With `_subscribes_at:=0.3`: the goal arrived only at 1.5 s",
        "has a parameter `latch`",
    ),
    (
        {GOAL: "        rospy.Timer(rospy.Duration(1.2), lambda event: self.publisher.publish(7), oneshot=True)"},
        "With `_subscribes_at:=0.3`: the goal arrived only at 1.2 s",
        "has a parameter `latch`",
    ),
    ({"[LISTENER]": "[ROBOT]"}, "the goal did not arrive", "The robot should stay as it is"),
    ({GOAL: GOAL.replace("7", "8")}, "the goal 8 arrived, not 7", "The goal is 7."),
    ({GOAL: ""}, "the goal did not arrive", "The planner publishes nothing on `/goal`."),
    (
        {LATCHES: "", '"goal", UInt32, self.goalCallback': '"goal", UInt32, self.goalCallback, latch=True'},
        "unexpected keyword argument 'latch'",
        "latch",
    ),
    ({GOAL: GOAL + "\n        self.publisher.unregister()"}, "the goal did not arrive", "has a parameter `latch`"),
    ({LATCHES: "latch=true, "}, "name 'true' is not defined", "In Python this is written `True`."),
    ({"    rospy.spin()": ""}, "the goal did not arrive", "The node ended by itself"),
    ({GOAL: f"{GOAL}\n        self.publisher.publish(0)"}, "the goal 0 arrived, not 7", "The goal is 7."),
]
