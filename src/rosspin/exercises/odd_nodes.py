"""Nodes of ROS 1 in odd style, for the answers of several exercises. ``PERIOD`` stands for a period (s)."""

from __future__ import annotations

HEAD = 'import rospy\nrospy.init_node("n")\n'


def say(counter: str, tag: str = "SPINNER PY NODE") -> str:
    """The line that prints a counter."""
    return f'rospy.loginfo("[{tag}] counter = " + str({counter}))'


# A timer whose callback is a function.
PLAIN = f"""{HEAD}count = 0
def callback(event):
    global count
    count += 1
    {say("count")}
timer = rospy.Timer(rospy.Duration(PERIOD), callback)
rospy.spin()
"""

# A timer that is made by a generator.
LAMBDA = f"""{HEAD}from itertools import count
counts = count(1)
rospy.Timer(rospy.Duration(PERIOD), lambda event: {say("next(counts)")})
rospy.spin()
"""

# It prints by other means than a log line, and logs an error that it has caught.
CAUGHT = """
import rospy
class Spinner:
    counter = 0
    def __call__(self, event):
        self.counter += 1
        try:
            [][self.counter]
        except IndexError:
            rospy.logwarn("Exception in thread Thread-1:", exc_info=True)
        print("[SPINNER PY NODE] counter = %d" % self.counter)
def main():
    rospy.init_node("spinner")
    rospy.Timer(period=rospy.Duration(nsecs=int(PERIOD * 1e9)), callback=Spinner())
    rospy.spin()
main()
"""

# A loop that sleeps first.
SLEEPS_FIRST = f"""{HEAD}rate = rospy.Rate(1 / PERIOD)
count = 0
while not rospy.is_shutdown():
    rate.sleep()
    count += 1
    {say("count")}
"""

# A thread of its own beside spin().
THREAD = f"""import threading
{HEAD}def run():
    for count in range(1, 1000):
        rospy.sleep(PERIOD)
        {say("count")}
threading.Thread(target=run, daemon=True).start()
rospy.spin()
"""


def at(period: str, *nodes: str) -> list[str]:
    """Nodes with a period."""
    return [node.replace("PERIOD", period) for node in nodes]
