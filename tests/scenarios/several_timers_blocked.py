"""Three timers of different periods, blocked at the same time for different lengths: none waits for another."""

import rospy
from scenario import P, begin, block, end_after, mark_event


def callback(name, periods):
    calls = []

    def call(event):
        calls.append(event)
        mark_event(name, event)
        if len(calls) == 1:
            block(periods)

    return call


begin("several_timers_blocked")
rospy.Timer(rospy.Duration(P), callback("first", 4.5))
rospy.Timer(rospy.Duration(1.5 * P), callback("second", 2.25))
rospy.Timer(rospy.Duration(2 * P), callback("third", 1.5))
end_after(9.3)
