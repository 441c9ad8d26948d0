"""One timer shuts another down while that one's callback is blocked."""

import rospy
from scenario import P, begin, block, end_after, mark, mark_event


def slow(event):
    mark_event("slow", event)
    block(2.5)
    mark("slow_done")


def killer(event):
    mark_event("killer", event)
    timer.shutdown()


begin("timer_shutdown_of_another")
timer = rospy.Timer(rospy.Duration(P), slow)
rospy.Timer(rospy.Duration(2.5 * P), killer, oneshot=True)
end_after(7)
