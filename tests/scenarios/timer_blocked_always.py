"""Every call of a timer takes ~block periods. Every field of the events."""

import rospy
from scenario import P, begin, block, end_after, mark_event


def callback(event):
    mark_event("tick", event)
    block(rospy.get_param("~block"))


begin("timer_blocked_always")
timer = rospy.Timer(rospy.Duration(P), callback)
end_after(9.5)
