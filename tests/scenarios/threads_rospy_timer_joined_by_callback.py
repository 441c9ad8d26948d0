"""A callback that waits for another timer's end; one that joins itself fails."""

import rospy
from scenario import P, begin, block, end_after, mark


def join(event):
    mark("waits")
    other.join()
    mark("goes_on")
    timer.join()


def work(event):
    mark("works")
    block(2)


begin("threads_rospy_timer_joined_by_callback")
other = rospy.Timer(rospy.Duration(1.5 * P), work, oneshot=True)
timer = rospy.Timer(rospy.Duration(P), join)
end_after(5)
print("alive", timer.is_alive(), other.is_alive())
