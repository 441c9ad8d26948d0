"""On a ROS time that jumps backward: a timer's thread dies, one with reset continues from there."""

import rospy
from scenario import begin, block

Time = rospy.Time
set_time = rospy.rostime._set_rostime


def callback(event):
    print("tick", event.current_expected.to_sec(), event.current_real.to_sec(), flush=True)


begin("ros_time_backward")
set_time(Time(100))
timer = rospy.Timer(rospy.Duration(1), callback, reset=rospy.get_param("~reset"))
for seconds in (101, 102, 50, 50.5, 51, 52, 53):
    block(1)
    print("clock", seconds, flush=True)
    set_time(Time.from_sec(seconds))
block(1)
print("alive", timer.is_alive())
