"""What Rate.remaining says before, within and after a pass, and what the rate's own fields hold."""

import rospy
from scenario import P, begin, block, mark

begin("rate_remaining")
rate = rospy.Rate(1 / P)
print("sleep_dur", rate.sleep_dur, type(rate.sleep_dur).__name__, type(rate.last_time).__name__)
for periods in (0, 0.5, 1.5, 3.5):
    mark("remaining", rate.remaining().to_sec())
    block(periods)
    mark("left", rate.remaining().to_sec())
    rate.sleep()
    mark("last_time", rate.last_time)
