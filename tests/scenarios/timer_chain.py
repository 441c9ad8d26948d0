"""Each oneshot timer starts the next."""

import rospy
from scenario import P, begin, end_after, mark_event


def link(number):
    def callback(event):
        mark_event(f"link{number}", event)
        if number < 5:
            rospy.Timer(rospy.Duration(P * (1 + number % 2)), link(number + 1), oneshot=True)

    return callback


begin("timer_chain")
rospy.Timer(rospy.Duration(P), link(1), oneshot=True)
end_after(9)
