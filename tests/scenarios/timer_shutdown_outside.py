"""A timer shut down from the main, in its sleep: it wakes up once more without a call, and ends."""

import rospy
from scenario import P, begin, block, end_after, mark, mark_event

begin("timer_shutdown_outside")
timer = rospy.Timer(rospy.Duration(P), lambda event: mark_event("tick", event))
block(2.5)
timer.shutdown()
print("alive", timer.is_alive())
timer.join()
mark("ended")
print("alive", timer.is_alive())
end_after(2)
